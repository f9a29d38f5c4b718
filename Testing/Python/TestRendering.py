# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtksoftshadows.rendering: soft shadows in a line, whatever else the renderer draws with.

The scene is that of TestTechniques.py: on the ground the visibility at (x, 0) is 3 x - 1.5, cut to
[0, 1].
"""

import sys
import unittest

try:
    import numpy
    from vtkmodules.vtkCommonCore import vtkDoubleArray
    from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
    from vtkmodules.vtkRenderingCore import (
        vtkActor, vtkAssembly, vtkDataSetMapper, vtkLight, vtkRenderer)
except ImportError as error:
    print("skipped: VTK's Python modules or NumPy are missing:", error)
    sys.exit(77)

from TestTechniques import HEIGHT, WIDTH, Scene
import vtksoftshadows
from vtksoftshadows import _results, rendering

POINTS = [i / 20.0 for i in range(2, 27)]


def expected(x):
    return min(max(3.0 * x - 1.5, 0.0), 1.0)


class Plain(Scene):
    """The scene without a pass."""

    def __init__(self, actors=()):
        super().__init__(None, lambda _: None, actors)

    def picture(self):
        self.window.Render()
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ShouldRerenderOff()
        grab.Update()
        return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).astype(int)

    def pixel(self, x, y=0.0):
        """Row from the top and column."""
        self.renderer.SetWorldPoint(x, y, 0.0, 1.0)
        self.renderer.WorldToDisplay()
        column, row = (int(value) for value in self.renderer.GetDisplayPoint()[:2])
        return HEIGHT - 1 - row, column

    def errors(self):
        """Of the visibility at points of the ground."""
        visibility = rendering.visibility(self.renderer, self.lamp)
        return [visibility[self.pixel(x)] - expected(x) for x in POINTS]


class TestVisibility(unittest.TestCase):
    def test_values(self):
        """The closed form, from every technique."""
        for technique in rendering.TECHNIQUES:
            with self.subTest(technique=technique):
                scene = Plain()
                options = {"weights": "mean"} if technique in ("sssm", "ssabss") else {}
                shadows = rendering.enable(scene.renderer, technique, **options)
                errors = scene.errors()
                self.assertLess(numpy.abs(errors).max(), 0.3 if technique == "ssabss" else 0.13)
                self.assertLess(numpy.sqrt(numpy.square(errors).mean()),
                                0.1 if technique == "ssabss" else 0.045)
                self.assertEqual(shadows.technique, technique)

    def test_form(self):
        scene = Plain()
        rendering.enable(scene.renderer, "pcss")
        visibility = rendering.visibility(scene.renderer)
        self.assertEqual(visibility.shape, (HEIGHT, WIDTH))
        self.assertEqual(visibility.dtype, numpy.float32)
        # The ground ends below the horizon: nothing above it.
        self.assertTrue(numpy.isnan(visibility[0]).all())
        self.assertTrue(numpy.isfinite(visibility[HEIGHT // 2 + 40, WIDTH // 2]))

    def test_is_of_now(self):
        scene = Plain()
        rendering.enable(scene.renderer, "pcss")
        at_lit = scene.pixel(1.3)
        self.assertGreater(rendering.visibility(scene.renderer)[at_lit], 0.98)
        scene.lamp.SetPosition(-4.0, 0.0, 4.0)  # the shadow's middle goes to x = 4 / 3
        self.assertLess(rendering.visibility(scene.renderer)[at_lit], 0.02)

    def test_points(self):
        scene = Plain()
        plane = scene.renderer.GetActors().GetItemAsObject(0).GetMapper().GetInputAlgorithm()
        plane.SetResolution(80, 80)
        rendering.enable(scene.renderer, "sampled", samples=256)
        meshes = rendering.add_visibility(scene.renderer, scene.lamp, "lamp")
        self.assertEqual(len(meshes), 2)
        data = meshes[0]
        array = data.GetPointData().GetArray("lamp")
        self.assertEqual(array.GetNumberOfTuples(), data.GetNumberOfPoints())
        errors, hidden = [], 0
        for i in range(data.GetNumberOfPoints()):
            x, y, _ = data.GetPoint(i)
            value = array.GetValue(i)
            if y == 0.0 and 0.0 <= x <= 1.3:
                if numpy.isnan(value):
                    hidden += 1
                else:
                    errors.append(value - expected(x))
            # Behind the square, as the camera sees it, there is nothing to be known.
            if abs(x) < 0.3 and y > 3.85:
                self.assertTrue(numpy.isnan(value), (x, y, value))
        self.assertEqual(hidden, 0)
        self.assertGreater(len(errors), 10)
        self.assertLess(numpy.abs(errors).max(), 0.06)

    def test_points_of_parts(self):
        """Parts of assemblies and rectilinear grids are where they are drawn."""
        scene = Plain()
        ground = scene.renderer.GetActors().GetItemAsObject(0)
        scene.renderer.RemoveActor(ground)
        grid = vtkRectilinearGrid()
        grid.SetDimensions(81, 3, 1)
        for axis, values in (("X", numpy.linspace(-2.0, 2.0, 81)), ("Y", [-2.0, 0.0, 2.0]), ("Z", [0.0])):
            array = vtkDoubleArray()
            for value in values:
                array.InsertNextValue(value + (0.5 if axis == "X" else 0.0))
            getattr(grid, "Set%sCoordinates" % axis)(array)
        mapper = vtkDataSetMapper()
        mapper.SetInputData(grid)
        part = vtkActor()
        part.SetMapper(mapper)
        assembly = vtkAssembly()
        assembly.AddPart(part)
        assembly.SetPosition(-0.5, 0.0, 0.0)
        scene.renderer.AddActor(assembly)
        rendering.enable(scene.renderer, "sampled", samples=256)
        meshes = rendering.add_visibility(scene.renderer, scene.lamp, "lamp")
        self.assertTrue(any(mesh is grid for mesh in meshes))
        array = grid.GetPointData().GetArray("lamp")
        errors = [array.GetValue(i) - expected(grid.GetPoint(i)[0] - 0.5)
                  for i in range(grid.GetNumberOfPoints())
                  if grid.GetPoint(i)[1] == 0.0 and 0.6 <= grid.GetPoint(i)[0] <= 1.8]
        seen = [error for error in errors if not numpy.isnan(error)]
        self.assertGreater(len(seen), 15)
        self.assertLess(max(map(abs, seen)), 0.06)

    def test_what_stands_behind_a_wire_is_hidden(self):
        row = numpy.array([10.0, 10.1, 10.2, 4.0, 10.4, 10.5, 10.6])
        slack = _results._slack(numpy.tile(row, (7, 1)))
        self.assertLess(slack[3, 3], 1.0)
        self.assertGreater(slack[3, 1], 0.1, "a surface that leans")
        row[2] = row[4] = numpy.nan
        self.assertLess(_results._slack(numpy.tile(row, (7, 1)))[3, 3], 1.0)

    def test_lights_are_named(self):
        scene = Plain()
        rendering.enable(scene.renderer, "pcss")
        scene.renderer.AddLight(vtkLight())
        with self.assertRaisesRegex(ValueError, "2 lights"):
            rendering.visibility(scene.renderer)
        with self.assertRaisesRegex(ValueError, "no light of the renderer"):
            rendering.visibility(scene.renderer, vtkLight())
        scene.lamp.SwitchOff()
        with self.assertRaisesRegex(ValueError, "is off"):
            rendering.visibility(scene.renderer, scene.lamp)
        rendering.disable(scene.renderer)
        with self.assertRaisesRegex(ValueError, "not on"):
            rendering.visibility(scene.renderer, scene.lamp)
        with self.assertRaisesRegex(ValueError, "in no window"):
            lonely = vtkRenderer()
            rendering.enable(lonely)
            rendering.visibility(lonely)


class TestSettings(unittest.TestCase):
    def make(self, technique="pcss", tolerance=None, **options):
        return rendering.enable(vtkRenderer(), technique, tolerance, **options).shadow_pass

    def test_options_of_all_techniques(self):
        """Every option of the tool's table reaches its pass, and nothing beyond its range does."""
        for name, technique in rendering.TECHNIQUES.items():
            for option_name, option in technique.options.items():
                if option_name == "tolerance":
                    continue  # the argument of enable has that name
                with self.subTest(technique=name, option=option_name):
                    index = () if option.index is None else (option.index,)
                    values = list(option.choices) or [option.least, option.most]
                    for place, value in enumerate(values):
                        shadow_pass = self.make(name, **{option_name: value})
                        got = getattr(shadow_pass, "Get" + option.property)(*index)
                        self.assertEqual(got, place if option.choices else value)
                    beyond = [] if option.choices else [option.most + 1, option.least - 1]
                    for wrong in ["nonsense", None, float("nan"), *beyond]:
                        with self.assertRaisesRegex(ValueError, "'%s'" % option_name):
                            self.make(name, **{option_name: wrong})

    def test_properties(self):
        shadow_pass = self.make(progressive=True, progressive_points=16, map_memory=64, split=2)
        self.assertTrue(shadow_pass.GetProgressive())
        self.assertEqual(shadow_pass.GetProgressivePoints(), 16)
        self.assertEqual(shadow_pass.GetMapMemory(), 64)
        self.assertEqual(shadow_pass.GetSplit(), 2)
        with self.assertRaisesRegex(ValueError, "'progressive_points'.*from 1 to 1024"):
            self.make(progressive_points=0)
        for not_an_option in ("delegate_pass", "debug", "reference_count", "object_name"):
            with self.assertRaisesRegex(TypeError, not_an_option):
                self.make(**{not_an_option: 1})

    def test_tolerance(self):
        self.assertEqual(self.make("pcss", 0.02).GetSplit(), 2)
        self.assertEqual(self.make("pcss", 0.03).GetSplit(), 2)
        self.assertEqual(self.make("pcss", 0.01).GetSplit(), 4)
        self.assertEqual(self.make("pcss", 0.05).GetSplit(), 1)
        self.assertEqual(self.make("pcss", 0.05).GetMapSize(), 1024)
        self.assertEqual(self.make("pcss", 0.05, map_size=512).GetMapSize(), 512)
        self.assertEqual(self.make("sssm", 0.02).GetWeights(), 0)
        for tolerance in (0.007, 1e-9):
            with self.assertRaisesRegex(ValueError, "less than 0.008"):
                self.make("pcss", tolerance)
        for wrong in (0.0, -1.0, float("nan"), "good"):
            with self.assertRaisesRegex(ValueError, "tolerance"):
                self.make("pcss", wrong)
        with self.assertRaisesRegex(ValueError, "ssabss.*0.02; cascaded has"):
            self.make("ssabss", 0.02)

    def test_culprits(self):
        with self.assertRaisesRegex(ValueError, "'pscs'; did you mean 'pcss'"):
            self.make("pscs")
        with self.assertRaisesRegex(TypeError, "'pcss' has no option 'map_sise'; did you mean 'map_size'"):
            self.make("pcss", map_sise=3)
        with self.assertRaisesRegex(ValueError, "'map_size'.*from 32 to 16384, is 7"):
            self.make("pcss", map_size=7)
        with self.assertRaisesRegex(ValueError, "'weights': must be mean or gaussian, is 'flat'"):
            self.make("pcss", weights="flat")
        with self.assertRaisesRegex(ValueError, "light size.*-1"):
            renderer = vtkRenderer()
            renderer.AddLight(vtkLight())
            rendering.enable(renderer, light_size=-1)
        with self.assertRaisesRegex(TypeError, "'auto' may be any of .*'cascaded' has no option 'rays'"
                                    if "traced" in rendering.TECHNIQUES else "rays"):
            rendering.enable(vtkRenderer(), rays=3)

    def test_what_fails_changes_nothing(self):
        scene = Plain()
        before = rendering.enable(scene.renderer, "pcss")
        with self.assertRaises(TypeError):
            rendering.enable(scene.renderer, "marched", nonsense=1)
        self.assertIs(rendering.shadows_of(scene.renderer), before)

    def test_auto(self):
        """OpenGL's name decides, in the window that is drawn in."""
        scene = Plain()
        shadows = rendering.enable(scene.renderer, tolerance=0.02, map_size=1024)
        self.assertEqual(shadows.technique, "auto")
        self.assertIsNone(shadows.shadow_pass)
        scene.window.Render()
        software = "llvmpipe" in scene.window.ReportCapabilities() or (
            "softpipe" in scene.window.ReportCapabilities())
        name = "traced" if software and "traced" in rendering.TECHNIQUES else "cascaded"
        self.assertEqual(shadows.technique, name)
        self.assertEqual(shadows.shadow_pass.GetClassName(), rendering.TECHNIQUES[name].class_name)
        self.assertEqual(shadows.shadow_pass.GetMapSize(), 1024)
        self.assertLess(numpy.sqrt(numpy.square(scene.errors()).mean()), 0.04)

    def test_auto_by_name(self):
        from vtksoftshadows import _settings

        class Window:
            def __init__(self, renderer):
                self.report = "OpenGL vendor string:  X\nOpenGL renderer string:  %s\nllvmpipe" % renderer

            def ReportCapabilities(self):
                return self.report
        traced = "traced" if "traced" in rendering.TECHNIQUES else "cascaded"
        self.assertEqual(_settings.choose("auto", Window("llvmpipe (LLVM 19, 256 bits)")), traced)
        self.assertEqual(_settings.choose("auto", Window("softpipe")), traced)
        self.assertEqual(_settings.choose("auto", Window("NVIDIA H200/PCIe/SSE2")), "cascaded")
        self.assertEqual(_settings.choose("pcss", Window("llvmpipe")), "pcss")


class TestLights(unittest.TestCase):
    def test_sizes_of_plain_lights(self):
        """A plain light with a size casts what an area light of that size does."""
        for directional in (False, True):
            with self.subTest(directional=directional):
                arrays = []
                for kind in (vtkLight, vtksoftshadows.vtkAreaLight):
                    scene = Plain()
                    light = kind()
                    light.SetPosition(0.0, 0.0, 4.0)
                    light.SetPositional(not directional)
                    light.SetConeAngle(60.0)
                    if kind is not vtkLight and not directional:
                        light.SetShapeToDisk()
                    scene.renderer.RemoveAllLights()
                    scene.renderer.AddLight(light)
                    size = 8.0 if directional else 1.0
                    rendering.enable(scene.renderer, "sampled", light_size=size, samples=64)
                    self.assertAlmostEqual(rendering.light_size(light), size)
                    arrays.append(rendering.visibility(scene.renderer, light))
                difference = numpy.abs(arrays[0] - arrays[1])
                self.assertLess(numpy.nanmax(difference), 1e-5)
                self.assertGreater(numpy.nanmean((arrays[0] > 0.1) & (arrays[0] < 0.9)), 0.002)

    def test_copies(self):
        plain = vtkLight()
        plain.SetPosition(1.0, 2.0, 3.0)
        plain.SetColor(0.25, 0.5, 0.75)
        plain.SetPositional(1)
        rendering.set_light_size(plain, 0.6)
        area = rendering.area_light(plain)
        self.assertEqual(area.GetPosition(), plain.GetPosition())
        self.assertEqual(area.GetDiffuseColor(), plain.GetDiffuseColor())
        self.assertEqual((area.GetShapeAsString(), area.GetSize()), ("disk", (0.6, 0.6)))
        self.assertEqual(rendering.area_light(plain, 2.0).GetSize(), (2.0, 2.0))
        sun = vtkLight()
        rendering.set_light_size(sun, 0.53)
        self.assertAlmostEqual(rendering.area_light(sun).GetAngularDiameter(), 0.53)
        again = rendering.area_light(rendering.area_light(sun))
        self.assertAlmostEqual(again.GetAngularDiameter(), 0.53)
        self.assertFalse(again.GetPositional())

    def test_sizes_of_area_lights(self):
        area = vtksoftshadows.vtkAreaLight()
        rendering.set_light_size(area, (2.0, 0.5))
        self.assertEqual(rendering.light_size(area), (2.0, 0.5))
        area.SetShapeToPoint()
        self.assertEqual(rendering.light_size(area), 0.0)
        rendering.set_light_size(area, 1.5)
        self.assertEqual((rendering.light_size(area), area.GetShapeAsString()), (1.5, "disk"))
        for wrong in (-1, float("inf"), float("nan"), "wide", (1, 2, 3), None, True):
            with self.assertRaisesRegex(ValueError, "light size"):
                rendering.set_light_size(area, wrong)
        with self.assertRaisesRegex(ValueError, "two numbers"):
            rendering.set_light_size(vtkLight(), (1, 2))


if __name__ == "__main__":
    unittest.main(verbosity=2)

# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every technique, from Python: a square above a ground under a square lamp, and what three points see.

The lamp's edge is 1 and its height 4, the square's edge is 1 and its height 1. On the ground the edge of
the square at 0.5 has its penumbra from 0.5 to 5/6, and half of the lamp is seen at 2/3.
"""

import math
import sys
import unittest

try:
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkFiltersSources import vtkPlaneSource
    from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer,
                                             vtkRenderWindow)
    from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
except ImportError as error:
    print("skipped: VTK's Python modules are missing:", error)
    sys.exit(77)

import vtksoftshadows

WIDTH, HEIGHT = 320, 240


def techniques():
    """All classes of techniques, by name; what they share is abstract."""
    found = {}
    for name, value in vars(vtksoftshadows).items():
        if isinstance(value, type) and issubclass(value, vtksoftshadows.vtkSoftShadowPass):
            try:
                value()
            except TypeError:
                continue  # abstract
            found[name] = value
    return found


def square(half_edge, height):
    """A horizontal square around (0, 0, height)."""
    source = vtkPlaneSource()
    source.SetOrigin(-half_edge, -half_edge, height)
    source.SetPoint1(half_edge, -half_edge, height)
    source.SetPoint2(-half_edge, half_edge, height)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def steps_with(shadows):
    """VTK's own frame with the shadows as its opaque step."""
    steps = vtkRenderStepsPass()
    steps.SetOpaquePass(shadows)
    return steps


class Scene:
    """The scene of this file's head, in a window of its own, drawn once.

    make_chain makes the renderer's pass of the soft-shadow pass; actors are added to the scene.
    """

    def __init__(self, shadows, make_chain=steps_with, actors=()):
        self.shadows = shadows
        self.renderer = vtkRenderer()
        self.renderer.AddActor(square(4.0, 0.0))
        self.renderer.AddActor(square(0.5, 1.0))
        for actor in actors:
            self.renderer.AddActor(actor)

        self.lamp = vtksoftshadows.vtkAreaLight()
        self.lamp.SetPosition(0.0, 0.0, 4.0)
        self.lamp.SetFocalPoint(0.0, 0.0, 0.0)
        self.lamp.SetShapeToRectangle()
        self.lamp.SetSize(1.0, 1.0)
        self.renderer.SetAutomaticLightCreation(0)
        self.renderer.AddLight(self.lamp)

        self.chain = make_chain(shadows)
        self.renderer.SetPass(self.chain)

        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.0, -9.0, 3.0)
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetViewUp(0.0, 0.0, 1.0)

        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(WIDTH, HEIGHT)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()

    def visibility(self, x, y):
        """The visibility of the lamp at a point of the ground."""
        image = vtkImageData()
        if not self.shadows.GetVisibilityImage(self.lamp, image):
            return math.nan
        self.renderer.SetWorldPoint(x, y, 0.0, 1.0)
        self.renderer.WorldToDisplay()
        column, row, _ = self.renderer.GetDisplayPoint()
        return image.GetScalarComponentAsDouble(int(column), int(row), 0, 0)


class TestTechniques(unittest.TestCase):
    def test_all_are_there(self):
        self.assertGreaterEqual(len(techniques()), 9)

    def test_umbra_penumbra_lit(self):
        for name, technique in techniques().items():
            with self.subTest(technique=name):
                scene = Scene(technique())
                self.assertLess(scene.visibility(0.2, 0.0), 0.02)
                self.assertAlmostEqual(scene.visibility(2.0 / 3.0, 0.0), 0.5, delta=0.15)
                self.assertGreater(scene.visibility(1.3, 0.0), 0.98)


class TestResults(unittest.TestCase):
    def setUp(self):
        self.shadows = vtksoftshadows.vtkPercentageCloserSoftShadowPass()
        self.scene = Scene(self.shadows)

    def test_images(self):
        image = vtkImageData()
        self.assertTrue(self.shadows.GetDepthImage(image))
        self.assertEqual(image.GetDimensions(), (WIDTH, HEIGHT, 1))
        self.assertAlmostEqual(
            image.GetScalarComponentAsDouble(WIDTH // 2, HEIGHT // 2 - 40, 0, 0), 8.0, delta=1.0)
        untouched = vtkImageData()
        other = vtksoftshadows.vtkAreaLight()
        self.assertFalse(self.shadows.GetVisibilityImage(other, untouched))
        self.assertEqual(untouched.GetNumberOfPoints(), 0)

    def test_maps_are_kept_while_nothing_moves(self):
        baked = self.shadows.GetCount("maps_baked")
        self.assertEqual(baked, 1)
        self.scene.window.Render()
        self.assertEqual(self.shadows.GetCount("maps_baked"), baked)
        self.scene.lamp.SetPosition(0.1, 0.0, 4.0)
        self.scene.window.Render()
        self.assertEqual(self.shadows.GetCount("maps_baked"), baked + 1)
        self.assertEqual(self.shadows.GetCount("no such count"), -1)
        self.assertGreaterEqual(self.shadows.GetMilliseconds("receivers"), 0.0)
        self.assertEqual(self.shadows.GetMilliseconds("no such step"), -1.0)

    def test_keys(self):
        ground = self.scene.renderer.GetActors().GetLastActor()
        casters = vtksoftshadows.vtkShadowCasters
        self.assertTrue(casters.GetCastsShadow(ground))
        casters.SetCastsShadow(ground, False)
        self.assertFalse(casters.GetCastsShadow(ground))
        self.scene.window.Render()
        self.assertGreater(self.scene.visibility(0.2, 0.0), 0.98)

    def test_report_and_documentation(self):
        self.assertIn("rectangle", self.shadows.GetLightReport())
        self.assertIn("blocker search", self.shadows.__doc__)
        self.assertIn("world units", vtksoftshadows.vtkAreaLight.SetSize.__doc__)
        self.assertIn("bottom row first", self.shadows.GetVisibilityImage.__doc__)


    def test_windows_come_and_go(self):
        """What is read lies in the pass's own window, whichever rendered or died last."""
        other = Scene(vtksoftshadows.vtkSampledSoftShadowPass())
        self.assertGreater(self.scene.visibility(1.3, 0.0), 0.98)
        self.assertGreater(other.visibility(1.3, 0.0), 0.98)
        del other
        self.assertGreater(self.scene.visibility(1.3, 0.0), 0.98)


class TestSettings(unittest.TestCase):
    def test_clamped(self):
        shadows = vtksoftshadows.vtkSampledSoftShadowPass()
        shadows.SetNumberOfSamples(0)
        self.assertEqual(shadows.GetNumberOfSamples(), 1)
        shadows.SetMapSize(10**6)
        self.assertEqual(shadows.GetMapSize(), 16384)

    def test_lights(self):
        lamp = vtksoftshadows.vtkAreaLight()
        lamp.SetShapeToDisk()
        self.assertEqual(lamp.GetShape(), vtksoftshadows.vtkAreaLight.DISK)
        self.assertEqual(lamp.GetSize(), (1.0, 1.0))


if __name__ == "__main__":
    unittest.main(verbosity=2)

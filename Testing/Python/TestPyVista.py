# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtksoftshadows.pyvista: plotters as their users have them.

The scene is that of TestTechniques.py: on the ground the visibility at (x, 0) is 3 x - 1.5, cut to
[0, 1].
"""

import gc
import pathlib
import sys
import tempfile
import unittest
import warnings

try:
    import numpy
    import pyvista
except ImportError as error:
    print("skipped: PyVista is missing:", error)
    sys.exit(77)

import vtksoftshadows
from vtksoftshadows import pyvista as softshadows

pyvista.OFF_SCREEN = True
SIZE = (320, 240)
POINTS = [i / 20.0 for i in range(2, 27)]


def expected(x):
    return min(max(3.0 * x - 1.5, 0.0), 1.0)


def square(edge, height, resolution=1):
    return pyvista.Plane(center=(0.0, 0.0, height), i_size=edge, j_size=edge,
                         i_resolution=resolution, j_resolution=resolution)


def lamp(**options):
    return softshadows.AreaLight(
        position=(0.0, 0.0, 4.0), focal_point=(0.0, 0.0, 0.0), size=1.0, **options)


def fill(plotter, resolution=1):
    """Puts the scene into the active renderer; returns the ground."""
    ground = square(8.0, 0.0, resolution)
    plotter.add_mesh(ground, color="white", lighting=True)
    plotter.add_mesh(square(1.0, 1.0), color="tan")
    plotter.camera_position = [(0.0, -9.0, 3.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
    return ground


def make_plotter(light=None, **options):
    plotter = pyvista.Plotter(lighting="none", window_size=SIZE, **options)
    plotter.disable_anti_aliasing()
    plotter.add_light(light or lamp())
    fill(plotter)
    return plotter


def pixel(plotter, x, y=0.0):
    """Row from the top and column of a point of the ground, in the active renderer's picture."""
    renderer = plotter.renderer
    renderer.SetWorldPoint(x, y, 0.0, 1.0)
    renderer.WorldToView()
    to_screen = renderer.GetViewPoint()
    width, height = renderer.GetSize()
    return (int((1.0 - to_screen[1]) * 0.5 * height), int((to_screen[0] + 1.0) * 0.5 * width))


def picture(plotter):
    plotter.screenshot(return_img=True)  # VTK's depth of field is a frame late
    plotter.render()
    return plotter.screenshot(return_img=True).astype(int)


class Case(unittest.TestCase):
    def assert_values(self, plotter, light=None, most=0.13):
        visibility = softshadows.visibility(plotter, light)
        errors = [visibility[pixel(plotter, x)] - expected(x) for x in POINTS]
        self.assertLess(numpy.abs(errors).max(), most)
        self.assertLess(numpy.sqrt(numpy.square(errors).mean()), 0.04)
        return visibility


class TestVisibility(Case):
    def test_values(self):
        for technique in ("auto", "traced", "cascaded", "sampled", "pcss", "marched", "sbfs", "pvssm"):
            if technique in ("auto", *softshadows.TECHNIQUES):
                with self.subTest(technique=technique):
                    plotter = make_plotter()
                    softshadows.enable(plotter, technique)
                    visibility = self.assert_values(plotter)
                    self.assertEqual(visibility.shape, (SIZE[1], SIZE[0]))
                    plotter.close()

    def test_meshes(self):
        plotter = pyvista.Plotter(lighting="none", window_size=SIZE)
        plotter.add_light(lamp())
        ground = fill(plotter, resolution=80)
        softshadows.enable(plotter, "sampled", samples=256)
        meshes = softshadows.add_visibility(plotter, name="lamp")
        self.assertEqual(len(meshes), 2)
        values = ground["lamp"]
        self.assertEqual(values.shape, (ground.n_points,))
        row = (numpy.abs(ground.points[:, 1]) < 1e-6) & (ground.points[:, 0] >= -1e-6) & (
            ground.points[:, 0] < 1.3)
        self.assertGreater(row.sum(), 10)
        errors = values[row] - [expected(x) for x in ground.points[row, 0]]
        self.assertLess(numpy.abs(errors).max(), 0.06)
        # Behind the square, as the camera sees it.
        hidden = (numpy.abs(ground.points[:, 0]) < 0.3) & (ground.points[:, 1] > 3.85)
        self.assertTrue(numpy.isnan(values[hidden]).all())
        plotter.close()

    def test_moved_actors(self):
        """Points lie where their actor is."""
        plotter = pyvista.Plotter(lighting="none", window_size=SIZE)
        plotter.add_light(lamp())
        fill(plotter)
        ground = square(0.2, 0.0, 4)
        actor = plotter.add_mesh(ground)
        actor.position = (2.0 / 3.0, 0.0, 0.002)
        actor.scale = (0.5, 0.5, 1.0)
        softshadows.enable(plotter, "sampled", samples=256)
        softshadows.add_visibility(plotter)
        for (x, _, _), value in zip(ground.points, ground["visibility"]):
            self.assertAlmostEqual(value, expected(2.0 / 3.0 + 0.5 * x), delta=0.06)
        plotter.close()

    def test_screenshot_shows_what_is_now(self):
        plotter = make_plotter()
        softshadows.enable(plotter, "pcss")
        before = picture(plotter)
        at = pixel(plotter, 1.3)
        self.assertGreater(before[at].min(), 100)
        plotter.renderer.lights[0].position = (-4.0, 0.0, 4.0)
        after = picture(plotter)
        self.assertLess(after[at].max(), 10)
        plotter.close()

    def test_nobody_to_ask(self):
        plotter = make_plotter()
        with self.assertRaisesRegex(ValueError, "not on"):
            softshadows.visibility(plotter)
        softshadows.enable(plotter, "pcss")
        plotter.close()
        with self.assertRaisesRegex(ValueError, "closed"):
            softshadows.visibility(plotter)
        with self.assertRaisesRegex(ValueError, "closed"):
            softshadows.enable(plotter)
        softshadows.disable(plotter)


class TestLights(Case):
    def test_area_light_is_a_light_of_pyvista(self):
        light = softshadows.AreaLight(
            position=(1, 2, 3), focal_point=(0, 0, 1), color="red", size=(2, 0.5), intensity=0.5,
            shadow_attenuation=0.75, view_up=(0, 0, 1))
        self.assertIsInstance(light, pyvista.Light)
        self.assertIsInstance(light, vtksoftshadows.vtkAreaLight)
        self.assertEqual(light.GetClassName(), "vtkAreaLight")
        self.assertEqual(light.position, (1.0, 2.0, 3.0))
        self.assertEqual(light.diffuse_color, "red")
        self.assertEqual((light.size, light.shape), ((2.0, 0.5), "rectangle"))
        self.assertTrue(light.positional)
        self.assertEqual(light.cone_angle, 90.0)
        self.assertEqual(light.intensity, 0.5)
        self.assertEqual(light.shadow_attenuation, 0.75)
        self.assertEqual(light.view_up, (0.0, 0.0, 1.0))
        light.cone_angle = 40
        self.assertEqual(light.GetConeAngle(), 40.0)
        light.positional = False
        self.assertFalse(light.GetPositional())
        copy = light.copy()
        self.assertIsInstance(copy, softshadows.AreaLight)
        self.assertEqual((copy.size, copy.position), (light.size, light.position))
        self.assertIn("AreaLight", repr(light))

    def test_suns(self):
        sun = softshadows.AreaLight(angular_diameter=0.53)
        sun.set_direction_angle(30, 120)
        self.assertFalse(sun.positional)
        self.assertAlmostEqual(sun.GetAngularDiameter(), 0.53)
        self.assertAlmostEqual(sun.position[2], 0.5)
        with self.assertRaisesRegex(ValueError, "angular_diameter"):
            softshadows.AreaLight(size=1, angular_diameter=1)
        with self.assertRaisesRegex(ValueError, "directional"):
            sun.size = 1.0

    def test_culprits(self):
        with self.assertRaisesRegex(ValueError, "-2"):
            softshadows.AreaLight(size=-2)
        with self.assertRaisesRegex(ValueError, "'ring'"):
            softshadows.AreaLight(shape="ring")
        plotter = make_plotter()
        with self.assertRaisesRegex(ValueError, "did you mean 'cascaded'"):
            softshadows.enable(plotter, "cascade")
        with self.assertRaisesRegex(TypeError, "'quality'"):
            softshadows.enable(plotter, "pcss", quality="good")
        with self.assertRaisesRegex(ValueError, "light size.*-1"):
            softshadows.enable(plotter, "pcss", light_size=-1)
        self.assertIsNone(softshadows.shadows_of(plotter))
        plotter.close()

    def test_vtk_area_light_stays_one(self):
        """Plotter.add_light copies what is no light of PyVista's; the copy has the extent, too."""
        original = vtksoftshadows.vtkAreaLight()
        original.SetPosition(0.0, 0.0, 4.0)
        original.SetFocalPoint(0.0, 0.0, 0.0)
        original.SetSize(1.0, 1.0)
        plotter = make_plotter(original)
        light = plotter.renderer.lights[0]
        self.assertIsInstance(light, softshadows.AreaLight)
        self.assertEqual(light.size, (1.0, 1.0))
        softshadows.enable(plotter, "pcss")
        self.assert_values(plotter, original)
        self.assert_values(plotter, light)
        plotter.close()

    def test_sizes_of_pyvista_lights(self):
        light = pyvista.Light(position=(0, 0, 4), focal_point=(0, 0, 0), positional=True, cone_angle=60)
        plotter = make_plotter(light)
        softshadows.enable(plotter, "sampled", light_size=1.0, samples=64)
        soft = softshadows.visibility(plotter)
        self.assertGreater(numpy.nanmean((soft > 0.1) & (soft < 0.9)), 0.002)
        self.assertAlmostEqual(soft[pixel(plotter, 2.0 / 3.0)], 0.5, delta=0.1)
        self.assertEqual(softshadows.light_size(light.copy()), 1.0)
        self.assertEqual(softshadows.light_size(pyvista.Light.from_vtk(light)), 1.0)
        area = softshadows.AreaLight.from_vtk(light)
        self.assertEqual((area.size, area.shape, area.cone_angle), ((1.0, 1.0), "disk", 60.0))
        softshadows.set_light_size(light, 0.0)
        hard = softshadows.visibility(plotter)
        self.assertLess(numpy.nanmean((hard > 0.1) & (hard < 0.9)), 0.001)
        plotter.close()

    def test_spot_shows_its_actor(self):
        """What PyVista does for its lights when a cone changes, it does for area lights."""
        light = lamp(cone_angle=20)
        plotter = make_plotter(light)
        light.show_actor()
        softshadows.enable(plotter, "pcss")
        self.assertTrue(any("vtkLightActor" in name for name in plotter.renderer.actors))
        picture(plotter)
        plotter.close()


class TestPasses(Case):
    """With lights that no shadow takes anything from, the picture is that without soft shadows."""

    def plotter(self):
        plotter = make_plotter(lamp(shadow_attenuation=0.0))
        plotter.add_mesh(square(3.2, 0.3), color="red", opacity=0.5)
        plotter.add_mesh(square(3.2, 0.2), color="blue", opacity=0.5)
        return plotter

    def assert_kept(self, switch_on, most=2, values=True):
        plain = self.plotter()
        switch_on(plain)
        reference = picture(plain)
        plain.close()
        for when in ("before", "after", "between frames"):
            with self.subTest(when=when):
                plotter = self.plotter()
                if when == "before":
                    switch_on(plotter)
                softshadows.enable(plotter, "pcss")
                if when == "between frames":
                    picture(plotter)
                if when != "before":
                    switch_on(plotter)
                now = picture(plotter)
                self.assertLessEqual(numpy.abs(now - reference).max(), most)
                plotter.renderer.lights[0].shadow_attenuation = 1.0
                self.assertGreater(numpy.abs(picture(plotter) - reference).max(), 10)
                if values:
                    self.assert_values(plotter)
                softshadows.disable(plotter)
                self.assertTrue((picture(plotter) == reference).all())
                plotter.close()
        return reference

    def test_nothing(self):
        self.assert_kept(lambda plotter: None)

    def test_ambient_occlusion(self):
        self.assert_kept(lambda plotter: plotter.enable_ssao(radius=0.5, kernel_size=32))

    def test_eye_dome_lighting(self):
        self.assert_kept(lambda plotter: plotter.enable_eye_dome_lighting())

    def test_blurring(self):
        self.assert_kept(lambda plotter: plotter.add_blurring())

    def test_fast_antialiasing(self):
        plain = self.assert_kept(lambda plotter: None)
        smooth = self.assert_kept(lambda plotter: plotter.renderer.UseFXAAOn())
        self.assertGreater(numpy.abs(plain - smooth).max(), 10)

    def test_supersampling(self):
        self.assert_kept(lambda plotter: plotter.enable_anti_aliasing("ssaa"))

    def test_multisampling(self):
        self.assert_kept(lambda plotter: plotter.enable_anti_aliasing("msaa", multi_samples=4))

    def test_depth_peeling(self):
        self.assert_kept(lambda plotter: plotter.enable_depth_peeling(4))

    def test_depth_of_field(self):
        self.assert_kept(lambda plotter: plotter.enable_depth_of_field())

    def test_several(self):
        def switch_on(plotter):
            plotter.enable_ssao(radius=0.5, kernel_size=32)
            plotter.enable_eye_dome_lighting()
            plotter.enable_anti_aliasing("ssaa")
        self.assert_kept(switch_on)

    def test_what_pyvista_loses_is_kept(self):
        """FXAA has no effect below PyVista's SSAO without soft shadows, and with them it has."""
        plotter = self.plotter()
        plotter.enable_ssao(radius=0.5, kernel_size=32)
        softshadows.enable(plotter, "pcss")
        occluded = picture(plotter)
        plotter.renderer.UseFXAAOn()
        self.assertGreater(numpy.abs(picture(plotter) - occluded).max(), 10)
        plotter.renderer.UseFXAAOff()
        self.assertTrue((picture(plotter) == occluded).all())
        plotter.close()

    def test_switched_off_later(self):
        plotter = self.plotter()
        softshadows.enable(plotter, "pcss")
        before = picture(plotter)
        for on, off in ((lambda: plotter.enable_ssao(radius=0.5, kernel_size=32), plotter.disable_ssao),
                        (plotter.enable_eye_dome_lighting, plotter.disable_eye_dome_lighting),
                        (lambda: plotter.enable_anti_aliasing("ssaa"), plotter.disable_anti_aliasing)):
            on()
            self.assertGreater(numpy.abs(picture(plotter) - before).max(), 3)
            off()
            self.assertTrue((picture(plotter) == before).all())
        plotter.close()

    def test_hard_shadows_are_left_out(self):
        plotter = make_plotter()
        softshadows.enable(plotter, "pcss")
        before = picture(plotter)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            plotter.enable_shadows()
            after = picture(plotter)
        self.assertTrue(any("enable_shadows" in str(warning.message) for warning in caught))
        self.assertTrue((after == before).all())
        plotter.enable_ssao(radius=0.5, kernel_size=32)
        self.assert_values(plotter)
        plotter.close()


class TestPlotters(Case):
    def test_subplots(self):
        plotter = pyvista.Plotter(shape=(1, 2), lighting="none", window_size=(640, 240))
        plotter.disable_anti_aliasing()
        for column in (0, 1):
            plotter.subplot(0, column)
            fill(plotter)
        plotter.add_light(lamp())
        softshadows.enable(plotter, "pcss")
        for column in (0, 1):
            plotter.subplot(0, column)
            self.assertEqual(self.assert_values(plotter).shape, (240, 320))
        whole = picture(plotter)
        self.assertLessEqual(numpy.abs(whole[5:-5, 5:315] - whole[5:-5, 325:635]).max(), 2)
        plotter.subplot(0, 0)
        softshadows.disable(plotter.renderer)
        half = picture(plotter)
        self.assertGreater(half[pixel(plotter, 0.2)].max(), 100)
        self.assertTrue((half[:, 325:] == whole[:, 325:]).all())
        plotter.close()

    def test_several_plotters(self):
        first, second = make_plotter(), make_plotter()
        softshadows.enable(first, "pcss")
        softshadows.enable(second, "marched")
        for _ in range(2):
            self.assert_values(first)
            self.assert_values(second)
        second.close()
        self.assert_values(first)
        first.close()

    def test_loop_after_show(self):
        plotter = make_plotter()
        softshadows.enable(plotter, "pcss")
        plotter.show(auto_close=False)
        light = plotter.renderer.lights[0]
        for x in (0.0, 0.5, 1.0):
            light.position = (x, 0.0, 4.0)
            light.focal_point = (x, 0.0, 0.0)
            visibility = softshadows.visibility(plotter)
            # The edge at 0.5, seen from a lamp at x: half of it at 0.5 + (0.5 - x) / 3.
            self.assertAlmostEqual(visibility[pixel(plotter, 0.5 + (0.5 - x) / 3.0)], 0.5, delta=0.1)
        plotter.window_size = (400, 200)
        self.assertEqual(self.values_at_rest(plotter, light).shape, (200, 400))
        plotter.close()

    def values_at_rest(self, plotter, light):
        light.position = (0.0, 0.0, 4.0)
        light.focal_point = (0.0, 0.0, 0.0)
        return self.assert_values(plotter)

    def test_meshes_come_and_go(self):
        plotter = make_plotter()
        softshadows.enable(plotter, "pcss")
        picture(plotter)
        actor = plotter.add_mesh(square(1.0, 1.0).translate((2.0, 0.0, 0.0)), name="second")
        at = pixel(plotter, 2.8)
        self.assertLess(softshadows.visibility(plotter)[at], 0.05)
        plotter.remove_actor(actor)
        self.assertGreater(softshadows.visibility(plotter)[at], 0.98)
        plotter.close()

    def test_export(self):
        plotter = make_plotter()
        softshadows.enable(plotter, "pcss")
        before = picture(plotter)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("gltf", "obj", "vrml"):
                file = pathlib.Path(folder) / ("scene." + {"vrml": "wrl"}.get(name, name))
                getattr(plotter, "export_" + name)(str(file))
                self.assertGreater(file.stat().st_size, 100)
        self.assertTrue((picture(plotter) == before).all())
        plotter.close()

    def test_gif(self):
        import imageio
        plotter = make_plotter()
        softshadows.enable(plotter, "pcss")
        with tempfile.TemporaryDirectory() as folder:
            file = str(pathlib.Path(folder) / "day.gif")
            plotter.open_gif(file)
            for x in (-1.5, 0.0, 1.5):
                plotter.renderer.lights[0].position = (x, 0.0, 4.0)
                plotter.write_frame()
            at = pixel(plotter, 0.9)
            plotter.close()
            frames = [frame[at][0] for frame in imageio.mimread(file)]
        self.assertEqual(len(frames), 3)
        self.assertLess(frames[0], 30)  # umbra, as the lamp at -1.5 throws the square's edge to 7 / 6
        self.assertGreater(frames[1], 100)
        self.assertGreater(frames[2], 100)

    def test_translucent_meshes(self):
        plotter = make_plotter()
        plotter.add_mesh(square(1.6, 0.3), color="red", opacity=0.5)
        softshadows.enable(plotter, "pcss")
        self.assert_values(plotter)  # of the ground behind them
        colors = picture(plotter)[pixel(plotter, 0.3, 0.3)]  # through the pane
        self.assertGreater(colors[0], colors[1] + 50)
        plotter.close()

    def test_scale(self):
        plotter = make_plotter()
        softshadows.enable(plotter, "pcss")
        large = plotter.screenshot(return_img=True, scale=2)
        self.assertEqual(large.shape[:2], (2 * SIZE[1], 2 * SIZE[0]))
        row, column = pixel(plotter, 0.2)
        self.assertLess(large[2 * row, 2 * column].max(), 10)
        row, column = pixel(plotter, 1.3)
        self.assertGreater(large[2 * row, 2 * column].min(), 100)
        plotter.close()


class TestGarbage(Case):
    def deleted_after(self, use):
        deleted = []
        plotter = make_plotter()
        shadows = softshadows.enable(plotter, "pcss")
        shadows.shadow_pass.AddObserver("DeleteEvent", lambda *_: deleted.append("pass"))
        use(plotter)
        plotter.close()
        plotter.deep_clean()
        del plotter, shadows
        gc.collect()
        return deleted

    def test_closed(self):
        self.assertEqual(self.deleted_after(lambda plotter: None), ["pass"])

    def test_drawn_and_closed(self):
        self.assertEqual(self.deleted_after(picture), ["pass"])

    def test_with_other_passes(self):
        def use(plotter):
            plotter.enable_ssao(radius=0.5, kernel_size=32)
            picture(plotter)
        self.assertEqual(self.deleted_after(use), ["pass"])

    def test_disabled(self):
        def use(plotter):
            picture(plotter)
            softshadows.disable(plotter)
            self.assertNotIn("screenshot", vars(plotter))
        self.assertEqual(self.deleted_after(use), ["pass"])


if __name__ == "__main__":
    unittest.main(verbosity=2)

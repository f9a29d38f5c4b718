# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The PyVista code of Documentation/Python.md and the example in the style of PyVista's gallery, run.

Every block runs where those before it on the page did, with a terrain and a part. After each that makes a
plotter there must be umbra, penumbra and light in it.
"""

import os
import pathlib
import runpy
import sys
import tempfile
import unittest

try:
    import numpy
    import pyvista
except ImportError as error:
    print("skipped: PyVista is missing:", error)
    sys.exit(77)

from TestSnippets import DOCUMENTATION, blocks
from vtksoftshadows import pyvista as softshadows

pyvista.OFF_SCREEN = True
pyvista.global_theme.window_size = (320, 240)
EXAMPLE = DOCUMENTATION.parent / "Examples" / "Python" / "soft_shadows_gallery.py"


def make_terrain():
    x, y = numpy.meshgrid(numpy.linspace(-5, 5, 101), numpy.linspace(-5, 5, 101))
    return pyvista.StructuredGrid(x, y, 0.8 * numpy.sin(1.3 * x) * numpy.cos(0.9 * y))


class TestPage(unittest.TestCase):
    def run_blocks(self):
        """Plotters in the order of the page, and what the code has left."""
        scope = {"terrain": make_terrain(), "part": pyvista.Cylinder(radius=0.3, height=1.0).rotate_z(30)}
        plotters = []
        for block in blocks("Python.md"):
            if "pyvista" not in block and "pyvista" not in scope:
                continue
            before = scope.get("plotter")
            exec(block, scope)
            if scope["plotter"] is not before:
                plotters.append(scope["plotter"])
        return plotters, scope

    def test_page(self):
        folder = os.getcwd()
        with tempfile.TemporaryDirectory() as output:
            os.chdir(output)
            try:
                plotters, scope = self.run_blocks()
                self.check_gif("day.gif")
            finally:
                os.chdir(folder)
        self.assertEqual(len(plotters), 4)
        for number, plotter in enumerate(plotters[:3]):  # the last one is closed by its own code
            with self.subTest(plotter=number):
                lights = plotter.renderer.lights
                light = lights[1 if len(lights) > 1 else 0]
                visibility = softshadows.visibility(plotter, light)
                self.assertGreater((visibility < 0.01).sum(), 80)
                self.assertGreater(((visibility > 0.05) & (visibility < 0.95)).sum(), 20)
                self.assertGreater((visibility > 0.99).sum(), 3000)
                self.assert_picture(plotter.screenshot(return_img=True).astype(float), visibility, light)
                plotter.close()
        sunlight = scope["terrain"]["sunlight"]
        self.assertGreater(numpy.isfinite(sunlight).mean(), 0.9)
        self.assertTrue(0.05 < (sunlight < 0.5).mean() < 0.7)

    def assert_picture(self, picture, visibility, light):
        """Not black but darker in the shadow."""
        brightness = picture.mean(axis=2)
        lit, shadowed = brightness[visibility > 0.99].mean(), brightness[visibility < 0.01].mean()
        self.assertGreater(lit, 60)
        self.assertLess(shadowed, 0.8 * lit)

    def check_gif(self, file):
        import imageio
        frames = [frame.astype(float) for frame in imageio.mimread(file)]
        self.assertEqual(len(frames), 6)
        for one, next_one in zip(frames, frames[1:]):
            self.assertGreater(numpy.abs(one[..., :3] - next_one[..., :3]).mean(), 2.0)


class TestGallery(unittest.TestCase):
    def test_example(self):
        pictures = []
        show = pyvista.Plotter.show

        def look(plotter, *_arguments, **_keywords):
            file = os.environ.get("PICTURES") and "%s%d.png" % (os.environ["PICTURES"], len(pictures))
            pictures.append(plotter.screenshot(file or None, return_img=True).astype(float).mean(axis=2))
            plotter.close()
        pyvista.Plotter.show = look
        try:
            runpy.run_path(str(EXAMPLE))
        finally:
            pyvista.Plotter.show = show
        self.assertEqual(len(pictures), 3)
        for picture in pictures:
            self.assertGreater((picture < 60).mean(), 0.01)
            self.assertGreater((picture > 120).mean(), 0.1)


if __name__ == "__main__":
    unittest.main(verbosity=2)

# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python code of Documentation/Python.md and Integrating.md, taken from there, run and looked at.

Every block of a page is run where those before it on the page were: a ball above a ground, in a
renderer and a window of those names. After each that sets the renderer's pass the picture must have a
soft shadow in a scene that is lit. The code for PyVista is run by TestUses.py.
"""

import pathlib
import re
import sys
import unittest

try:
    from vtkmodules import vtkRenderingOpenGL2
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
    from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer,
                                             vtkRenderWindow, vtkWindowToImageFilter)
except ImportError as error:
    print("skipped: VTK's Python modules are missing:", error)
    sys.exit(77)

import vtksoftshadows

WIDTH, HEIGHT = 200, 150
DOCUMENTATION = pathlib.Path(__file__).resolve().parents[2] / "Documentation"


def blocks(page):
    """The Python blocks of a page."""
    text = (DOCUMENTATION / page).read_text(encoding="ascii")
    return re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def values(image):
    scalars = image.GetPointData().GetScalars()
    return [scalars.GetComponent(i, 0) for i in range(scalars.GetNumberOfTuples())]


class Stage:
    """What the code of the pages finds: a renderer in a window, with a ball above a ground."""

    def __init__(self):
        self.renderer = vtkRenderer()
        plane = vtkPlaneSource()
        plane.SetOrigin(-4.0, -4.0, 0.0)
        plane.SetPoint1(4.0, -4.0, 0.0)
        plane.SetPoint2(-4.0, 4.0, 0.0)
        self.add(plane)
        sphere = vtkSphereSource()
        sphere.SetCenter(0.0, 0.0, 0.7)
        sphere.SetThetaResolution(32)
        sphere.SetPhiResolution(32)
        self.ball = self.add(sphere)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(1.5, -6.0, 3.5)
        camera.SetFocalPoint(-0.2, -0.2, 0.2)
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.renderer.ResetCameraClippingRange()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(WIDTH, HEIGHT)
        self.window.AddRenderer(self.renderer)

    def add(self, source):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        return actor

    def colors(self):
        """The brightness of every pixel, bottom row first."""
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        return [value / 255.0 for value in values(grab.GetOutput())]

    def depth(self, shadows):
        self.window.Render()
        image = vtkImageData()
        assert shadows.GetDepthImage(image)
        return values(image)


class TestSnippets(unittest.TestCase):
    def look(self, stage, shadows, lamp):
        """The picture as it is now."""
        self.assertIs(type(lamp), vtksoftshadows.vtkAreaLight)
        depth = stage.depth(shadows)
        colors = stage.colors()
        image = vtkImageData()
        self.assertTrue(shadows.GetVisibilityImage(lamp, image))
        visibility = values(image)
        stage.ball.VisibilityOff()
        is_ground = [a == b for a, b in zip(depth, stage.depth(shadows))]
        stage.ball.VisibilityOn()
        stage.window.Render()
        lit = [c for c, v, g in zip(colors, visibility, is_ground) if g and v > 0.99]
        shadowed = [c for c, v in zip(colors, visibility) if v < 0.01]
        penumbra = [v for v, g in zip(visibility, is_ground) if g and 0.1 < v < 0.9]
        self.assertGreater(len(penumbra), 100)
        self.assertGreater(len(lit), 5000)
        self.assertGreater(len(shadowed), 300)
        self.assertGreater(sum(lit) / len(lit), 0.3)
        self.assertGreater(sum(shadowed) / len(shadowed), 0.02)
        self.assertLess(sum(shadowed) / len(shadowed), 0.7 * sum(lit) / len(lit))

    def test_python(self):
        page = blocks("Python.md")
        stage = Stage()
        scope = {"renderer": stage.renderer, "window": stage.window}
        exec(page[0], scope)  # the ten lines
        self.assertIn("SetPass", page[0])
        self.look(stage, scope["shadows"], scope["lamp"])
        for block in page[1:]:
            if "pyvista" in block:
                break  # TestUses.py runs the rest of the page
            exec(block, scope)
        self.assertEqual(scope["visibility"].shape, (HEIGHT, WIDTH))
        self.assertTrue(scope["shadows"].GetConverged())

    def test_integrating(self):
        for number, block in enumerate(blocks("Integrating.md")):
            with self.subTest(block=number):
                stage = Stage()
                scope = {"renderer": stage.renderer, "window": stage.window}
                exec(blocks("Python.md")[0], scope)
                for name in dir(vtkRenderingOpenGL2):
                    scope.setdefault(name, getattr(vtkRenderingOpenGL2, name))
                self.assertIn("SetPass", block)
                exec(block, scope)
                self.look(stage, scope["shadows"], scope["lamp"])


if __name__ == "__main__":
    unittest.main(verbosity=2)

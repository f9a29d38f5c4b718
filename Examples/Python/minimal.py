#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A sphere on a plane under a square lamp, with plain vtkmodules.

    minimal.py                a window; drag to turn the scene
    minimal.py FILE.png       a picture instead
"""

import sys

import vtkmodules.vtkInteractionStyle  # noqa: F401 (registers the default mouse bindings)
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkRenderWindowInteractor, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
from vtksoftshadows import vtkAreaLight, vtkPercentageCloserSoftShadowPass


def add_actor(renderer, source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)


def make_renderer():
    renderer = vtkRenderer()
    plane = vtkPlaneSource()
    plane.SetOrigin(-10.0, -10.0, 0.0)
    plane.SetPoint1(10.0, -10.0, 0.0)
    plane.SetPoint2(-10.0, 10.0, 0.0)
    add_actor(renderer, plane)
    sphere = vtkSphereSource()
    sphere.SetCenter(0.0, 0.0, 0.5)
    sphere.SetThetaResolution(64)
    sphere.SetPhiResolution(64)
    add_actor(renderer, sphere)

    lamp = vtkAreaLight()  # a vtkLight with an extent
    lamp.SetPosition(3.0, 4.0, 5.0)
    lamp.SetFocalPoint(0.0, 0.0, 0.0)
    lamp.SetShapeToRectangle()
    lamp.SetSize(1.0, 1.0)  # world units
    renderer.AddLight(lamp)

    shadows = vtkPercentageCloserSoftShadowPass()
    steps = vtkRenderStepsPass()  # VTK's own frame around it
    steps.SetOpaquePass(shadows)
    renderer.SetPass(steps)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.0, -5.0, 3.0)
    camera.SetFocalPoint(-0.2, -0.3, 0.2)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCameraClippingRange()
    return renderer


def save(window, file):
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()


def main():
    if len(sys.argv) > 2:
        sys.exit("usage: minimal.py [FILE.png]")
    window = vtkRenderWindow()
    window.SetSize(640, 480)
    window.SetWindowName("SoftShadows")
    window.AddRenderer(make_renderer())
    if len(sys.argv) == 2:
        window.SetOffScreenRendering(1)
        window.Render()
        save(window, sys.argv[1])
        return
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    window.Render()
    interactor.Start()


if __name__ == "__main__":
    main()

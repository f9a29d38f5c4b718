#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The textures of one frame, side by side: the figure of Documentation/Design.md.

    frame-figure.py MAP.png FILE.png

MAP.png is the depth map that Examples/SaveDepthMaps writes; the scene here is the same. Then follow
the receivers' depth, the visibility and the shaded frame. Needs the Python package vtksoftshadows.
"""

import math
import sys

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkImagingCore import (vtkImageAppendComponents, vtkImageConstantPad,
                                       vtkImageResize)
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
from vtksoftshadows import vtkAreaLight, vtkPercentageCloserSoftShadowPass

WIDTH, HEIGHT = 320, 240
GAP = 6  # white columns behind each panel


def make_renderer():
    plane = vtkPlaneSource()
    plane.SetOrigin(-10.0, -10.0, 0.0)
    plane.SetPoint1(10.0, -10.0, 0.0)
    plane.SetPoint2(-10.0, 10.0, 0.0)
    sphere = vtkSphereSource()
    sphere.SetCenter(-0.6, 0.0, 0.5)
    sphere.SetThetaResolution(64)
    sphere.SetPhiResolution(64)
    cone = vtkConeSource()
    cone.SetCenter(0.6, 0.0, 0.5)
    cone.SetDirection(0.0, 0.0, 1.0)
    cone.SetResolution(64)
    renderer = vtkRenderer()
    for source in (plane, sphere, cone):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)

    lamp = vtkAreaLight()
    lamp.SetPosition(3.0, 4.0, 5.0)
    lamp.SetFocalPoint(0.0, 0.0, 0.0)
    lamp.SetSize(1.0, 1.0)
    renderer.AddLight(lamp)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.0, -4.5, 3.0)
    camera.SetFocalPoint(-0.3, -0.4, 0.1)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCameraClippingRange()
    return renderer, lamp


def grey(image, white, black):
    """A float image as bytes, NaN as white."""
    values = image.GetPointData().GetScalars()
    picture = vtkImageData()
    picture.SetDimensions(image.GetDimensions())
    picture.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
    out = picture.GetPointData().GetScalars()
    for i in range(values.GetNumberOfTuples()):
        value = values.GetValue(i)
        share = 1.0 if math.isnan(value) else (value - black) / (white - black)
        out.SetValue(i, round(255.0 * min(max(share, 0.0), 1.0)))
    return picture


def as_colors(image):
    if image.GetNumberOfScalarComponents() == 3:
        return image
    join = vtkImageAppendComponents()
    for _ in range(3):
        join.AddInputData(image)
    join.Update()
    return join.GetOutput()


def panel(image):
    """As high as the others, and a white gap on the right."""
    resize = vtkImageResize()
    resize.SetInputData(as_colors(image))
    width, height, _ = image.GetDimensions()
    width = width * HEIGHT // height
    resize.SetOutputDimensions(width, HEIGHT, 1)
    pad = vtkImageConstantPad()
    pad.SetInputConnection(resize.GetOutputPort())
    pad.SetOutputWholeExtent(0, width + GAP - 1, 0, HEIGHT - 1, 0, 0)
    pad.SetConstant(255)
    pad.Update()
    return pad.GetOutput()


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: frame-figure.py MAP.png FILE.png")
    renderer, lamp = make_renderer()
    shadows = vtkPercentageCloserSoftShadowPass()
    steps = vtkRenderStepsPass()
    steps.SetOpaquePass(shadows)
    renderer.SetPass(steps)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(WIDTH, HEIGHT)
    window.AddRenderer(renderer)
    window.Render()

    depth_map = vtkPNGReader()
    depth_map.SetFileName(sys.argv[1])
    depth_map.Update()
    depth, visibility = vtkImageData(), vtkImageData()
    shadows.GetDepthImage(depth)
    shadows.GetVisibilityImage(lamp, visibility)
    frame = vtkWindowToImageFilter()
    frame.SetInput(window)
    frame.Update()

    row = vtkImageAppend()
    for image in (depth_map.GetOutput(), grey(depth, 3.0, 9.0), grey(visibility, 1.0, 0.0),
                  frame.GetOutput()):
        row.AddInputData(panel(image))
    writer = vtkPNGWriter()
    writer.SetInputConnection(row.GetOutputPort())
    writer.SetFileName(sys.argv[2])
    writer.Write()


if __name__ == "__main__":
    main()

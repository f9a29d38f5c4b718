# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Visibility as arrays: of the picture's pixels, and of the points of what is drawn."""

import numpy

from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData, vtkPointSet
from vtkmodules.vtkRenderingCore import vtkActor


def _array(image):
    """Rows from the bottom up."""
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width)


def read_visibility(shadow_pass, light):
    """Of the last frame, bottom row first, at the resolution that the pass drew with."""
    image = vtkImageData()
    if not shadow_pass.GetVisibilityImage(light, image):
        raise ValueError("%s is off, or no light of the renderer" % light.GetClassName())
    return _array(image)


def drawn_size(shadow_pass):
    """Width and height of the last frame. Passes around may draw at another size than they show."""
    image = vtkImageData()
    shadow_pass.GetDepthImage(image)
    return image.GetDimensions()[:2]


def point_visibility(renderer, shadow_pass, light, points):
    """What the camera sees at points in world coordinates; NaN at those that it does not see."""
    visibility = read_visibility(shadow_pass, light)
    image = vtkImageData()
    shadow_pass.GetDepthImage(image)
    depth = _array(image)
    height, width = depth.shape
    x, y, distance = _project(renderer, points, width, height)
    # The four pixels around a point, weighed as their centres are near; those of its surface count.
    column, row = numpy.floor(x - 0.5).astype(int), numpy.floor(y - 0.5).astype(int)
    slack = _slack(depth)
    total, weights = numpy.zeros(len(points)), numpy.zeros(len(points))
    for i, j in ((0, 0), (1, 0), (0, 1), (1, 1)):
        c, r = column + i, row + j
        inside = (c >= 0) & (c < width) & (r >= 0) & (r < height) & (distance > 0.0)
        c, r = numpy.where(inside, c, 0), numpy.where(inside, r, 0)
        value = visibility[r, c]
        seen = inside & numpy.isfinite(value) & (numpy.abs(depth[r, c] - distance) <= slack[r, c])
        near = (1.0 - numpy.abs(x - 0.5 - c)) * (1.0 - numpy.abs(y - 0.5 - r))
        weight = numpy.where(seen, numpy.maximum(near, 1e-6), 0.0)
        total += weight * numpy.where(seen, value, 0.0)
        weights += weight
    with numpy.errstate(invalid="ignore"):
        return (total / weights).astype(numpy.float32)


def _project(renderer, points, width, height):
    """Pixel coordinates from the lower left corner, and depths along the view direction."""
    camera = renderer.GetActiveCamera()
    to_clip = _matrix(camera.GetCompositeProjectionTransformMatrix(
        renderer.GetTiledAspectRatio(), -1.0, 1.0))
    to_view = _matrix(camera.GetModelViewTransformMatrix())
    homogeneous = numpy.column_stack([points, numpy.ones(len(points))])
    clip = homogeneous @ to_clip.T
    with numpy.errstate(divide="ignore", invalid="ignore"):
        x = (clip[:, 0] / clip[:, 3] + 1.0) * 0.5 * width
        y = (clip[:, 1] / clip[:, 3] + 1.0) * 0.5 * height
    distance = -(homogeneous @ to_view.T)[:, 2]
    outside = ~(numpy.isfinite(x) & numpy.isfinite(y)) | (numpy.abs(x) > 1e6) | (numpy.abs(y) > 1e6)
    return (numpy.where(outside, -9.0, x), numpy.where(outside, -9.0, y), distance)


def _slack(depth):
    """How far the surface of a pixel may go in depth from its centre to the neighbours'."""
    slack = numpy.zeros(depth.shape)
    for axis in (0, 1):
        step = numpy.abs(numpy.diff(depth, axis=axis))
        step = numpy.where(numpy.isfinite(step), step, numpy.inf)
        edge = numpy.full_like(numpy.take(depth, [0], axis=axis), numpy.inf)
        before = numpy.concatenate([edge, step], axis=axis)
        after = numpy.concatenate([step, edge], axis=axis)
        # A silhouette on one side says nothing of the surface; one on both, of a wire, neither.
        least = numpy.minimum(before, after)
        with numpy.errstate(invalid="ignore"):
            alike = numpy.abs(before - after) <= 0.5 * least
        thin = ~numpy.isfinite(least) | ((least > 0.05 * depth) & alike)
        slack += numpy.where(thin, 0.0, least)
    return 1.5 * slack + 1e-4 * numpy.nan_to_num(depth)


def _matrix(matrix):
    return numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def meshes(renderer):
    """The data sets that a renderer's actors and parts of assemblies draw, each with its matrix."""
    props = renderer.GetViewProps()
    for i in range(props.GetNumberOfItems()):
        prop = props.GetItemAsObject(i)
        if not prop.GetVisibility():
            continue
        prop.InitPathTraversal()
        path = prop.GetNextPath()
        while path is not None:
            node = path.GetLastNode()
            data = _drawn_data(node.GetViewProp())
            if data is not None:
                yield data, _matrix(node.GetMatrix())
            path = prop.GetNextPath()


def _drawn_data(prop):
    """What an actor draws; None for other props, and for composite data."""
    mapper = prop.GetMapper() if isinstance(prop, vtkActor) and prop.GetVisibility() else None
    if mapper is None or not mapper.GetNumberOfInputConnections(0):
        return None
    mapper.Update()
    data = mapper.GetInputDataObject(0, 0)
    return data if isinstance(data, vtkDataSet) and data.GetNumberOfPoints() else None


def world_points(data, matrix):
    """Points of a data set in world coordinates."""
    if isinstance(data, vtkPointSet):
        local = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    else:
        local = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    return numpy.column_stack([local, numpy.ones(len(local))]) @ matrix.T[:, :3]


def add_point_array(data, name, values):
    array = numpy_to_vtk(values, deep=1)
    array.SetName(name)
    data.GetPointData().AddArray(array)

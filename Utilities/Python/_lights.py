# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The extent of lights, also of those that are no vtkAreaLight."""

import math
import numbers

from vtksoftshadows import vtkAreaLight


def light_size(light):
    """What set_light_size has set: a number or, of an area light that is longer than wide, two."""
    if isinstance(light, vtkAreaLight):
        if not light.GetPositional():
            return light.GetAngularDiameter()
        width, height = (0.0, 0.0) if light.GetShape() == vtkAreaLight.POINT else light.GetSize()
        return width if width == height else (width, height)
    return vtkAreaLight.GetExtent(light)


def set_light_size(light, size):
    """Gives a light its extent, of which its penumbrae are made.

    size: of a light with a position the diameter in world units (the edge of a square area light), of
    one without the degrees under which it is seen; the sun has 0.53. 0 makes hard shadows. Two numbers,
    width and height, go to a vtkAreaLight alone.
    """
    sizes = size if isinstance(size, (tuple, list)) else (size, size)
    if len(sizes) != 2 or not all(_is_extent(value) for value in sizes):
        raise ValueError("light size: must be a finite number of at least 0, or two of them, is %r"
                         % (size,))
    is_square = sizes[0] == sizes[1]
    if not is_square and not (isinstance(light, vtkAreaLight) and light.GetPositional()):
        raise ValueError("light size: %r is of two numbers, which only an area light with a position "
                         "can have" % (size,))
    if isinstance(light, vtkAreaLight):
        if light.GetPositional():
            light.SetSize(float(sizes[0]), float(sizes[1]))
            if light.GetShape() == vtkAreaLight.POINT:
                light.SetShapeToDisk()
        else:
            light.SetAngularDiameter(float(sizes[0]))
        return
    vtkAreaLight.SetExtent(light, float(sizes[0]))


def area_light(light, size=None):
    """A vtkAreaLight with all that a light has: a disk as large as a plain one's extent, or of size."""
    area = vtkAreaLight()
    area.DeepCopy(light)
    if not isinstance(light, vtkAreaLight):
        area.SetShapeToDisk()
        set_light_size(area, light_size(light))
    if size is not None:
        set_light_size(area, size)
    return area


def _is_extent(value):
    return (isinstance(value, numbers.Real) and not isinstance(value, bool)
            and math.isfinite(value) and value >= 0.0)

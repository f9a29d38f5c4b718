#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Soft shadows in a PyVista plotter.

    pyvista_style.py              a window
    pyvista_style.py FILE.png     a picture instead

PyVista must run on the VTK that SoftShadows was built with. Without PyVista the program says so and ends
with the exit code 77.
"""

import sys

from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
from vtksoftshadows import vtkAreaLight, vtkMarchedSoftShadowPass


def add_soft_shadows(renderer, position, focal_point, size):
    """Gives any vtkRenderer (plotter.renderer is one) a square lamp and its shadows.

    position, focal_point: three world coordinates; size: edge of the lamp in world units.
    Returns the lamp and the pass, for later changes.
    """
    lamp = vtkAreaLight()
    lamp.SetPosition(position)
    lamp.SetFocalPoint(focal_point)
    lamp.SetShapeToRectangle()
    lamp.SetSize(size, size)
    renderer.AddLight(lamp)  # plotter.add_light takes pyvista.Light only

    shadows = vtkMarchedSoftShadowPass()
    steps = vtkRenderStepsPass()
    steps.SetOpaquePass(shadows)
    renderer.SetPass(steps)
    return lamp, shadows


def main():
    if len(sys.argv) > 2:
        sys.exit("usage: pyvista_style.py [FILE.png]")
    try:
        import pyvista
    except ImportError as error:
        print("PyVista cannot be imported (%s); see minimal.py for plain vtkmodules." % error)
        sys.exit(77)

    plotter = pyvista.Plotter(lighting="none", off_screen=len(sys.argv) == 2)
    plotter.add_mesh(pyvista.Plane(i_size=8.0, j_size=8.0), color="white")
    plotter.add_mesh(pyvista.Sphere(radius=0.5, center=(0.0, 0.0, 0.5)), color="tan")
    plotter.add_mesh(pyvista.Cone(center=(1.2, 0.3, 0.5), direction=(0.0, 0.0, 1.0)), color="teal")
    add_soft_shadows(plotter.renderer, (3.0, 4.0, 5.0), (0.0, 0.0, 0.0), 1.0)
    plotter.camera_position = [(2.0, -5.0, 3.0), (0.3, 0.0, 0.3), (0.0, 0.0, 1.0)]
    plotter.show(screenshot=sys.argv[1] if len(sys.argv) == 2 else False)


if __name__ == "__main__":
    main()

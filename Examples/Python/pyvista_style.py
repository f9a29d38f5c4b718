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

try:
    import pyvista
except ImportError as error:
    print("PyVista cannot be imported (%s); see minimal.py for plain vtkmodules." % error)
    sys.exit(77)

from vtksoftshadows import pyvista as softshadows


def main():
    if len(sys.argv) > 2:
        sys.exit("usage: pyvista_style.py [FILE.png]")
    plotter = pyvista.Plotter(lighting="none", off_screen=len(sys.argv) == 2)
    plotter.add_mesh(pyvista.Plane(i_size=8.0, j_size=8.0), color="white")
    plotter.add_mesh(pyvista.Sphere(radius=0.5, center=(0.0, 0.0, 0.5)), color="tan")
    plotter.add_mesh(pyvista.Cone(center=(1.2, 0.3, 0.5), direction=(0.0, 0.0, 1.0)), color="teal")
    lamp = softshadows.AreaLight(position=(3.0, 4.0, 5.0), focal_point=(0.0, 0.0, 0.0), size=1.0)
    plotter.add_light(lamp)
    softshadows.enable(plotter)
    plotter.camera_position = [(2.0, -5.0, 3.0), (0.3, 0.0, 0.3), (0.0, 0.0, 1.0)]
    plotter.show(screenshot=sys.argv[1] if len(sys.argv) == 2 else False)


if __name__ == "__main__":
    main()

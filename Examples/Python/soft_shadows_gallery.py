#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""
.. _soft_shadows_example:

Soft Shadows
~~~~~~~~~~~~

Shadows of lights that have a size, with penumbrae that widen away from what
throws them, by the package ``vtksoftshadows``.

"""

from __future__ import annotations

# sphinx_gallery_thumbnail_number = 1
import numpy as np
import pyvista as pv
from vtksoftshadows import pyvista as softshadows

# %%
# A sun over a terrain
# ++++++++++++++++++++
# A :class:`pyvista.Light` with an extent: the sun is seen under half a degree.

x, y = np.meshgrid(np.linspace(-5, 5, 201), np.linspace(-5, 5, 201))
z = 0.8 * np.sin(1.3 * x) * np.cos(0.9 * y) + 0.15 * np.sin(5 * x + 2 * y)
terrain = pv.StructuredGrid(x, y, z)

sun = softshadows.AreaLight(angular_diameter=0.53)
sun.set_direction_angle(20, 150)

pl = pv.Plotter(lighting='none')
pl.add_mesh(terrain, color='tan', smooth_shading=True, ambient=0.15)
pl.add_light(sun)
softshadows.enable(pl)
pl.camera_position = [(2, -14, 9), (0, 0, 0), (0, 0, 1)]
pl.show()

# %%
# Shadows as data
# +++++++++++++++
# How much of the sun the points of the terrain see, from 0 to 1.

pl = pv.Plotter(lighting='none', off_screen=True)
pl.add_mesh(terrain)
pl.add_light(sun.copy())
pl.view_xy()
softshadows.enable(pl)
softshadows.add_visibility(pl, name='sunlight')
pl.close()

pl = pv.Plotter()
pl.add_mesh(terrain, scalars='sunlight', cmap='cividis', lighting=False)
pl.view_xy()
pl.show()

# %%
# Studio lights
# +++++++++++++
# The key light of PyVista's light kit is large and throws the only shadow; the
# other lights brighten it. SSAO goes with it.

pl = pv.Plotter(lighting='light kit')
torus = pv.ParametricTorus(ringradius=0.7, crosssectionradius=0.25)
pl.add_mesh(torus, color='white', smooth_shading=True)
pl.add_mesh(pv.Sphere(radius=0.3, center=(0, 0, 0.6)), color='orange', smooth_shading=True)
pl.add_floor('-z', pad=1.5, color='lightgray', lighting=True)
head, key, *fills = pl.renderer.lights
for light in (head, *fills):
    light.shadow_attenuation = 0
softshadows.set_light_size(key, 15)  # degrees
softshadows.enable(pl)
pl.enable_ssao(radius=0.3, kernel_size=64)
pl.camera_position = [(0, -5, 3), (0, 0, 0), (0, 0, 1)]
pl.show()

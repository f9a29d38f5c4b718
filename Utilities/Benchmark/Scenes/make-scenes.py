#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the benchmark's scene files beside itself. Fixed seeds: the same files every time.

The meshes foliage.vtp and terrain.vtp are made by the benchmark itself when it first runs
(softshadow benchmark --write-models DIR); bunny.ply and dragon.ply are the tests'.
"""

import json
import math
import os
import random

FOLDER = os.path.dirname(os.path.abspath(__file__))
MODELS = "../../../Testing/Data/"
GREY = [0.8, 0.8, 0.8]


def ground(size, z=0.0):
    return {"source": "plane", "origin": [-size, -size, z], "point1": [size, -size, z],
            "point2": [-size, size, z], "color": GREY}


def box(x0, x1, y0, y1, z0, z1, color=(0.75, 0.6, 0.5)):
    numbers = [round(v, 4) for v in (x0, x1, y0, y1, z0, z1)]
    return {"source": "box", "bounds": numbers, "color": list(color)}


def moved(shape, x, y, z, scale=1.0):
    shape["matrix"] = [scale, 0, 0, x, 0, scale, 0, y, 0, 0, scale, z, 0, 0, 0, 1]
    return shape


def rectangle(position, focal_point, width, height, cone=60):
    return {"position": position, "focal_point": focal_point, "shape": "rectangle",
            "size": [width, height], "cone_angle": cone}


def scene(name, camera, lights, objects):
    keys = ("position", "focal_point", "view_up", "view_angle")
    document = {"version": 1, "image": {"width": 640, "height": 480},
                "camera": dict(zip(keys, camera)), "lights": lights, "objects": objects}
    with open(os.path.join(FOLDER, name + ".json"), "w", encoding="ascii") as file:
        file.write("{\n")
        items = list(document.items())
        for i, (key, value) in enumerate(items):
            comma = "" if i + 1 == len(items) else ","
            if isinstance(value, list):
                lines = ",\n".join("    " + json.dumps(item) for item in value)
                file.write(f'  "{key}": [\n{lines}\n  ]{comma}\n')
            else:
                file.write(f'  "{key}": {json.dumps(value)}{comma}\n')
        file.write("}\n")


def foliage():
    scene("foliage", ([3.2, -5.4, 4.2], [0, 0, 0.8], [0, 0, 1], 30),
          [rectangle([2, -1, 6], [0, 0, 0], 0.6, 0.6)],
          [ground(20), {"file": "foliage.vtp", "color": [0.35, 0.6, 0.3]}])


def bunny():
    scene("bunny", ([6, 16, 36], [2.2, 3.4, 0], [0, 1, 0], 22),
          [{"position": [-17, 27, 9], "focal_point": [0, 3, 0], "shape": "rectangle",
            "size": [3, 3], "cone_angle": 50}],
          [{"file": MODELS + "bunny.ply", "color": [0.86, 0.76, 0.64]},
           {"source": "plane", "origin": [-400, 0, 400], "point1": [400, 0, 400],
            "point2": [-400, 0, -400], "color": GREY}])


def dragon():
    ground_y = 0.0529
    scene("dragon", ([0.1, 0.28, 0.46], [0, 0.1, 0], [0, 1, 0], 30),
          [{"position": [-0.16, 0.42, 0.16], "focal_point": [0, 0.1, 0], "shape": "rectangle",
            "size": [0.16, 0.16], "cone_angle": 60}],
          [{"file": MODELS + "dragon.ply", "color": [0.7, 0.75, 0.6]},
           {"source": "plane", "origin": [-4, ground_y, 4], "point1": [4, ground_y, 4],
            "point2": [-4, ground_y, -4], "color": GREY}])


def assembly():
    """A base plate with ribs, bolts, a shaft in bearings, a ring: fine parts in contact."""
    steel = [0.65, 0.68, 0.72]
    parts = [ground(30), box(-2, 2, -1.2, 1.2, 0, 0.15, steel)]
    for i in range(9):
        x = -1.8 + 0.45 * i
        parts.append(box(x - 0.02, x + 0.02, -0.9, 0.9, 0.15, 0.3, steel))
    for x in (-1.85, 1.85):
        for y in (-1.05, 1.05):
            parts.append(upright(x, y, 0.19, 0.09, 0.08, 6))
            parts.append(upright(x, y, 0.28, 0.045, 0.12, 24))
    for x in (-1.2, 1.2):
        parts.append(box(x - 0.12, x + 0.12, -0.35, 0.35, 0.3, 0.95, steel))
    shaft = {"source": "cylinder", "radius": 0.12, "height": 3.2, "resolution": 64,
             "color": [0.8, 0.75, 0.6], "matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0.95,
                                                   0, 0, 0, 1]}
    parts.append(shaft)
    ring = {"source": "torus", "ring_radius": 0.45, "cross_section_radius": 0.06,
            "u_resolution": 64, "v_resolution": 24, "color": [0.7, 0.4, 0.3],
            "matrix": [0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0.95, 0, 0, 0, 1]}
    parts.append(ring)
    for i in range(8):
        angle = 2 * math.pi * i / 8
        parts.append({"source": "sphere", "center": [0, round(0.28 * math.cos(angle), 4),
                                                     round(0.95 + 0.28 * math.sin(angle), 4)],
                      "radius": 0.05, "theta_resolution": 24, "phi_resolution": 24,
                      "color": steel})
    scene("assembly", ([3.5, -5, 3.6], [0, 0, 0.4], [0, 0, 1], 28),
          [rectangle([-2.5, -2, 5], [0, 0, 0], 0.7, 0.7, 50)], parts)


def upright(x, y, z, radius, height, resolution):
    """A cylinder along z with its middle at (x, y, z)."""
    return {"source": "cylinder", "radius": radius, "height": height, "resolution": resolution,
            "color": [0.65, 0.68, 0.72],
            "matrix": [1, 0, 0, x, 0, 0, -1, y, 0, 1, 0, z, 0, 0, 0, 1]}


def street():
    """Boxes along a street to the horizon, a sun."""
    numbers = random.Random(3)
    boxes = [ground(2000)]
    for row in range(40):
        for side in (-1, 1):
            y = 6.0 + 14.0 * row
            near = 6.0 + numbers.uniform(0, 2)
            height = numbers.uniform(5, 24)
            xs = sorted((side * near, side * (near + numbers.uniform(6, 12))))
            boxes.append(box(xs[0], xs[1], y, y + numbers.uniform(7, 12), 0, height))
            boxes.append(box(side * 4.5 - 0.08, side * 4.5 + 0.08, y, y + 0.16, 0, 5,
                             (0.3, 0.3, 0.3)))
    scene("street", ([1.5, -8, 3.0], [0.5, 40, 4], [0, 0, 1], 45),
          [{"directional": True, "position": [-0.6, -0.45, 0.66], "focal_point": [0, 0, 0],
            "angular_diameter": 2.0}], boxes)


def fence():
    """Posts and rails under a light near the horizon: long shadows at a grazing angle."""
    wood = (0.6, 0.45, 0.3)
    parts = [ground(60)]
    for i in range(25):
        x = -3 + 0.25 * i
        parts.append(box(x - 0.05, x + 0.05, -0.02, 0.02, 0, 1.0, wood))
    for z in (0.3, 0.75):
        parts.append(box(-3.1, 3.1, 0.02, 0.06, z - 0.04, z + 0.04, wood))
    scene("fence", ([2.5, -6.5, 3.2], [0, -1.2, 0.2], [0, 0, 1], 35),
          [rectangle([-2, 9, 2.6], [0, 0, 0], 0.5, 0.5, 40)], parts)


def fused():
    """Blockers at very different depths whose penumbrae overlap."""
    numbers = random.Random(5)
    parts = [ground(30)]
    for i in range(14):
        z = 0.15 + 3.2 * (i / 13) ** 1.5
        x, y = numbers.uniform(-0.9, 0.9), numbers.uniform(-0.9, 0.9)
        half = numbers.uniform(0.12, 0.35)
        parts.append(box(x - half, x + half, y - half, y + half, z, z + 0.02))
    scene("fused", ([3.5, -5.5, 5], [0, 0, 0.6], [0, 0, 1], 30),
          [rectangle([0.3, 0.2, 5], [0, 0, 0], 1.2, 1.2)], parts)


def lights():
    """Five lights of all kinds over a few solids."""
    parts = [ground(30), box(-0.4, 0.4, -0.4, 0.4, 0, 0.8),
             {"source": "sphere", "center": [1.3, 0.3, 0.5], "radius": 0.5,
              "theta_resolution": 64, "phi_resolution": 64, "color": [0.5, 0.6, 0.8]},
             {"source": "cone", "center": [-1.3, 0.2, 0.5], "radius": 0.5, "height": 1,
              "resolution": 48, "direction": [0, 0, 1], "color": [0.8, 0.6, 0.6]},
             moved({"source": "torus", "ring_radius": 0.5, "cross_section_radius": 0.12,
                    "color": [0.6, 0.8, 0.6]}, 0.2, -1.2, 0.12)]
    all_lights = [rectangle([3, -3, 4], [0, 0, 0], 0.8, 0.3),
                  {"position": [-3, -2, 4], "focal_point": [0, 0, 0], "shape": "disk",
                   "size": [0.6, 0.6], "cone_angle": 45},
                  {"position": [0, 3, 3], "focal_point": [0, 0, 0], "shape": "point",
                   "cone_angle": 40},
                  {"directional": True, "position": [1, 2, 4], "focal_point": [0, 0, 0],
                   "angular_diameter": 4},
                  rectangle([0, -1, 5], [0, 0, 0], 0.2, 1.2)]
    for light in all_lights:
        light["intensity"] = 0.3
    scene("lights", ([2.5, -5, 3.5], [0, -0.2, 0.3], [0, 0, 1], 32), all_lights, parts)


def molecule():
    """Spheres in a double helix with rungs, over a ground."""
    parts = [ground(30)]
    colors = ([0.8, 0.3, 0.3], [0.3, 0.4, 0.8], [0.75, 0.75, 0.75])
    for i in range(36):
        angle = 2 * math.pi * i / 11
        z = 0.25 + 0.085 * i
        for strand in (0, 1):
            a = angle + math.pi * strand
            parts.append(ball(0.8 * math.cos(a), 0.8 * math.sin(a), z, 0.19, colors[strand]))
        for step in (-0.4, 0.0, 0.4):
            parts.append(ball(step * math.cos(angle), step * math.sin(angle), z, 0.12, colors[2]))
    scene("molecule", ([4.5, -6.5, 4.5], [0, 0, 1.3], [0, 0, 1], 32),
          [{"position": [3, 2, 6], "focal_point": [0, 0, 1], "shape": "disk", "size": [0.8, 0.8],
            "cone_angle": 50}], parts)


def ball(x, y, z, radius, color):
    return {"source": "sphere", "center": [round(x, 4), round(y, 4), round(z, 4)],
            "radius": radius, "theta_resolution": 24, "phi_resolution": 24, "color": color}


def terrain():
    scene("terrain", ([0, -9, 4.5], [0, 0, 0], [0, 0, 1], 35),
          [{"directional": True, "position": [-2.4, 1, 0.9], "focal_point": [0, 0, 0],
            "angular_diameter": 3}],
          [{"file": "terrain.vtp", "color": [0.6, 0.65, 0.5]}])


if __name__ == "__main__":
    for make in (assembly, bunny, dragon, fence, foliage, fused, lights, molecule, street,
                 terrain):
        make()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Turns the results.json of a graphics card (see gpu-bundle.sh) into a part of SpeedAgainstError.md."""

import argparse
import json
import math
import sys

MOTIONS = ("still", "camera", "light")
LIMIT = 4.0  # milliseconds, the goal for a frame in which camera and lights move


def number(value, digits=3):
    """As short as its digits allow; a dash for what was not measured."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return "-"
    return f"{value:.{digits}g}" if abs(value) < 10**digits else f"{value:.0f}"


def write_scene(scene):
    """The lines of a scene."""
    if "failure" in scene:
        return [f"### {scene['name']}", "", f"Broken: {scene['failure']}", ""]
    lines = [
        f"### {scene['name']}",
        "",
        "| contestant | light | camera | still | steps, light | RMSE |",
        "| :--- | ---: | ---: | ---: | ---: | ---: |",
    ]
    over = []
    for contestant in scene["contestants"]:
        name = contestant["name"]
        if contestant.get("failure"):
            lines.append(f"| {name} | {contestant['failure']} | | | | |")
            continue
        times = contestant.get("milliseconds", {})
        still, camera, light = (times.get(motion, {}).get("median") for motion in MOTIONS)
        steps = sum(contestant.get("steps", {}).values()) or None
        lines.append(
            f"| {name} | {number(light)} | {number(camera)} | {number(still)} "
            f"| {number(steps)} | {number(contestant.get('rmse'))} |"
        )
        if name.split()[0] not in ("plain", "vtk") and max(camera or 0.0, light or 0.0) > LIMIT:
            over.append(name)
    lines += ["", "Over 4 ms with moving lights or camera: " + (", ".join(over) or "none") + ".", ""]
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results")
    arguments = parser.parse_args()
    with open(arguments.results, encoding="utf-8") as file:
        document = json.load(file)
    own = document["soft_shadows"]
    context = document["context"]
    first = next(scene for scene in own["scenes"] if "failure" not in scene)
    lines = [
        f"Measured on {context['opengl']}, VTK {context['vtk']}, {context['date'][:10]}, "
        f"{first['width']} x {first['height']} pixels, every technique at its defaults. Times are medians of frames in "
        "milliseconds by the wall clock; steps are what timer queries say of a frame with moving lights.",
        "",
    ]
    for scene in own["scenes"]:
        lines += write_scene(scene)
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())

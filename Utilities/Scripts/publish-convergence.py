#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures how every technique converges on every scene of the benchmark, and fills the tables of
Documentation/Techniques/Convergence.md.

Figures are errors against ray tracing, which no load of the machine changes. Each one is kept in a file as
soon as it is measured, and not measured again: a run that was stopped goes on where it was.
"""

import argparse
import json
import os
import subprocess
import sys

SCENES = "assembly bunny dragon fence foliage fused lights molecule street terrain".split()
TECHNIQUES = "pcss marched sssm ssabss pvssm sampled sbfs cascaded fassalss".split()
# Techniques of many points take few of them for each of 64 parts, which makes 256 points and more.
FEW_POINTS = {
    "sampled": ["samples=4"],
    "cascaded": ["edge_0=2", "edge_1=2", "edge_2=2"],
    "fassalss": ["level=0"],
}
TOLERANCES = (0.02, 0.01)
GOAL = 0.01
DOCUMENT = "Documentation/Techniques/Convergence.md"


class Bench:
    """The program, its references and what it has measured so far."""

    def __init__(self, arguments):
        self.arguments = arguments
        os.makedirs(arguments.output, exist_ok=True)
        self.models = os.path.join(arguments.output, "models")
        self.store = os.path.join(arguments.output, "convergence.json")
        self.figures = {}
        if os.path.exists(self.store):
            with open(self.store, encoding="utf-8") as file:
                self.figures = json.load(file)

    def run(self, *words):
        command = [self.arguments.tool, *map(str, words)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: {done.stderr.strip()[-500:]}")

    def scene(self, name):
        """The words that name a scene, its models and its size."""
        file = os.path.join("Utilities/Benchmark/Scenes", name + ".json")
        size = self.arguments.size
        return [file, "--models", self.models, "--width", size[0], "--height", size[1]]

    def reference(self, name):
        if not os.path.exists(self.models):
            self.run("benchmark", "--write-models", self.models)
        path = os.path.join(self.arguments.output, name + ".exr")
        if not os.path.exists(path):
            self.run("reference", *self.scene(name), "-o", path, "--samples", 1024)
        return path

    def compare(self, name, candidate):
        """The worst of the lights, measure by measure."""
        report = os.path.join(self.arguments.output, "compare.json")
        self.run("compare", self.reference(name), candidate, "--report", report)
        with open(report, encoding="utf-8") as file:
            lights = json.load(file)["lights"]
        pixels = sum(light["all"]["pixels"] for light in lights)
        squares = sum(light["all"]["pixels"] * (light["all"]["rmse"] or 0) ** 2 for light in lights)
        return {
            "rmse": (squares / max(pixels, 1)) ** 0.5,
            "worst_tile": max(light["worst_tile"] for light in lights),
            "worst_tile_all": max(light["worst_tile_with_left_out"] for light in lights),
        }

    def measure(self, key, name, words):
        """Renders a scene and compares it; the figures under that key."""
        if key not in self.figures:
            picture = os.path.join(self.arguments.output, "candidate.exr")
            report = os.path.join(self.arguments.output, "report.json")
            try:
                self.run("render", *self.scene(name), *words, "--visibility", picture, "--report", report)
                self.figures[key] = self.compare(name, picture)
                with open(report, encoding="utf-8") as file:
                    self.figures[key].update(json.load(file).get("converge", {}))
            except RuntimeError as error:
                print(f"{key}: {error}", file=sys.stderr)
                return None
            with open(self.store + ".part", "w", encoding="utf-8") as file:
                json.dump(self.figures, file, indent=1)
            os.replace(self.store + ".part", self.store)
            print(key, self.figures[key], flush=True)
        return self.figures[key]

    def split(self, name, technique, parts, texels):
        words = ["--technique", technique, "--option", "weights=mean", "--option", f"split={parts}"]
        words += ["--option", f"map_size={texels}"]
        for option in FEW_POINTS.get(technique, []) if parts > 1 else []:
            words += ["--option", option]
        return self.measure(f"{name} {technique} split={parts} {texels}", name, words)

    def rest(self, name, tolerance):
        words = ["--technique", "marched", "--option", "map_size=2048", "--converge", tolerance]
        return self.measure(f"{name} converge={tolerance}", name, words)


def cell(lookup, key):
    """Bold over the goal, with what maps of twice the size make of it; a dash where nothing was measured."""
    figures, finer = lookup(f"{key} 2048"), lookup(f"{key} 4096")
    if figures is None:
        return "-"
    text = f"{figures['rmse']:.4f}"
    text = f"**{text}**" if figures["rmse"] > GOAL else text
    return text + (f" ({finer['rmse']:.4f})" if finer else "")


def split_table(lookup):
    lines = ["| | " + " | ".join(SCENES) + " |", "| --- " * (len(SCENES) + 1) + "|"]
    for technique in TECHNIQUES:
        row = [cell(lookup, f"{name} {technique} split=8") for name in SCENES]
        lines.append(f"| `{technique}` | " + " | ".join(row) + " |")
    return "\n".join(lines)


def rest_table(lookup):
    heads = "scene | tolerance | points | converged | estimate | true | true / estimate | with silhouettes | RMSE"
    lines = [f"| {heads} |", "| --- " * 9 + "|"]
    for name in SCENES:
        for tolerance in TOLERANCES:
            figures = lookup(f"{name} converge={tolerance}")
            if figures is None:
                continue
            estimate, true = figures["estimated_error"], figures["worst_tile"]
            cells = [name, tolerance, figures["points"], "yes" if figures["converged"] else "no: maps"]
            cells += [f"{estimate:.4f}", f"{true:.4f}", f"{true / estimate:.2f}"]
            cells += [f"{figures['worst_tile_all']:.4f}", f"{figures['rmse']:.4f}"]
            lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def fill_document(bench):
    lookup = bench.figures.get
    blocks = {
        "split-8": split_table(lookup),
        "resting": rest_table(lookup),
    }
    words = []
    for name, text in blocks.items():
        path = os.path.join(bench.arguments.output, name + ".md")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text + "\n")
        words += ["--block", f"{name}={path}"]
    subprocess.run([sys.executable, "Utilities/Scripts/fill-document.py", DOCUMENT, *words], check=True)


def measure_all(bench):
    for technique in TECHNIQUES:
        for name in SCENES:
            bench.split(name, technique, 8, 2048)
    for name in SCENES:
        for tolerance in TOLERANCES:
            bench.rest(name, tolerance)
    for technique in TECHNIQUES:
        for name in SCENES:
            eighth = bench.split(name, technique, 8, 2048)
            if eighth and eighth["rmse"] > GOAL:
                bench.split(name, technique, 8, 4096)


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tool", default="build/bin/softshadow", help="the program")
    parser.add_argument("--output", default="build/convergence", help="folder of references and figures")
    parser.add_argument("--size", type=int, nargs=2, default=(160, 120), help="pixels")
    parser.add_argument("--document-only", action="store_true", help="only fill the document")
    bench = Bench(parser.parse_args())
    if not bench.arguments.document_only:
        measure_all(bench)
    fill_document(bench)


if __name__ == "__main__":
    main()

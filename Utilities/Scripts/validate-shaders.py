#!/usr/bin/env python3
"""Judges shader programs that Mesa wrote down (MESA_SHADER_CAPTURE_PATH): check-shaders.sh calls it.

Usage: validate-shaders.py <folder>

The folder has a folder for each run, named NUMBER-DRIVER; a driver whose name ends in gl32 has no textureGather.
Every program is compiled and linked by glslangValidator, Khronos' reference compiler, as what its version line
says. Every line of code in the .glsl files of Modules must stand in one of the programs, after the directives of the
preprocessor: what no program has was not compiled.
"""

import hashlib
import os
import re
import subprocess
import sys

STAGES = {"vertex": "vert", "geometry": "geom", "fragment": "frag"}
GATHER = "GL_ARB_texture_gather"
# The compiler knows gl_Layer in vertex shaders by another extension, and only from a later version on.
LAYER = "GL_AMD_vertex_shader_layer"
KNOWN_LAYER = "GL_ARB_shader_viewport_layer_array"
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def split(path):
    """The stages of a captured program: pairs of an ending and a text."""
    stages = []
    with open(path, encoding="utf-8", errors="replace") as file:
        parts = re.split(r"^\[(\w+)(?: shader)?\]\n", file.read(), flags=re.M)
    for name, text in zip(parts[1::2], parts[2::2]):
        if name in STAGES:
            stages.append((STAGES[name], text))
    return stages


def compile_program(stages, folder, gathers):
    """The compiler's complaints, or nothing."""
    files = []
    layered = any(LAYER in text for _, text in stages)
    for ending, text in stages:
        # glslang knows the extension whatever a driver has.
        text = text if gathers else text.replace(GATHER, "GL_absent_extension")
        if layered: # all stages are of one version
            text = text.replace(LAYER, KNOWN_LAYER).replace("#version 150", "#version 410")
        files.append(os.path.join(folder, "program." + ending))
        with open(files[-1], "w", encoding="utf-8") as file:
            file.write(text)
    done = subprocess.run(
        ["glslangValidator", "-l", *files],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
        text=True,
    )
    return "" if done.returncode == 0 else done.stdout


def line_of(line):
    """A line as it is compared: without comment, and with VTK's names of outputs."""
    line = re.sub(r"//.*", "", line)
    return re.sub(r"\s+", " ", re.sub(r"gl_FragData\[(\d)\]", r"fragOutput\1", line)).strip()


def lines_behind_directives(text, gathers):
    """The lines of a shader that its #if leave."""
    text = re.sub(r"^\s*#\s*(version|extension|error).*$", "", text, flags=re.M)
    done = subprocess.run(
        ["cpp", "-undef", "-P", "-w", "-fdirectives-only"] + (["-D" + GATHER] if gathers else []),
        input=text,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        check=True,
        text=True,
    )
    return {line_of(line) for line in done.stdout.splitlines()}


def find_shaders():
    """All .glsl files of the library."""
    for folder, _, names in os.walk(os.path.join(ROOT, "Modules")):
        for name in sorted(names):
            if name.endswith(".glsl"):
                yield os.path.relpath(os.path.join(folder, name), ROOT)


def missing_lines(path, compiled):
    """Numbers and texts of lines of code that no program has."""
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            code = line_of(line)
            if code and not code.startswith("#") and not re.fullmatch(r"[{}();]*", code):
                if code not in compiled:
                    yield number, code


def main():
    """Judges the folder."""
    folder = sys.argv[1]
    seen, compiled, bad = set(), set(), 0
    for run in sorted(os.listdir(folder)):
        path = os.path.join(folder, run)
        if not os.path.isdir(path):
            continue
        gathers = not run.endswith("gl32")
        for name in sorted(os.listdir(path)):
            stages = split(os.path.join(path, name))
            text = "".join(text for _, text in stages)
            key = hashlib.sha256((text + str(gathers)).encode()).digest()
            if key in seen:
                continue
            seen.add(key)
            complaints = compile_program(stages, folder, gathers)
            if complaints:
                bad += 1
                print(f"{os.path.join(path, name)}:\n{complaints}")
            for _, stage in stages:
                compiled |= lines_behind_directives(stage, gathers)
    files, missing = 0, 0
    for path in find_shaders():
        files += 1
        for number, code in missing_lines(path, compiled):
            missing += 1
            print(f"{path}:{number}: in no program: {code}")
    print(f"shaders: {len(seen)} programs of {files} files, {bad} refused, {missing} lines not compiled")
    sys.exit(0 if seen and not bad and not missing else 1)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Draws which rooms (modules) include headers of which others, in Graphviz' language.

Usage: draw-includes.py [--classes ROOM] [source folder]        (| dot -Tsvg > includes.svg)

An edge's label is the number of includes. Tests are left out. With --classes the drawing is of one
room's own headers and sources, by class. The exit code is 1 if arrows run in a circle.
"""

import argparse
import collections
import pathlib
import re
import sys

INCLUDE = re.compile(r'^#include "(\w+)\.h"', re.MULTILINE)


def read_sources(root):
    """Room and includes of every source, by path."""
    sources = {}
    for path in sorted((root / "Modules").glob("*/*")):
        if path.suffix in (".h", ".cxx"):
            sources[path] = (path.parent.name, INCLUDE.findall(path.read_text(encoding="ascii")))
    return sources


def count_edges(sources, room):
    """Includes between rooms or, with a room, between its classes."""
    homes = {path.stem: home for path, (home, _) in sources.items()}
    edges = collections.Counter()
    for path, (home, includes) in sources.items():
        for name in includes:
            if room and home == room and homes.get(name) == room and name != path.stem:
                edges[path.stem, name] += 1
            elif not room and homes.get(name, home) != home:
                edges[home, homes[name]] += 1
    return edges


def find_circle(edges):
    """A list of nodes that lead back to the first one; empty if there is none."""
    after = collections.defaultdict(list)
    for source, target in edges:
        after[source].append(target)
    done = set()

    def walk(node, way):
        if node in way:
            return way[way.index(node):] + [node]
        if node in done:
            return []
        for target in after[node]:
            circle = walk(target, way + [node])
            if circle:
                return circle
        done.add(node)
        return []

    for node in list(after):
        circle = walk(node, [])
        if circle:
            return circle
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--classes", metavar="ROOM")
    parser.add_argument("folder", nargs="?", default=pathlib.Path(__file__).parents[2])
    options = parser.parse_args()
    edges = count_edges(read_sources(pathlib.Path(options.folder)), options.classes)
    print("digraph includes {")
    for (source, target), count in sorted(edges.items()):
        print(f'  "{source}" -> "{target}" [label={count}];')
    print("}")
    circle = find_circle(edges)
    if circle:
        print("circle: " + " -> ".join(circle), file=sys.stderr)
    return 1 if circle else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts generated text into a document, and the pictures that it shows beside it.

A block is everything between the lines <!-- generated: NAME --> and <!-- end: NAME -->; it is replaced
by the file's text. Headings keep their levels. Blocks whose file is missing stay as they are, and are named.
"""

import argparse
import os
import re
import shutil
import sys


def replace_block(text, name, content):
    """The text with the block's content replaced. Raises ValueError if there is no such block."""
    begin, end = f"<!-- generated: {name} -->", f"<!-- end: {name} -->"
    first, last = text.find(begin), text.find(end)
    if first < 0 or last < first:
        raise ValueError(f"no block {name}")
    return text[: first + len(begin)] + "\n\n" + content.strip() + "\n\n" + text[last:]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("document")
    parser.add_argument("--block", action="append", default=[], help="NAME=FILE")
    parser.add_argument("--images", help="folder of the pictures that the blocks show")
    arguments = parser.parse_args()
    with open(arguments.document, encoding="utf-8") as file:
        text = file.read()
    missing = []
    for block in arguments.block:
        name, _, path = block.partition("=")
        if not os.path.exists(path):
            missing.append(path)
            continue
        with open(path, encoding="utf-8") as file:
            text = replace_block(text, name, file.read())
    with open(arguments.document + ".part", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(arguments.document + ".part", arguments.document)
    folder = os.path.dirname(arguments.document)
    for image in re.findall(r"\]\(Images/([^)]*)\)", text):
        source = os.path.join(arguments.images or "", image)
        if arguments.images and os.path.exists(source):
            os.makedirs(os.path.join(folder, "Images"), exist_ok=True)
            shutil.copy(source, os.path.join(folder, "Images", image))
    for path in missing:
        print(f"{arguments.document}: {path} is missing, its block was left as it was", file=sys.stderr)
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tightens the tolerances of the hard cases to what a run measured.

Reads the tables of Documentation/Stability.md, printed by SoftShadowsStability, and writes
Testing/Stability/HardCaseTolerances.inc: each tolerance becomes 1.25 times the measured error, rounded up to
0.001, but no less than the row's floor and no more than it was. Errors above their tolerance change nothing; they
are named, and the exit code is 1. A new case gets a row by hand, with tolerances of 1.
"""

import math
import re
import sys

DOCUMENT = "Documentation/Stability.md"
TABLE = "Testing/Stability/HardCaseTolerances.inc"
HEADROOM = 1.25


def read_errors(path):
    """The measured errors of each case; what follows the first table with a case repeats it as changes."""
    errors = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            cells = [cell.strip().strip("*") for cell in line.strip().strip("|").split("|")]
            figures = cells[2:]
            if len(figures) > 2 and all(re.fullmatch(r"\d+\.\d+", figure) for figure in figures):
                errors.setdefault(cells[0], [float(figure) for figure in figures])
    return errors


def tighten(tolerance, error, floor):
    """The tolerance that an error asks for; None if it is above the present one."""
    if error > tolerance:
        return None
    return min(tolerance, max(floor, math.ceil(1000.0 * HEADROOM * error) / 1000.0))


def main():
    errors = read_errors(sys.argv[1] if len(sys.argv) > 1 else DOCUMENT)
    lines, above = [], []
    with open(TABLE, encoding="utf-8") as file:
        for line in file:
            row = re.fullmatch(r'\{ "([^"]+)", ([\d.]+), \{ (.*) \} \},\n', line)
            if not row or row[1] not in errors:
                lines.append(line)
                continue
            tolerances = [float(text) for text in row[3].split(", ")]
            new = [tighten(t, e, float(row[2])) for t, e in zip(tolerances, errors[row[1]])]
            above += [f"{row[1]}: {e} above {t}" for n, t, e in zip(new, tolerances, errors[row[1]]) if n is None]
            new = [t if n is None else n for n, t in zip(new, tolerances)]
            lines.append(f'{{ "{row[1]}", {row[2]}, {{ {", ".join(f"{n:.3f}" for n in new)} }} }},\n')
    with open(TABLE, "w", encoding="utf-8") as file:
        file.writelines(lines)
    print("\n".join(above), end="\n" if above else "")
    return 1 if above else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The techniques, their options and qualities by name: the table of the command-line tool."""

import json
import pathlib
from collections import namedtuple

Technique = namedtuple("Technique", "class_name meaning options qualities")
Option = namedtuple("Option", "property index kind least most choices meaning")


def _option(table):
    choices = table.get("choices", ())
    return Option(table["property"], table.get("index"), table["kind"], table.get("least"),
                  table.get("most"), tuple(choices), table["meaning"])


def _technique(table):
    options = {option["name"]: _option(option) for option in table["options"]}
    return Technique(table["class"], table["meaning"], options, table["qualities"])


_table = json.loads(pathlib.Path(__file__).with_suffix(".json").read_text(encoding="ascii"))

# A technique's qualities are settings by name; None where it has none of that class.
TECHNIQUES = {table["name"]: _technique(table) for table in _table["techniques"]}

# The largest error of each class of qualities.
QUALITIES = {quality["name"]: quality["largest_error"] for quality in _table["qualities"]}

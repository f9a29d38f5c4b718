# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Passes by the name of their technique, with options by name: what the command-line tool takes."""

import difflib
import math
import numbers

from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLRenderPass

import vtksoftshadows

from ._techniques import QUALITIES, TECHNIQUES, Option

AUTO = "auto"

# What "auto" stands for: where OpenGL draws on the processor, and on a graphics card.
_ON_PROCESSOR, _ON_CARD = "traced", "cascaded"

# As the names of software rasterisers have it in GL_RENDERER, in small letters.
_RASTERISERS = ("llvmpipe", "softpipe", "lavapipe", "swrast", "swr (", "swiftshader", "software",
                "gdi generic", "microsoft basic render")


def candidates(technique):
    """The names that a technique may turn out to be."""
    if technique == AUTO:
        return [name for name in (_ON_PROCESSOR, _ON_CARD) if name in TECHNIQUES]
    return [technique]


def choose(technique, window):
    """The name of a technique; what "auto" is in a window whose context exists."""
    if technique != AUTO:
        return technique
    capabilities = window.ReportCapabilities().lower()
    names = [line for line in capabilities.splitlines() if "renderer string" in line]
    on_processor = any(name in line for line in names for name in _RASTERISERS)
    return _ON_PROCESSOR if on_processor and _ON_PROCESSOR in TECHNIQUES else _ON_CARD


def check(technique, tolerance, options):
    """Raises what make_pass would, before there is a window."""
    for name in candidates(technique):
        try:
            make_pass(name, tolerance, options)
        except TypeError as error:
            if technique != AUTO:
                raise
            raise TypeError("technique 'auto' may be any of %s, and takes what all of them do: %s"
                            % (", ".join(candidates(technique)), error)) from None


def make_pass(technique, tolerance=None, options=None):
    """A pass of a technique with the settings that meet the tolerance, and the options on top."""
    if technique not in TECHNIQUES:
        if technique == _ON_PROCESSOR:
            raise ValueError("technique 'traced' is not built here: it needs Embree 3 or 4")
        raise ValueError("there is no technique %r; %s"
                         % (technique, _suggest(technique, [AUTO, *TECHNIQUES])))
    shadow_pass = getattr(vtksoftshadows, TECHNIQUES[technique].class_name)()
    if tolerance is not None:
        for name, text in _settings_for(technique, tolerance).items():
            option = TECHNIQUES[technique].options[name]
            value = text if option.kind in ("flag", "choice") else float(text)
            set_option(shadow_pass, technique, name, value)
    for name, value in (options or {}).items():
        set_option(shadow_pass, technique, name, value)
    return shadow_pass


def set_option(shadow_pass, technique, name, value):
    """Sets an option of the tool, or a property of the pass's class in snake case."""
    option = TECHNIQUES[technique].options.get(name)
    if option is None:
        _set_property(shadow_pass, technique, name, value)
        return
    setter = getattr(shadow_pass, "Set" + option.property)
    value = _value_of(name, value, option)
    if option.index is None:
        setter(value)
    else:
        setter(option.index, value)


def _settings_for(technique, tolerance):
    """The settings of the cheapest quality whose class of errors is within the tolerance."""
    if not _is_number(tolerance) or not tolerance > 0.0:
        raise ValueError("tolerance: must be a positive number, is %r" % (tolerance,))
    within = [name for name, error in QUALITIES.items() if error <= tolerance]
    if not within:
        raise ValueError("tolerance: %g is less than %g, the least error that there are settings for; "
                         "progressive=True converges to less while nothing changes"
                         % (tolerance, min(QUALITIES.values())))
    settings = TECHNIQUES[technique].qualities[max(within, key=QUALITIES.get)]
    if settings is None:
        raise ValueError("technique '%s' has no settings for tolerance %g; cascaded has"
                         % (technique, tolerance))
    return settings


def _is_number(value):
    return (isinstance(value, numbers.Real) and not isinstance(value, bool)
            and math.isfinite(value))


def _value_of(name, value, option):
    """What the setter takes for a value; an error that names the option if it takes none."""
    if option.kind == "choice":
        if value not in option.choices:
            raise ValueError("option '%s': must be %s, is %r"
                             % (name, " or ".join(option.choices), value))
        return option.choices.index(value)
    if option.kind == "flag":
        return _flag_of(name, value)
    whole = option.kind == "integer"
    if not _is_number(value) or not option.least <= value <= option.most or (
            whole and value != int(value)):
        raise ValueError("option '%s': must be a %snumber from %g to %g, is %r"
                         % (name, "whole " if whole else "", option.least, option.most, value))
    return int(value) if whole else float(value)


def _flag_of(name, value):
    flags = {"on": True, "off": False, True: True, False: False}
    try:
        return flags[value]
    except (KeyError, TypeError):
        raise ValueError("option '%s': must be True or False, is %r" % (name, value)) from None


def _properties(shadow_pass):
    """Names of the numbers and flags of a pass, and their values, by the names of options."""
    found = {}
    for name in dir(shadow_pass):
        if name.startswith("Set") and hasattr(shadow_pass, "Get" + name[3:]) and not hasattr(
                vtkOpenGLRenderPass, name):
            try:
                value = getattr(shadow_pass, "Get" + name[3:])()
            except TypeError:
                continue  # it takes an index
            if isinstance(value, (bool, int, float)):
                found[_snake(name[3:])] = (name[3:], value)
    return found


def _snake(name):
    return "".join("_" + c.lower() if c.isupper() else c for c in name).lstrip("_")


def _set_property(shadow_pass, technique, name, value):
    known = _properties(shadow_pass)
    if name not in known:
        raise TypeError("technique '%s' has no option '%s'; %s" % (
            technique, name, _suggest(name, [*TECHNIQUES[technique].options, *known])))
    property_name, before = known[name]
    limits = [getattr(shadow_pass, "Get%s%sValue" % (property_name, end), None)
              for end in ("Min", "Max")]
    kind = {bool: "flag", int: "integer", float: "number"}[type(before)]
    least = limits[0]() if limits[0] else -math.inf
    most = limits[1]() if limits[1] else math.inf
    option = Option(property_name, None, kind, least, most, (), "")
    getattr(shadow_pass, "Set" + property_name)(_value_of(name, value, option))


def _suggest(name, known):
    near = difflib.get_close_matches(str(name), known, 1)
    start = "did you mean '%s'? There are " % near[0] if near else "there are "
    return start + ", ".join(known)

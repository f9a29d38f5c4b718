# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Soft shadows of a vtkRenderer in a line, whatever else it draws with.

    from vtksoftshadows import rendering as softshadows

    softshadows.enable(renderer, light_size=0.5)
    window.Render()
    visibility = softshadows.visibility(renderer, light)

The same names for PyVista's plotters are in vtksoftshadows.pyvista.
"""

import contextlib
import weakref

from vtkmodules.vtkCommonCore import vtkWeakReference

from . import _results, _settings
from ._chain import Chain, alone
from ._lights import area_light, light_size, set_light_size
from ._techniques import TECHNIQUES

__all__ = ["SoftShadows", "TECHNIQUES", "add_visibility", "area_light", "disable", "enable",
           "light_size", "set_light_size", "shadows_of", "visibility"]

# By the renderers' addresses. Observers of the renderers hold them, so they die with these: attributes
# of a renderer's Python object would not.
_ALL = weakref.WeakValueDictionary()


class SoftShadows:
    """What enable has switched on in a renderer.

    technique    its name; "auto" until the first frame tells where OpenGL draws
    shadow_pass  the vtkSoftShadowPass, whose settings may be changed; None while the technique is "auto"
    """

    def __init__(self, technique, tolerance, options):
        _settings.check(technique, tolerance, options)
        self.technique = technique
        self.shadow_pass = None
        self.is_alone = False  # in a frame without the passes around
        self._settings = (tolerance, options)
        self._chain = None
        self._observer = None
        self._renderer = vtkWeakReference()
        if technique != _settings.AUTO:
            self._make_pass()

    def _make_pass(self):
        self.shadow_pass = _settings.make_pass(self.technique, *self._settings)
        self._chain = Chain(self.shadow_pass)

    def _before_frame(self, renderer, _event=None):
        if self.is_alone:
            return
        if self._chain is None:
            self.technique = _settings.choose(self.technique, renderer.GetRenderWindow())
            self._make_pass()
        self._chain.follow(renderer)

    def _enter(self, renderer):
        self._observer = renderer.AddObserver("StartEvent", self._before_frame)
        self._renderer.Set(renderer)
        _ALL[renderer.__this__] = self

    def _leave(self, renderer):
        renderer.RemoveObserver(self._observer)
        if self._chain is not None:
            self._chain.leave(renderer)
        self._renderer.Set(None)
        _ALL.pop(renderer.__this__, None)


def shadows_of(renderer):
    """The SoftShadows of a renderer; None where they are not on."""
    shadows = _ALL.get(renderer.__this__)
    return shadows if shadows is not None and shadows._renderer.Get() is renderer else None


def enable(renderer, technique="auto", tolerance=None, light_size=None, **options):
    """Switches soft shadows on in a vtkRenderer, or on with other settings.

    technique   a name of the command-line tool (pcss, marched, cascaded, traced, ...), or "auto":
                traced where OpenGL is a software rasteriser, if it is built, and cascaded elsewhere
    tolerance   the error, root mean square over the bundled scene, that the settings are chosen for:
                at least 0.008. By default they are the technique's own
    light_size  the size of all lights that the renderer has (see set_light_size). By default they stay
                as they are, and have hard shadows unless they have an extent
    options     the technique's, by the names of the tool or of the pass's properties: map_size=1024,
                split=2, progressive=True

    The frame stays what it was: the passes that are set on the renderer, and its flags for FXAA, SSAO
    and depth peeling, also those that change later. Returns the SoftShadows.
    """
    shadows = SoftShadows(technique, tolerance, options)
    if light_size is not None:
        for light in lights_of(renderer):
            set_light_size(light, light_size)
    disable(renderer)
    shadows._enter(renderer)
    return shadows


def disable(renderer):
    """Switches soft shadows off: the renderer's passes are what they would be without. Lights stay."""
    shadows = shadows_of(renderer)
    if shadows is not None:
        shadows._leave(renderer)


def visibility(renderer, light=None):
    """How much of a light every pixel sees, as a NumPy array with the picture's top row first.

    1 is lit, 0 umbra and NaN no receiver: the background, unlit and translucent surfaces, and what is
    outside the light's cone. Draws a frame first. light may be left out where the renderer has one.
    """
    with _frame(renderer, light) as (shadow_pass, light):
        return _results.read_visibility(shadow_pass, light)[::-1].copy()


def add_visibility(renderer, light=None, name="visibility"):
    """Gives every mesh that is drawn a point array with the visibility of a light at its points.

    It is NaN where the camera does not see the point. Returns the data sets. Draws a frame first.
    """
    with _frame(renderer, light) as (shadow_pass, light):
        found = [(data, _results.point_visibility(
            renderer, shadow_pass, light, _results.world_points(data, matrix)))
            for data, matrix in _results.meshes(renderer)]
    for data, values in found:
        _results.add_point_array(data, name, values)
    return [data for data, _ in found]


def lights_of(renderer):
    lights = renderer.GetLights()
    return [lights.GetItemAsObject(i) for i in range(lights.GetNumberOfItems())]


def _ready(renderer, light):
    """The shadows and the light, after a frame of what there is now."""
    shadows = shadows_of(renderer)
    if shadows is None:
        raise ValueError("soft shadows are not on in this renderer: call enable first")
    window = renderer.GetRenderWindow()
    if window is None:
        raise ValueError("the renderer is in no window: there is nothing to be seen")
    lights = lights_of(renderer)
    if light is None:
        if len(lights) != 1:
            raise ValueError("the renderer has %d lights: say which" % len(lights))
        light = lights[0]
    elif not any(light is other for other in lights):  # PyVista's lights are equal by value
        raise ValueError("%s is no light of the renderer" % type(light).__name__)
    window.Render()
    if shadows.shadow_pass is None:
        raise ValueError("the renderer draws nothing: there is nothing to be seen")
    return shadows, light


@contextlib.contextmanager
def _frame(renderer, light):
    """The pass and the light after a frame whose pixels are the renderer's."""
    shadows, light = _ready(renderer, light)
    if _results.drawn_size(shadows.shadow_pass) == renderer.GetSize():
        yield shadows.shadow_pass, light
        return
    # Passes around draw more pixels, or others beside those that they show.
    window = renderer.GetRenderWindow()
    swaps, chain = window.GetSwapBuffers(), renderer.GetPass()
    window.SwapBuffersOff()
    shadows.is_alone = True
    try:
        renderer.SetPass(alone(shadows.shadow_pass))
        window.Render()
        yield shadows.shadow_pass, light
    finally:
        shadows.is_alone = False
        renderer.SetPass(chain)
        window.Render()
        window.SetSwapBuffers(swaps)

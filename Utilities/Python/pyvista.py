# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Soft shadows for PyVista.

    import pyvista
    from vtksoftshadows import pyvista as softshadows

    plotter = pyvista.Plotter(lighting="none")
    plotter.add_mesh(mesh)
    plotter.add_light(softshadows.AreaLight(position=(3, 4, 5), size=0.5))
    softshadows.enable(plotter)
    plotter.show()

To import this module makes PyVista keep the extent of lights: Plotter.add_light makes an AreaLight of a
vtkAreaLight, and Light.copy copies what set_light_size has set.
"""

import functools
import weakref

import pyvista

from vtksoftshadows import vtkAreaLight

from . import rendering
from ._lights import light_size, set_light_size
from ._techniques import TECHNIQUES

__all__ = ["AreaLight", "TECHNIQUES", "add_visibility", "disable", "enable", "light_size",
           "set_light_size", "shadows_of", "visibility"]

_ORIGIN = "_copied_from"  # among the Python attributes of copies of lights


class AreaLight(vtkAreaLight, pyvista.Light):
    """A pyvista.Light with an extent, and a vtkAreaLight with PyVista's properties.

    size              edge of the square or diameter of the disk in world units, or (width, height)
    shape             "rectangle", "disk" or "point"
    view_up           where the light's height points; by default the axis least aligned with its
                      direction
    angular_diameter  of a sun, in degrees; makes the light directional, so that size and shape have
                      no effect

    The rest is pyvista.Light's, but that the light has a position and no cone unless told otherwise.
    """

    def __init__(self, position=None, focal_point=None, color=None, *, size=None, shape="rectangle",
                 view_up=None, angular_diameter=None, positional=None, cone_angle=None, **others):
        pyvista.Light.__init__(self, position=position, focal_point=focal_point, color=color, **others)
        if angular_diameter is not None and (size is not None or positional):
            raise ValueError("angular_diameter: a light that has it is directional, without size and "
                             "position")
        if shape == "point" and size is not None:
            raise ValueError("size: a light of shape 'point' has none")
        self.SetPositional(angular_diameter is None and (positional is None or bool(positional)))
        self.SetConeAngle(90.0 if cone_angle is None else cone_angle)
        self.shape = shape
        if size is not None:
            self.size = size
        if view_up is not None:
            self.view_up = view_up
        if angular_diameter is not None:
            self.angular_diameter = angular_diameter

    @property
    def size(self):
        """Width and height in world units."""
        return self.GetSize()

    @size.setter
    def size(self, size):
        if not self.GetPositional():
            raise ValueError("size: the light is directional and has an angular_diameter")
        set_light_size(self, size)

    @property
    def shape(self):
        """ "rectangle", "disk" or "point"."""
        return self.GetShapeAsString()

    @shape.setter
    def shape(self, shape):
        shapes = {"rectangle": vtkAreaLight.RECTANGLE, "disk": vtkAreaLight.DISK,
                  "point": vtkAreaLight.POINT}
        if shape not in shapes:
            raise ValueError("shape: must be %s, is %r" % (" or ".join(shapes), shape))
        self.SetShape(shapes[shape])

    @property
    def view_up(self):
        """Where the light's height points; (0, 0, 0) is the axis least aligned with its direction."""
        return self.GetViewUp()

    @view_up.setter
    def view_up(self, view_up):
        self.SetViewUp(*view_up)

    @property
    def angular_diameter(self):
        """Degrees under which a directional light is seen; the sun has 0.53."""
        return self.GetAngularDiameter()

    @angular_diameter.setter
    def angular_diameter(self, degrees):
        if degrees:
            self.SetPositional(False)
        set_light_size(self, degrees) if not self.GetPositional() else self.SetAngularDiameter(0.0)

    def copy(self, deep=True):
        """A copy; a shallow one shares the transformation matrix."""
        light = AreaLight.from_vtk(self)
        if not deep:
            light.transform_matrix = self.transform_matrix
        return light

    @classmethod
    def from_vtk(cls, light):
        """A copy of any vtkLight; a plain one becomes a disk of the size that set_light_size gave it."""
        copy = cls()
        copy.DeepCopy(rendering.area_light(light))
        return copy


# What VTK's wrapping gives vtkAreaLight must not hide PyVista's properties of the same names.
for _name in {*vars(vtkAreaLight), "__repr__"} & set(vars(pyvista.Light)) - set(vars(AreaLight)):
    if _name == "__repr__" or not _name.startswith("_"):
        setattr(AreaLight, _name, vars(pyvista.Light)[_name])


def _patch_lights():
    """PyVista copies lights property by property, and knows no extent."""
    from_vtk, copy = pyvista.Light.from_vtk, pyvista.Light.copy

    @functools.wraps(from_vtk.__func__)
    def from_vtk_with_extent(cls, vtk_light):
        if isinstance(vtk_light, vtkAreaLight):
            light = AreaLight.from_vtk(vtk_light)
            vars(light)[_ORIGIN] = weakref.ref(vtk_light)
            return light
        return _with_size_of(vtk_light, from_vtk.__func__(cls, vtk_light))

    @functools.wraps(copy)
    def copy_with_extent(self, *arguments, **keywords):
        return _with_size_of(self, copy(self, *arguments, **keywords))

    pyvista.Light.from_vtk = classmethod(from_vtk_with_extent)
    pyvista.Light.copy = copy_with_extent


def _with_size_of(light, copy):
    if light_size(light):
        set_light_size(copy, light_size(light))
    return copy


_patch_lights()


def enable(plotter, technique="auto", tolerance=None, light_size=None, **options):
    """Switches soft shadows on in all renderers of a plotter, or in one renderer (plotter.renderer).

    The arguments are those of vtksoftshadows.rendering.enable. What the plotter has on stays on: SSAO,
    EDL, blurring, depth of field, depth peeling, FXAA, SSAA and MSAA, also what is switched on or off
    later; enable_shadows is left out with a warning. Plotter.screenshot shows what there is now, not
    what was drawn last. Returns the SoftShadows of the renderer, of a plotter those of its active one.
    """
    _refuse_closed(plotter)
    renderers = _renderers_of(plotter)
    for renderer in renderers:
        rendering.enable(renderer, technique, tolerance, light_size, **options)
    if _is_plotter(plotter):
        _draw_before_screenshots(plotter)
    return shadows_of(plotter)


def disable(plotter):
    """Switches soft shadows off in all renderers of a plotter, or in one renderer. Lights stay."""
    for renderer in _renderers_of(plotter):
        rendering.disable(renderer)
    if _is_plotter(plotter):
        vars(plotter).pop("screenshot", None)


def shadows_of(plotter):
    """The SoftShadows of a renderer, or of a plotter's active one; None where they are not on."""
    return rendering.shadows_of(_active(plotter))


def visibility(plotter, light=None):
    """How much of a light every pixel of the active renderer sees; see vtksoftshadows.rendering."""
    _draw_first_frame(plotter)
    return rendering.visibility(_active(plotter), _of(plotter, light))


def add_visibility(plotter, light=None, name="visibility"):
    """Gives every mesh that the active renderer draws an array of the light at its points.

    It is NaN where the camera does not see the point. Returns the meshes.
    """
    _draw_first_frame(plotter)
    return [pyvista.wrap(data) for data in
            rendering.add_visibility(_active(plotter), _of(plotter, light), name)]


def _is_plotter(plotter):
    return hasattr(plotter, "renderers") and hasattr(plotter, "render_window")


def _renderers_of(plotter):
    return list(plotter.renderers) if _is_plotter(plotter) else [plotter]


def _active(plotter):
    return plotter.renderer if _is_plotter(plotter) else plotter


def _of(plotter, light):
    """The light, or the copy of it that Plotter.add_light has made."""
    for copy in rendering.lights_of(_active(plotter)):
        origin = vars(copy).get(_ORIGIN)
        if origin is not None and origin() is light:
            return copy
    return light


def _refuse_closed(plotter):
    if getattr(plotter, "_closed", False):
        raise ValueError("the %s is closed" % type(plotter).__name__.lower())


def _draw_first_frame(plotter):
    """PyVista prepares the camera when it draws for the first time: on screen not before show."""
    _refuse_closed(plotter)
    if _is_plotter(plotter):
        plotter.screenshot(return_img=True)


def _draw_before_screenshots(plotter):
    screenshot = type(plotter).screenshot
    reference = weakref.ref(plotter)

    @functools.wraps(screenshot)
    def screenshot_of_now(*arguments, **keywords):
        owner = reference()
        if owner.render_window is not None:
            owner.render()  # nothing before the first frame
        return screenshot(owner, *arguments, **keywords)

    vars(plotter)["screenshot"] = screenshot_of_now

# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The place of the soft shadows among a renderer's other passes, kept whatever is switched on or off."""

import warnings

from vtkmodules.vtkRenderingCore import vtkRenderPass
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass, vtkDualDepthPeelingPass, vtkOpaquePass, vtkOpenGLFXAAPass, vtkOrderIndependentTranslucentPass,
    vtkRenderStepsPass, vtkSequencePass, vtkShadowMapBakerPass, vtkShadowMapPass, vtkSSAOPass,
    vtkTranslucentPass, vtkVolumetricPass)


def delegates(render_pass):
    """The passes that a pass draws with."""
    if isinstance(render_pass, vtkSequencePass):
        passes = render_pass.GetPasses()
        return [passes.GetItemAsObject(i) for i in range(passes.GetNumberOfItems())] if passes else []
    if hasattr(render_pass, "GetDelegatePass"):
        return [inner for inner in [render_pass.GetDelegatePass()] if inner is not None]
    return []


def find_all(render_pass, kind):
    """All passes of a kind in a chain, and whose delegates they are; its outermost is nobody's."""
    found = []
    pending = [(render_pass, None)]
    while pending:
        current, owner = pending.pop()
        if isinstance(current, kind):
            found.append((current, owner))
        pending.extend((inner, current) for inner in delegates(current))
    return found


def insert(passes, place, render_pass):
    """Puts a pass into a collection, so that it is at the place, counted from 0."""
    behind = [passes.GetItemAsObject(i) for i in range(place, passes.GetNumberOfItems())]
    for other in behind:
        passes.RemoveItem(other)
    for other in [render_pass] + behind:
        passes.AddItem(other)


def uses_order_independent_blending(renderer):
    """Whether VTK's renderer blends so where depth is not peeled: in VTK 9.1 always."""
    return bool(renderer.GetUseOIT()) if hasattr(renderer, "GetUseOIT") else True


def signature(render_pass):
    """What tells a chain from another: its passes, and what they draw opaque props with."""
    steps = [step.GetOpaquePass() for step, _ in find_all(render_pass, vtkRenderStepsPass)]
    chain = [step for step, _ in find_all(render_pass, vtkRenderPass)]
    return [step.__this__ for step in chain + steps if step is not None]


def alone(shadow_pass):
    """VTK's own frame with the shadows, without anything around."""
    steps = vtkRenderStepsPass()
    steps.SetOpaquePass(shadow_pass)
    return steps


class Chain:
    """Puts a soft-shadow pass into a renderer's chain of passes and takes it out again.

    What others set as the renderer's pass is left as it is, but for its opaque and translucent steps. If
    they set none, the frame is what VTK's renderer draws without a pass, its flags included.
    """

    def __init__(self, shadow_pass):
        self.shadow_pass = shadow_pass
        self._outermost = None  # what was set last
        self._others = None  # what others set as the renderer's pass
        self._seen = None  # the flags and the chain as they were then
        self._undo = []  # functions, last in first out

    def follow(self, renderer):
        """Brings the renderer's pass in line with its flags and with what others set since."""
        flags = self._flags_of(renderer)
        current = renderer.GetPass()
        if self._seen == (flags, signature(current)):
            return
        if current is not self._outermost or self._outermost is None:
            self._others = current
        self._take_out()
        self._outermost = self._put_in(renderer)
        self._seen = (flags, signature(self._outermost))
        if current is not self._outermost:
            renderer.SetPass(self._outermost)

    def leave(self, renderer):
        """Leaves the renderer as others have it."""
        self._take_out()
        if self._outermost is not None and renderer.GetPass() is self._outermost:
            renderer.SetPass(self._others)
        self._outermost = self._others = self._seen = None

    @staticmethod
    def _flags_of(renderer):
        return (renderer.GetUseFXAA(), renderer.GetUseDepthPeeling(),
                renderer.GetUseDepthPeelingForVolumes(), renderer.GetMaximumNumberOfPeels(),
                renderer.GetOcclusionRatio(), renderer.GetUseSSAO(), renderer.GetSSAORadius(),
                renderer.GetSSAOBias(), renderer.GetSSAOKernelSize(), renderer.GetSSAOBlur(),
                uses_order_independent_blending(renderer))

    def _take_out(self):
        while self._undo:
            self._undo.pop()()

    def _put_in(self, renderer):
        """The outermost pass of a chain that holds the shadows."""
        if self._others is None:
            chain = vtkRenderStepsPass()
            if uses_order_independent_blending(renderer):
                blending = vtkOrderIndependentTranslucentPass()
                blending.SetTranslucentPass(vtkTranslucentPass())
                chain.SetTranslucentPass(blending)
            self._fill(chain, renderer)
        else:
            chain = self._others
            self._leave_hard_shadows_out(chain)
            self._fill_others(chain, renderer)
        if renderer.GetUseFXAA() and not find_all(chain, vtkOpenGLFXAAPass):
            smooth = vtkOpenGLFXAAPass()
            if renderer.GetFXAAOptions() is not None:
                smooth.SetFXAAOptions(renderer.GetFXAAOptions())
            smooth.SetDelegatePass(chain)
            chain = smooth
        return chain

    def _fill_others(self, chain, renderer):
        steps = find_all(chain, vtkRenderStepsPass)
        for step, _ in steps:
            self._fill(step, renderer)
        if steps or find_all(chain, type(self.shadow_pass)):
            return
        opaque = [(step, owner) for step, owner in find_all(chain, vtkOpaquePass)
                  if owner is not None]
        for step, owner in opaque:
            self._replace(step, owner)
        if not opaque:
            warnings.warn("the renderer's pass (%s) has neither a vtkRenderStepsPass nor a "
                          "vtkOpaquePass: there is no place for soft shadows in it"
                          % chain.GetClassName())

    def _fill(self, steps, renderer):
        """The steps' opaque pass is the shadows, and their translucent one what the flags ask for."""
        opaque, translucent = steps.GetOpaquePass(), steps.GetTranslucentPass()
        steps.SetOpaquePass(self._with_occlusion(renderer))
        self._undo.append(lambda: steps.SetOpaquePass(opaque))
        if renderer.GetUseDepthPeeling():
            peeling = vtkDualDepthPeelingPass()
            peeling.SetTranslucentPass(vtkTranslucentPass())
            peeling.SetMaximumNumberOfPeels(renderer.GetMaximumNumberOfPeels())
            peeling.SetOcclusionRatio(renderer.GetOcclusionRatio())
            if renderer.GetUseDepthPeelingForVolumes():
                peeling.SetVolumetricPass(vtkVolumetricPass())
            steps.SetTranslucentPass(peeling)
            self._undo.append(lambda: steps.SetTranslucentPass(translucent))

    def _with_occlusion(self, renderer):
        """The shadows, in the ambient occlusion that the renderer's own flag asks for."""
        if not renderer.GetUseSSAO():
            return self.shadow_pass
        occlusion = vtkSSAOPass()
        occlusion.SetRadius(renderer.GetSSAORadius())
        occlusion.SetBias(renderer.GetSSAOBias())
        occlusion.SetKernelSize(renderer.GetSSAOKernelSize())
        occlusion.SetBlur(renderer.GetSSAOBlur())
        camera = vtkCameraPass()  # without it VTK 9.6 draws a black picture
        camera.SetDelegatePass(self.shadow_pass)
        occlusion.SetDelegatePass(camera)
        return occlusion

    def _replace(self, step, owner):
        if isinstance(owner, vtkSequencePass):
            passes = owner.GetPasses()
            place = passes.IsItemPresent(step) - 1  # counted from 1
            passes.ReplaceItem(place, self.shadow_pass)
            self._undo.append(lambda: passes.ReplaceItem(place, step))
        else:
            owner.SetDelegatePass(self.shadow_pass)
            self._undo.append(lambda: owner.SetDelegatePass(step))

    def _leave_hard_shadows_out(self, chain):
        """VTK's shadow maps draw the opaque props again, over the soft shadows."""
        hard = find_all(chain, (vtkShadowMapPass, vtkShadowMapBakerPass))
        removed = False
        for step, owner in hard:
            if isinstance(owner, vtkSequencePass):
                passes = owner.GetPasses()
                place = passes.IsItemPresent(step) - 1  # counted from 1
                passes.RemoveItem(step)
                self._undo.append(lambda passes=passes, step=step, place=place: insert(passes, place, step))
                removed = True
        if removed:
            warnings.warn("VTK's own shadows (enable_shadows) are left out while soft shadows are on")

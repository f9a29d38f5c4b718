# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtksoftshadows.rendering among the passes of others, and when it dies."""

import gc
import sys
import unittest
import warnings

try:
    import numpy
    from vtkmodules.vtkRenderingOpenGL2 import (
        vtkCameraPass, vtkDefaultPass, vtkLightsPass, vtkOpaquePass, vtkOverlayPass,
        vtkRenderPassCollection, vtkRenderStepsPass, vtkSequencePass, vtkShadowMapBakerPass,
        vtkShadowMapPass)
except ImportError as error:
    print("skipped: VTK's Python modules or NumPy are missing:", error)
    sys.exit(77)

from TestPassChains import ambient_occlusion
from TestRendering import Plain
from TestTechniques import square
from vtksoftshadows import rendering


def flat_pane(height, color):
    pane = square(1.6, height)
    pane.GetProperty().SetColor(color)
    pane.GetProperty().SetOpacity(0.5)
    return pane


class TestChain(unittest.TestCase):
    """With lights that no shadow takes anything from, the picture is that without soft shadows."""

    def panes(self):
        return [flat_pane(0.3, (1.0, 0.0, 0.0)), flat_pane(0.2, (0.0, 0.0, 1.0))]

    def assert_same_picture(self, prepare, most=2):
        """prepare(renderer) before and after enable: the same picture as without."""
        pictures = []
        for when in ("never", "before", "after", "between frames"):
            scene = Plain(self.panes())
            scene.lamp.SetShadowAttenuation(0.0)
            if when in ("never", "before"):
                prepare(scene.renderer)
            if when != "never":
                rendering.enable(scene.renderer, "pcss")
            if when == "between frames":
                scene.picture()
            if when not in ("never", "before"):
                prepare(scene.renderer)
            pictures.append(scene.picture())
            if when != "never":
                self.assertLessEqual(numpy.abs(pictures[-1] - pictures[0]).max(), most, when)
                scene.lamp.SetShadowAttenuation(1.0)
                self.assertGreater(numpy.abs(scene.picture() - pictures[0]).max(), 50, when)
                self.assertLess(numpy.abs(scene.errors()).max(), 0.13)
                rendering.disable(scene.renderer)
                self.assertTrue((scene.picture() == pictures[0]).all(), when)
        return pictures[0]

    def test_flags(self):
        def fxaa(renderer):
            renderer.UseFXAAOn()

        def occlusion(renderer):
            renderer.UseSSAOOn()
            renderer.SetSSAORadius(0.5)

        def peeling(renderer):
            renderer.UseDepthPeelingOn()
            renderer.SetMaximumNumberOfPeels(4)

        def all_of_them(renderer):
            for prepare in (fxaa, occlusion, peeling):
                prepare(renderer)
        plain = self.assert_same_picture(lambda renderer: None)
        for prepare in (fxaa, occlusion, peeling, all_of_them):
            with self.subTest(prepare.__name__):
                picture = self.assert_same_picture(prepare)
                self.assertGreater(numpy.abs(picture - plain).max(), 5, "it has no effect")

    def test_flags_switched_off_later(self):
        scene = Plain(self.panes())
        rendering.enable(scene.renderer, "pcss")
        before = scene.picture()
        scene.renderer.UseFXAAOn()
        self.assertGreater(numpy.abs(scene.picture() - before).max(), 5)
        scene.renderer.UseFXAAOff()
        self.assertTrue((scene.picture() == before).all())

    def test_chains_of_others(self):
        def steps(renderer):
            renderer.SetPass(vtkRenderStepsPass())

        def occluded_steps(renderer):
            renderer.SetPass(ambient_occlusion(vtkRenderStepsPass()))

        def sequence(renderer):
            passes = vtkRenderPassCollection()
            for step in (vtkLightsPass(), vtkOpaquePass(), vtkOverlayPass()):
                passes.AddItem(step)
            sequence = vtkSequencePass()
            sequence.SetPasses(passes)
            camera = vtkCameraPass()
            camera.SetDelegatePass(sequence)
            renderer.SetPass(camera)
        for prepare in (steps, occluded_steps, sequence):
            with self.subTest(prepare.__name__):
                self.assert_same_picture(prepare)

    def test_others_find_their_chain_as_it_was(self):
        scene = Plain()
        steps = vtkRenderStepsPass()
        opaque, translucent = steps.GetOpaquePass(), steps.GetTranslucentPass()
        outer = ambient_occlusion(steps)
        scene.renderer.SetPass(outer)
        scene.renderer.UseFXAAOn()
        scene.renderer.UseDepthPeelingOn()
        rendering.enable(scene.renderer, "pcss")
        scene.window.Render()
        self.assertIsNot(steps.GetOpaquePass(), opaque)
        self.assertIsNot(steps.GetTranslucentPass(), translucent)
        rendering.disable(scene.renderer)
        self.assertIs(scene.renderer.GetPass(), outer)
        self.assertIs(steps.GetOpaquePass(), opaque)
        self.assertIs(steps.GetTranslucentPass(), translucent)

    def test_hard_shadows_come_back_to_their_place(self):
        scene = Plain()
        baker, hard, overlay = vtkShadowMapBakerPass(), vtkShadowMapPass(), vtkOverlayPass()
        hard.SetShadowMapBakerPass(baker)
        steps, sequence, camera = vtkRenderStepsPass(), vtkSequencePass(), vtkCameraPass()
        passes = vtkRenderPassCollection()
        for item in (steps, baker, hard, overlay):
            passes.AddItem(item)
        sequence.SetPasses(passes)
        camera.SetDelegatePass(sequence)
        scene.renderer.SetPass(camera)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            rendering.enable(scene.renderer, "pcss")
            scene.window.Render()
        left = [passes.GetItemAsObject(i) for i in range(passes.GetNumberOfItems())]
        self.assertEqual([item.GetClassName() for item in left],
                         ["vtkRenderStepsPass", "vtkOverlayPass"])
        rendering.disable(scene.renderer)
        back = [passes.GetItemAsObject(i) for i in range(passes.GetNumberOfItems())]
        self.assertEqual([item.GetClassName() for item in back],
                         ["vtkRenderStepsPass", "vtkShadowMapBakerPass", "vtkShadowMapPass",
                          "vtkOverlayPass"])

    def test_no_place(self):
        scene = Plain()
        camera = vtkCameraPass()
        camera.SetDelegatePass(vtkDefaultPass())
        scene.renderer.SetPass(camera)
        rendering.enable(scene.renderer, "pcss")
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            scene.window.Render()
            scene.window.Render()
        self.assertEqual(len(caught), 1)
        self.assertIn("vtkCameraPass", str(caught[0].message))

    def test_enabled_again(self):
        scene = Plain()
        rendering.enable(scene.renderer, "pcss")
        scene.window.Render()
        rendering.enable(scene.renderer, "marched")
        scene.window.Render()
        rendering.disable(scene.renderer)
        rendering.disable(scene.renderer)
        scene.window.Render()
        self.assertIsNone(scene.renderer.GetPass())


class TestGarbage(unittest.TestCase):
    def test_nothing_holds_what_is_gone(self):
        for with_frames in (False, True):
            deleted = []
            scene = Plain()
            shadows = rendering.enable(scene.renderer, "pcss")
            shadows.shadow_pass.AddObserver("DeleteEvent", lambda *_: deleted.append("pass"))
            scene.renderer.AddObserver("DeleteEvent", lambda *_: deleted.append("renderer"))
            if with_frames:
                scene.window.Render()
            del shadows, scene
            gc.collect()
            self.assertEqual(sorted(deleted), ["pass", "renderer"])

    def test_disabled(self):
        deleted = []
        scene = Plain()
        shadows = rendering.enable(scene.renderer, "pcss")
        shadows.shadow_pass.AddObserver("DeleteEvent", lambda *_: deleted.append("pass"))
        scene.window.Render()
        rendering.disable(scene.renderer)
        scene.window.Render()
        del shadows
        gc.collect()
        self.assertEqual(deleted, ["pass"])

    def test_wrappers_come_and_go(self):
        """The renderer's Python object may die while its window holds the renderer."""
        scene = Plain()
        rendering.enable(scene.renderer, "pcss")
        window, scene.renderer = scene.window, None
        gc.collect()
        window.Render()
        renderer = window.GetRenderers().GetFirstRenderer()
        shadows = rendering.shadows_of(renderer)
        self.assertEqual(shadows.technique, "pcss")
        self.assertEqual(shadows.shadow_pass.GetCount("maps_baked"), 1)
        rendering.disable(renderer)
        window.Render()
        self.assertIsNone(renderer.GetPass())


if __name__ == "__main__":
    unittest.main(verbosity=2)

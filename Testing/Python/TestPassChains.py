# SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The chains of passes in Documentation/Integrating.md: each keeps the visibility, and each has its effect.

The scene is that of TestTechniques.py.
"""

import math
import sys
import unittest

try:
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkRenderingCore import vtkRenderer, vtkWindowToImageFilter
    from vtkmodules.vtkRenderingOpenGL2 import (
        vtkCameraPass, vtkDualDepthPeelingPass, vtkLightsPass, vtkOpenGLFXAAPass, vtkOverlayPass,
        vtkRenderPassCollection, vtkRenderStepsPass, vtkSequencePass, vtkSSAOPass, vtkToneMappingPass,
        vtkTranslucentPass)
except ImportError as error:
    print("skipped: VTK's Python modules are missing:", error)
    sys.exit(77)

from TestTechniques import HEIGHT, WIDTH, Scene, square, steps_with
import vtksoftshadows

UMBRA, PENUMBRA, LIT = (0.2, 0.0), (2.0 / 3.0, 0.0), (1.3, 0.0)


def ambient_occlusion(delegate):
    ssao = vtkSSAOPass()
    ssao.SetRadius(0.5)
    ssao.SetBias(0.01)
    ssao.SetKernelSize(64)
    ssao.BlurOn()
    ssao.SetDelegatePass(delegate)
    return ssao


def below_camera(delegate):
    """Right around an opaque pass VTK 9.6's ambient occlusion is black."""
    camera = vtkCameraPass()
    camera.SetDelegatePass(delegate)
    return camera


def peeling():
    peel = vtkDualDepthPeelingPass()
    peel.SetTranslucentPass(vtkTranslucentPass())
    peel.SetMaximumNumberOfPeels(4)
    peel.SetOcclusionRatio(0.0)
    return peel


class Chain(Scene):
    """The scene with a chain of passes, made of the soft-shadow pass by a function."""

    def __init__(self, make_chain, translucent=False):
        panes = []
        if translucent:
            for height, color in ((0.3, (1.0, 0.0, 0.0)), (0.2, (0.0, 0.0, 1.0))):
                pane = square(1.6, height)  # over the point that is lit
                pane.GetProperty().SetColor(color)
                pane.GetProperty().SetOpacity(0.5)
                pane.GetProperty().LightingOff()
                panes.append(pane)
        super().__init__(vtksoftshadows.vtkPercentageCloserSoftShadowPass(), make_chain, panes)

    def image(self):
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ShouldRerenderOff()
        grab.Update()
        return grab.GetOutput()

    def pixel(self, x, y):
        self.renderer.SetWorldPoint(x, y, 0.0, 1.0)
        self.renderer.WorldToDisplay()
        column, row = (int(value) for value in self.renderer.GetDisplayPoint()[:2])
        image = self.image()
        return [image.GetScalarComponentAsDouble(column, row, 0, i) for i in range(3)]

    def picture(self):
        scalars = self.image().GetPointData().GetScalars()
        return [scalars.GetValue(i) for i in range(scalars.GetNumberOfValues())]


def largest_difference(first, second):
    return max(abs(a - b) for a, b in zip(first, second))


class TestChains(unittest.TestCase):
    def assert_shadow(self, chain, least_lit=150):
        """Visibility and picture are dark, half lit and lit where they must be, also from elsewhere."""
        self.assert_shadow_now(chain, least_lit)
        chain.renderer.GetActiveCamera().Azimuth(3.0)
        chain.window.Render()
        self.assert_shadow_now(chain, least_lit)
        chain.renderer.GetActiveCamera().Azimuth(-3.0)
        chain.window.Render()

    def assert_shadow_now(self, chain, least_lit):
        self.assertLess(chain.visibility(*UMBRA), 0.02)
        self.assertAlmostEqual(chain.visibility(*PENUMBRA), 0.5, delta=0.1)
        self.assertGreater(chain.visibility(*LIT), 0.98)
        lit = chain.pixel(*LIT)[0]
        self.assertLess(chain.pixel(*UMBRA)[0], 8)
        self.assertGreater(lit, least_lit)
        self.assertTrue(0.2 * lit < chain.pixel(*PENUMBRA)[0] < 0.9 * lit)

    def test_steps(self):
        self.assert_shadow(Chain(steps_with))

    def test_sequence_under_a_camera_pass(self):
        def make(shadows):
            passes = vtkRenderPassCollection()
            for step in (vtkLightsPass(), shadows, vtkTranslucentPass(), vtkOverlayPass()):
                passes.AddItem(step)
            sequence = vtkSequencePass()
            sequence.SetPasses(passes)
            return below_camera(sequence)
        chain = Chain(make)
        self.assert_shadow(chain)
        self.assertEqual(largest_difference(chain.picture(), Chain(steps_with).picture()), 0)

    def test_peeling(self):
        def make(shadows):
            steps = steps_with(shadows)
            steps.SetTranslucentPass(peeling())
            return steps
        chain = Chain(make, translucent=True)
        # As VTK blends without our pass, where there is light; and half of red over the umbra.
        def make_plain(_):
            steps = vtkRenderStepsPass()
            steps.SetTranslucentPass(peeling())
            return steps
        plain = Chain(make_plain, translucent=True)
        self.assertLess(largest_difference(chain.pixel(*LIT), plain.pixel(*LIT)), 2)
        self.assertGreater(plain.pixel(*UMBRA)[1], 90)
        self.assertLess(largest_difference(chain.pixel(*UMBRA), (128, 0, 0)), 3)
        self.assertLess(chain.visibility(*UMBRA), 0.02)
        self.assertGreater(chain.visibility(*LIT), 0.98)

    def test_ambient_occlusion_around_the_shadows(self):
        def make(shadows):
            steps = vtkRenderStepsPass()
            steps.SetOpaquePass(ambient_occlusion(below_camera(shadows)))
            return steps
        chain = Chain(make)
        self.assert_shadow(chain, 120)
        self.assertGreater(largest_difference(chain.picture(), Chain(steps_with).picture()), 10)

    def test_ambient_occlusion_around_all_steps(self):
        self.assert_shadow(Chain(lambda shadows: ambient_occlusion(steps_with(shadows))), 120)

    def test_antialiasing(self):
        def make(shadows):
            smooth = vtkOpenGLFXAAPass()
            smooth.SetDelegatePass(steps_with(shadows))
            return smooth
        chain = Chain(make)
        self.assert_shadow(chain)
        self.assertGreater(largest_difference(chain.picture(), Chain(steps_with).picture()), 10)

    def test_tone_mapping(self):
        def make(shadows):
            tones = vtkToneMappingPass()
            tones.SetToneMappingType(vtkToneMappingPass.Reinhard)
            tones.SetDelegatePass(steps_with(shadows))
            return tones
        chain = Chain(make)
        self.assert_shadow(chain, 100)
        self.assertLess(chain.pixel(*LIT)[0], Chain(steps_with).pixel(*LIT)[0] - 20)

    def test_all_at_once(self):
        def make(shadows):
            steps = vtkRenderStepsPass()
            steps.SetOpaquePass(ambient_occlusion(below_camera(shadows)))
            steps.SetTranslucentPass(peeling())
            tones = vtkToneMappingPass()
            tones.SetToneMappingType(vtkToneMappingPass.Clamp)
            tones.SetDelegatePass(steps)
            smooth = vtkOpenGLFXAAPass()
            smooth.SetDelegatePass(tones)
            return smooth
        chain = Chain(make, translucent=True)
        self.assertLess(chain.visibility(*UMBRA), 0.02)
        self.assertGreater(chain.visibility(*LIT), 0.98)
        red, green, blue = chain.pixel(*LIT)
        self.assertGreater(red, max(green, blue) + 50)
        self.assertLess(max(chain.pixel(*UMBRA)[1:]), 8)

    def test_flags_of_the_renderer_are_ignored_under_a_pass(self):
        chain = Chain(steps_with)
        before = chain.picture()
        chain.renderer.UseFXAAOn()
        chain.renderer.UseSSAOOn()
        chain.renderer.UseDepthPeelingOn()
        chain.window.Render()
        self.assertEqual(largest_difference(chain.picture(), before), 0)

    def test_two_renderers_need_two_passes(self):
        chain = Chain(steps_with)
        other = vtkRenderer()
        other.SetViewport(0.5, 0.0, 1.0, 1.0)
        chain.renderer.SetViewport(0.0, 0.0, 0.5, 1.0)
        other.AddActor(square(4.0, 0.0))
        other.AddActor(square(0.5, 1.0))
        other.SetAutomaticLightCreation(0)
        other.AddLight(chain.lamp)
        other.SetActiveCamera(chain.renderer.GetActiveCamera())
        second = vtksoftshadows.vtkPercentageCloserSoftShadowPass()
        other.SetPass(steps_with(second))
        chain.window.AddRenderer(other)
        chain.window.Render()
        images = [vtkImageData(), vtkImageData()]
        self.assertTrue(chain.shadows.GetVisibilityImage(chain.lamp, images[0]))
        self.assertTrue(second.GetVisibilityImage(chain.lamp, images[1]))
        self.assertEqual(images[0].GetDimensions(), (WIDTH // 2, HEIGHT, 1))
        scalars = [image.GetPointData().GetScalars() for image in images]
        for i in range(scalars[0].GetNumberOfTuples()):
            first, other_value = scalars[0].GetValue(i), scalars[1].GetValue(i)
            if not math.isnan(first):
                self.assertAlmostEqual(first, other_value, delta=1e-6)


if __name__ == "__main__":
    unittest.main(verbosity=2)

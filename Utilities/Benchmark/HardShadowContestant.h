// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HardShadowContestant
 * @brief   vtkShadowMapPass: VTK's own hard shadows, one map of the given size per light.
 *
 * The pass has no visibility to read. It is taken from pictures: per light the scene with white
 * diffuse surfaces and this light alone is drawn with the pass and without; the ratio of the two,
 * clamped to [0, 1], is the visibility. Both pictures have 8 bits, so a pixel that shows the share c of full
 * white without shadows has a step of 1 / (255 c). Pixels darker than DarkestMeasured have no value.
 */

#ifndef SoftShadowsBenchmark_HardShadowContestant_h
#define SoftShadowsBenchmark_HardShadowContestant_h

#include "WindowContestant.h"

namespace softshadows
{

class HardShadowContestant : public WindowContestant
{
public:
  /// Of 255: the ratio's step is at most 1 / 16.
  static constexpr int DarkestMeasured = 16;

  HardShadowContestant(const SceneFactory& makeScene, int width, int height, int mapSize);

  std::vector<std::vector<float>> GetVisibility() override;

private:
  SceneFactory MakeScene;
  int Width;
  int Height;
  int MapSize;

  ColorImage DrawWhite(int light, bool withShadows) const;
};

}

#endif

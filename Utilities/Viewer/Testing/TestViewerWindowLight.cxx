// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Moving the light in the viewer's window: the ball, the shadow on the screen.
#include "ViewerWindowFixture.h"

#include "vtkAreaLight.h"

#include <algorithm>
#include <cmath>

using namespace softshadows;

namespace
{

class ViewerWindowLights : public ViewerWindowTest
{
protected:
  /// Column of the shadow's centre on the ground, from the visibility; pixels of the scene's room.
  double ShadowColumn()
  {
    const VisibilityImage image = this->Frame().GetVisibility();
    double sum = 0.0;
    double weight = 0.0;
    for (int y = image.Height * 4 / 10; y < image.Height; ++y)
    {
      for (int x = 0; x < image.Width; ++x)
      {
        const float visibility = image.Visibility[0][static_cast<std::size_t>(y) * image.Width + x];
        if (!std::isnan(visibility))
        {
          sum += (1.0 - visibility) * x;
          weight += 1.0 - visibility;
        }
      }
    }
    return sum / weight;
  }
};

}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindowLights, TheBallDragsTheLightAndItsShadow)
{
  this->Open();
  const Vector2 ball = this->Frame().GetHandle()->GetDisplayPosition();
  const MenuRect room = this->Frame().GetRoom();
  ASSERT_TRUE(room.Contains(static_cast<int>(ball[0]), static_cast<int>(ball[1])));
  const Vector3 before = this->State->GetLight().Position;
  const double shadowBefore = this->ShadowColumn();
  const Screen screenBefore = this->Grab();

  const int x = static_cast<int>(std::lround(ball[0]));
  const int y = static_cast<int>(std::lround(ball[1]));
  this->Drag(x, y, x + 150, y);

  const Vector3 after = this->State->GetLight().Position;
  EXPECT_GT(after[0], before[0] + 0.5) << "to the right, as seen";
  EXPECT_EQ(this->Frame().GetScene().GetLight(0)->GetPosition()[0], after[0]);
  EXPECT_LT(this->ShadowColumn(), shadowBefore - 20.0) << "the shadow goes the other way";
  EXPECT_GT(this->Grab().Differing(screenBefore, room), 0.02);
  const Vector2 moved = this->Frame().GetHandle()->GetDisplayPosition();
  EXPECT_NEAR(moved[0], ball[0] + 150.0, 8.0) << "the ball follows the mouse";
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindowLights, HiddenTheBallDragsNothing)
{
  this->Open();
  const Vector2 ball = this->Frame().GetHandle()->GetDisplayPosition();
  const Vector3 before = this->State->GetLight().Position;
  this->Press("g");
  const int x = static_cast<int>(std::lround(ball[0]));
  const int y = static_cast<int>(std::lround(ball[1]));
  this->Drag(x, y, x + 100, y);
  EXPECT_EQ(this->State->GetLight().Position, before);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindowLights, TheBallStaysInViewWhereverTheLightIs)
{
  this->Open();
  this->State->SetLightPosition({ { -40.0, -30.0, 60.0 } });
  this->Frame().Draw();
  const Vector2 ball = this->Frame().GetHandle()->GetDisplayPosition();
  EXPECT_TRUE(
    this->Frame().GetRoom().Contains(static_cast<int>(ball[0]), static_cast<int>(ball[1])))
    << ball[0] << " " << ball[1];
  const double distanceBefore = this->State->GetLight().Position[0];
  const int x = static_cast<int>(std::lround(ball[0]));
  const int y = static_cast<int>(std::lround(ball[1]));
  this->Drag(x, y, x + 60, y);
  EXPECT_GT(this->State->GetLight().Position[0], distanceBefore + 1.0)
    << "a drag of the ball counts as one of the light";
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindowLights, TheHandleCastsAndReceivesNothing)
{
  this->Open();
  const std::vector<float> with = this->Frame().GetVisibility().Visibility[0];
  this->Press("g");
  const std::vector<float> without = this->Frame().GetVisibility().Visibility[0];
  for (std::size_t i = 0; i < with.size(); ++i)
  {
    ASSERT_TRUE(with[i] == without[i] || (std::isnan(with[i]) && std::isnan(without[i])));
  }
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindowLights, KeysResizeTheLightAndWidenThePenumbra)
{
  this->Open();
  const auto penumbra = [this]
  {
    const std::vector<float> values = this->Frame().GetVisibility().Visibility[0];
    return std::count_if(
      values.begin(), values.end(), [](float v) { return v > 0.05F && v < 0.95F; });
  };
  const auto before = penumbra();
  for (int i = 0; i < 4; ++i)
  {
    this->Press("plus");
  }
  EXPECT_NEAR(this->Frame().GetScene().GetLight(0)->GetSize()[0], 0.6 * std::pow(1.25, 4), 1e-9);
  EXPECT_GT(penumbra(), before * 3 / 2);
}

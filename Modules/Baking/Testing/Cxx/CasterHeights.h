// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CasterHeights.h
 * @brief What a parallel map sees of casters from above, as heights, and small props to be seen.
 */

#ifndef SoftShadowsBaking_CasterHeights_h
#define SoftShadowsBaking_CasterHeights_h

#include "BakingScene.h"

#include "vtkCubeSource.h"
#include "vtkPolyData.h"

#include <cmath>  // For isnan
#include <limits> // For NaN
#include <vector> // For depths

// A parallel view straight down over [-2, 2]^2 from z = 5, 16 texels to the unit.
inline vtkShadowMapView MakeView()
{
  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(0.0, 0.0, 5.0, true);
  view.Window = { { -2.0, 2.0, -2.0, 2.0 } };
  view.Near = 1.0;
  view.Far = 9.0;
  return view;
}
constexpr int RESOLUTION = 64;

inline vtkSmartPointer<vtkPolyData> MakeBox(double x0, double x1, double y0, double y1, double top)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(x0, x1, y0, y1, top - 0.5, top);
  box->Update();
  return box->GetOutput();
}

// The heights seen, NaN where there is nothing.
class Heights
{
public:
  explicit Heights(BakingScene& scene)
    : Depths(scene.BakeDepths(MakeView(), RESOLUTION))
  {
  }
  double At(double x, double y) const
  {
    const auto i = static_cast<size_t>((x + 2.0) * 16.0);
    const auto j = static_cast<size_t>((y + 2.0) * 16.0);
    const float depth = this->Depths[j * RESOLUTION + i];
    return depth < 1.0f ? 4.0 - 8.0 * depth : std::numeric_limits<double>::quiet_NaN();
  }
  bool IsEmptyAt(double x, double y) const { return std::isnan(this->At(x, y)); }
  bool operator==(const Heights& other) const { return this->Depths == other.Depths; }

private:
  std::vector<float> Depths;
};

inline vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

#endif

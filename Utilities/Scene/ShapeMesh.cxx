// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShapeMesh.h"

#include "vtkAlgorithm.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

namespace softshadows
{
namespace
{

template <typename Source>
vtkSmartPointer<vtkPolyData> Run(Source* source)
{
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> Make(const PlaneShape& plane)
{
  vtkNew<vtkPlaneSource> source;
  // All three at once: the source refuses to pass through a plane without extent.
  source->SetOrigin(plane.Origin[0], plane.Origin[1], plane.Origin[2]);
  source->SetPoint1(plane.Point1[0], plane.Point1[1], plane.Point1[2]);
  source->SetPoint2(plane.Point2[0], plane.Point2[1], plane.Point2[2]);
  source->SetResolution(plane.XResolution, plane.YResolution);
  return Run(source.Get());
}

vtkSmartPointer<vtkPolyData> Make(const BoxShape& box)
{
  vtkNew<vtkCubeSource> source;
  source->SetBounds(box.Bounds.data());
  return Run(source.Get());
}

vtkSmartPointer<vtkPolyData> Make(const SphereShape& sphere)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(sphere.Center[0], sphere.Center[1], sphere.Center[2]);
  source->SetRadius(sphere.Radius);
  source->SetThetaResolution(sphere.ThetaResolution);
  source->SetPhiResolution(sphere.PhiResolution);
  source->SetStartTheta(sphere.StartTheta);
  source->SetEndTheta(sphere.EndTheta);
  source->SetStartPhi(sphere.StartPhi);
  source->SetEndPhi(sphere.EndPhi);
  return Run(source.Get());
}

vtkSmartPointer<vtkPolyData> Make(const CylinderShape& cylinder)
{
  vtkNew<vtkCylinderSource> source;
  source->SetCenter(cylinder.Center[0], cylinder.Center[1], cylinder.Center[2]);
  source->SetRadius(cylinder.Radius);
  source->SetHeight(cylinder.Height);
  source->SetResolution(cylinder.Resolution);
  source->SetCapping(cylinder.Capping);
  return Run(source.Get());
}

vtkSmartPointer<vtkPolyData> Make(const ConeShape& cone)
{
  vtkNew<vtkConeSource> source;
  source->SetCenter(cone.Center[0], cone.Center[1], cone.Center[2]);
  source->SetRadius(cone.Radius);
  source->SetHeight(cone.Height);
  source->SetResolution(cone.Resolution);
  source->SetDirection(cone.Direction[0], cone.Direction[1], cone.Direction[2]);
  source->SetCapping(cone.Capping);
  return Run(source.Get());
}

vtkSmartPointer<vtkPolyData> Make(const TorusShape& torus)
{
  vtkNew<vtkParametricTorus> function;
  function->SetRingRadius(torus.RingRadius);
  function->SetCrossSectionRadius(torus.CrossSectionRadius);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(function);
  source->SetUResolution(torus.UResolution);
  source->SetVResolution(torus.VResolution);
  source->SetScalarModeToNone();
  return Run(source.Get());
}

}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeMesh(
  const ShapeDescription& shape, const std::string& sceneFolder, ModelStore& models)
{
  if (const auto* model = std::get_if<ModelShape>(&shape))
  {
    return models.Load(*model, sceneFolder);
  }
  return std::visit(
    [](const auto& source) -> vtkSmartPointer<vtkPolyData>
    {
      using Shape = std::decay_t<decltype(source)>;
      if constexpr (std::is_same_v<Shape, ModelShape>)
      {
        return nullptr;
      }
      else
      {
        return Make(source);
      }
    },
    shape);
}

}

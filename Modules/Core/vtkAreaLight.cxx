// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLight.h"

#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationKeyLookup.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

// vtkOSPRayLightNode's key, without linking to the ray tracing module; null if nobody has it.
vtkInformationDoubleKey* FindRadiusKey()
{
  return vtkInformationDoubleKey::SafeDownCast(
    vtkInformationKeyLookup::Find("RADIUS", "vtkOSPRayLightNode"));
}

}

vtkStandardNewMacro(vtkAreaLight);

//------------------------------------------------------------------------------
vtkAreaLight::vtkAreaLight()
{
  constexpr double noCone = 90.0;
  this->Positional = 1;
  this->ConeAngle = noCone;
}

//------------------------------------------------------------------------------
const char* vtkAreaLight::GetShapeAsString() const
{
  switch (this->Shape)
  {
    case DISK:
      return "disk";
    case POINT:
      return "point";
    default:
      return "rectangle";
  }
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetPositional(vtkTypeBool positional)
{
  this->Superclass::SetPositional(positional);
  this->WarnOfContradiction();
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetSize(double width, double height)
{
  if (!std::isfinite(width) || !std::isfinite(height) || width < 0.0 || height < 0.0)
  {
    vtkErrorMacro("Size must be finite and not negative, but is ("
      << width << ", " << height << "); it stays (" << this->Size[0] << ", " << this->Size[1]
      << ").");
    return;
  }
  if (this->Size[0] != width || this->Size[1] != height)
  {
    this->Size[0] = width;
    this->Size[1] = height;
    this->Modified();
  }
  this->SizeIsSet = true;
  this->WarnOfContradiction();
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetAngularDiameter(double degrees)
{
  if (std::isnan(degrees))
  {
    vtkErrorMacro("AngularDiameter must be a number; it stays " << this->AngularDiameter << ".");
    return;
  }
  const double clamped = std::min(
    std::max(degrees, this->GetAngularDiameterMinValue()), this->GetAngularDiameterMaxValue());
  if (this->AngularDiameter != clamped)
  {
    this->AngularDiameter = clamped;
    this->Modified();
  }
  if (clamped > 0.0)
  {
    this->Superclass::SetPositional(0);
  }
  this->WarnOfContradiction();
}

//------------------------------------------------------------------------------
// Once when a contradiction arises, not again until it is gone.
void vtkAreaLight::WarnOfContradiction()
{
  const bool isUselessSize = !this->Positional && this->SizeIsSet;
  const bool isUselessAngle = this->Positional && this->AngularDiameter > 0.0;
  const bool isNews = !this->IsWarned && !this->WarnsOfNothing;
  this->IsWarned = isUselessSize || isUselessAngle;
  if (isNews && isUselessSize)
  {
    vtkWarningMacro(
      "The light is directional, and its Size has no effect: set its AngularDiameter, "
      "or call SetPositional(1).");
  }
  if (isNews && isUselessAngle)
  {
    vtkWarningMacro("The light is positional, and its AngularDiameter of "
      << this->AngularDiameter
      << " degrees has no effect: set its Size and an AngularDiameter of 0, or call "
         "SetPositional(0).");
  }
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetExtent(vtkLight* light, double extent)
{
  if (!light || vtkAreaLight::SafeDownCast(light))
  {
    return;
  }
  if (!std::isfinite(extent) || extent < 0.0)
  {
    vtkErrorWithObjectMacro(
      light, "The extent must be finite and not negative, but is " << extent << ".");
    return;
  }
  vtkInformationDoubleKey* key = FindRadiusKey();
  if (!key)
  {
    key = vtkInformationDoubleKey::MakeKey("RADIUS", "vtkOSPRayLightNode");
  }
  if (!light->GetInformation())
  {
    light->SetInformation(vtkNew<vtkInformation>());
  }
  light->GetInformation()->Set(key, light->GetPositional() ? 0.5 * extent : extent);
  light->Modified();
}

//------------------------------------------------------------------------------
double vtkAreaLight::GetExtent(vtkLight* light)
{
  vtkInformation* information = light ? light->GetInformation() : nullptr;
  vtkInformationDoubleKey* key = FindRadiusKey();
  if (!information || !key || !information->Has(key) || vtkAreaLight::SafeDownCast(light))
  {
    return 0.0;
  }
  const double radius = information->Get(key);
  const double extent = light->GetPositional() ? 2.0 * radius : radius;
  return std::isfinite(extent) ? std::max(extent, 0.0) : 0.0;
}

//------------------------------------------------------------------------------
void vtkAreaLight::GetTransformedAxes(
  vtkLight* light, double widthAxis[3], double heightAxis[3], double direction[3])
{
  double position[3];
  double focalPoint[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focalPoint);
  vtkMath::Subtract(focalPoint, position, direction);
  if (vtkMath::Normalize(direction) == 0.0)
  {
    direction[2] = -1.0; // a light that aims at itself has no direction; any will do
  }

  double up[4] = { 0.0, 0.0, 0.0, 0.0 };
  if (vtkAreaLight* area = vtkAreaLight::SafeDownCast(light))
  {
    std::copy(area->ViewUp, area->ViewUp + 3, up);
  }
  if (vtkMatrix4x4* transform = light->GetTransformMatrix())
  {
    transform->MultiplyPoint(up, up);
  }
  vtkMath::Normalize(up);
  vtkMath::Cross(direction, up, widthAxis);
  // No up, one along the direction, or one that is not finite (the norm is not a number then).
  if (!(vtkMath::Norm(widthAxis) >= 1e-6))
  {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      // "Equal" survives the rounding of a normalised direction.
      least = std::abs(direction[axis]) < std::abs(direction[least]) - 1e-12 ? axis : least;
    }
    double worldAxis[3] = { 0.0, 0.0, 0.0 };
    worldAxis[least] = 1.0;
    vtkMath::Cross(direction, worldAxis, widthAxis);
  }
  vtkMath::Normalize(widthAxis);
  vtkMath::Cross(widthAxis, direction, heightAxis);
}

//------------------------------------------------------------------------------
void vtkAreaLight::CopyExtent(vtkAreaLight* light)
{
  this->SetShape(light->Shape);
  this->SetSize(light->Size);
  this->SizeIsSet = light->SizeIsSet;
  this->SetViewUp(light->ViewUp);
  this->SetAngularDiameter(light->AngularDiameter);
  this->SetPositional(light->Positional); // which an angular diameter has changed
}

//------------------------------------------------------------------------------
vtkLight* vtkAreaLight::ShallowClone()
{
  // Not the superclass's clone, which lacks the shadow attenuation and the information keys.
  vtkAreaLight* clone = vtkAreaLight::New();
  clone->DeepCopy(this);
  clone->SetTransformMatrix(this->TransformMatrix);
  return clone;
}

//------------------------------------------------------------------------------
void vtkAreaLight::DeepCopy(vtkLight* light)
{
  this->WarnsOfNothing = true;
  this->Superclass::DeepCopy(light);
  if (vtkAreaLight* area = vtkAreaLight::SafeDownCast(light))
  {
    this->CopyExtent(area);
  }
  this->WarnsOfNothing = false;
}

//------------------------------------------------------------------------------
void vtkAreaLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->GetShapeAsString() << "\n";
  os << indent << "Size: (" << this->Size[0] << ", " << this->Size[1] << ")\n";
  os << indent << "ViewUp: (" << this->ViewUp[0] << ", " << this->ViewUp[1] << ", "
     << this->ViewUp[2] << ")\n";
  os << indent << "AngularDiameter: " << this->AngularDiameter << "\n";
}
VTK_ABI_NAMESPACE_END

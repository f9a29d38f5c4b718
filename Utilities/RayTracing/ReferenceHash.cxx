// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceHash.h"

#include "ReferenceCamera.h"
#include "ReferenceGeometry.h"

#include "vtkShadowEmitter.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkRenderer.h>
#include <vtksys/MD5.h>

#include <memory> // For the hash's life

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
class Hash
{
public:
  Hash()
    : State(vtksysMD5_New(), vtksysMD5_Delete)
  {
    vtksysMD5_Initialize(this->State.get());
  }

  template <typename T>
  void Add(const T* values, size_t count)
  {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values);
    size_t left = count * sizeof(T);
    while (left > 0)
    {
      // The library takes an int.
      const size_t part = std::min<size_t>(left, 1U << 30);
      vtksysMD5_Append(this->State.get(), bytes, static_cast<int>(part));
      bytes += part;
      left -= part;
    }
  }

  void Add(double value) { this->Add(&value, 1); }
  void Add(const Vector& value) { this->Add(value.data(), 3); }

  std::string Finish()
  {
    char digits[33] = {};
    vtksysMD5_FinalizeHex(this->State.get(), digits);
    return std::string(digits, 32);
  }

private:
  std::unique_ptr<vtksysMD5, void (*)(vtksysMD5*)> State;
};

//--------------------------------------------------------------------------------------------------
void AddGeometry(const ReferenceGeometry& geometry, Hash& hash)
{
  hash.Add(geometry.Origin);
  hash.Add(geometry.Scale);
  hash.Add(geometry.Points.data(), geometry.Points.size());
  hash.Add(geometry.Triangles.data(), geometry.Triangles.size());
  for (const ReferenceGeometry::Object& object : geometry.Objects)
  {
    hash.Add((object.Casts ? 1.0 : 0.0) + (object.Receives ? 2.0 : 0.0));
  }
}

//--------------------------------------------------------------------------------------------------
void AddLight(vtkLight* light, Hash& hash)
{
  vtkShadowEmitter emitter;
  std::string reason;
  hash.Add(vtkShadowEmitter::FromLight(light, emitter, reason) ? 1.0 : 0.0);
  hash.Add(emitter.Shape + (emitter.Directional ? 8.0 : 0.0) + (emitter.Omni ? 16.0 : 0.0));
  for (const Vector& vector : { emitter.Center, emitter.AxisU, emitter.AxisV, emitter.Direction })
  {
    hash.Add(vector);
  }
  hash.Add(emitter.HalfSize.data(), 2);
  hash.Add(emitter.ConeAngle);
}

}

//--------------------------------------------------------------------------------------------------
std::string HashScene(vtkRenderer* renderer)
{
  Hash hash;
  const ReferenceGeometry geometry(renderer);
  AddGeometry(geometry, hash);
  // Two corners' rays tell all that a camera decides on.
  const ReferenceCamera camera(renderer->GetActiveCamera(), 16, 16, geometry);
  for (int corner : { 0, 15 })
  {
    const ReferenceRayCaster::Ray ray = camera.GetRay(corner, corner / 2);
    hash.Add(ray.Origin);
    hash.Add(ray.Direction);
  }
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      AddLight(light, hash);
    }
  }
  return hash.Finish();
}

}

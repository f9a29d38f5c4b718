// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedReceivers
 * @brief   The visible points of a frame in the processor's memory.
 */

#ifndef vtkTracedReceivers_h
#define vtkTracedReceivers_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedVector.h"

#include <cstddef> // For sizes
#include <vector>  // For pixels

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowReceivers;
class vtkTracedScene;

class vtkTracedReceivers
{
public:
  /// Copies what the receivers' camera sees. Waits for the GPU.
  void Read(vtkShadowReceivers* receivers);

  /// Coordinates below are the scene's local ones.
  void SetScene(const vtkTracedScene& scene);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

  /// Where the camera is, which view coordinates are relative to.
  const vtkTracedVector& GetEye() const { return this->ViewToLocal.Offset; }

  bool Receives(std::size_t pixel) const;

  struct Point
  {
    vtkTracedVector Place;
    vtkTracedVector Normal; // unit, towards the camera
    double Precision;       // how far off the place may be

    /// Where its rays start.
    vtkTracedVector GetStart() const { return this->Place + this->Precision * this->Normal; }
  };
  Point GetPoint(std::size_t pixel) const;

  /// Of view coordinates to local ones.
  float GetScale() const { return static_cast<float>(this->Scale); }

  /// View coordinates.
  const float* GetPosition(std::size_t pixel) const { return &this->Positions[4 * pixel]; }
  const float* GetNormal(std::size_t pixel) const { return &this->Normals[4 * pixel]; }

private:
  int Width = 0;
  int Height = 0;
  std::vector<float> Positions; // 4 per pixel, bottom row first; the last is the mark
  std::vector<float> Normals;
  std::array<double, 16> ViewToWorld{};
  vtkTracedMap ViewToLocal;
  double Scale = 1.0;
};

VTK_ABI_NAMESPACE_END
#endif

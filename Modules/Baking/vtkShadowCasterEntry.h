// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterEntry
 * @brief   What is remembered of one visible opaque prop, or leaf of an assembly.
 */

#ifndef vtkShadowCasterEntry_h
#define vtkShadowCasterEntry_h

#include "vtkShadowCasterBuffer.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowCasterShape.h"
#include "vtkShadowCasterSource.h"
#include "vtkShadowCasters.h"
#include "vtkShadowScreen.h"
#include "vtkShadowStrokes.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array>   // For matrices
#include <cstdint> // For signatures
#include <memory>  // For strokes
#include <vector>  // For the scratch memory

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
class vtkProp3D;

class vtkShadowCasterEntry
{
public:
  /// What the last Refresh or Place found to be new.
  struct Change
  {
    bool Casters = false; ///< what a depth map shows
    bool Bodies = false;  ///< boxes, planes, flags
    bool Looks = false;   ///< what a picture shows of it, from anywhere
  };

  vtkProp3D* Prop = nullptr; // valid during an Update and the draws until the next
  bool IsLeaf = false;       // of an assembly: Matrix is not the prop's own
  std::array<double, 16> Matrix{};
  vtkShadowCasters::Body Body;
  /// What maps are fitted to: parts of the body, or itself.
  std::vector<vtkShadowCasters::Body> Parts;
  bool HasBody = false;

  /**
   * Whether anything that receives lies on the negative and on the positive side of a flat body.
   * Both for any other.
   */
  std::array<bool, 2> HasReceivers{ { true, true } };

  /// Of the map that is drawn now: GetFacing(), or 0 for both sides, or NO_SIDE.
  static constexpr int NO_SIDE = 2;
  int SideToDraw = NO_SIDE;

  /// Takes over what the prop is now. Geometry is rebuilt if the prop's shape changed.
  Change Refresh(const vtkShadowCasterSource& source, const std::array<double, 16>& matrix,
    bool casts, bool receives);

  /// The prop has to be transformed and written again, whether or not it changed.
  void Touch() { this->Moved = true; }

  /// Transforms, finds the body and writes to the buffer what is new.
  Change Place(vtkShadowCasterBuffer& buffer, const std::array<double, 3>& origin,
    const vtkShadowScreen& screen, std::vector<float>& scratch);

  /// Gives the buffer its room back, and OpenGL what is the entry's own.
  void Remove(vtkShadowCasterBuffer& buffer)
  {
    buffer.Free(this->Range);
    this->ReleaseGraphicsResources();
  }
  void ReleaseGraphicsResources();
  /// The buffer has been cleared.
  void ForgetRange();

  bool DrawsFromBuffer() const { return this->HasBody && this->Body.Casts && this->IsInBuffer(); }
  bool DrawsThroughMapper() const
  {
    return this->HasBody && this->Body.Casts && this->Route == vtkShadowCasterSource::MAPPER;
  }
  /// Nothing but triangles in a plane.
  bool IsFlat() const { return this->HasBody && this->Body.Flat && this->IsInBuffer(); }
  const vtkShadowCasterBuffer::Range& GetRange() const { return this->Range; }

  /// Which the strokes are as wide as.
  const vtkShadowScreen& GetScreen() const { return this->Screen; }
  bool HasStrokes() const { return this->Strokes != nullptr; }
  /// To be drawn; null if there are none.
  vtkShadowStrokes* GetStrokes() const
  {
    return this->DrawsFromBuffer() ? this->Strokes.get() : nullptr;
  }

  /// For techniques that do without depth maps.
  vtkShadowCasterShape GetShape() const;

  /// 1 or -1 if a light outside the body's box sees only the triangles that turn counterclockwise
  /// or clockwise, 0 if it may see both.
  int GetFacing() const { return this->Facing; }

private:
  bool IsInBuffer() const { return this->Route == vtkShadowCasterSource::BUFFER; }
  void StampShape();
  void FindFacing();
  void TakeStrokes(const vtkShadowCasterSource& source);
  bool FindBody(const std::array<double, 3>& origin, std::vector<float>& scratch);
  void AddStrokeBounds();
  bool HasOwnDraws() const { return this->Strokes || this->Route == vtkShadowCasterSource::MAPPER; }
  void FindPlane();
  void FindParts();
  static bool SetCorners(const std::array<std::array<double, 3>, 4>& corners,
    const std::array<double, 16>& matrix, vtkShadowCasters::Body& body);
  Change Write(vtkShadowCasterBuffer& buffer, const std::vector<float>& scratch);

  int Route = vtkShadowCasterSource::NONE;
  std::uint64_t Number = 0; // of no other entry, 0 before the first Refresh
  vtkMTimeType ShapeTime = 0;
  std::vector<vtkPolyData*> Pieces; // valid during an Update and until the next; none if not known
  std::uint64_t Signature = 0;
  std::uint64_t Look = 0;
  bool Moved = true;
  bool Reshaped = true;
  int UnchangedUpdates = 0; // of the geometry
  int Orientation = 0;      // of the geometry
  int Facing = 0;
  vtkShadowCasterGeometry Geometry;
  vtkShadowCasterBuffer::Range Range;
  std::unique_ptr<vtkShadowStrokes> Strokes;
  vtkShadowScreen Screen;                 // which the strokes are as wide as
  std::array<double, 6> TriangleBounds{}; // of a body with strokes
  bool HasTriangles = false;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterEntry.h

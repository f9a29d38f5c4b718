// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowMapStore
 * @brief   The depth maps of many lights under one budget: found by light and emitter, baked, evicted.
 *
 * Maps are found by whom they are of, whatever the order of the lights, and are valid as long as views and
 * casters stay. Where the budget ends, maps that nothing has used since Begin go first, the least recently
 * used before others; then the most recently used ones, so that those before them are still there in the
 * next frame. A texture that goes is handed to whom it fits: beyond the budget nothing is allocated as long
 * as sizes repeat. What is used for one emitter stays together, even beyond the budget.
 */

#ifndef vtkShadowMapStore_h
#define vtkShadowMapStore_h

#include "vtkRenderingSoftShadowsBakingModule.h" // For export macro
#include "vtkShadowMapView.h"                    // For views
#include "vtkSoftShadowsABI.h"                   // For the ABI namespace
#include "vtkType.h"                             // For bytes

#include <memory> // For the implementation
#include <vector> // For views

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
class vtkRenderer;
class vtkShadowCasters;
class vtkShadowDepthMaps;
class vtkShadowDepthPyramid;
class vtkWindow;

class VTKRENDERINGSOFTSHADOWSBAKING_EXPORT vtkShadowMapStore
{
public:
  vtkShadowMapStore();
  ~vtkShadowMapStore();
  vtkShadowMapStore(const vtkShadowMapStore&) = delete;
  vtkShadowMapStore& operator=(const vtkShadowMapStore&) = delete;

  /// Whose maps they are.
  struct Key
  {
    const vtkLight* Light = nullptr; // compared, never followed
    int Part = 0;                    // which of its emitters
    int Kind = 0;                    // which of the emitter's textures

    bool operator==(const Key& other) const
    {
      return this->Light == other.Light && this->Part == other.Part && this->Kind == other.Kind;
    }
  };

  /// What is asked for.
  struct Request
  {
    std::vector<vtkShadowMapView> Views;
    int MapSize = 0;
    bool Conservative = false;
    bool Pyramid = false;
  };

  /// Maps that are valid until the next emitter begins. Null if they cannot be had.
  struct Maps
  {
    vtkShadowDepthMaps* Depths = nullptr;
    vtkShadowDepthPyramid* Pyramid = nullptr; // there, but empty, where none was asked for
    int Baked = 0;                            // layers, just now
  };

  /// Bytes of all maps and pyramids together; 0: no budget. What is beyond a smaller one goes in Begin.
  void SetBudget(vtkTypeInt64 bytes);

  /// Begins a frame. What belongs to lights that the renderer no longer has goes.
  void Begin(vtkRenderer* renderer);

  /// What is used from now on stays until the next call.
  void BeginEmitter();

  /// Makes the maps valid and counts as a use. vtkShadowFailures is told what cannot be had.
  Maps Bake(
    vtkRenderer* renderer, vtkShadowCasters* casters, const Key& key, const Request& request);

  /// Frees one texture.
  void Release(const Key& key);

  ///@{
  /// Bytes of all textures; draw calls into maps and number of textures made, since construction.
  vtkTypeInt64 GetBytes() const;
  vtkTypeInt64 GetNumberOfDrawCalls() const;
  vtkTypeInt64 GetNumberOfAllocations() const { return this->Allocations; }
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Entry;

  Entry* Find(const Key& key) const;
  Entry& Provide(const Key& key, const Request& request);
  /// What goes next; with a request, of those alone whose texture suits it. Null if there is none.
  Entry* FindVictim(const Entry* wanting, const Request* suiting) const;
  void Remove(const Entry* entry);

  std::vector<std::unique_ptr<Entry>> Entries;
  vtkTypeInt64 Budget = 0;
  bool IsBudgetLess = false; // than before
  vtkTypeInt64 Uses = 0;     // a clock
  vtkTypeInt64 FrameBegin = 0;
  vtkTypeInt64 EmitterBegin = 0;
  vtkTypeInt64 DrawCalls = 0; // of what is gone
  vtkTypeInt64 Allocations = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowMapStore.h

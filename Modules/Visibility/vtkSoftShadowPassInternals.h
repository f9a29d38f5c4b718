// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowPass::Internals
 * @brief   What a soft-shadow pass keeps from frame to frame.
 */

#ifndef vtkSoftShadowPassInternals_h
#define vtkSoftShadowPassInternals_h

#include "vtkNew.h" // For members
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowContextWatch.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkSmartPointer.h"
#include "vtkSoftShadowAccumulator.h"
#include "vtkSoftShadowDrawnMappers.h"
#include "vtkSoftShadowLightMaps.h"
#include "vtkSoftShadowLosses.h"
#include "vtkSoftShadowMapperHooks.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowSchedule.h"
#include "vtkSoftShadowSignature.h"
#include "vtkSoftShadowTarget.h"
#include "vtkSoftShadowTimers.h"
#include "vtkWeakPointer.h"

#include "vtkSoftShadowConstantFS.h"
#include "vtkSoftShadowPointFS.h"
#include "vtkSoftShadowProofFS.h"

#include <memory> // For light maps
#include <set>    // For names
#include <string> // For reasons
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN

class vtkSoftShadowPass::Internals
{
public:
  explicit Internals(vtkSoftShadowPass* self)
    : Watch([self](vtkOpenGLRenderWindow* window) { self->ReleaseGraphicsResources(window); })
    , PointMaps(vtkSmartPointer<vtkShadowDepthMaps>::New())
  {
  }

  /// Of the window whose context holds the resources.
  vtkShadowContextWatch Watch;

  // What is read back lies in the window of the last frame, whichever has rendered or died since.
  void MakeCurrent()
  {
    if (this->Watch.GetWindow())
    {
      this->Watch.GetWindow()->MakeCurrent();
    }
  }

  /// A lit light of the frame.
  struct LitLight
  {
    vtkLight* Light = nullptr;
    bool Casts = false;
    vtkShadowEmitter Emitter;
    std::string Reason; // why it casts nothing
    int Layer = -1;
  };

  vtkNew<vtkShadowCasters> Casters;
  vtkNew<vtkShadowReceivers> Receivers;
  std::unique_ptr<vtkSoftShadowTarget> Target{ new vtkSoftShadowTarget };
  vtkSoftShadowMapperHooks Hooks;
  vtkSoftShadowDrawnMappers ReceiverMappers; // of the visibility that is held
  vtkSoftShadowDrawnMappers ShadingMappers;
  vtkSoftShadowDrawnMappers* Drawn = nullptr; // one of them while it is drawn
  vtkSoftShadowTimers Timers;
  vtkSoftShadowStatistics Statistics;
  vtkSoftShadowSignature Signature;     // of the visibility that is held
  vtkSoftShadowSignature NextSignature; // of the frame at hand
  std::vector<LitLight> Lights;
  std::vector<std::unique_ptr<vtkSoftShadowLightMaps>> Maps; // per casting light
  vtkSoftShadowLosses Losses;                                // of the visibility that is held
  int ToldMapSize = 0;                                       // that is too large for this OpenGL
  bool ToldLayers = false;           // that there are more lights than layers
  std::set<std::string> ToldMappers; // whose programs take no shadows

  vtkShadowShader ProofShader{ vtkSoftShadowProofFS };
  vtkShadowShader ConstantShader{ vtkSoftShadowConstantFS };

  /// The running mean while nothing changes.
  vtkSoftShadowSchedule Schedule;
  std::unique_ptr<vtkSoftShadowAccumulator> Accumulator{ new vtkSoftShadowAccumulator };
  vtkSmartPointer<vtkShadowDepthMaps> PointMaps; // of one point; sizes follow each other
  std::vector<double> PointWeights;              // in the sum, per casting light
  vtkShadowShader PointShader{ vtkSoftShadowPointFS };
  int Refinements = 0;  // frames that added to it
  bool HasNews = false; // it has just converged
  bool WarnedOfRange = false;

  /**
   * What is read, where the picture is shaded with the visibility of smooth receivers: that of the
   * triangles themselves. Its own target, mean and queries change places with the picture's while it is
   * estimated.
   */
  struct DataEstimate
  {
    std::unique_ptr<vtkSoftShadowTarget> Target{ new vtkSoftShadowTarget };
    vtkSoftShadowSchedule Schedule;
    std::unique_ptr<vtkSoftShadowAccumulator> Accumulator{ new vtkSoftShadowAccumulator };
    vtkSmartPointer<vtkShadowDepthMaps> PointMaps = vtkSmartPointer<vtkShadowDepthMaps>::New();
    std::vector<double> PointWeights;
    int Refinements = 0;
    std::vector<unsigned int> Queries;
    size_t UsedQueries = 0;
    bool IsKnown = false;  // of the receivers at hand
    bool IsWanted = false; // it was read since they were drawn
  };
  DataEstimate Data;
  bool IsData = false;                  // it is what is being estimated
  bool IsTechniqueMoved = false;        // a technique was last asked for data
  vtkWeakPointer<vtkRenderer> Renderer; // of the last frame

  void SwapData();
  void ReleaseData(vtkWindow* window);

  /// What a light's sum is multiplied by to be a mean; 0 if there is none.
  float GetMeanScale(int layer) const
  {
    const double weight = this->PointWeights[layer];
    return weight > 0.0 ? static_cast<float>(1.0 / weight) : 0.0f;
  }

  int Viewport[4] = { 0, 0, 0, 0 };

  /// Occlusion queries of the filtered pixels: one per light and face.
  std::vector<unsigned int> Queries;
  size_t UsedQueries = 0;
  bool CountNextDraw = false;
};

VTK_ABI_NAMESPACE_END
#endif

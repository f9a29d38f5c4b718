// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowLights
 * @brief   The lit lights of a frame in the renderer's order, with the views that fit those that cast.
 */

#ifndef vtkSoftShadowLights_h
#define vtkSoftShadowLights_h

#include "vtkShadowEmitter.h"      // For emitters
#include "vtkSoftShadowLightFit.h" // For fits
#include "vtkSoftShadowsABI.h"     // For the ABI namespace

#include <map>    // For fits
#include <string> // For reasons
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
class vtkRenderer;
class vtkShadowMapFitter;
class vtkSoftShadowLosses;
class vtkSoftShadowSignature;

class vtkSoftShadowLights
{
public:
  struct LitLight
  {
    vtkLight* Light = nullptr; // may have died since it was collected
    bool Positional = false;
    bool Casts = false;
    vtkShadowEmitter Emitter;
    std::string Reason; // why it casts nothing
    int Layer = -1;     // its number among those that cast
  };

  /// Takes the renderer's. Returns what to warn of: lights without layers, once; else nothing.
  std::string Collect(vtkRenderer* renderer);

  /// Takes lights that are far away compared with what casts as directional ones.
  void SeeFromAfar(const vtkShadowMapFitter& fitter);

  /// A light that is lost has no layer: it reaches every surface.
  void Hide(const vtkSoftShadowLosses& losses);

  std::vector<LitLight>::const_iterator begin() const { return this->Lights.begin(); }
  std::vector<LitLight>::const_iterator end() const { return this->Lights.end(); }
  int GetNumberOfLights() const { return static_cast<int>(this->Lights.size()); }
  const LitLight& GetLight(int index) const { return this->Lights[index]; }

  /// As of Collect, those that were lost later included.
  int GetNumberOfCasting() const { return this->Casting; }

  /// Which of the lit lights it is; -1 if it is none.
  int Find(const vtkLight* light) const;

  /// The numbers of the lights that cast, by layer.
  std::vector<int> GetNumbersByLayer() const;

  /// The views that fit a light that casts.
  vtkSoftShadowLightFit& GetFit(int layer) { return *this->FitsByLayer[layer]; }

  void AddTo(vtkSoftShadowSignature& signature) const;

  /// A line per light: what it casts, or why it casts nothing.
  std::string Describe() const;

private:
  std::vector<LitLight> Lights;
  std::map<const vtkLight*, vtkSoftShadowLightFit> Fits; // of the renderer's lights, lit or not
  std::vector<vtkSoftShadowLightFit*> FitsByLayer;
  int Casting = 0;
  bool ToldLayers = false; // that there are more lights than layers
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowLights.h

// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowMapperHooks
 * @brief   What the pass changes in the mappers' programs, and the uniforms it sets in them.
 *
 * One program serves both stages, so that no program is rebuilt from frame to frame; the uniform
 * softShadowStage chooses between writing receivers and shading.
 *
 *     mark                     must be there              becomes
 *     //VTK::Light::Dec        always                     declarations, then the mark
 *     //VTK::Light::Impl       always                     own marks Receive and Shade, then the mark
 *     //VTK::Picking::Impl     with textures              the mark, then own mark Receive
 *     //VTK::PositionVC::Impl  of the vertex shader       the mark, then own mark Bend
 *     own mark Bend            normals of vertices        writes what tells the smooth surface
 *     own mark Smooth          the same                   finds the smooth surface
 *     own mark Receive         vertexVC (lit surfaces)    writes position and plane, of the depth
 *                                                         that is drawn where a shader replaces it
 *     own mark Shade           uniform lightColor<i>      multiplies the light's colour
 */

#ifndef vtkSoftShadowMapperHooks_h
#define vtkSoftShadowMapperHooks_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <string> // For sources
#include <vector> // For layers

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkShadowCasters;
class vtkSoftShadowLights;

class vtkSoftShadowMapperHooks
{
public:
  ///@{
  /// Frame-wide values of the uniforms.
  int Stage = 0;
  int Origin[2] = { 0, 0 };
  int VisibilityUnit = 0;
  /// The camera's projection: z and w of clip coordinates are a z + b and c z + d in view coordinates.
  float DepthToView[4] = { 0.0f, 0.0f, 0.0f, 1.0f };
  const vtkShadowCasters* Casters = nullptr; // what receivers are part of
  bool Smooth = false;             // receivers on the surface that the vertices' normals tell of
  std::vector<int> Layers;         // per lit light, in the renderer's order
  std::vector<float> Attenuations; // per lit light: vtkLight::ShadowAttenuation, within [0, 1]
  ///@}

  /// Takes over the lights.
  void SetLights(const vtkSoftShadowLights& lights);

  /// Takes over the projection.
  void SetCamera(vtkRenderer* renderer);

  void PreReplace(std::string& vertexShader, std::string& fragmentShader, vtkProp* prop) const;
  /**
   * Puts in what the marks stand for. Returns what is wrong with a program that lights its surfaces but
   * has none of the marks that shadows need, as if VTK had renamed them: an end of a sentence, empty if
   * all is well.
   */
  static std::string PostReplace(
    std::string& vertexShader, const std::string& geometryShader, std::string& fragmentShader);
  void SetUniforms(vtkShaderProgram* program, vtkProp* prop) const;
};

VTK_ABI_NAMESPACE_END
#endif

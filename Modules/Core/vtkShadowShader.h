// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowShader
 * @brief   A fragment shader run over the whole viewport, made of a .glsl file and shared snippets.
 *
 * In the text a line
 *
 *     //SoftShadows::Include NAME
 *
 * is replaced by Core's snippet NAME (the stem of a file in Modules/Core/glsl), once however often it
 * is asked for. Definitions become `define` lines behind the version. The program is built when first
 * used and again only if the definitions change. In the drawing code:
 *
 *     if (shader.Use(window))
 *     {
 *       shader.GetProgram()->SetUniformf("weight", 0.5f);
 *       shader.Draw();
 *     }
 */

#ifndef vtkShadowShader_h
#define vtkShadowShader_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkShadowContextWatch.h"             // For members
#include "vtkSmartPointer.h"                   // For members
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <string>  // For text
#include <utility> // For definitions
#include <vector>  // For definitions

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkWindow;

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowShader
{
public:
  using Definitions = std::vector<std::pair<std::string, std::string>>;

  /// text: a fragment shader as encoded from a .glsl file; kept, not copied.
  explicit vtkShadowShader(const char* text);
  ~vtkShadowShader();
  vtkShadowShader(const vtkShadowShader&) = delete;
  vtkShadowShader& operator=(const vtkShadowShader&) = delete;

  /**
   * The text with its includes and definitions in place. An unknown include becomes an `error` line.
   */
  static std::string Compose(const char* text, const Definitions& definitions = Definitions());

  /// What C++ and GLSL share (stages, receiver marks), added to every composed text.
  static Definitions CommonDefinitions();

  /// Replaces the definitions; the program is rebuilt at the next Use if they differ.
  void SetDefinitions(const Definitions& definitions);

  /// Makes the program current, building it if need be. False, which vtkShadowFailures is told, if it
  /// does not compile.
  bool Use(vtkOpenGLRenderWindow* window);

  vtkShaderProgram* GetProgram() const { return this->Program; }

  /// Number of times the program was built.
  int GetNumberOfBuilds() const { return this->NumberOfBuilds; }

  /**
   * Draws over the viewport at depth 0.5, in bands if the taps that a pixel takes at most make it long
   * work (vtkShadowBands). The program must be in use. Nothing is drawn once something could not be had
   * (vtkShadowFailures::IsFailing).
   */
  void Draw(double tapsPerPixel = 0.0);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  const char* Text;
  Definitions Defined;
  vtkShaderProgram* Program = nullptr; // the window's shader cache owns it
  vtkSmartPointer<vtkOpenGLVertexArrayObject> VertexArray;
  int NumberOfBuilds = 0;
  vtkShadowContextWatch Watch;
};

/// Marks of receivers and values of the stage uniform.
enum vtkSoftShadowMarks
{
  VTK_SOFT_SHADOW_STAGE_SHADE = 0,
  VTK_SOFT_SHADOW_STAGE_RECEIVE = 1,
  VTK_SOFT_SHADOW_SURFACE = 2,
  VTK_SOFT_SHADOW_RECEIVES = 3
};

/**
 * In the receivers' position texture w is a mark with a normal: at least FIRST_NORMAL for what receives, at
 * most its negative for a surface that does not. What is beyond it is the number x + STEPS y of a cell of
 * the octahedron's map onto a square: an integer that floats hold exactly.
 */
enum vtkSoftShadowPackedNormals
{
  VTK_SOFT_SHADOW_FIRST_NORMAL = 4,
  VTK_SOFT_SHADOW_NORMAL_STEPS = 2048
};

/// Points of the light per draw of the snippet vtkShadowSamples: a matrix each must fit the least
/// number of uniforms that OpenGL 3.2 guarantees.
enum vtkSoftShadowLimits
{
  VTK_SOFT_SHADOW_SAMPLES_PER_DRAW = 32
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowShader.h

// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowPass
 * @brief   Draws opaque props with the visibility of area lights; the technique is a subclass.
 *
 * A frame, in order:
 *  1. casters: bring the cached geometry up to date;
 *  2. maps: fit views to the lights;
 *  3. receivers: the visible point of every pixel, drawn by the mappers' own programs;
 *  4. visibility: per light, bake the depth maps that something changed, prove pixels lit or blocked where
 *     the technique allows it, and let the technique estimate the rest, one emitter (a light or a part of
 *     one) at a time;
 *  5. shading: the mappers draw as ever, each light's colour multiplied by its visibility.
 * Steps 3 and 4 are skipped while neither camera, lights, props nor settings change; in progressive
 * mode points of the lights are added to a running mean instead.
 *
 * Use as the opaque pass of a vtkRenderStepsPass:
 *
 *     steps->SetOpaquePass(shadows);
 *     renderer->SetPass(steps);
 *
 * The visibility of a light at a pixel is in [0, 1], 1 fully lit and 0 umbra. It can be read as an
 * image. Opaque surfaces receive; translucent props and unlit surfaces neither receive nor cast.
 *
 * Where OpenGL has not the memory, or not the textures that a light's visibility takes, that light is
 * shown without shadows (visibility 1). A warning names it once and the light report says why; later
 * frames try again.
 *
 * @sa vtkAreaLight vtkShadowCasters
 */

#ifndef vtkSoftShadowPass_h
#define vtkSoftShadowPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingSoftShadowsVisibilityModule.h" // For export macro
#include "vtkShadowLightSampling.h"                  // For points
#include "vtkSmartPointer.h"                         // For images
#include "vtkSoftShadowRequirements.h"               // For requirements
#include "vtkSoftShadowStatistics.h"                 // For statistics
#include "vtkSoftShadowsABI.h"                       // For the ABI namespace
#include "vtkWrappingHints.h"                        // For VTK_WRAPEXCLUDE

#include <memory> // For the implementation
#include <string> // For names
#include <vector> // For warnings

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkLight;
class vtkShadowTextureArray;
class vtkSoftShadowServices;

class VTKRENDERINGSOFTSHADOWSVISIBILITY_EXPORT vtkSoftShadowPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkSoftShadowPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * The pass that draws opaque props in step 5. Default (null) draws each prop's opaque geometry.
   */
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass() { return this->DelegatePass; }
  ///@}

  ///@{
  /**
   * Texels along an edge of a depth map, in [32, 16384]. More resolve finer casters and closer
   * contacts; cost is quadratic, when baking. Default is 2048. More than the driver allows count as
   * what it allows, with a warning.
   */
  vtkSetClampMacro(MapSize, int, 32, 16384);
  vtkGetMacro(MapSize, int);
  ///@}

  ///@{
  /**
   * Cuts every light into Split x Split parts, each with a map and a kernel of its own, in [1, 32].
   * Every technique converges to the truth as it grows; cost grows with its square. Default is 1.
   */
  vtkSetClampMacro(Split, int, 1, 32);
  vtkGetMacro(Split, int);
  ///@}

  ///@{
  /**
   * Prove pixels fully lit or fully blocked from the pyramid of depths before filtering. Changes no
   * result beyond rounding, only the time. Default is on.
   */
  vtkSetMacro(EarlyOut, bool);
  vtkGetMacro(EarlyOut, bool);
  vtkBooleanMacro(EarlyOut, bool);
  ///@}

  ///@{
  /**
   * Memory for the depth maps of all lights together, in MiB, in [0, 65536]. Maps that do not fit are drawn
   * anew whenever visibility is, an emitter's own in batches; what is least recently used goes first. 0, the
   * default, is a quarter of what the driver says is free when the pass first draws, or 1024 where it does
   * not say. What one emitter needs at a time, a map at least, is held in any case.
   */
  vtkSetClampMacro(MapMemory, int, 0, 65536);
  vtkGetMacro(MapMemory, int);
  ///@}

  ///@{
  /**
   * Progressive mode: while neither scene, lights, camera, size nor settings change, each frame adds
   * ProgressivePoints points of every light, in a low-discrepancy order and with a hard shadow each, to
   * a running mean. The first frame is the technique's own. The first 64 points only measure the maps,
   * and again whenever the maps grow; the mean takes over as the next 64 come. It converges to the truth
   * whatever the technique. The mean depends on the number of its points, not on that of the frames. Any
   * change starts it again. Default is off.
   *
   * Frames are the application's to draw: while GetRefining() is true another one improves the
   * picture. Afterwards a frame costs what it costs without progressive mode, and what the mean needed
   * is given back. Where there is no memory for finer maps the mean goes on with the last ones, where
   * there is none for any the technique's picture stays, with a warning.
   */
  vtkSetMacro(Progressive, bool);
  vtkGetMacro(Progressive, bool);
  vtkBooleanMacro(Progressive, bool);
  ///@}

  ///@{
  /**
   * The estimated error, of the worst tile of 32 x 32 pixels, under which the mean is good enough;
   * in units of visibility, in [0.0001, 1]. Default is 0.02.
   */
  vtkSetClampMacro(ProgressiveTolerance, double, 0.0001, 1.0);
  vtkGetMacro(ProgressiveTolerance, double);
  ///@}

  ///@{
  /// Points of every light that a frame adds, in [1, 1024]. Default is 4.
  vtkSetClampMacro(ProgressivePoints, int, 1, 1024);
  vtkGetMacro(ProgressivePoints, int);
  ///@}

  ///@{
  /**
   * Shades coarse bodies with smooth normals as the smooth bodies that they stand for: their receivers lie
   * on the surface that the vertices' normals tell of, not on the triangles, of which those that turn away
   * from the light would show as dark blocks along the terminator. For the picture alone:
   * GetVisibilityImage gives the visibility of the triangles themselves, which is then estimated when it is
   * read, once for as long as nothing changes. Flat shading, props without normals and edges across which
   * normals turn by more than about 70 degrees stay as they are. Default is off.
   */
  vtkSetMacro(SmoothTerminator, bool);
  vtkGetMacro(SmoothTerminator, bool);
  vtkBooleanMacro(SmoothTerminator, bool);
  ///@}

  /// Whether the estimated error of what is shown is under the tolerance, as of the last frame.
  bool GetConverged() const;

  /**
   * Whether another frame would improve the picture, as of the last one. False once converged, and also
   * where no number of points can reach the tolerance because the maps, which grow to MapMemory and at
   * most 8192 texels, are too coarse for it.
   */
  bool GetRefining() const;

  /**
   * Standard error of the mean in the worst tile: a root mean square over its pixels, that of the
   * points and that of the maps' texels. Pixels at silhouettes are left out: there it hangs on a hair
   * which surface is seen. 1 before it is known.
   */
  double GetEstimatedError() const;

  /// Whether progressive mode goes on, or why it ended: a sentence with the figures of the last frame.
  std::string GetProgressReport() const;

  enum EventType
  {
    /// Invoked at the end of the frame in which the mean converged.
    ConvergedEvent = 4200 // above vtkCommand::UserEvent
  };

  ///@{
  /**
   * The visibility of a light in the last frame: float, one component, the size of the viewport,
   * bottom row first. NaN where there is no surface, where the surface receives no shadow or is
   * unlit, and outside the light's cone or behind it. Null if the light was not lit. With
   * SmoothTerminator read it before the scene or its camera change. Waits for the GPU and makes the context of the last frame's window current. Not wrapped: VTK 9.1 wraps no smart
   * pointers.
   */
  VTK_WRAPEXCLUDE vtkSmartPointer<vtkImageData> GetVisibilityImage(vtkLight* light);
  VTK_WRAPEXCLUDE vtkSmartPointer<vtkImageData> GetVisibilityImage(int litLight);
  ///@}

  /// Linear view depth of the receivers in the last frame, NaN where there is no surface.
  VTK_WRAPEXCLUDE vtkSmartPointer<vtkImageData> GetDepthImage();

  /**
   * Writes the visibility of a light in the last frame into an image: float, one component, the
   * size of the viewport, bottom row first, 1 lit and 0 umbra. NaN where there is no surface, where
   * the surface receives no shadow or is unlit, and outside the light's cone or behind it. Returns
   * false, the image untouched, if the light was not lit. Makes the window's context current.
   */
  bool GetVisibilityImage(vtkLight* light, vtkImageData* image);

  /**
   * Writes the linear view depth of the receivers in the last frame into an image of the same form,
   * NaN where there is no surface. Returns false, the image untouched, before the first frame.
   */
  bool GetDepthImage(vtkImageData* image);

  ///@{
  /**
   * The visibilities as a texture for other passes: R32F, a layer per casting light, negative where
   * there is no value: what the picture is shaded with. GetVisibilityLayer is -1 for lights that cast nothing (visibility 1).
   */
  vtkShadowTextureArray* GetVisibilityTexture();
  int GetVisibilityLayer(vtkLight* light) const;
  ///@}

  /// Counts and times.
  const vtkSoftShadowStatistics& GetStatistics();

  ///@{
  /**
   * One count or time of the statistics, for wrapped languages: its name is that in
   * vtkSoftShadowStatistics::GetCounts ("maps_baked") or of a step ("shading"). -1 if there is none.
   */
  vtkTypeInt64 GetCount(const std::string& name);
  double GetMilliseconds(const std::string& step);
  ///@}

  /// A line per lit light of the renderer in the last frame: what it casts, or why it casts nothing.
  std::string GetLightReport() const;

  ///@{
  /// Hooks that mappers call; see vtkOpenGLRenderPass.
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  ///@}

  ///@{
  /**
   * What a technique is: each subclass overrides the first and Add, the others if it has to. A technique
   * is given all that it uses. It can be asked by whoever has the services for it.
   *
   * What it needs of a frame; asked anew in every frame.
   */
  VTK_WRAPEXCLUDE virtual vtkSoftShadowRequirements GetRequirements() const { return {}; }

  /**
   * Called before any emitter of an estimate; of the services, what concerns an emitter is not set.
   * Framebuffer, viewport, blending and depth test are the technique's to set and to restore.
   */
  VTK_WRAPEXCLUDE virtual void Begin(const vtkSoftShadowServices&) {}

  /**
   * With Requirements::Preparation: called for the emitters whose maps are all held at a time, before Add
   * is for the first of them, in the same order. So the GPU can be asked for all and waited for once. A
   * technique keeps what it prepares itself, and prepares what was left out. State as for Begin.
   */
  VTK_WRAPEXCLUDE virtual void Prepare(const vtkSoftShadowServices&) {}

  /**
   * Adds Emitter.Weight times the emitter's visibility to the bound framebuffer for every pixel
   * that is neither proved nor out of the light's reach. Framebuffer, viewport, additive blending
   * and the depth test that keeps other pixels untouched are set up and must be the same after the
   * call; the last step is drawn with vtkSoftShadowServices::DrawMarked (depth 0.5), writing the product
   * to gl_FragData[0].
   */
  VTK_WRAPEXCLUDE virtual void Add(const vtkSoftShadowServices& services) = 0;

  /**
   * For progressive mode: adds what pixels see of one point of the emitter, its weight or nothing, to the
   * bound framebuffer, as Add but without marks. False, the default, lets it be drawn with a depth map.
   */
  VTK_WRAPEXCLUDE virtual bool AddPoint(
    const vtkSoftShadowServices&, const vtkShadowLightSampling::Sample&)
  {
    return false;
  }

  /**
   * Whether the technique would do better now although nothing changed: counts it did not wait for
   * have come back. Asked whenever visibility may be kept, which is mostly once per frame. Default is no.
   */
  VTK_WRAPEXCLUDE virtual bool WantsVisibilityAnew() { return false; }

  /// Adds what the technique holds and did beyond the services: bytes, draw calls, builds of shaders.
  VTK_WRAPEXCLUDE virtual void AddStatistics(vtkSoftShadowStatistics&) {}
  ///@}

protected:
  vtkSoftShadowPass();
  ~vtkSoftShadowPass() override;

  vtkRenderPass* DelegatePass = nullptr;
  int MapSize = 2048;
  int Split = 1;
  bool EarlyOut = true;
  int MapMemory = 0;
  bool Progressive = false;
  double ProgressiveTolerance = 0.02;
  int ProgressivePoints = 4;
  bool SmoothTerminator = false;

private:
  vtkSoftShadowPass(const vtkSoftShadowPass&) = delete;
  void operator=(const vtkSoftShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  void Warn(const std::vector<std::string>& news);
  void CollectLights(const vtkRenderState* s);
  void UpdateVisibility(const vtkRenderState* s);
  bool SignatureChanged(const vtkRenderState* s);
  void EstimateVisibility(const vtkRenderState* s, bool changed);
  bool DrawReceivers(const vtkRenderState* s);
  void DrawOpaque(const vtkRenderState* s);
  void Shade(const vtkRenderState* s);
};

VTK_ABI_NAMESPACE_END
#endif

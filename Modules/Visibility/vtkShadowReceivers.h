// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowReceivers
 * @brief   The visible points: view position and plane of the front-most opaque surface per pixel.
 *
 * Two RGBA32F textures of the viewport's size. Position: xyz in view coordinates, w is whether it
 * receives or is a surface that does not, with the normal in a few bits for filters on the screen
 * (vtkSoftShadowPackedNormals), or anything between where there is no surface. Normal: xyz is the
 * unit normal of the visible triangle's plane, towards the camera, w is how far the surface may rise
 * from that plane (see vtkShadowCasters::GetLargestRise), or -1 where the plane is made up: points and
 * lines have none.
 */

#ifndef vtkShadowReceivers_h
#define vtkShadowReceivers_h

#include "vtkNew.h" // For members
#include "vtkObject.h"
#include "vtkRenderingSoftShadowsVisibilityModule.h" // For export macro
#include "vtkShadowTextureUnit.h"                    // For members
#include "vtkSmartPointer.h"                         // For the image
#include "vtkSoftShadowsABI.h"                       // For the ABI namespace

#include <array>  // For matrices
#include <vector> // For copies

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class VTKRENDERINGSOFTSHADOWSVISIBILITY_EXPORT vtkShadowReceivers : public vtkObject
{
public:
  static vtkShadowReceivers* New();
  vtkTypeMacro(vtkShadowReceivers, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Makes textures of the size, binds them for drawing and clears them. Returns 1 if they were made or
   * resized, 0 if they were there, and -1 if they cannot be had: then nothing can be drawn. Every
   * Begin needs its End, which restores the framebuffer.
   */
  int Begin(vtkRenderer* renderer, int width, int height);
  void End(vtkRenderer* renderer);

  ///@{
  /**
   * Whether Begin is for smooth receivers too, and whether Activate gives them to the shaders: the plane
   * of the smooth surface that the vertices' normals tell of, and its height above the triangle.
   */
  vtkSetMacro(Smooth, bool);
  vtkGetMacro(Smooth, bool);
  ///@}

  ///@{
  /// Size in pixels.
  vtkGetMacro(Width, int);
  vtkGetMacro(Height, int);
  ///@}

  /// View to world coordinates of the camera that drew the receivers, row-major.
  const std::array<double, 16>& GetViewToWorld() const { return this->ViewToWorld; }

  ///@{
  /// Binds the textures and sets the samplers of the snippet vtkShadowReceiver; needs Deactivate.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  ///@}

  vtkTextureObject* GetPositions() { return this->Positions; }
  vtkTextureObject* GetNormals() { return this->Normals; }

  /// Bytes of the textures.
  vtkTypeInt64 GetBytes() const;

  /// Whether any of the smooth receivers is not on its triangle. Waits for the GPU, the first time.
  bool HasSmooth();

  /**
   * Copies the receivers to the processor's memory as shaders see them: of each pixel the view position
   * with its mark (VTK_SOFT_SHADOW_RECEIVES, VTK_SOFT_SHADOW_SURFACE or 0), and the plane's normal,
   * four floats each, bottom row first. Waits for the GPU.
   */
  void Read(std::vector<float>& positions, std::vector<float>& normals);

  /// Linear view depth, float, NaN where there is no surface, bottom row first.
  vtkSmartPointer<vtkImageData> ReadDepth();

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkShadowReceivers();
  ~vtkShadowReceivers() override;

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Positions;
  vtkNew<vtkTextureObject> Normals;
  vtkNew<vtkTextureObject> Surfaces; // smooth: unit normal, and height above the triangle along it
  vtkNew<vtkTextureObject> Depth;
  vtkShadowTextureUnit PositionUnit;
  vtkShadowTextureUnit NormalUnit;
  vtkShadowTextureUnit SurfaceUnit;
  int Width = 0;
  int Height = 0;
  bool Smooth = false;
  int FoundSmooth = -1; // what HasSmooth found; -1 if it was not asked
  std::array<double, 16> ViewToWorld;

private:
  vtkShadowReceivers(const vtkShadowReceivers&) = delete;
  void operator=(const vtkShadowReceivers&) = delete;

  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height);
};

VTK_ABI_NAMESPACE_END
#endif

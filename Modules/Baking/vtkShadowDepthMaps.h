// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowDepthMaps
 * @brief   The depth maps of one light: layers of one resolution, kept until something changes.
 *
 * Layer i shows the casters through view i; its values are -d of vtkShadowMapView: 1 on the near plane,
 * 0 where there is no caster. The format is 32-bit float depth.
 */

#ifndef vtkShadowDepthMaps_h
#define vtkShadowDepthMaps_h

#include "vtkNew.h" // For members
#include "vtkObject.h"
#include "vtkRenderingSoftShadowsBakingModule.h" // For export macro
#include "vtkShadowFramebuffer.h"                // For members
#include "vtkShadowMapView.h"                    // For views
#include "vtkSmartPointer.h"                     // For the image
#include "vtkSoftShadowsABI.h"                   // For the ABI namespace

#include <vector> // For views

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkRenderer;
class vtkShadowCasters;
class vtkShadowTextureArray;
class vtkWindow;

class VTKRENDERINGSOFTSHADOWSBAKING_EXPORT vtkShadowDepthMaps : public vtkObject
{
public:
  static vtkShadowDepthMaps* New();
  vtkTypeMacro(vtkShadowDepthMaps, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Makes the layers show the views: bakes those whose view differs from what the layer holds, or all
   * if the casters, the resolution or the flag changed. Returns the number of layers baked, 0 if all
   * was up to date, -1 if the texture cannot be had, which vtkShadowFailures is told. The texture only
   * grows in layers while the resolution stays. Restores framebuffer, viewport and all other OpenGL state.
   */
  int Bake(vtkRenderer* renderer, vtkShadowCasters* casters,
    const std::vector<vtkShadowMapView>& views, int resolution, bool conservative = false);

  /// The views that the layers show, as of the last Bake.
  const std::vector<vtkShadowMapView>& GetViews() const { return this->Views; }

  /// DEPTH32F, resolution x resolution, at least GetViews().size() layers.
  vtkShadowTextureArray* GetTexture() { return this->Texture; }

  vtkGetMacro(Resolution, int);

  /// Grows with every Bake that drew something: pyramids and other derived data compare it.
  vtkGetMacro(BakeTime, vtkMTimeType);

  ///@{
  /// Totals since construction.
  vtkGetMacro(NumberOfBakes, vtkTypeInt64);
  vtkGetMacro(NumberOfDrawCalls, vtkTypeInt64);
  ///@}

  /**
   * A layer as an image of linear distances along the emitter's direction (float, 1 component,
   * infinite where there is no caster; origin and spacing are those of the view's window).
   */
  vtkSmartPointer<vtkImageData> ReadDepth(int layer);

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkShadowDepthMaps();
  ~vtkShadowDepthMaps() override;

  vtkNew<vtkShadowTextureArray> Texture;
  std::vector<vtkShadowMapView> Views;
  int Resolution = 0;
  bool Conservative = false;
  vtkMTimeType CastersTime = 0;
  vtkMTimeType BakeTime = 0;
  vtkTypeInt64 NumberOfBakes = 0;
  vtkTypeInt64 NumberOfDrawCalls = 0;
  vtkShadowFramebuffer Framebuffer;
  bool CanBakeAtOnce = true; // until the driver refuses

private:
  vtkShadowDepthMaps(const vtkShadowDepthMaps&) = delete;
  void operator=(const vtkShadowDepthMaps&) = delete;

  int BakeLayers(
    vtkRenderer* renderer, vtkShadowCasters* casters, const std::vector<vtkShadowMapView>& views);
  int BakeOneByOne(
    vtkRenderer* renderer, vtkShadowCasters* casters, const std::vector<vtkShadowMapView>& views);
  int BakeAllAtOnce(
    vtkRenderer* renderer, vtkShadowCasters* casters, const std::vector<vtkShadowMapView>& views);
  bool IsHeld(std::size_t layer, const vtkShadowMapView& view) const;
};

VTK_ABI_NAMESPACE_END
#endif

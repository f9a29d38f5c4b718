// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasters
 * @brief   Everything in a renderer that can block light, ready to be drawn into depth maps.
 *
 * Opaque, visible props whose CASTS_SHADOW key is not 0 are casters, whether the camera sees them or
 * not. Where the prop allows it, its polygons and strips are kept as triangles in one position-only
 * vertex buffer, in world coordinates relative to a local origin (subtracted in double): one draw
 * call fills a depth map. A copy on the CPU, of the buffer's size, tells what really changed.
 *
 * Points and lines (vertices, lines, wireframes, the points of a representation as points) wider than a
 * pixel cast as wide as the renderer's camera draws them: as spheres and tubes where the property says
 * so, else as flat squares and bands that face the light, and never thinner than a texel. A pixel's size
 * in the world is that of the camera at the last Update(): such casters follow the camera, and maps are
 * baked again whenever it moves. Without them no camera changes anything.
 *
 * What cannot be represented so is drawn through its own mapper and casts what that draws: glyphs,
 * imposters, textures with alpha, replaced shaders, clipped surfaces, mappers of other classes, points
 * and lines no wider than a pixel. Points and lines drawn so are as wide in the depth map, in texels, as
 * in the picture, in pixels, and keep that width at any resolution. Translucent props, volumes, skyboxes
 * and overlays cast nothing. Casters are two-sided whatever faces a property culls.
 *
 * A vtkAssembly or vtkPropAssembly hands its own property keys to its parts whenever VTK renders it,
 * so the keys below count on the assembly and not on its parts.
 *
 * Update() asks everything that decides which fragments a prop has and where they lie, at any depth:
 * mappers, their inputs, blocks and arrays, clipping planes, textures with their pipelines, tables and
 * transforms, shader code and the values of its uniforms, levels of detail, and of properties what is
 * not colour. It rebuilds only what changed; what was modified but looks the same to a light, as a
 * colour, changes nothing. What no object tells cannot be seen: uniforms that an observer sets in the
 * mapper's program, and data written to without Modified().
 */

#ifndef vtkShadowCasters_h
#define vtkShadowCasters_h

#include "vtkObject.h"
#include "vtkRenderingSoftShadowsBakingModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                   // For the ABI namespace

#include <array>  // For boxes
#include <memory> // For the implementation
#include <vector> // For boxes

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationIntegerKey;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkWindow;
struct vtkShadowCasterShape;
struct vtkShadowMapView;

class VTKRENDERINGSOFTSHADOWSBAKING_EXPORT vtkShadowCasters : public vtkObject
{
public:
  static vtkShadowCasters* New();
  vtkTypeMacro(vtkShadowCasters, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Keys in a prop's property keys: 0 switches off that the prop casts or receives shadows. Absent
   * means 1. The Set functions keep whatever other keys the prop has.
   *
   * A prop without a key of ours may have VTK's, OCCLUDER and RECEIVER of vtkShadowMapBakerPass. As
   * VTK says, they count by being there: a prop with one of the two does that alone, one with both
   * does both. Where VTK does not define them, vtkInformationIntegerKey::MakeKey does.
   */
  static vtkInformationIntegerKey* CASTS_SHADOW();
  static vtkInformationIntegerKey* RECEIVES_SHADOW();
  static void SetCastsShadow(vtkProp* prop, bool casts);
  static void SetReceivesShadow(vtkProp* prop, bool receives);
  static bool GetCastsShadow(vtkProp* prop);
  static bool GetReceivesShadow(vtkProp* prop);
  ///@}

  /**
   * Brings the casters up to date with the renderer's props. Returns true if anything that casts,
   * or any box below, changed since the last call. Needs the window's context to be current.
   */
  bool Update(vtkRenderer* renderer);

  ///@{
  /**
   * Leave out flat casters behind which, seen from the whole emitter, nothing lies that receives: a
   * ground plane throws no shadow. Its texels stay empty, which proves what is on it lit where
   * nothing else is. Default is on.
   */
  void SetEffectiveOnly(bool effectiveOnly);
  vtkGetMacro(EffectiveOnly, bool);
  vtkBooleanMacro(EffectiveOnly, bool);
  ///@}

  /// Grows whenever Update finds a change in what casts; depth maps are valid for one value of it.
  vtkGetMacro(CastersTime, vtkMTimeType);

  /// Grows whenever Update returns true; fits of depth maps are valid for one value of it.
  vtkGetMacro(BodiesTime, vtkMTimeType);

  /**
   * Grows whenever Update finds that something visible, caster or not, may show other fragments or
   * stands elsewhere: an actor, a part of an assembly, a level of detail, a clipping plane, a texture.
   */
  vtkGetMacro(LooksTime, vtkMTimeType);

  /// What the fit of a depth map needs to know of one prop (or leaf of an assembly), or of a part of it
  /// that is far from the rest, or flat.
  struct Body
  {
    /// World coordinates {xmin, xmax, ymin, ymax, zmin, zmax}, finite.
    std::array<double, 6> Bounds;
    bool Casts = true;
    bool Receives = true;
    /// All points lie in the plane Normal . p = Offset (to 1e-6 of its extent).
    bool Flat = false;
    std::array<double, 3> Normal = { { 0.0, 0.0, 0.0 } };
    double Offset = 0.0;
    /// For flat bodies: the corners of the body's bounding rectangle in its own plane (world).
    std::array<std::array<double, 3>, 4> Corners;
  };

  /// All visible opaque props or their parts, casters and receivers alike.
  const std::vector<Body>& GetBodies() const;

  /**
   * How far the surface of a prop may rise from the plane of one of its triangles, in world units: infinite
   * unless all of it lies in one plane.
   */
  double GetLargestRise(const vtkProp* prop) const;

  /// What coordinates of the casters are best taken relative to: floats are finest where the detail is.
  const std::array<double, 3>& GetOrigin() const;

  /// Everything that casts, for techniques that do without depth maps.
  std::vector<vtkShadowCasterShape> GetShapes() const;

  ///@{
  /// Counts for statistics.
  vtkTypeInt64 GetNumberOfTriangles() const;
  int GetNumberOfCasters() const;
  int GetNumberOfMapperCasters() const;
  /// Closed surfaces, of which only the side towards the light is drawn.
  int GetNumberOfClosedCasters() const;
  vtkTypeInt64 GetBytes() const;
  ///@}

  /**
   * Draws the casters (see EffectiveOnly) whose boxes touch the view's frustum into the framebuffer and viewport that are
   * bound now, depth only (depth test on, colour writes off, both sides of what is not closed, depth
   * clamped to the view's range so that nothing in front of Near is lost). With conservative, every
   * texel that a triangle touches gets the least depth the triangle's plane has within the texel
   * (not less than the triangle's own); mapper-drawn casters are rasterised normally.
   * Returns the number of draw calls. Restores all OpenGL and VTK state it changes.
   */
  int Draw(vtkRenderer* renderer, const vtkShadowMapView& view, int resolution, bool conservative);

  /**
   * Whether DrawLayers() can be used: the driver lets a vertex shader choose the layer, and everything
   * that casts is drawn from the casters' own triangles. Needs an up-to-date list, see Update.
   */
  bool CanDrawLayers(vtkRenderer* renderer);

  /**
   * Draws the casters for several views at once, not conservatively, into the first layers of the bound
   * framebuffer; all layers of its texture are attached. A caster that any of the views
   * shows is drawn for all of them, so a map may show one more than Draw's, behind which nothing receives
   * in that view. Returns the number of draw calls, -1 if the driver fails, and nothing was drawn.
   */
  int DrawLayers(vtkRenderer* renderer, const std::vector<vtkShadowMapView>& views);

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkShadowCasters();
  ~vtkShadowCasters() override;

  bool EffectiveOnly = true;
  vtkMTimeType CastersTime = 0;
  vtkMTimeType BodiesTime = 0;
  vtkMTimeType LooksTime = 0;

private:
  vtkShadowCasters(const vtkShadowCasters&) = delete;
  void operator=(const vtkShadowCasters&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

VTK_ABI_NAMESPACE_END
#endif

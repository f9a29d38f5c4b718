// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAreaLight
 * @brief   A vtkLight with an extent, the source of shadows with penumbrae.
 *
 * The light is everything a vtkLight is, and mappers shade with it as with any other. The extent is
 * read by the soft-shadow passes alone: it decides how much of the light a surface point sees.
 *
 * A positional light is a rectangle, a disk or a point around the light's position, perpendicular
 * to its direction (focal point - position). Rectangles and disks shine to their front only. A
 * directional light is a disk of directions, uniform in solid angle, of AngularDiameter degrees.
 *
 * Unlike a vtkLight, which is directional, an area light as constructed is positional and has no
 * cone (a ConeAngle of 90 degrees): it needs a position, a focal point and a size. For a sun set its
 * AngularDiameter. A setter that leaves a directional light with a size that was set, or a positional
 * one with an angular diameter, warns: the one or the other has no effect.
 *
 * vtkLight's ShadowAttenuation says how much of the light a full shadow takes away, in the picture:
 * 1, the default, all of it, 0 nothing. It is 1 - ShadowAttenuation * (1 - visibility) that the
 * light's colour is multiplied with, as in vtkShadowMapPass; values outside [0, 1] count as the
 * nearest within. Visibility as data does not know it.
 *
 * The light's own plane has the axes direction x ViewUp (first component of Size) and ViewUp made
 * perpendicular to the direction (second component).
 *
 * A plain vtkLight casts a hard shadow, unless it carries vtkOSPRayLightNode's RADIUS key: then it
 * is a disk of that radius, or, directional, a sun of that many degrees.
 *
 * @sa vtkSoftShadowPass vtkShadowEmitter
 */

#ifndef vtkAreaLight_h
#define vtkAreaLight_h

#include "vtkLight.h"
#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkAreaLight : public vtkLight
{
public:
  static vtkAreaLight* New();
  vtkTypeMacro(vtkAreaLight, vtkLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShapeType
  {
    RECTANGLE = 0,
    DISK = 1,
    POINT = 2
  };

  ///@{
  /**
   * The shape of a positional light. A point casts a hard shadow. Directional lights ignore it.
   * Default is RECTANGLE.
   */
  vtkSetClampMacro(Shape, int, RECTANGLE, POINT);
  vtkGetMacro(Shape, int);
  void SetShapeToRectangle() { this->SetShape(RECTANGLE); }
  void SetShapeToDisk() { this->SetShape(DISK); }
  void SetShapeToPoint() { this->SetShape(POINT); }
  const char* GetShapeAsString() const;
  ///@}

  /**
   * Whether the light has a place (1) or only a direction (0). Default is 1, vtkLight's is 0.
   */
  void SetPositional(vtkTypeBool positional) override;

  ///@{
  /**
   * Width and height of a positional light in world units: the edges of the rectangle or the
   * diameters of the disk. Zero is a point. Negative or non-finite sizes are refused with an error
   * and change nothing. Directional lights ignore it. Default is (1, 1).
   */
  void SetSize(double width, double height);
  void SetSize(const double size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Up direction of the light's plane, in the coordinates of the light's position (world
   * coordinates for a scene light). The null vector, the default, takes the axis least aligned with
   * the light's direction (x before y before z among equals); so does a vector along the direction
   * or one that is not finite.
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Angle under which a directional light is seen, in degrees, clamped to [0, 170]. The sun has 0.53.
   * More than 0 makes the light directional; 0 does not make it positional. What is not a number is
   * refused with an error and changes nothing. Default is 0, of a directional light a hard shadow.
   */
  virtual void SetAngularDiameter(double degrees);
  virtual double GetAngularDiameterMinValue() { return 0.0; }
  virtual double GetAngularDiameterMaxValue() { return 170.0; }
  vtkGetMacro(AngularDiameter, double);
  ///@}

  ///@{
  /**
   * The extent of a vtkLight that is no area light: of a positional one the diameter of its disk in world
   * units, of a directional one its angular diameter in degrees. It is kept in vtkOSPRayLightNode's RADIUS
   * key, so that VTK's ray tracers respect it, too, if their module was loaded before the first extent was
   * set. Of an area light nothing is set, and what is got is 0.
   * Default is 0; negative or non-finite extents are refused with an error and change nothing.
   */
  static void SetExtent(vtkLight* light, double extent);
  static double GetExtent(vtkLight* light);
  ///@}

  /**
   * A light's frame in world coordinates, the light's own transform applied: unit vectors along the
   * width, along the height and along the direction in which it shines. A plain vtkLight has the
   * frame of an area light without a ViewUp.
   */
  static void GetTransformedAxes(
    vtkLight* light, double widthAxis[3], double heightAxis[3], double direction[3]);

  ///@{
  /**
   * Copy of all parameters, without a warning. A plain light has no extent to copy: the own one
   * stays. ShallowClone returns a vtkAreaLight that the caller owns and that shares the transform.
   */
  vtkLight* ShallowClone() override;
  void DeepCopy(vtkLight* light);
  ///@}

protected:
  vtkAreaLight();
  ~vtkAreaLight() override = default;

  int Shape = RECTANGLE;
  double Size[2] = { 1.0, 1.0 };
  double ViewUp[3] = { 0.0, 0.0, 0.0 };
  double AngularDiameter = 0.0;

private:
  vtkAreaLight(const vtkAreaLight&) = delete;
  void operator=(const vtkAreaLight&) = delete;

  bool SizeIsSet = false;      // by SetSize: the default contradicts nothing
  bool IsWarned = false;       // of the contradiction that there is
  bool WarnsOfNothing = false; // while values are copied

  void CopyExtent(vtkAreaLight* light);
  void WarnOfContradiction();
};

VTK_ABI_NAMESPACE_END
#endif

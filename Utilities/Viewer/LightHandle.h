// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ball that drags the light, with the light's outline and the line that it shines along.
 */

#ifndef LightHandle_h
#define LightHandle_h

#include "SceneDescription.h"

#include "vtkActor.h"
#include "vtkHandleWidget.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereHandleRepresentation.h"

#include <functional>

class vtkAreaLight;
class vtkCamera;
class vtkRenderWindowInteractor;
class vtkRenderer;

namespace softshadows
{

/**
 * Drawn in a renderer above the scene, whose camera follows the scene's: a shadow pass never sees
 * it. Most lights stand outside the view. Their ball stands on the line to the light where it leaves
 * the view, and a drag counts as if it were made at the light: nearer balls move it farther.
 */
class LightHandle
{
public:
  using Observer = std::function<void(const Vector3&)>;

  /// Told where a drag puts the light.
  LightHandle(vtkRenderer* overlay, vtkRenderWindowInteractor* interactor, Observer moved);
  ~LightHandle();
  LightHandle(const LightHandle&) = delete;
  LightHandle& operator=(const LightHandle&) = delete;

  /// The light as it is, seen by the scene's camera. The ball keeps this many pixels off the edges.
  void Update(
    const LightDescription& description, vtkAreaLight* light, vtkCamera* camera, int margin);

  void SetVisible(bool visible);

  /// Where the ball is, in pixels of the window.
  Vector2 GetDisplayPosition() const;

private:
  vtkRenderer* Overlay;
  Observer Moved;
  vtkNew<vtkHandleWidget> Widget;
  vtkNew<vtkSphereHandleRepresentation> Ball;
  vtkNew<vtkPolyData> Lines;
  vtkNew<vtkActor> LineActor;

  Vector3 Anchor{ { 0.0, 0.0, 0.0 } }; ///< The end of the line that stays.
  Vector3 Way{ { 0.0, 0.0, 1.0 } };    ///< From there to the light, or against its direction.
  Vector3 Focal{ { 0.0, 0.0, 0.0 } };
  double Share = 1.0; ///< Where along the way the ball is.
  bool Dragging = false;

  void Started() { this->Dragging = true; }
  void Ended() { this->Dragging = false; }
  void Dragged();
  void PlaceBall(int margin);
  void DrawLines(vtkAreaLight* light, bool directional);
  void FollowCamera(vtkCamera* camera);
  Vector3 OnWay(double share) const;
  bool IsInRoom(const Vector3& point, int margin) const;
};

}

#endif

// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the viewer shows and how, as plain values: no window, nothing drawn.
 */

#ifndef ViewerState_h
#define ViewerState_h

#include "DebugView.h"
#include "SceneDescription.h"
#include "Technique.h"
#include "ViewerAction.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace softshadows
{

/**
 * The technique with the values of its options, the scene's lights, the view, and what of the menu
 * is open. Every technique keeps its options while another is shown. Whoever draws observes it.
 */
class ViewerState
{
public:
  /// What an observer is told to have changed.
  enum class Change
  {
    Technique, ///< And with it options and views.
    Options,   ///< Of the technique, or of its view.
    Light,     ///< Position, direction or size of a light.
    Menu       ///< What is selected, listed or open.
  };
  using Observer = std::function<void(Change)>;

  /**
   * Throws std::runtime_error for techniques and options that do not exist or do not fit (see
   * CreatePass).
   */
  ViewerState(
    SceneDescription scene, const std::string& technique, const OptionTexts& options = {});

  /// One only; called after each change.
  void SetObserver(Observer observer) { this->Notify = std::move(observer); }

  /// Does what an action of the state asks for; false for the window's actions.
  bool Perform(const ViewerAction& action);

  ///@{
  /// Techniques by their place in GetTechniques().
  void SetTechnique(int place);
  int GetTechniquePlace() const { return this->TechniquePlace; }
  const Technique& GetTechnique() const;
  ///@}

  ///@{
  /// Options of the technique. Values out of range are clamped; see TechniqueOption.
  double GetOption(const std::string& name) const;
  void SetOption(const std::string& name, double value);
  double GetDefault(const std::string& name) const;
  ///@}

  ///@{
  /// Qualities by their place in GetQualities(); -1 if the options are those of none. One that the
  /// technique does not have changes nothing.
  bool HasQuality(int place) const;
  void SetQuality(int place);
  int GetQualityPlace() const;
  ///@}

  /// Gives a pass of the technique all options, those of the view among them.
  void Apply(vtkSoftShadowPass* pass) const;

  /// Whether the technique takes the light for bright in its middle.
  bool HasGaussianWeights() const;

  /// The options that are settings, in the table's order: all but those of views.
  std::vector<const TechniqueOption*> GetSettings() const;

  ///@{
  /// The setting that keys change: its place in GetSettings().
  int GetSelection() const { return this->Selection; }
  void SetSelection(int place);
  ///@}

  ///@{
  const std::vector<DebugView>& GetViews() const { return this->Views; }
  int GetViewPlace() const { return this->ViewPlace; }
  const DebugView& GetView() const { return this->Views[this->ViewPlace]; }
  void SetView(int place);
  ///@}

  ///@{
  /// The light that keys and the handle change: its place in the scene.
  int GetLightPlace() const { return this->LightPlace; }
  bool HasLight() const { return !this->Scene.Lights.empty(); }
  const LightDescription& GetLight() const { return this->Scene.Lights[this->LightPlace]; }
  void SetLightPosition(const Vector3& position);
  ///@}

  ///@{
  /// The scene as it is now. The window tells where its camera is.
  const SceneDescription& GetScene() const { return this->Scene; }
  void SetCamera(const CameraDescription& camera) { this->Scene.Camera = camera; }
  void SetImageSize(int width, int height);
  ///@}

  bool IsHelpOpen() const { return this->HelpOpen; }
  bool IsMenuOpen() const { return this->MenuOpen; }
  bool IsHandleShown() const { return this->HandleShown; }
  /// Whether the resting picture converges to the truth, whatever the technique.
  bool IsProgressive() const { return this->Progressive; }

private:
  struct Values
  {
    std::map<std::string, double> Defaults;
    std::map<std::string, double> Current;
  };

  SceneDescription Scene;
  std::vector<LightDescription> FirstLights; ///< To go back to.
  Vector3 Up;
  std::vector<Values> Options; ///< Per technique.
  std::vector<DebugView> Views;
  int TechniquePlace = 0;
  int Selection = 0;
  int ViewPlace = 0;
  int LightPlace = 0;
  bool HelpOpen = false;
  bool MenuOpen = true;
  bool HandleShown = true;
  bool Progressive = false;
  Observer Notify;

  void Changed(Change what);
  std::map<std::string, double> GetQualityValues(int place) const;
  void StepQuality(int steps);
  bool PerformOnLight(const ViewerAction& action);
  bool PerformOnOptions(const ViewerAction& action);
};

}

#endif

// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A viewer's window with a small scene, its keys and its mouse.
 */

#ifndef ViewerWindowFixture_h
#define ViewerWindowFixture_h

#include "ViewerWindow.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// RGB, bottom row first.
struct Screen
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels;

  /// Share of a rectangle's pixels that are another in another screen of the same size.
  double Differing(const Screen& other, const softshadows::MenuRect& where) const;
};

class ViewerWindowTest : public testing::Test
{
protected:
  static constexpr int Width = 800;
  static constexpr int Height = 600;

  std::filesystem::path Folder; ///< Where the window saves; empty at the test's start.
  softshadows::ModelStore Models;
  std::unique_ptr<softshadows::ViewerState> State;
  std::unique_ptr<softshadows::ViewerWindow> Window;

  void SetUp() override;
  void TearDown() override;

  void Open(const std::string& technique = "pcss");

  void Press(const std::string& key);
  /// Window's pixels, the origin at the lower left.
  void Click(int x, int y);
  /// On the box that does this.
  void Click(const softshadows::ViewerAction& action);
  void Drag(int fromX, int fromY, int toX, int toY);

  /// What stands on the screen now, without drawing it anew.
  Screen Grab();

  /// Runs the window's timer until the reference has as many rays, or for a minute.
  void Rest(int raysPerPixel);

  softshadows::ViewerFrame& Frame() { return this->Window->GetFrame(); }

  /// A ground, a box over it and a lamp.
  static softshadows::SceneDescription MakeScene();

private:
  void Send(unsigned long event, int x, int y);
};

#endif

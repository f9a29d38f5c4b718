// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Room.h
 * @brief A scene with silhouettes, a crease and shadows across both.
 */

#ifndef SoftShadowsTesting_Room_h
#define SoftShadowsTesting_Room_h

#include "Picture.h" // For depths

#include "vtkSmartPointer.h" // For the renderer

#include <vector> // For surfaces

class vtkRenderer;

namespace SoftShadowsTesting
{

/// A floor and a wall that stands on it, a board above them, and a lamp of the size given.
vtkSmartPointer<vtkRenderer> MakeRoom(double lampSize);

/// Which of the room's planes (0 floor, 1 wall, 2 board; -1 none) each pixel of a picture of linear
/// depths shows.
std::vector<int> RoomSurfaces(vtkRenderer* renderer, const Picture& depth);

}

#endif

#pragma once
/// \file
/// Raised pads with flat tops: upright prisms over rounded rectangles.

#include "shell.h"

namespace holdfast::generate {

struct Pad {
  Vector3 centre;  ///< of the foot
  double halfX;
  double halfY;
  double radius;  ///< of the corners, at most halfX and halfY; equal to both for a round pad
  double height;
};

/// Adds side and top; returns the border of the foot.
Ring addPad(Shell& shell, const std::string& group, const Pad& pad);

}  // namespace holdfast::generate

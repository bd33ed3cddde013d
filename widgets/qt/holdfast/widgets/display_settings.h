#pragma once
/// \file
/// How the document is shown: chosen in a panel, kept in sessions, no part of the document's history.

#include <holdfast/view/coloring_range.h>
#include <holdfast/view/scene_contents.h>

namespace holdfast {

enum class ConstraintDisplay { Hidden, Shown };

struct DisplaySettings {
  ColorBy colorBy = ColorBy::Displacement;
  ColorRange range = AutomaticRange{};
  ColorMap map = ColorMap::BlueGreenYellow;
  RestGhost rest = RestGhost::Edges;
  MeshEdges edges = MeshEdges::Sharp;
  RotationDisplay rotations = RotationDisplay::Hidden;
  ConstraintDisplay constraints = ConstraintDisplay::Shown;
};

}  // namespace holdfast

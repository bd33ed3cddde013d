#pragma once
/// \file
/// How the document is shown: chosen in a panel, kept in sessions, no part of the document's history.

#include <holdfast/view/coloring.h>
#include <holdfast/view/scene_contents.h>

namespace holdfast {

struct DisplaySettings {
  ColorBy colorBy = ColorBy::Displacement;
};

}  // namespace holdfast

#pragma once
/// \file
/// What sessions keep of the view: the camera, the colours, and what is shown.

#include <holdfast/document/session_file.h>

namespace holdfast {

class Viewport;

[[nodiscard]] ViewState viewStateOf(Viewport& viewport);

/// What `state` does not say, and names that are not known (of a newer version), stay as they are.
void apply(const ViewState& state, Viewport& viewport);

}  // namespace holdfast

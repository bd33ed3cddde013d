#pragma once
/// What sessions keep of the view: the camera, the colours, and what is shown.

#include <holdfast/document/session_file.h>

namespace holdfast {

class Viewport;

[[nodiscard]] ViewState viewStateOf(Viewport& viewport);

/// Settings that `state` leaves out, and unknown names (of a newer version), change nothing.
void apply(const ViewState& state, Viewport& viewport);

}  // namespace holdfast

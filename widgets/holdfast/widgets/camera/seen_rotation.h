#pragma once
/// \file
/// The first way of section 3.3 of the paper to turn a handle: by the angle that it makes on the screen.

#include <holdfast/widgets/camera/view_geometry.h>

namespace holdfast {

/// By how many degrees the way from `center` to `from` turns on the display into the way to `to`, counterclockwise:
/// about the viewing axis towards the eye. Of all angles that differ by whole turns the nearest to `near`; `near` where
/// one of the three is not in front of the eye, or appears where the center does. Places in model units.
[[nodiscard]] double degreesSeen(const ViewGeometry& view, const Vector3& center, const Vector3& from,
                                 const Vector3& to, double near);

}  // namespace holdfast

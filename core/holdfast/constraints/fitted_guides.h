#pragma once
/// The plane and the line that lie nearest to places, by least squares.

#include <optional>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// Returns the plane that lies nearest to `places`. A normal that is along a coordinate axis to 1e-6 is that axis, so
/// that the faces of a part whose coordinates were rounded are parallel and square. Returns nothing where other planes
/// lie as near: for places on a line, in one place, or all around. O(places).
[[nodiscard]] std::optional<OnPlane> fittedPlane(const Positions& places);

/// Returns the line that lies nearest to `places`, with a direction that is rounded as the normal of `fittedPlane`.
/// Returns nothing where other lines lie as near. O(places).
[[nodiscard]] std::optional<OnLine> fittedLine(const Positions& places);

}  // namespace holdfast

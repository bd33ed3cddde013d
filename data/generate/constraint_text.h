#pragma once
/// \file
/// Constraint files and point lists as text.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <holdfast/base/types.h>

#include "spot.h"

namespace holdfast::generate {

/// JSON texts of selections.
[[nodiscard]] std::string inSphere(const Vector3& centre, double radius);
[[nodiscard]] std::string inBox(const Vector3& min, const Vector3& max);
[[nodiscard]] std::string inHalfSpace(const Vector3& point, const Vector3& normal);
[[nodiscard]] std::string inComponent(Index component);
/// What a closed curve on the surface through the points nearest to `places` encloses.
[[nodiscard]] std::string inCurve(const std::vector<Vector3>& places);
[[nodiscard]] std::string allOf(const std::vector<std::string>& parts);
[[nodiscard]] std::string anyOf(const std::vector<std::string>& parts);
[[nodiscard]] std::string notIn(const std::string& part);

/// JSON texts of constraints.
[[nodiscard]] std::string fixedText(const std::string& name, const std::string& select);
[[nodiscard]] std::string pointTo(const std::string& name, const Spot& spot, const Vector3& target);
[[nodiscard]] std::string pointBy(const std::string& name, const Spot& spot, const Vector3& move);

/// A point of one face by weights of its own.
[[nodiscard]] std::string pointInFace(const std::string& name, Index face, const std::array<double, 3>& weights,
                                      const Vector3& move);
[[nodiscard]] std::string rigidText(const std::string& name, const std::string& select);
/// The vector between two points: as at rest and turned with the surface where there is no `offset`.
[[nodiscard]] std::string relativeText(const std::string& name, const Spot& from, const Spot& to,
                                       const std::optional<Vector3>& offset);

/// A turn about the centroid of the selection, or about `center`.
struct TurnText {
  Vector3 axis;
  double degrees;
  std::optional<Vector3> center = std::nullopt;
};
[[nodiscard]] std::string handleText(const std::string& name, const std::string& select, const TurnText& turn,
                                     const Vector3& translate);
[[nodiscard]] std::string handleText(const std::string& name, const std::string& select, const Vector3& translate);

/// A constraint file in millimetres, one constraint a line.
[[nodiscard]] std::string constraintFile(const std::vector<std::string>& constraints);

/// A place that was measured on the real thing.
struct MeasuredPoint {
  std::string name;
  Spot spot;
  Vector3 target;
};

/// A list of points as CSV.
[[nodiscard]] std::string pointList(const std::vector<MeasuredPoint>& points);

}  // namespace holdfast::generate

#pragma once
/// \file
/// Where points of the surface lie at rest, for panels that show and edit targets.

#include <optional>

#include <holdfast/surface/location_kind.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Places on the mesh that an editor holds.
class RestPlaces {
 public:
  /// `editor` stays alive as long as this.
  explicit RestPlaces(const Editor& editor) : editor_(editor) {}

  /// The place that the solver starts from, bit for bit; nothing where the mesh has no such location. O(log T), the
  /// first of type `near` O(T log T).
  [[nodiscard]] std::optional<Vector3> of(const SurfaceLocation& location) const;

  /// The same where a mesh is open; throws `InputError` with the reason where that has no such location.
  [[nodiscard]] Vector3 require(const SurfaceLocation& location) const;

  /// The location as one of another kind, with the errors of `holdfast::converted`. A mesh is open.
  [[nodiscard]] SurfaceLocation converted(const SurfaceLocation& location, LocationKind kind) const;

 private:
  const Editor& editor_;
};

/// Where the point goes, as the solver computes it from the place at rest.
[[nodiscard]] Vector3 placeOf(const PointConstraint& point, const Vector3& rest);

/// The point that goes to `place` to the last bit: a shift stays a shift where rest + shift is that place, and becomes
/// a target where no shift is.
[[nodiscard]] PointConstraint goingTo(PointConstraint point, const Vector3& rest, const Vector3& place);

}  // namespace holdfast

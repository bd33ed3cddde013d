#pragma once
/// How the places that constraints name by `near` lie to the surface, and what they may have been meant to be.

#include <optional>
#include <span>
#include <string>

#include <holdfast/surface/surface_locator.h>

namespace holdfast {

/// How a place lies to a surface.
struct Nearness {
  double distance = 0;          ///< model units
  bool isBetweenSides = false;  ///< another side of the surface is about as near, across the place

  friend bool operator==(const Nearness&, const Nearness&) = default;
};

/// A `near` place of an enabled constraint. One constraint may have two.
struct NearPlace {
  Index constraint = 0;  ///< place in the list
  Vector3 place = Vector3::Zero();
  Nearness nearness;

  friend bool operator==(const NearPlace&, const NearPlace&) = default;
};

/// That of `place`, whose closest point of the surface is at `closest`. `diagonal`: of the mesh. O(log T).
[[nodiscard]] Nearness nearnessOf(const Vector3& place, const Vector3& closest, const SurfaceLocator& locator,
                                  double diagonal);

/// The diagonal of the box around `places`, model units.
[[nodiscard]] double spreadOf(std::span<const NearPlace> places);

/// What would bring all of `places`, three or more, within `reach` of the surface: another unit, swapped or mirrored
/// axes, as the end of a sentence; empty where nothing does. Costs about a search for each of 600 guesses, and one for
/// each place where a guess holds.
[[nodiscard]] std::string guessOfPlaces(std::span<const NearPlace> places, const SurfaceLocator& locator, double reach);

}  // namespace holdfast

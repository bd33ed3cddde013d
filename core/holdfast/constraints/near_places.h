#pragma once
/// Constraints name places by `near`. These functions tell how such places lie to the surface, and what they may have
/// been meant to be.

#include <span>
#include <string>

#include <holdfast/surface/surface_locator.h>

namespace holdfast {

/// Tells how a place lies to a surface.
struct Nearness {
  double distance = 0;          ///< model units
  bool isBetweenSides = false;  ///< another side of the surface is about as near, across the place

  friend bool operator==(const Nearness&, const Nearness&) = default;
};

/// An enabled constraint has this `near` place. One constraint may have two.
struct NearPlace {
  Index constraint = 0;  ///< place in the list
  Vector3 place = Vector3::Zero();
  Nearness nearness;

  friend bool operator==(const NearPlace&, const NearPlace&) = default;
};

/// Returns how `place` lies to the surface. Its closest point there is at `closest`. `diagonal` is that of the mesh.
/// O(log T).
[[nodiscard]] Nearness nearnessOf(const Vector3& place, const Vector3& closest, const SurfaceLocator& locator,
                                  double diagonal);

/// Returns the diagonal of the box around `places`, in model units.
[[nodiscard]] double spreadOf(std::span<const NearPlace> places);

/// Says what would bring all of `places`, three or more, within `reach` of the surface: another unit, swapped or
/// mirrored axes. Returns that as the end of a sentence. It is empty where nothing does. The cost is about a search for
/// each of 600 guesses, and one for each place where a guess holds.
[[nodiscard]] std::string guessOfPlaces(std::span<const NearPlace> places, const SurfaceLocator& locator, double reach);

}  // namespace holdfast

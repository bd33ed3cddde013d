#include "holdfast/constraints/near_places.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace holdfast {
namespace {

// A share of the diagonal: what lies nearer lies on the surface, up to the digits of files.
constexpr double kOnSurface = 1e-9;

// In distances of the nearest side. Another side up to twice as far leaves open which is meant: the place is in the
// middle third between both. None is nearer; a little less allows for rounding and for sides that lean.
constexpr double kAsNear = 0.8;
constexpr double kClearlyFarther = 2;

// In reaches. Places closer together would all lie on the surface wherever one of them does.
constexpr double kSpread = 4;

/// A length in one unit as lengths in another.
struct UnitGuess {
  double factor;
  const char* words;
};

constexpr std::array<UnitGuess, 11> kUnitGuesses{{{1, ""},
                                                  {1000, "from m to mm"},
                                                  {1 / 1000.0, "from mm to m"},
                                                  {25.4, "from inches to mm"},
                                                  {1 / 25.4, "from mm to inches"},
                                                  {10, "from cm to mm"},
                                                  {1 / 10.0, "from mm to cm"},
                                                  {100, "from m to cm"},
                                                  {1 / 100.0, "from cm to m"},
                                                  {304.8, "from feet to mm"},
                                                  {1 / 304.8, "from mm to feet"}}};

using Axes = std::array<int, 3>;

/// What a place may have been before it was written as it is.
struct PlaceGuess {
  UnitGuess unit = kUnitGuesses[0];
  Axes axes{0, 1, 2};  // where x, y and z of the guess are taken from
  std::array<bool, 3> isMirrored{};

  [[nodiscard]] std::ptrdiff_t mirrors() const { return std::ranges::count(isMirrored, true); }
  [[nodiscard]] bool isSwapped() const { return axes != Axes{0, 1, 2}; }
  [[nodiscard]] std::ptrdiff_t changes() const
  {
    return (unit.factor == 1 ? 0 : 1) + (isSwapped() ? 1 : 0) + mirrors();
  }

  [[nodiscard]] Vector3 of(const Vector3& place) const
  {
    Vector3 guess;
    for (int k = 0; k < 3; ++k) guess[k] = (isMirrored[k] ? -1 : 1) * unit.factor * place[axes[k]];
    return guess;
  }

  [[nodiscard]] std::string words() const
  {
    constexpr std::array kNames{"x", "y", "z"};
    std::vector<std::string> parts;
    if (unit.factor != 1) parts.push_back(fmt::format("multiplied by {:.6g}, as {}", unit.factor, unit.words));
    if (isSwapped())
      parts.push_back(fmt::format("with {}, {}, {} for x, y, z", kNames[axes[0]], kNames[axes[1]], kNames[axes[2]]));
    std::vector<const char*> mirrored;
    for (int k = 0; k < 3; ++k)
      if (isMirrored[k]) mirrored.push_back(kNames[k]);
    if (!mirrored.empty()) parts.push_back(fmt::format("with the sign of {} changed", fmt::join(mirrored, " and ")));
    return fmt::format("{}", fmt::join(parts, ", "));
  }
};

/// All of them, those that change least first.
std::vector<PlaceGuess> allGuesses()
{
  std::vector<PlaceGuess> guesses;
  for (const UnitGuess& unit : kUnitGuesses) {
    Axes axes{0, 1, 2};
    do
      for (unsigned signs = 0; signs < 8; ++signs)
        guesses.push_back({unit, axes, {(signs & 1U) != 0, (signs & 2U) != 0, (signs & 4U) != 0}});
    while (std::ranges::next_permutation(axes).found);
  }
  std::ranges::stable_sort(guesses, {}, &PlaceGuess::changes);
  guesses.erase(guesses.begin());  // nothing is changed
  return guesses;
}

}  // namespace

Nearness nearnessOf(const Vector3& place, const Vector3& closest, const SurfaceLocator& locator, double diagonal)
{
  const Vector3 away = place - closest;
  Nearness nearness{away.stableNorm(), false};
  if (!(nearness.distance > kOnSurface * diagonal)) return nearness;
  // Whatever lies that far across the place is in a ball.
  const Vector3 center = place + 0.5 * (kAsNear + kClearlyFarther) * away;
  if (center.allFinite())
    nearness.isBetweenSides =
        locator.closestTo(center).distance <= 0.5 * (kClearlyFarther - kAsNear) * nearness.distance;
  return nearness;
}

double spreadOf(std::span<const NearPlace> places)
{
  Eigen::AlignedBox3d box;
  for (const NearPlace& near : places) box.extend(near.place);
  return places.empty() ? 0 : box.diagonal().stableNorm();
}

std::string guessOfPlaces(std::span<const NearPlace> places, const SurfaceLocator& locator, double reach)
{
  constexpr std::size_t kFewestPlaces = 3;  // fewer lie somewhere on a surface by chance
  if (places.size() < kFewestPlaces) return "";
  const double spread = spreadOf(places);
  for (const PlaceGuess& guess : allGuesses()) {
    const auto isNear = [&](const NearPlace& near) {
      const Vector3 place = guess.of(near.place);
      return place.allFinite() && locator.closestTo(place).distance <= reach;
    };
    if (guess.unit.factor * spread > kSpread * reach && std::ranges::all_of(places, isNear)) return guess.words();
  }
  return "";
}

}  // namespace holdfast

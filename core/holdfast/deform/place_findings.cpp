#include "holdfast/deform/place_findings.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace holdfast {
namespace {

/// The constraints of the places for which `is`.
template <class Is>
std::vector<Index> constraintsWhose(std::span<const NearPlace> places, const Is& is)
{
  std::vector<Index> constraints;
  for (const NearPlace& place : places)
    if (is(place.nearness)) constraints.push_back(place.constraint);
  return constraints;
}

Finding farPlaces(std::span<const NearPlace> places, const SurfaceLocator& locator, double reach,
                  std::vector<Index> constraints)
{
  const double farthest =
      std::ranges::max_element(places, {}, [](const NearPlace& p) { return p.nearness.distance; })->nearness.distance;
  const std::string guess = guessOfPlaces(places, locator, reach);
  const std::string rest =
      fmt::format("farther than {:.3g} from the surface, the farthest {:.4g}, and takes the closest point instead; ",
                  reach, farthest) +
      (guess.empty() ? "check its unit and coordinate system, or allow more by \"near_limit\""
                     : fmt::format("all places would lie on it if they were read {}", guess));
  return makeFinding("places_off_surface", "constraint", std::move(constraints),
                     {"constraint names a place " + rest, "constraints name places, each of which lies " + rest});
}

/// Places that are all in one spot of the surface, where reading them otherwise would spread them over it: in metres
/// near an origin that lies on the surface, for example.
void addCrowded(std::vector<Finding>& findings, std::span<const NearPlace> places, const SurfaceLocator& locator,
                double reach)
{
  if (spreadOf(places) > reach) return;
  const std::string guess = guessOfPlaces(places, locator, reach);
  if (guess.empty()) return;
  findings.push_back(makeFinding(
      "places_in_one_spot", "constraint", constraintsWhose(places, [](const Nearness&) { return true; }),
      {{},
       fmt::format("constraints name places within {:.3g} of one another; all of them would lie spread over the "
                   "surface if they were read {}",
                   spreadOf(places), guess)}));
}

}  // namespace

void PlaceFindings::update(std::span<const NearPlace> places, const SurfaceLocator& locator, double reach)
{
  if (std::ranges::equal(places, places_)) return;
  places_.assign(places.begin(), places.end());
  findings_.clear();
  if (auto far = constraintsWhose(places, [&](const Nearness& n) { return n.distance > reach; }); !far.empty())
    findings_.push_back(farPlaces(places, locator, reach, std::move(far)));
  else
    addCrowded(findings_, places, locator, reach);
  if (auto between =
          constraintsWhose(places, [&](const Nearness& n) { return n.isBetweenSides && n.distance <= reach; });
      !between.empty())
    findings_.push_back(makeFinding(
        "places_between_sides", "constraint", std::move(between),
        {"constraint names a place in the middle between two sides of the surface, and either may be meant; the nearer "
         "one is taken: move the place beyond the side that is meant, or name its face",
         "constraints name places in the middle between two sides of the surface, and either may be meant; the nearer "
         "one is taken: move the places beyond the side that is meant, or name its faces"}));
}

}  // namespace holdfast

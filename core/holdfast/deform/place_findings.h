#pragma once
/// These findings say what is doubtful about the places that constraints name by `near`.

#include <span>
#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/constraints/near_places.h>

namespace holdfast {

/// Findings about the `near` places of one list after another on one mesh. While places stay, nothing is searched.
class PlaceFindings {
 public:
  /// Looks for places farther from the surface than `reach`, a length, and guesses what was meant. It also looks for
  /// places in the middle between two sides. `locator` is that of the mesh. O(places), and the cost of `guessOfPlaces`
  /// where one is far.
  void update(std::span<const NearPlace> places, const SurfaceLocator& locator, double reach);

  /// Adds what was found to `findings`.
  void addTo(std::vector<Finding>& findings) const
  {
    findings.insert(findings.end(), findings_.begin(), findings_.end());
  }

 private:
  std::vector<NearPlace> places_;
  std::vector<Finding> findings_;
};

}  // namespace holdfast

#pragma once
/// Known places are what constraints name on a mesh. They are kept from one list to the next.

#include <map>
#include <optional>
#include <span>
#include <vector>

#include <holdfast/constraints/mirror_pairs.h>
#include <holdfast/constraints/near_places.h>
#include <holdfast/constraints/selection.h>
#include <holdfast/numbers/term.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

/// Finds the places that a list names, and keeps them for the next list on the same mesh. A place that is stated as
/// before is not found again.
class KnownPlaces {
 public:
  struct KnownPoint {
    SurfaceLocation at;
    FewTerms terms;                         ///< over unknowns
    Vector3 rest;                           ///< model units
    int corners = 0;                        ///< see `ConstraintRow::corners`
    std::optional<Nearness> nearness = {};  ///< of a `near` place
  };

  /// Returns the point of the constraint at this place in the list. `find` makes it where the last one was elsewhere.
  template <class Find>
  [[nodiscard]] const KnownPoint& point(Index place, const SurfaceLocation& at, const Find& find)
  {
    if (place >= static_cast<Index>(points_.size())) points_.resize(static_cast<std::size_t>(place) + 1);
    std::optional<KnownPoint>& known = points_[place];
    if (!known || known->at != at) known = find();
    return *known;
  }

  /// Returns the vertices that the constraint at this place selects. `find` finds them anew where it selects otherwise
  /// than before.
  template <class Find>
  [[nodiscard]] std::span<const Index> vertices(Index place, const Selection& selection, const Find& find)
  {
    auto known = selected_.find(place);
    if (known == selected_.end() || known->second.by != selection)
      known = selected_.insert_or_assign(place, Selected{selection, find()}).first;
    return known->second.vertices;
  }

  /// Returns the partners that the mirror at this place finds. `find` finds them anew where it is another than before.
  template <class Find>
  [[nodiscard]] const MirrorPairs& partners(Index place, const MirrorConstraint& mirror, const Find& find)
  {
    auto known = partners_.find(place);
    if (known == partners_.end() || !areOfSamePartners(known->second.by, mirror))
      known = partners_.insert_or_assign(place, Partners{mirror, find()}).first;
    return known->second.found;
  }

 private:
  struct Partners {
    MirrorConstraint by;
    MirrorPairs found;
  };

  static bool areOfSamePartners(const MirrorConstraint& a, const MirrorConstraint& b)
  {
    return a.point == b.point && a.normal == b.normal && a.tolerance == b.tolerance && a.select == b.select;
  }

  struct Selected {
    Selection by;
    std::vector<Index> vertices;
  };

  std::vector<std::optional<KnownPoint>> points_;  // of each constraint
  std::map<Index, Selected> selected_;             // of those that select vertices
  std::map<Index, Partners> partners_;             // of mirrors that find them
};

}  // namespace holdfast

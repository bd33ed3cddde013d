#include <fmt/format.h>

#include "chapters.h"

namespace holdfast::tour {
namespace {

// In the order of the panel's entries.
enum RangeKind { OfAllValues, OfFixedEnds, OfDecades };
enum Rest { kHidden, kEdges, kSurface };

}  // namespace

void colors(TourWindow& tour)
{
  tour.open("head.ply", "head.rigid_eyes.constraints.json");
  tour.raise("colorsDock");
  for (std::size_t field = 0; field < colorByNames().size(); ++field) {
    tour.choose("colorField", static_cast<int>(field));
    tour.picture(fmt::format("coloured_by_{}", colorByNames()[field]));
  }
  tour.choose("colorField", static_cast<int>(ColorBy::Displacement));
  tour.choose("colorMap", 3);
  tour.choose("colorRangeKind", OfFixedEnds);
  tour.enter("colorLow", "10");
  tour.enter("colorHigh", "60");
  tour.picture("other_map_and_fixed_range");
  tour.choose("colorRangeKind", OfDecades);
  tour.choose("colorMap", 0);
  tour.picture("logarithmic_range");
  tour.choose("colorRangeKind", OfAllValues);

  tour.choose("colorField", static_cast<int>(ColorBy::None));
  tour.choose("restGhost", kSurface);
  tour.check("rotationArrows", Qt::Checked);
  tour.picture("rotation_arrows_and_shape_at_rest");
  tour.check("rotationArrows", Qt::Unchecked);
  tour.choose("restGhost", kEdges);
  tour.choose("meshEdges", 1);
  tour.picture("all_edges");
  tour.choose("meshEdges", 0);
  tour.choose("colorField", static_cast<int>(ColorBy::Displacement));
  tour.raise("constraintsDock");
}

}  // namespace holdfast::tour

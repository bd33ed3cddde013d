#include <fmt/format.h>

#include "chapters.h"

namespace holdfast::tour {
namespace {

// In the order of the panel's entries.
enum RangeKind { kAutomatic, kFixed, kLogarithmic };
enum Rest { kHidden, kEdges, kSurface };

}  // namespace

void colors(Stage& stage)
{
  stage.open("head.ply", "head.rigid_eyes.constraints.json");
  stage.raise("colorsDock");
  for (std::size_t field = 0; field < colorByNames().size(); ++field) {
    stage.choose("colorField", static_cast<int>(field));
    stage.picture(fmt::format("coloured_by_{}", colorByNames()[field]));
  }
  stage.choose("colorField", static_cast<int>(ColorBy::Displacement));
  stage.choose("colorMap", 2);
  stage.choose("colorRangeKind", kFixed);
  stage.enter("colorLow", "10");
  stage.enter("colorHigh", "60");
  stage.picture("other_map_and_fixed_range");
  stage.choose("colorRangeKind", kLogarithmic);
  stage.choose("colorMap", 0);
  stage.picture("logarithmic_range");
  stage.choose("colorRangeKind", kAutomatic);

  stage.choose("colorField", static_cast<int>(ColorBy::None));
  stage.choose("restGhost", kSurface);
  stage.check("rotationArrows", Qt::Checked);
  stage.picture("rotation_arrows_and_shape_at_rest");
  stage.check("rotationArrows", Qt::Unchecked);
  stage.choose("restGhost", kEdges);
  stage.choose("meshEdges", 1);
  stage.picture("all_edges");
  stage.choose("meshEdges", 0);
  stage.choose("colorField", static_cast<int>(ColorBy::Displacement));
  stage.raise("constraintsDock");
}

}  // namespace holdfast::tour

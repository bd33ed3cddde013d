#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/widgets/interaction/region_widget.h>

#include "interaction/interaction_fixture.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

TEST(BrushStroke, ReachesNothingThatASectionCutsAway)
{
  test::InteractionFixture fixture(test::grid(10, 8));
  const auto regions = std::make_shared<VertexRegions>(fixture.model().mesh, fixture.model().solverMesh);
  const DisplayPoint pixel = fixture.pixelOf({5, 4, 0});
  const double radius = 1.2 * (fixture.pixelOf({6, 4, 0}) - pixel).norm();
  const auto reached = [&](const std::optional<SectionPlane>& section) {
    BrushStroke stroke(regions);
    stroke.paintTo(pixel, radius, std::make_shared<const VisibleSurface>(fixture.surface()->withSection(section)),
                   fixture.renderer());
    return stroke.reached();
  };
  // Vertex (i, j) of the grid is 11 j + i.
  EXPECT_EQ(reached(std::nullopt), (std::vector<Index>{38, 48, 49, 50, 60}));
  EXPECT_EQ(reached(SectionPlane{{4.5, 0, 0}, {1, 0, 0}}), (std::vector<Index>{38, 49, 50, 60}));
}

}  // namespace
}  // namespace holdfast

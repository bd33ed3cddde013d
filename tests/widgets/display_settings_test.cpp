#include <gtest/gtest.h>

#include <holdfast/widgets/scene/scene_contents.h>

#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

TEST(DisplaySettings, ChangeTheScaleAndNotTheValues)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  NoProgress progress;
  const DeformResult deformation = deform(model, test::listOf({test::hold({0}), test::moveBy(AtVertex{24}, {0, 0, 1})}),
                                          "constraints", {}, progress);
  const auto plain = coloringOf(model, deformation, ColorBy::Displacement, "mm");
  const ColorSettings settings{ColorBy::Displacement, FixedRange{0.25, 3}, ColorMap::Grey};
  const auto chosen = coloringOf(model, deformation, settings, "mm");
  ASSERT_TRUE(plain && chosen);
  EXPECT_EQ(chosen->values, plain->values);
  EXPECT_EQ(chosen->scale.title, plain->scale.title);
  EXPECT_EQ(chosen->scale.low, 0.25);
  EXPECT_EQ(chosen->scale.high, 3);
  EXPECT_EQ(chosen->scale.map, ColorMap::Grey);
  EXPECT_FALSE(coloringOf(model, deformation, ColorSettings{ColorBy::None, {}, {}}, "mm"));
}

}  // namespace
}  // namespace holdfast

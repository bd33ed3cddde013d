#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "holdfast/widgets/interaction/vtkHoldfastSurfaceRulerRepresentation.h"
#include "interaction/interaction_fixture.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using test::InteractionFixture;

const std::vector<int> kArrowColor{156, 43, 255};

/// An arrow from vertex 5 to 13, drawn without a widget.
struct Arrow : InteractionFixture, testing::Test {
  Arrow() : InteractionFixture(test::grid(4, 3))
  {
    arrow->SetSurface(surface());
    arrow->SetRenderer(&renderer());
    arrow->GetHandle(0).SetLocation(AtVertex{5});
    arrow->GetHandle(1).SetLocation(AtVertex{13});
    renderer().AddViewProp(arrow);
  }

  vtkNew<vtkHoldfastSurfaceRulerRepresentation> arrow;
};

TEST_F(Arrow, SaysItsComponentsOnlyWhereTheyAreAskedFor)
{
  EXPECT_EQ(arrow->GetVector(), Vector3(3, 1, 0)) << "from end 0 to end 1";
  EXPECT_EQ(arrow->GetLabel(), "3.162 (rest 3.162)");
  arrow->SetUnits("mm");
  arrow->ShowVectorOn();
  EXPECT_EQ(arrow->GetLabel(), "3.162 mm: 3, 1, 0 (rest 3.162)");
  arrow->GetHandle(1).SetPlacement(nullptr);
  EXPECT_EQ(arrow->GetVector(), Vector3(0, 0, 0));
}

TEST_F(Arrow, IsThatOfTheSurfaceAsItIsNow)
{
  arrow->ShowVectorOn();
  auto moved = std::make_shared<Positions>(model().mesh.positions);
  moved->row(13) << 3, 1e-9, -7.123456;
  arrow->SetSurface(std::make_shared<const VisibleSurface>(surface()->movedTo(moved)));
  EXPECT_EQ(arrow->GetLabel(), "7.794: 3, -1, -7.123 (rest 3.162)");
  moved = std::make_shared<Positions>(*moved);
  moved->row(13) << 3, 1 + 1e-9, -7.123456;
  arrow->SetSurface(std::make_shared<const VisibleSurface>(surface()->movedTo(moved)));
  EXPECT_EQ(arrow->GetLabel(), "7.729: 3, 0, -7.123 (rest 3.162)") << "rounding is not shown";
}

TEST_F(Arrow, HasAHeadAtItsEnd)
{
  const auto accent = [&] { return countPixels(kArrowColor, 30); };
  const auto atHead = [&] {
    const DisplayPoint along = pixelOfVertex(13) - pixelOfVertex(5);
    const DisplayPoint across = DisplayPoint(-along.y(), along.x()).normalized();
    const DisplayPoint tip = pixelOfVertex(13) - 5 * along.normalized();
    int seen = 0;
    for (const double side : {-1.0, 1.0})
      for (double back = 6; back <= 9; ++back)
        if (colorAt(tip - back * along.normalized() + side * 0.47 * back * across)[1] < 100) ++seen;
    return seen;
  };
  const int line = accent();
  EXPECT_GT(line, 100);
  EXPECT_EQ(atHead(), 0);
  arrow->ShowVectorOn();
  EXPECT_GE(atHead(), 6);
  EXPECT_GT(accent(), line);
}

}  // namespace
}  // namespace holdfast

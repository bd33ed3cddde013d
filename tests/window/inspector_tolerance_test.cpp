// How near points come to their targets, in the inspector.

#include "inspected_sheet.h"

namespace holdfast {
namespace {

using enum test::Inspected;

/// In the order of the box.
enum Nearness { Exact, InBall, InABox, InASlab, Soft };

class InspectorOfTolerances : public test::InspectedSheet {
 protected:
  void SetUp() override
  {
    InspectedSheet::SetUp();
    editor.selectConstraints({kAtVertex});
  }

  template <class Tolerance>
  [[nodiscard]] const Tolerance& tolerance()
  {
    return std::get<Tolerance>(what<PointConstraint>(kAtVertex).within);
  }
};

TEST_F(InspectorOfTolerances, ABallIsTypedToTheLastDigit)
{
  EXPECT_FALSE(find("toleranceRadius").isVisible()) << "it is exact";
  const auto before = editor.history().state();
  choose("toleranceWay", InBall);
  expectOneEntry(before, "give P1 a tolerance");
  EXPECT_GT(tolerance<WithinBall>().radius, 0);
  typeInto("toleranceRadius", "0.020000000000000004");
  EXPECT_EQ(tolerance<WithinBall>().radius, 0.020000000000000004);
  typeInto("toleranceRadius", "-1");
  EXPECT_NE(refusal().find("must be above 0"), std::string::npos) << refusal();
  EXPECT_EQ(tolerance<WithinBall>().radius, 0.020000000000000004);
  expectKeptInSession();
  choose("toleranceWay", Exact);
  EXPECT_TRUE(std::holds_alternative<Exactly>(what<PointConstraint>(kAtVertex).within));
}

TEST_F(InspectorOfTolerances, BoxesSlabsAndWeightsHaveTheirNumbers)
{
  choose("toleranceWay", InABox);
  typeInto("toleranceBoxY", "0.5");
  EXPECT_EQ(tolerance<WithinBox>().half.y(), 0.5);
  choose("toleranceWay", InASlab);
  typeInto("toleranceLow", "-0.25");
  typeInto("toleranceHigh", "0.75");
  typeInto("toleranceNormalX", "2");
  EXPECT_EQ(tolerance<WithinSlab>().low, -0.25);
  EXPECT_EQ(tolerance<WithinSlab>().high, 0.75);
  EXPECT_EQ(tolerance<WithinSlab>().normal, Vector3(2, 0, 1));
  typeInto("toleranceLow", "0.75");
  EXPECT_NE(refusal().find("is not below"), std::string::npos) << refusal();
  choose("toleranceWay", Soft);
  typeInto("toleranceWeight", "12.5");
  EXPECT_EQ(tolerance<Weighted>().weight, 12.5);
  expectKeptInSession();
}

TEST_F(InspectorOfTolerances, PointsOnPlanesHaveThoseThatMakeSenseThere)
{
  constexpr int kOnAPlane = 3;
  choose("toleranceWay", InBall);
  choose("targetWay", kOnAPlane);
  EXPECT_TRUE(std::holds_alternative<OnPlane>(what<PointConstraint>(kAtVertex).to));
  EXPECT_GT(tolerance<WithinBall>().radius, 0) << "around the plane";
  choose("toleranceWay", InASlab);
  EXPECT_FALSE(tolerance<WithinSlab>().normal) << "that of the plane is meant";
  EXPECT_FALSE(find("toleranceNormalX").isVisible());
  choose("toleranceWay", InABox);
  EXPECT_NE(refusal().find("goes to one place"), std::string::npos) << refusal();
  choose("targetWay", 0);
  EXPECT_TRUE(std::holds_alternative<Exactly>(what<PointConstraint>(kAtVertex).within)) << "a slab needs a normal";
}

}  // namespace
}  // namespace holdfast

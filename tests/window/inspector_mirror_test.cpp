// Mirrors, scales of handles and rings in the inspector.

#include "inspected_sheet.h"

namespace holdfast {
namespace {

using enum test::Inspected;

class InspectorOfMirrors : public test::InspectedSheet {
 protected:
  void SetUp() override
  {
    InspectedSheet::SetUp();
    ConstraintList list = editor.list();
    list.constraints.push_back(
        {"mirror", true, MirrorConstraint{{5, 0, 0}, {1, 0, 0}, {}, {VertexIds{{40, 41, 60}}}, {}}});
    editor.edit("add mirror", std::move(list));
    editor.selectConstraints({kPair + 1});
  }
  [[nodiscard]] const MirrorConstraint& mirror() { return what<MirrorConstraint>(kPair + 1); }
  [[nodiscard]] QString partners() { return find<QLabel>("mirrorPartners").text(); }
};

TEST_F(InspectorOfMirrors, SaysHowManyVerticesHavePartners)
{
  EXPECT_EQ(partners().toStdString(), "2 pairs, 1 on the plane");
  typeInto("mirrorThroughX", "2.25");
  EXPECT_EQ(mirror().point.x(), 2.25);
  EXPECT_EQ(partners().toStdString(), "0 pairs, 3 without a partner");
  typeInto("mirrorTolerance", "0.5");
  EXPECT_EQ(mirror().tolerance, 0.5);
  EXPECT_EQ(partners().toStdString(), "0 pairs, 3 without a partner") << "their images lie off the sheet, or between";
  expectKeptInSession();
}

TEST_F(InspectorOfMirrors, ADirectionIsNeverZero)
{
  const auto before = editor.history().state();
  typeInto("mirrorNormalX", "0");
  EXPECT_NE(refusal().find("a direction cannot be zero"), std::string::npos) << refusal();
  EXPECT_EQ(editor.history().state(), before);
  typeInto("mirrorNormalY", "2");
  EXPECT_EQ(mirror().normal, Vector3(1, 2, 0));
}

TEST_F(InspectorOfMirrors, AHandleIsScaledAlongItsAxes)
{
  editor.selectConstraints({kTip});
  const auto before = editor.history().state();
  typeInto("handleScaleX", "1.5");
  EXPECT_EQ(what<HandleConstraint>(kTip).scale, Vector3(1.5, 1, 1));
  expectOneEntry(before, "scale tip by x = 1.5");
  typeInto("handleScaleY", "0");
  EXPECT_NE(refusal().find("above 0"), std::string::npos) << refusal();
  EXPECT_EQ(what<HandleConstraint>(kTip).scale, Vector3(1.5, 1, 1));
  expectKeptInSession();
}

TEST_F(InspectorOfMirrors, FixedVerticesAndHandlesHaveRings)
{
  editor.selectConstraints({kBase});
  const auto before = editor.history().state();
  typeInto("verticesRings", "2");
  expectOneEntry(before, "hold base with 2 rings");
  EXPECT_EQ(std::get<Grown>(what<FixedConstraint>(kBase).select.what).rings, 2);
  EXPECT_EQ(find<QLabel>("verticesCount").text().toStdString(), "33 vertices");
  typeInto("verticesRings", "1.5");
  EXPECT_NE(refusal().find("is no number of rings"), std::string::npos) << refusal();
  typeInto("verticesRings", "0");
  EXPECT_TRUE(std::holds_alternative<InHalfSpace>(what<FixedConstraint>(kBase).select.what));
  expectKeptInSession();
  editor.selectConstraints({kPair + 1});
  EXPECT_FALSE(find("verticesRings").isVisible()) << "a mirror has none";
}

}  // namespace
}  // namespace holdfast

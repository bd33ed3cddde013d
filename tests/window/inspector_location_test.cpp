#include "inspected_sheet.h"

namespace holdfast {
namespace {

using enum test::Inspected;

/// The kinds of places in the order of the box.
enum Kind { OnVertex, OnEdge, InAFace, Nearest };

class InspectorOfLocations : public test::InspectedSheet {
 protected:
  template <class At>
  [[nodiscard]] const At& at(Index k)
  {
    return std::get<At>(what<PointConstraint>(k).at);
  }
};

TEST_F(InspectorOfLocations, AVertexBecomesAPointOfEveryKindInItsPlace)
{
  editor.selectConstraints({kAtVertex});
  const auto before = editor.history().state();
  choose("locationKind", OnEdge);
  EXPECT_EQ(at<AtEdge>(kAtVertex).i, 36);
  EXPECT_EQ(at<AtEdge>(kAtVertex).t, 1);
  EXPECT_EQ(find("locationFirst").text(), "36");
  EXPECT_EQ(find("locationT").text(), "1");
  expectOneEntry(before, "put P1 on an edge");
  choose("locationKind", InAFace);
  EXPECT_EQ(find("locationWeight0").isVisible(), true);
  choose("locationKind", Nearest);
  EXPECT_EQ(at<AtNear>(kAtVertex).place, Vector3(3, 3, 0));
  EXPECT_EQ(find("locationNearX").text(), "3");
  expectKeptInSession();
  choose("locationKind", OnVertex);
  EXPECT_EQ(at<AtVertex>(kAtVertex).vertex, 36);
  EXPECT_EQ(std::get<Target>(what<PointConstraint>(kAtVertex).to).place, Vector3(3, 2, 1)) << "the target stays";
}

TEST_F(InspectorOfLocations, AnEdgeTakesItsNearerEndAndAFaceKeepsItsShares)
{
  editor.selectConstraints({kAtEdge});
  choose("locationKind", InAFace);
  expectKeptInSession();
  double most = 0;
  for (const double weight : at<AtFace>(kAtEdge).weights) most = std::max(most, weight);
  EXPECT_EQ(most, 0.75);
  editor.undo();
  choose("locationKind", OnVertex);
  EXPECT_EQ(at<AtVertex>(kAtEdge).vertex, 49);
}

TEST_F(InspectorOfLocations, TheSameKindIsNoEdit)
{
  editor.selectConstraints({kInFace});
  choose("locationKind", InAFace);
  EXPECT_FALSE(editor.history().canUndo());
}

TEST_F(InspectorOfLocations, BothEndsOfAnEdgeAreTypedOneAfterTheOther)
{
  editor.selectConstraints({kAtEdge});
  const auto before = editor.history().state();
  typeInto("locationFirst", "5");
  EXPECT_NE(refusal().find("no face has an edge between the vertices 5 and 49"), std::string::npos) << refusal();
  EXPECT_EQ(editor.history().state(), before);
  EXPECT_EQ(find("locationFirst").text(), "5") << "until the other end is typed";
  typeInto("locationSecond", "6");
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(at<AtEdge>(kAtEdge).i, 5);
  EXPECT_EQ(at<AtEdge>(kAtEdge).j, 6);
  EXPECT_EQ(at<AtEdge>(kAtEdge).t, 0.25);
  expectOneEntry(before, "relocate P2");
  expectKeptInSession();
}

TEST_F(InspectorOfLocations, EndsThatWereNeverTakenAreForgottenWithTheSelection)
{
  editor.selectConstraints({kAtEdge});
  typeInto("locationFirst", "5");
  editor.selectConstraints({kTip});
  editor.selectConstraints({kAtEdge});
  EXPECT_EQ(find("locationFirst").text(), "48");
}

TEST_F(InspectorOfLocations, APlaceThatTheMeshDoesNotHaveCannotChangeItsKind)
{
  ConstraintList list = editor.list();
  std::get<PointConstraint>(list.constraints[kAtVertex].what).at = AtVertex{1000};
  editor.edit("elsewhere", list);
  const auto before = editor.history().state();
  editor.selectConstraints({kAtVertex});
  choose("locationKind", InAFace);
  EXPECT_NE(refusal().find("no vertex 1000"), std::string::npos) << refusal();
  EXPECT_EQ(editor.history().state(), before);
  EXPECT_EQ(find<QComboBox>("locationKind").currentIndex(), OnVertex) << "as it is";
}

}  // namespace
}  // namespace holdfast

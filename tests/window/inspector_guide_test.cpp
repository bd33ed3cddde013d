// Points and selections that are free along some directions, in the inspector.

#include <QApplication>
#include <QScrollArea>
#include <QScrollBar>

#include <holdfast/surface/guide_surface.h>
#include <holdfast/window/model/constraint_actions.h>

#include "inspected_sheet.h"

namespace holdfast {
namespace {

using enum test::Inspected;

/// The ways of a point in the order of the box.
enum PointWay { AtPlace, Shifted, AtCoordinates, OnOnePlane, OnOneLine, OnAMesh };

/// The ways of a slide in the order of the box.
enum SlideWay { Plane, OwnPlanes, Line, OwnLines, FitPlane, FitLine, AMesh };

OnMesh scanOver(const Mesh& mesh)
{
  Mesh scan = mesh;
  scan.positions.col(2).array() += 0.5;
  return {"/scans/scan.stl", std::make_shared<const GuideSurface>(scan, "scan.stl")};
}

class InspectorOfGuides : public test::InspectedSheet {
 protected:
  template <class Goal>
  [[nodiscard]] const Goal& goal(Index k)
  {
    return std::get<Goal>(what<PointConstraint>(k).to);
  }
};

TEST_F(InspectorOfGuides, APointIsHeldInCoordinatesOfItsTarget)
{
  editor.selectConstraints({kAtVertex});
  const auto before = editor.history().state();
  choose("targetWay", AtCoordinates);
  EXPECT_EQ(goal<Coordinates>(kAtVertex).placeFrom(Vector3(7, 7, 7)), Vector3(7, 7, 1)) << "across the sheet";
  expectOneEntry(before, "hold coordinates of P1");
  EXPECT_TRUE(find<QComboBox>("targetFree").isVisible());
  EXPECT_FALSE(find("targetNormalX").isVisible());
  choose("targetFree", 1);
  EXPECT_EQ(goal<Coordinates>(kAtVertex).values[0], 3.0);
  EXPECT_FALSE(goal<Coordinates>(kAtVertex).values[1]);
  EXPECT_EQ(goal<Coordinates>(kAtVertex).values[2], 1.0);
  typeInto("targetPlaceX", "3.25");
  EXPECT_EQ(goal<Coordinates>(kAtVertex).values[0], 3.25);
  expectKeptInSession();
  typeInto("targetPlaceY", "2");
  EXPECT_EQ(goal<Target>(kAtVertex).place, Vector3(3.25, 2, 1)) << "no coordinate is free any more";
}

TEST_F(InspectorOfGuides, APointStaysOnAPlaneThatIsTyped)
{
  editor.selectConstraints({kAtVertex});
  const auto before = editor.history().state();
  choose("targetWay", OnOnePlane);
  expectOneEntry(before, "keep P1 on a plane");
  EXPECT_EQ(find("targetPlaceZ").text(), "1");
  EXPECT_EQ(find("targetNormalZ").text(), "1");
  typeInto("targetNormalX", "2");
  typeInto("targetNormalZ", "0");
  typeInto("targetOffset", "0.5");
  EXPECT_EQ(goal<OnPlane>(kAtVertex).normal, Vector3(2, 0, 0));
  EXPECT_EQ(goal<OnPlane>(kAtVertex).offset, 0.5);
  typeInto("targetPlaceX", "4");
  EXPECT_EQ(goal<OnPlane>(kAtVertex).point->x(), 4);
  EXPECT_EQ(editor.history().undoName(), "move P1 to x = 4");
  expectKeptInSession();
}

TEST_F(InspectorOfGuides, APointStaysOnAMeshThatIsAskedFor)
{
  editor.selectConstraints({kAtVertex});
  Rows asked;
  QObject::connect(&editor, &Editor::guideMeshWanted, &panel, [&](const Rows& rows) { asked = rows; });
  const auto before = editor.history().state();
  choose("targetWay", OnAMesh);
  EXPECT_EQ(asked, Rows{kAtVertex});
  EXPECT_EQ(editor.history().state(), before) << "nothing is chosen yet";
  keepOnMesh(editor, asked, scanOver(editor.model()->mesh));
  expectOneEntry(before, "keep P1 on scan.stl");
  EXPECT_EQ(find<QLabel>("targetMesh").text(), "scan.stl");
  EXPECT_EQ(find<QLabel>("targetMesh").toolTip(), "/scans/scan.stl");
  EXPECT_FALSE(find("targetPlaceX").isVisible());
  choose("targetWay", AtPlace);
  EXPECT_EQ(goal<Target>(kAtVertex).place.z(), 0.5) << "the foot of the place at rest";
}

TEST_F(InspectorOfGuides, ADirectionIsNeverZero)
{
  editor.selectConstraints({kAtVertex});
  choose("targetWay", OnOneLine);
  const auto before = editor.history().state();
  typeInto("targetDirectionZ", "0");
  EXPECT_NE(refusal().find("a direction cannot be zero"), std::string::npos) << refusal();
  EXPECT_EQ(editor.history().state(), before);
}

TEST_F(InspectorOfGuides, NoSectionOfANarrowPanelScrollsSideways)
{
  panel.resize(334, 700);
  auto& page = *panel.findChild<QScrollArea*>();
  for (Index k = kBase; k <= kPair; ++k) {
    editor.selectConstraints({k});
    QApplication::processEvents();
    ASSERT_TRUE(page.isVisible());
    EXPECT_EQ(page.horizontalScrollBar()->maximum(), 0) << editor.list().constraints[k].name;
  }
}

class InspectorOfSlides : public test::InspectedSheet {
 protected:
  void SetUp() override
  {
    InspectedSheet::SetUp();
    ConstraintList list = editor.list();
    list.constraints.push_back({"flange", true, SlideConstraint{{VertexIds{{70, 71, 82, 83}}}, FittedPlane{}, false}});
    editor.edit("add flange", std::move(list));
    editor.selectConstraints({kPair + 1});
  }
  [[nodiscard]] const SlideConstraint& slide() { return what<SlideConstraint>(kPair + 1); }
};

TEST_F(InspectorOfSlides, APlaneThatIsGivenBeginsWithTheOneThatFits)
{
  EXPECT_FALSE(find("slideNormalX").isVisible()) << "it is fitted";
  const auto before = editor.history().state();
  choose("slideGuide", Plane);
  expectOneEntry(before, "slide flange on another plane or line");
  EXPECT_EQ(std::get<OnPlane>(slide().on).normal, Vector3::UnitZ());
  EXPECT_EQ(find("slideThroughZ").text(), "0");
  typeInto("slideThroughZ", "0.25");
  EXPECT_EQ(std::get<OnPlane>(slide().on).point->z(), 0.25);
  typeInto("slideNormalY", "1");
  typeInto("slideOffset", "-0.5");
  EXPECT_EQ(std::get<OnPlane>(slide().on).normal, Vector3(0, 1, 1));
  EXPECT_EQ(std::get<OnPlane>(slide().on).offset, -0.5);
  expectKeptInSession();
}

TEST_F(InspectorOfSlides, VerticesStayNearAMesh)
{
  choose("slideTogether", 1);
  keepOnMesh(editor, {kPair + 1}, scanOver(editor.model()->mesh));
  EXPECT_FALSE(slide().together) << "a mesh does not shift";
  EXPECT_FALSE(find<QComboBox>("slideTogether").isVisible());
  EXPECT_EQ(find<QComboBox>("slideGuide").currentIndex(), AMesh);
  EXPECT_EQ(find<QLabel>("slideMesh").text(), "scan.stl");
  choose("slideToleranceWay", 1);
  typeInto("slideToleranceRadius", "0.125");
  EXPECT_EQ(std::get<WithinBall>(slide().within).radius, 0.125);
}

TEST_F(InspectorOfSlides, EachVertexMayHaveALineOfItsOwn)
{
  choose("slideGuide", OwnLines);
  EXPECT_FALSE(std::get<OnLine>(slide().on).point);
  EXPECT_FALSE(find("slideThroughX").isVisible());
  typeInto("slideDirectionZ", "3");
  EXPECT_EQ(std::get<OnLine>(slide().on).direction.z(), 3);
  choose("slideGuide", FitLine);
  EXPECT_TRUE(std::holds_alternative<FittedLine>(slide().on));
}

TEST_F(InspectorOfSlides, ThePlaneMayShift)
{
  const auto before = editor.history().state();
  choose("slideTogether", 1);
  EXPECT_TRUE(slide().together);
  expectOneEntry(before, "let the plane or line of flange shift");
  choose("slideTogether", 0);
  EXPECT_FALSE(slide().together);
  EXPECT_EQ(editor.history().undoName(), "keep the plane or line of flange where it is");
}

}  // namespace
}  // namespace holdfast

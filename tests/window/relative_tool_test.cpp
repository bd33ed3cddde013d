#include <QAction>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerRepresentation.h>

#include "open_document.h"
#include "support/meshes.h"
#include "window_user.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A sheet of 4 x 3 squares whose left side is fixed, seen straight from above, with the tool that keeps vectors. The
/// vertex (i, j) has the id 5 j + i.
class RelativeToolOnSheet : public test::WindowUser {
 protected:
  static constexpr double kHeight = 10;  // of the eye above the sheet

  void SetUp() override
  {
    WindowUser::SetUp();
    const ConstraintList left{"mm", {{"base", true, FixedConstraint{{InHalfSpace{{0.5, 0, 0}, {-1, 0, 0}}}}}}};
    ASSERT_TRUE(test::openMesh(editor(), test::grid(4, 3), left));
    view.target = {2, 1.5, 0};
    view.eye = {2, 1.5, kHeight};
    look(view);
    viewport().setFocus();
    keys("k");
    before = editor().history().state();
  }

  [[nodiscard]] Eigen::Vector2d pixelOf(const Vector3& place) const
  {
    return view.shown(place).head<2>().array().floor() + 0.5;
  }
  void clickAt(const Vector3& place) { test::click(viewport(), inWidget(pixelOf(place))); }
  void clickAt(Index vertex) { clickAt(placeOf(vertex)); }
  void moveTo(Index vertex) { test::moveMouse(viewport(), inWidget(pixelOf(placeOf(vertex)))); }
  [[nodiscard]] Vector3 placeOf(Index vertex) { return editor().model()->mesh.positions.row(vertex).transpose(); }
  /// The place of the sheet at rest in the middle of the pixel in which `place` is.
  [[nodiscard]] Vector3 clicked(const Vector3& place) const { return view.placeAt(pixelOf(place), kHeight); }

  [[nodiscard]] bool isUnchanged() { return editor().history().state() == before; }
  [[nodiscard]] const RelativeConstraint& lastOne()
  {
    return std::get<RelativeConstraint>(list().constraints.back().what);
  }
  [[nodiscard]] SurfacePoint pointOf(const SurfaceLocation& location)
  {
    return holdfast::pointOf(location, editor().model()->mesh);
  }
  [[nodiscard]] Vector3 restOf(const SurfaceLocation& location)
  {
    return positionOf(pointOf(location), editor().model()->mesh.positions);
  }
  void expectVertices(Index from, Index to)
  {
    ASSERT_EQ(list().constraints.size(), 2U);
    ASSERT_TRUE(std::holds_alternative<AtVertex>(lastOne().from));
    ASSERT_TRUE(std::holds_alternative<AtVertex>(lastOne().to));
    EXPECT_EQ(std::get<AtVertex>(lastOne().from).vertex, from);
    EXPECT_EQ(std::get<AtVertex>(lastOne().to).vertex, to);
    EXPECT_FALSE(lastOne().offset);
  }

  [[nodiscard]] std::string hint() { return find<QLabel>("statusHint").toolTip().toStdString(); }
  /// The labels of all arrows that the picture shows.
  [[nodiscard]] std::vector<std::string> arrows()
  {
    EXPECT_TRUE(settle());
    std::vector<std::string> labels;
    vtkPropCollection& props = *viewport().widgetRenderer().GetViewProps();
    for (int k = 0; k < props.GetNumberOfItems(); ++k)
      if (auto* ruler = vtkHoldfastSurfaceRulerRepresentation::SafeDownCast(props.GetItemAsObject(k)))
        if (ruler->GetVisibility() != 0 && ruler->IsPlaced()) labels.push_back(ruler->GetLabel());
    return labels;
  }
  /// Tells whether the arrow from vertex 6 to 13 is seen, beside its label.
  [[nodiscard]] bool isArrowSeen()
  {
    EXPECT_TRUE(settle());
    const QImage picture = viewport().grabFramebuffer();
    const QPointF place = viewport().pixelRatio() * inWidget(pixelOf((7 * placeOf(6) + placeOf(13)) / 8));
    const auto isAccent = [](const QColor& color) {
      return color.blue() > 200 && color.red() > 110 && color.green() < 110;
    };
    for (int k = 0; k < 25; ++k)
      if (isAccent(picture.pixelColor(place.toPoint() + QPoint(k % 5 - 2, k / 5 - 2)))) return true;
    return false;
  }

  void typeOffset(const char* axis, const char* text)
  {
    auto& line = find<QLineEdit>((std::string("relativeOffset") + axis).c_str());
    line.setFocus();
    line.selectAll();
    test::type(line, text);
    test::pressKey(line, Qt::Key_Return);
  }

  test::PlainView view;
  std::shared_ptr<const DocumentState> before;
};

TEST_F(RelativeToolOnSheet, IsChosenByItsKey)
{
  auto* action = window.findChild<QAction*>("toolRelative");
  EXPECT_TRUE(action->isChecked());
  EXPECT_TRUE(action->toolTip().endsWith("(K)"));
  EXPECT_THAT(hint(), HasSubstr("Click two points"));
  keys("s");
  EXPECT_FALSE(action->isChecked());
  clickAt(6);
  clickAt(13);
  EXPECT_TRUE(isUnchanged()) << "another tool is chosen";
}

TEST_F(RelativeToolOnSheet, TwoClicksKeepTheVectorFromTheFirstVertexToTheSecond)
{
  clickAt(6);
  EXPECT_THAT(hint(), HasSubstr("second point"));
  moveTo(8);
  EXPECT_THAT(arrows(), ElementsAre("2 mm: 2, 0, 0 (rest 2)")) << "goes with the cursor";
  clickAt(13);
  expectVertices(13, 6);
  EXPECT_EQ(editor().selectedConstraints(), (std::vector<Index>{1}));
  EXPECT_EQ(editor().history().undoName(), "add vector 1");
  openPanel("Selected");
  EXPECT_EQ(find<QLineEdit>("relativeOffsetX").text(), "2");
  EXPECT_EQ(find<QLineEdit>("relativeOffsetY").text(), "1");
  EXPECT_EQ(find<QLineEdit>("relativeOffsetZ").text(), "0");
  clickAt(9);
  EXPECT_EQ(list().constraints.size(), 2U) << "the next click is a first one";
}

TEST_F(RelativeToolOnSheet, PlacesLieInFacesAndOnEdges)
{
  const Vector3 inFace(1.5, 1.2, 0);
  const Vector3 onEdge(3.4, 2, 0);
  clickAt(inFace);
  clickAt(onEdge);
  ASSERT_EQ(list().constraints.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<AtFace>(lastOne().to));
  EXPECT_TRUE(std::holds_alternative<AtEdge>(lastOne().from));
  EXPECT_LE((restOf(lastOne().to) - clicked(inFace)).norm(), 1e-9);
  EXPECT_LE(std::abs(restOf(lastOne().from).x() - clicked(onEdge).x()), 1e-9);
  EXPECT_EQ(restOf(lastOne().from).y(), 2);
}

TEST_F(RelativeToolOnSheet, EscapeTakesTheFirstPointBack)
{
  clickAt(6);
  moveTo(8);
  ASSERT_EQ(arrows().size(), 1U);
  key(Qt::Key_Escape);
  EXPECT_THAT(arrows(), IsEmpty());
  EXPECT_THAT(hint(), HasSubstr("Click two points"));
  clickAt(7);
  EXPECT_TRUE(isUnchanged());
  clickAt(13);
  expectVertices(13, 7);
}

TEST_F(RelativeToolOnSheet, OnePlaceTwiceIsToldAndAddsNothing)
{
  const Vector3 inFace(1.5, 1.2, 0);
  for (const Vector3& place : {placeOf(6), inFace}) {
    clickAt(place);
    clickAt(place);
    EXPECT_TRUE(isUnchanged());
    EXPECT_THAT(hint(), HasSubstr("the same place"));
    EXPECT_THAT(arrows(), IsEmpty());
  }
  clickAt(7);
  EXPECT_THAT(hint(), HasSubstr("second point"));
  clickAt(13);
  expectVertices(13, 7);
  EXPECT_THAT(hint(), HasSubstr("Click two points"));
}

TEST_F(RelativeToolOnSheet, AConstraintIsOneEditThatIsTakenBackAndDoneAgain)
{
  clickAt(6);
  clickAt(13);
  const auto after = editor().history().state();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(isUnchanged());
  EXPECT_THAT(arrows(), IsEmpty());
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(editor().history().state(), after);
}

TEST_F(RelativeToolOnSheet, ATypedVectorIsThatOfTheSurfaceExactly)
{
  clickAt(Vector3(1.5, 1.2, 0));
  clickAt(Vector3(3.4, 2, 0));
  ASSERT_EQ(list().constraints.size(), 2U);
  openPanel("Selected");
  typeOffset("X", "2.1");
  typeOffset("Y", "0.3");
  typeOffset("Z", "0.7");
  const Vector3 typed(2.1, 0.3, 0.7);
  ASSERT_EQ(lastOne().offset, typed);
  ASSERT_TRUE(settle());
  const Positions& positions = editor().positions();
  const Vector3 vector = positionOf(pointOf(lastOne().from), positions) - positionOf(pointOf(lastOne().to), positions);
  EXPECT_LE((vector - typed).norm(), 1e-12 * editor().model()->solverMesh.diagonal);
  EXPECT_EQ(editor().deformation()->report.constraints[1].status, ConstraintStatus::Met);
  EXPECT_THAT(arrows(), ElementsAre(HasSubstr("mm: 2.1, 0.3, 0.7 (rest")));
}

TEST_F(RelativeToolOnSheet, WhatTheSectionPlaneCutsAwayIsNotTaken)
{
  viewport().setSection(SectionPlane{{2.5, 0, 0}, {-1, 0, 0}});
  clickAt(8);
  EXPECT_THAT(hint(), HasSubstr("Click two points")) << "no first point";
  clickAt(6);
  clickAt(8);
  EXPECT_TRUE(isUnchanged());
  EXPECT_THAT(hint(), HasSubstr("second point")) << "still the first";
  viewport().setSection(std::nullopt);
  clickAt(8);
  expectVertices(8, 6);
}

TEST_F(RelativeToolOnSheet, TheVectorOfTheSelectedConstraintIsShownWhateverTheTool)
{
  clickAt(6);
  clickAt(13);
  EXPECT_THAT(arrows(), ElementsAre("2.236 mm: 2, 1, 0 (rest 2.236)"));
  keys("s");
  EXPECT_EQ(arrows().size(), 1U);
  EXPECT_TRUE(isArrowSeen());
  editor().selectConstraints({0});
  EXPECT_THAT(arrows(), IsEmpty());
  EXPECT_FALSE(isArrowSeen());
  editor().selectConstraints({0, 1});
  EXPECT_THAT(arrows(), IsEmpty()) << "of several";
  editor().selectConstraints({1});
  EXPECT_EQ(arrows().size(), 1U);
  DisplaySettings hidden = viewport().display();
  hidden.areConstraintsShown = false;
  viewport().setDisplay(hidden);
  EXPECT_THAT(arrows(), IsEmpty()) << "with all constraints";
}

}  // namespace
}  // namespace holdfast

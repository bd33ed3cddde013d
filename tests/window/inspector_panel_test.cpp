#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <utility>

#include <gtest/gtest.h>

#include <holdfast/numbers/same_bits.h>

#include "inspected_sheet.h"
#include "open_document.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

class InspectorPanelOfSheet : public test::InspectedSheet {};

TEST_F(InspectorPanelOfSheet, SaysWhatToDoWhereNothingIsSelected)
{
  EXPECT_TRUE(find<QLabel>("inspectorEmpty").isVisible());
  editor.selectConstraints({1});
  EXPECT_FALSE(find<QLabel>("inspectorEmpty").isVisible());
  editor.edit("delete all", {});
  EXPECT_TRUE(find<QLabel>("inspectorEmpty").isVisible());
}

TEST_F(InspectorPanelOfSheet, ATypedTargetIsTheTargetToTheLastBit)
{
  editor.selectConstraints({1});
  typeInto("targetPlaceY", "0.30000000000000004");
  EXPECT_TRUE(hasSameBits(std::get<Target>(what<PointConstraint>(1).to).place.y(), 0.1 + 0.2));
  EXPECT_EQ(find("targetPlaceY").text(), "0.30000000000000004") << "shown with all digits";
}

TEST_F(InspectorPanelOfSheet, EscapeBringsBackTheNumberThatWasThere)
{
  editor.selectConstraints({1});
  QLineEdit& line = find("targetPlaceX");
  line.selectAll();
  test::type(line, "77");
  test::pressKey(line, Qt::Key_Escape);
  EXPECT_EQ(line.text(), "3");
  EXPECT_FALSE(editor.history().canUndo());
}

TEST_F(InspectorPanelOfSheet, AShiftIsTypedExactlyAndCanBecomeAPlace)
{
  editor.selectConstraints({2});
  typeInto("targetShiftZ", "-0.7");
  EXPECT_EQ(std::get<Move>(what<PointConstraint>(2).to).shift, Vector3(0, 0, -0.7));
  choose("targetWay", 0);
  EXPECT_EQ(std::get<Target>(what<PointConstraint>(2).to).place.z(), -0.7);
  EXPECT_FALSE(find("targetShiftZ").isVisible());
}

TEST_F(InspectorPanelOfSheet, WeightsThatDoNotSumToOneAreRefusedUntilNormalized)
{
  editor.selectConstraints({3});
  const auto before = editor.history().state();
  typeInto("locationWeight0", "0.75");
  EXPECT_EQ(editor.history().state(), before);
  EXPECT_NE(refusal().find("1.5"), std::string::npos) << refusal();
  press("locationNormalize");
  EXPECT_EQ(std::get<AtFace>(what<PointConstraint>(3).at).weights, (std::vector<double>{0.5, 0.25 / 1.5, 0.5 / 1.5}));
  EXPECT_EQ(refusal(), "");
}

TEST_F(InspectorPanelOfSheet, ARefusalGoesWhenTheFieldIsRight)
{
  panel.activateWindow();
  ASSERT_TRUE(test::waitUntil([this] { return panel.isActiveWindow(); }));
  editor.selectConstraints({1});
  for (const char* wrong : {"abc", "1000", "36.5"}) {
    typeInto("locationFirst", wrong);
    ASSERT_NE(refusal(), "") << wrong;
    typeInto("locationFirst", "36");
    EXPECT_EQ(refusal(), "") << "as it was before " << wrong;
  }
  typeInto("targetPlaceX", "abc");
  ASSERT_NE(refusal(), "");
  test::pressKey(find("targetPlaceX"), Qt::Key_Escape);
  EXPECT_EQ(refusal(), "") << "the last number is back";
  typeInto("targetPlaceX", "abc");
  find("targetPlaceY").setFocus();
  ASSERT_NE(refusal(), "") << "why the number is the last one";
  find("targetPlaceX").setFocus();
  EXPECT_EQ(refusal(), "");
}

TEST_F(InspectorPanelOfSheet, ARefusalOfSeveralNumbersStaysWhileTheyAreWrong)
{
  editor.selectConstraints({3});
  typeInto("locationWeight0", "0.75");
  ASSERT_NE(refusal(), "");
  find("locationWeight2").setFocus();
  EXPECT_NE(refusal(), "");
  typeInto("locationWeight2", "0");
  EXPECT_EQ(refusal(), "");
}

TEST_F(InspectorPanelOfSheet, ARefusalMovesNoField)
{
  editor.selectConstraints({1});
  QApplication::processEvents();
  const auto placeOf = [this](const char* name) { return find(name).mapTo(&panel, QPoint()); };
  const std::vector<const char*> fields{"inspectorName", "locationFirst", "targetPlaceX", "targetPlaceZ"};
  std::vector<QPoint> before;
  for (const char* field : fields) before.push_back(placeOf(field));
  typeInto("locationFirst", "1000");
  ASSERT_NE(refusal(), "");
  QApplication::processEvents();
  for (std::size_t k = 0; k < fields.size(); ++k) EXPECT_EQ(placeOf(fields[k]), before[k]) << fields[k];
  const auto& reason = find<QLabel>("inspectorRefusal");
  EXPECT_TRUE(panel.rect().contains(QRect(reason.mapTo(&panel, QPoint()), reason.size()))) << "it is seen";
}

TEST_F(InspectorPanelOfSheet, WeightsThatAreRefusedMoveNoField)
{
  panel.resize(320, 900);
  editor.selectConstraints({3});
  for (int k = 0; k < 5; ++k) QApplication::processEvents();
  const auto places = [this] {
    std::vector<QRect> all;
    for (const char* name : {"locationWeight0", "locationWeight2", "targetShiftX", "targetShiftZ"})
      all.emplace_back(find(name).mapTo(&panel, QPoint()), find(name).size());
    const auto& normalize = find<QPushButton>("locationNormalize");
    EXPECT_TRUE(normalize.isVisible());
    all.emplace_back(normalize.mapTo(&panel, QPoint()), normalize.size());
    return all;
  };
  const std::vector<QRect> before = places();
  for (const char* weight : {"0.75", "0.12345678901234567"}) {
    typeInto("locationWeight0", weight);
    QApplication::processEvents();
    ASSERT_NE(refusal(), "");
    EXPECT_EQ(places(), before) << weight;
  }
}

TEST_F(InspectorPanelOfSheet, WeightsThatSumToOneAreTaken)
{
  editor.selectConstraints({3});
  typeInto("locationWeight0", "0.5");
  typeInto("locationWeight2", "0.25");
  EXPECT_EQ(std::get<AtFace>(what<PointConstraint>(3).at).weights, (std::vector<double>{0.5, 0.25, 0.25}));
}

TEST_F(InspectorPanelOfSheet, PlacesThatTheMeshDoesNotHaveAreRefusedWithTheReason)
{
  editor.selectConstraints({1});
  const auto before = editor.history().state();
  typeInto("locationFirst", "1000");
  EXPECT_NE(refusal().find("no vertex 1000"), std::string::npos) << refusal();
  typeInto("locationFirst", "1.5");
  EXPECT_NE(refusal().find("whole numbers"), std::string::npos) << refusal();
  editor.selectConstraints({2});
  typeInto("locationT", "1.25");
  EXPECT_NE(refusal().find("from 0 to 1"), std::string::npos) << refusal();
  EXPECT_EQ(editor.history().state(), before);
  EXPECT_EQ(find("locationT").text(), "0.25");
  typeInto("locationT", "0.5");
  EXPECT_EQ(std::get<AtEdge>(what<PointConstraint>(2).at).t, 0.5);
}

TEST_F(InspectorPanelOfSheet, AHandleTurnsByAnyNumberOfTurnsAndByBothMethods)
{
  editor.selectConstraints({4});
  typeInto("handleDegrees", "720");
  EXPECT_EQ(std::get<AxisRotation>(what<HandleConstraint>(4).motion).degrees, 720);
  typeInto("handleAxisX", "1");
  EXPECT_EQ(std::get<AxisRotation>(what<HandleConstraint>(4).motion).axis, Vector3(1, 0, 1));
  choose("handleCenterChoice", 1);
  EXPECT_EQ(std::get<AxisRotation>(what<HandleConstraint>(4).motion).center, Vector3(9, 10, 0))
      << "from the centroid on";
  choose("handleMethod", 2);
  EXPECT_TRUE(std::holds_alternative<RotationAboutFixed>(what<HandleConstraint>(4).motion));
  EXPECT_FALSE(find("handleDegrees").isVisible());
}

TEST_F(InspectorPanelOfSheet, AnAxisOfZeroIsRefused)
{
  editor.selectConstraints({4});
  typeInto("handleAxisZ", "0");
  EXPECT_NE(refusal().find("axis"), std::string::npos);
  EXPECT_EQ(std::get<AxisRotation>(what<HandleConstraint>(4).motion).axis, Vector3(0, 0, 1));
}

TEST_F(InspectorPanelOfSheet, RegionsTellTheirVerticesAndSelectThem)
{
  editor.selectConstraints({0});
  EXPECT_EQ(find<QLabel>("verticesCount").text(), "11 vertices");
  press("verticesSelect");
  ASSERT_EQ(editor.selectedVertices().size(), 11U);
  EXPECT_EQ(editor.selectedVertices()[1], 11);
}

TEST_F(InspectorPanelOfSheet, ARelativeConstraintTakesAnOffset)
{
  editor.selectConstraints({5});
  choose("relativeWay", 1);
  EXPECT_EQ(what<RelativeConstraint>(5).offset, Vector3(-2, 0, 0)) << "what it was at rest";
  typeInto("relativeOffsetX", "-2.5");
  EXPECT_EQ(what<RelativeConstraint>(5).offset, Vector3(-2.5, 0, 0));
}

TEST_F(InspectorPanelOfSheet, ARelativeConstraintTellsBothPlacesAndItsVectorAtRest)
{
  editor.selectConstraints({5});
  EXPECT_TRUE(find<QLabel>("relativeFrom").text().contains("vertex 60"));
  EXPECT_TRUE(find<QLabel>("relativeFrom").text().contains("(5, 5, 0)"));
  EXPECT_TRUE(find<QLabel>("relativeTo").text().contains("(7, 5, 0)"));
  EXPECT_EQ(find("relativeOffsetX").text(), "-2");
  EXPECT_EQ(find("relativeOffsetY").text(), "0");
}

TEST_F(InspectorPanelOfSheet, ATypedComponentMakesTheVectorAtRestAnOffset)
{
  editor.selectConstraints({5});
  const auto before = editor.history().state();
  typeInto("relativeOffsetZ", "0.30000000000000004");
  EXPECT_EQ(what<RelativeConstraint>(5).offset, Vector3(-2, 0, 0.1 + 0.2));
  expectOneEntry(before, "set the offset of pair to z = 0.30000000000000004");
  expectKeptInSession();
  choose("relativeWay", 0);
  EXPECT_FALSE(what<RelativeConstraint>(5).offset) << "that at rest again";
  EXPECT_EQ(find("relativeOffsetZ").text(), "0");
}

TEST_F(InspectorPanelOfSheet, AVectorBetweenPlacesThatTheMeshDoesNotHaveIsRefused)
{
  ConstraintList list = editor.list();
  std::get<RelativeConstraint>(list.constraints[5].what).to = AtVertex{1000};
  editor.edit("elsewhere", list);
  const auto before = editor.history().state();
  editor.selectConstraints({5});
  EXPECT_TRUE(find<QLabel>("relativeTo").text().contains("nowhere"));
  EXPECT_EQ(find("relativeOffsetX").text(), "");
  typeInto("relativeOffsetX", "1");
  EXPECT_NE(refusal().find("no vertex 1000"), std::string::npos) << refusal();
  EXPECT_EQ(editor.history().state(), before);
}

TEST_F(InspectorPanelOfSheet, SeveralConstraintsAreEditedWhereTheyHaveSomethingInCommon)
{
  editor.selectConstraints({2, 3});
  EXPECT_EQ(find("targetShiftZ").text(), "0.1");
  EXPECT_EQ(find("targetPlaceX").text(), "") << "they differ";
  typeInto("targetPlaceX", "5");
  EXPECT_EQ(find("targetPlaceX").text(), "5");
  editor.undo();
  EXPECT_FALSE(editor.history().canUndo()) << "one entry";
  editor.selectConstraints({1, 4});
  EXPECT_FALSE(find("targetPlaceX").isVisible());
  QCheckBox& enabled = find<QCheckBox>("inspectorEnabled");
  test::click(enabled, QPointF(8, enabled.height() / 2.0));
  EXPECT_FALSE(editor.list().constraints[1].isEnabled);
  EXPECT_FALSE(editor.list().constraints[4].isEnabled);
}

TEST_F(InspectorPanelOfSheet, TellsTheOutcome)
{
  editor.selectConstraints({1});
  EXPECT_EQ(find<QLabel>("outcomeStatus").text(), "met");
  const double limit = *editor.outcome(editor.list().constraints[1].name, 1)->limit;
  EXPECT_EQ(find<QLabel>("outcomeResidual").text(), metText(limit, "mm"));
  EXPECT_EQ(find<QLabel>("outcomeResidual").toolTip(), "0") << "all digits";
  EXPECT_FALSE(find<QLabel>("outcomeAge").isVisible());
  editor.edit("delete", {"mm", {editor.list().constraints[0], editor.list().constraints[1]}});
  EXPECT_TRUE(find<QLabel>("outcomeAge").isVisible());
}

TEST_F(InspectorPanelOfSheet, ATakenNameIsRefusedWithTheReason)
{
  editor.selectConstraints({1});
  typeInto("inspectorName", "P2");
  EXPECT_EQ(editor.list().constraints[1].name, "P1");
  EXPECT_NE(refusal(), "");
  EXPECT_EQ(find("inspectorName").text(), "P1");
}

TEST_F(InspectorPanelOfSheet, TabGoesFromTopToBottomAndEachFieldHasAName)
{
  ConstraintList list = editor.list();
  HandleConstraint tip = what<HandleConstraint>(4);
  tip.rotations.assign(3, {});
  list.constraints.push_back({"vertex by vertex", true, tip});
  tip.motion = FrameMotion{{Vector3(1, 1, 1)}, {Vector3(2, 2, 2)}, 0};
  list.constraints.push_back({"by frames", true, tip});
  editor.edit("more", list);
  panel.resize(400, 1600);
  for (const Index k : {1, 2, 3, 4, 5, 6, 7}) {
    SCOPED_TRACE(k);
    editor.selectConstraints({k});
    // Layouts in layouts take a turn of the event loop each.
    for (int turn = 0; turn < 4; ++turn) QApplication::processEvents();
    int fields = 0;
    int lowest = 0;
    for (QWidget* next = panel.nextInFocusChain(); next != &panel; next = next->nextInFocusChain()) {
      if (!next->isVisible() || (next->focusPolicy() & Qt::TabFocus) == 0) continue;
      const std::string field = next->objectName().toStdString();
      EXPECT_FALSE(QAccessible::queryAccessibleInterface(next)->text(QAccessible::Name).isEmpty()) << field;
      if (field.empty()) continue;  // what scrolls all the others
      const int middle = next->mapTo(&panel, next->rect().center()).y();
      EXPECT_GE(middle, lowest - 2) << field;
      lowest = middle;
      ++fields;
    }
    EXPECT_GT(fields, 5);
  }
}

TEST_F(InspectorPanelOfSheet, NoTextIsCut)
{
  Mesh mesh = test::grid(10, 10);
  mesh.positions = (1.2345 * mesh.positions).rowwise() + Eigen::RowVector3d(-111.0625, -111.4723, 112.6439);
  ConstraintList list = inspectedList();
  list.constraints[0].what = FixedConstraint{{VertexIds{{0, 11, 22}}}};  // not by its place
  HandleConstraint byFrames;
  byFrames.select.what = InHalfSpace{Vector3(-100, -111, 112), Vector3(1, 1, 0)};
  byFrames.motion = FrameMotion{};
  HandleConstraint vertexByVertex = std::get<HandleConstraint>(list.constraints[4].what);
  vertexByVertex.motion = VertexTargets{{{1, 2, 3}, {4, 5, 7}, {6, 7, 8}}};
  vertexByVertex.rotations.assign(3, {{0, 0, 1}, 12.3456789});
  list.constraints.push_back({"by frames", true, byFrames});
  list.constraints.push_back({"vertex by vertex", true, vertexByVertex});
  ASSERT_TRUE(test::openMesh(editor, std::move(mesh), std::move(list)));
  panel.resize(400, 300);
  for (const Index k : {0, 1, 2, 3, 4, 5, 6, 7, 6, 3, 2, 1, 0}) {
    editor.selectConstraints({k});
    QApplication::processEvents();
    for (const QLabel* const label : panel.findChildren<QLabel*>()) {
      if (!label->isVisible() || !label->wordWrap()) continue;
      const int missing = label->heightForWidth(label->width()) - label->height();
      EXPECT_LT(missing, label->fontMetrics().height() / 4)
          << editor.list().constraints[k].name << ": " << label->text().toStdString();
    }
  }
}

}  // namespace
}  // namespace holdfast

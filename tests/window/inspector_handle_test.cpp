#include <QAbstractItemView>
#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <numeric>

#include <holdfast/numbers/same_bits.h>

#include "inspected_sheet.h"
#include "open_document.h"

namespace holdfast {
namespace {

using enum test::Inspected;

/// Ways to turn, in the order of the box.
enum DependencyGroup { NotAtAll, AboutAnAxis, AboutWhatIsFixed, ByFrames, ByTargets };

class InspectorOfHandles : public test::InspectedSheet {
 protected:
  void SetUp() override
  {
    InspectedSheet::SetUp();
    // Not in the order of their ids, and not on a line.
    HandleConstraint tip = what<HandleConstraint>(kTip);
    tip.select.what = VertexIds{{120, 97, 118, 119}};
    tip.motion = AxisRotation{{1, 2, 2}, 100, Vector3(1, 2, 3)};
    setTip(tip);
    panel.resize(400, 1200);
    editor.selectConstraints({kTip});
  }

  [[nodiscard]] const HandleConstraint& tip() { return what<HandleConstraint>(kTip); }
  [[nodiscard]] const FrameMotion& frames() { return std::get<FrameMotion>(tip().motion); }
  void setTip(const HandleConstraint& tip)
  {
    ConstraintList list = editor.list();
    list.constraints[kTip].what = tip;
    editor.edit("another tip", list);
  }

  /// Returns where the solver puts the surface now.
  [[nodiscard]] Positions solved()
  {
    EXPECT_TRUE(test::waitForCurrent(editor));
    return editor.deformation()->positions;
  }

  [[nodiscard]] QString shown(const char* table, int row, int column)
  {
    return find<QAbstractItemView>(table).model()->index(row, column).data().toString();
  }
  /// F2, the text in the place of what is there, Enter.
  void typeIntoCell(const char* name, int row, int column, const char* text)
  {
    QAbstractItemView& table = find<QAbstractItemView>(name);
    ASSERT_TRUE(table.isVisible()) << name;
    table.setCurrentIndex(table.model()->index(row, column));
    test::pressKey(table, Qt::Key_F2);
    QLineEdit* line = table.viewport()->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr) << "the cell can be edited";
    line->selectAll();
    test::type(*line, text);
    test::pressKey(*line, Qt::Key_Return);
    // The cell takes it with the next turn of the event loop.
    ASSERT_TRUE(test::waitUntil([&] { return table.viewport()->findChild<QLineEdit*>() == nullptr; }));
  }
};

TEST_F(InspectorOfHandles, FromFrameToFrameBeginsWhereTheHandleIs)
{
  for (const DependencyGroup way : {AboutAnAxis, NotAtAll, AboutWhatIsFixed}) {
    choose("handleMethod", way);
    const Positions before = solved();
    choose("handleMethod", ByFrames);
    ASSERT_TRUE(std::holds_alternative<FrameMotion>(tip().motion)) << way;
    EXPECT_LT((solved() - before).cwiseAbs().maxCoeff(), 1e-11) << way;
  }
  EXPECT_EQ(editor.history().undoName(), "rotation of tip: from frame to frame");
  expectKeptInSession();
}

TEST_F(InspectorOfHandles, FramesOfWholeTurnsAreRefused)
{
  typeInto("handleDegrees", "720");
  const auto before = editor.history().state();
  choose("handleMethod", ByFrames);
  EXPECT_NE(refusal().find("whole turns"), std::string::npos) << refusal();
  EXPECT_EQ(editor.history().state(), before);
  EXPECT_EQ(find<QComboBox>("handleMethod").currentIndex(), AboutAnAxis);
}

TEST_F(InspectorOfHandles, NumbersOfFramesAreTypedExactly)
{
  choose("handleMethod", ByFrames);
  const auto before = editor.history().state();
  typeInto("frameFromXX", "0.30000000000000004");
  EXPECT_TRUE(hasSameBits(frames().from.x.x(), 0.1 + 0.2));
  expectOneEntry(before, "set the frames of tip");
  typeInto("frameToYZ", "1e-5");
  EXPECT_EQ(frames().to.y.z(), 1e-5);
  typeInto("frameTurns", "-3");
  EXPECT_EQ(frames().turns, -3);
  choose("frameFromChoice", 1);
  EXPECT_EQ(frames().from.origin, Vector3(9, 9.5, 0)) << "from the centroid on";
  typeInto("frameFromOriginY", "0.1");
  EXPECT_EQ(frames().from.origin, Vector3(9, 0.1, 0));
  typeInto("frameToOriginX", "-7.25");
  EXPECT_EQ(frames().to.origin->x(), -7.25);
  expectKeptInSession();
  choose("frameToChoice", 0);
  EXPECT_FALSE(frames().to.origin);
  EXPECT_FALSE(find("frameToOriginX").isVisible());
  choose("frameToChoice", 1);
  EXPECT_EQ(frames().to.origin, Vector3(9, 0.1, 0)) << "where it is from";
}

TEST_F(InspectorOfHandles, FramesThatAreNoneAreRefusedAndMayBeTypedOn)
{
  HandleConstraint handle = tip();
  handle.motion = FrameMotion{};
  setTip(handle);
  const auto before = editor.history().state();
  typeInto("frameToXX", "0");
  EXPECT_EQ(refusal(), "to x: a direction cannot be zero in x, y and z");
  EXPECT_EQ(editor.history().state(), before);
  typeInto("frameToXY", "2");
  EXPECT_NE(refusal().find("to y: it is parallel to \"x\""), std::string::npos) << refusal();
  EXPECT_EQ(editor.history().state(), before) << "nothing by half";
  EXPECT_EQ(find("frameToXY").text(), "2");
  typeInto("frameToYX", "-1");
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(frames().to.x, Vector3(0, 2, 0));
  EXPECT_EQ(frames().to.y, Vector3(-1, 1, 0));
  expectOneEntry(before, "set the frames of tip");
}

TEST_F(InspectorOfHandles, WholeTurnsAreWholeAndNeedAnAxis)
{
  HandleConstraint handle = tip();
  handle.motion = FrameMotion{};
  setTip(handle);
  const auto before = editor.history().state();
  typeInto("frameTurns", "1");
  EXPECT_NE(refusal().find("no axis to turn about"), std::string::npos) << refusal();
  typeInto("frameTurns", "0.5");
  EXPECT_NE(refusal().find("no whole number"), std::string::npos) << refusal();
  EXPECT_EQ(find("frameTurns").text(), "0");
  EXPECT_EQ(editor.history().state(), before);
}

TEST_F(InspectorOfHandles, FramesOfSeveralHandlesKeepWhatDiffers)
{
  ConstraintList list = editor.list();
  HandleConstraint first = tip();
  first.motion = FrameMotion{{{}, {1, 0, 0}, {0, 1, 0}}, {{}, {0, 0, 1}, {0, 1, 0}}, 0};
  HandleConstraint second = first;
  std::get<FrameMotion>(second.motion).from.x = {2, 0, 0.5};
  second.select.what = VertexIds{{30, 31}};
  list.constraints[kTip].what = first;
  list.constraints.push_back({"other", true, second});
  editor.edit("two", list);
  editor.selectConstraints({kTip, 6});
  EXPECT_EQ(find("frameFromXX").text(), "") << "several";
  typeInto("frameFromYZ", "0.25");
  const auto& other = std::get<FrameMotion>(what<HandleConstraint>(6).motion);
  EXPECT_EQ(frames().from.y, Vector3(0, 1, 0.25));
  EXPECT_EQ(other.from.y, Vector3(0, 1, 0.25));
  EXPECT_EQ(other.from.x, Vector3(2, 0, 0.5));
}

TEST_F(InspectorOfHandles, EachVertexTakesARotationOfItsOwn)
{
  EXPECT_FALSE(find<QWidget>("vertexRotations").isVisible());
  const auto before = editor.history().state();
  press("vertexRotationsSwitch");
  ASSERT_EQ(tip().rotations.size(), 4U);
  EXPECT_EQ(tip().rotations[1].axis, Vector3(1, 2, 2)) << "that of the motion";
  EXPECT_EQ(tip().rotations[1].degrees, 100);
  expectOneEntry(before, "give each vertex of tip its own rotation");
  EXPECT_EQ(shown("vertexRotations", 1, 0), "97");
  typeIntoCell("vertexRotations", 1, 4, "0.30000000000000004");
  EXPECT_TRUE(hasSameBits(tip().rotations[1].degrees, 0.1 + 0.2));
  EXPECT_EQ(tip().rotations[0].degrees, 100);
  EXPECT_EQ(editor.history().undoName(), "rotate vertex 97 of tip otherwise");
  typeIntoCell("vertexRotations", 3, 1, "-7");
  EXPECT_EQ(tip().rotations[3].axis, Vector3(-7, 2, 2));
  expectKeptInSession();
  editor.undo();
  EXPECT_EQ(shown("vertexRotations", 3, 1), "1");
  press("vertexRotationsSwitch");
  EXPECT_TRUE(tip().rotations.empty());
  EXPECT_FALSE(find<QWidget>("vertexRotations").isVisible());
}

TEST_F(InspectorOfHandles, CellsRefuseWhatIsNoNumberAndWhatIsNoAxis)
{
  HandleConstraint handle = tip();
  handle.rotations.assign(4, {{0, 0, 1}, 30});
  setTip(handle);
  const auto before = editor.history().state();
  typeIntoCell("vertexRotations", 2, 4, "thirty");
  EXPECT_NE(refusal().find("no number"), std::string::npos) << refusal();
  typeIntoCell("vertexRotations", 2, 3, "0");
  EXPECT_NE(refusal().find("axis cannot be zero"), std::string::npos) << refusal();
  typeIntoCell("vertexRotations", 2, 3, "1");
  EXPECT_EQ(editor.history().state(), before) << "what is there already is no edit";
  EXPECT_EQ(find<QAbstractItemView>("vertexRotations").model()->index(2, 0).flags() & Qt::ItemIsEditable, 0);
}

TEST_F(InspectorOfHandles, EachVertexTakesATargetOfItsOwn)
{
  const Positions before = solved();
  press("vertexTargetsSwitch");
  ASSERT_TRUE(std::holds_alternative<VertexTargets>(tip().motion));
  EXPECT_EQ(editor.history().undoName(), "give each vertex of tip its own target");
  EXPECT_LT((solved() - before).cwiseAbs().maxCoeff(), 1e-11) << "from where it is";
  EXPECT_EQ(find<QComboBox>("handleMethod").currentIndex(), ByTargets);
  typeIntoCell("vertexTargets", 1, 3, "0.30000000000000004");
  EXPECT_TRUE(hasSameBits(std::get<VertexTargets>(tip().motion).places[1].z(), 0.1 + 0.2));
  EXPECT_EQ(editor.history().undoName(), "move vertex 97 of tip to z = 0.30000000000000004");
  const Positions moved = solved();
  EXPECT_EQ(moved(97, 2), 0.1 + 0.2) << "exactly";
  expectKeptInSession();
  press("vertexTargetsSwitch");
  EXPECT_TRUE(std::holds_alternative<FrameMotion>(tip().motion));
  EXPECT_EQ(editor.history().undoName(), "take one motion for all vertices of tip");
}

TEST_F(InspectorOfHandles, OthersSayWhyTheirVerticesHaveNothingOfTheirOwn)
{
  HandleConstraint handle = tip();
  handle.select.what = InHalfSpace{{9.5, 0, 0}, {1, 0, 0}};
  setTip(handle);
  EXPECT_NE(find<QLabel>("singleVerticesReason").text().toStdString().find("half space"), std::string::npos);
  EXPECT_TRUE(find<QLabel>("singleVerticesReason").isVisible());
  EXPECT_FALSE(find<QWidget>("vertexRotationsSwitch").isVisible());
  const auto before = editor.history().state();
  choose("handleMethod", ByTargets);
  EXPECT_NE(refusal(), "");
  EXPECT_EQ(editor.history().state(), before);
  handle.select.what = VertexIds{{5, 6, 5}};
  setTip(handle);
  EXPECT_NE(find<QLabel>("singleVerticesReason").text().toStdString().find("vertex 5 is in this list already"),
            std::string::npos);
}

TEST_F(InspectorOfHandles, ManyVerticesMakeNoMoreWidgetsThanFew)
{
  HandleConstraint handle = tip();
  handle.rotations.assign(4, {});
  setTip(handle);
  QApplication::processEvents();
  const int few = panel.findChildren<QWidget*>().size();
  const int height = find<QWidget>("vertexRotations").height();
  std::vector<Index> ids(121);
  std::iota(ids.begin(), ids.end(), Index{0});
  handle.select.what = VertexIds{ids};
  handle.rotations.assign(ids.size(), {});
  setTip(handle);
  QApplication::processEvents();
  EXPECT_EQ(find<QAbstractItemView>("vertexRotations").model()->rowCount(), 121);
  EXPECT_EQ(panel.findChildren<QWidget*>().size(), few);
  EXPECT_LT(find<QWidget>("vertexRotations").height(), 2 * height);
}

}  // namespace
}  // namespace holdfast

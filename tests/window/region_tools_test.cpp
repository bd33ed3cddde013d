#include <QLabel>
#include <algorithm>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "gestures.h"
#include "open_window.h"
#include "support/plain_curve.h"
#include "support/plain_mesh.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

/// The head from the front.
class RegionsOfHead : public test::OpenWindow {
 protected:
  void SetUp() override
  {
    OpenWindow::SetUp();
    open("head.ply");
    trigger("viewFront");
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] Vector3 placeOf(Index vertex) { return editor().positions().row(vertex).transpose(); }

  /// Draws on the screen, and waits for what is found there: on large meshes that takes several turns of the event
  /// loop.
  void select(const std::vector<QPointF>& way, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    editor().selectVertices({});
    test::drag(viewport(), way, Qt::LeftButton, modifiers);
    ASSERT_TRUE(test::waitUntil([&] { return !editor().selectedVertices().empty(); }));
  }

  [[nodiscard]] Index nearestVertex(const Vector3& place)
  {
    Index nearest = 0;
    (editor().positions().rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return nearest;
  }
};

TEST_F(RegionsOfHead, ACurveAroundAnEyeSelectsWhatIsInsideIt)
{
  const std::vector<Vector3> around{{41, -76, 25}, {27, -76, 39}, {13, -76, 25}, {27, -76, 11}};
  trigger("toolCurve");
  nlohmann::json curve;
  for (const Vector3& place : around) {
    const Index vertex = nearestVertex(place);
    test::click(viewport(), shownAt(placeOf(vertex)));
    const Vector3 exact = placeOf(vertex);
    curve["through"].push_back({{"near", {exact.x(), exact.y(), exact.z()}}});
  }
  test::pressKey(viewport(), Qt::Key_Return);

  const std::set<long> expected = test::insidePlain(curve, test::readPlainMesh(test::dataFolder() + "/head.ply"));
  const auto& selected = editor().selectedVertices();
  EXPECT_GT(selected.size(), 10u);
  EXPECT_EQ(std::set<long>(selected.begin(), selected.end()), expected);
}

TEST_F(RegionsOfHead, ARigidFeatureOfACurveKeepsTheCurve)
{
  trigger("toolCurve");
  for (const Vector3& place : {Vector3(41, -76, 25), Vector3(27, -76, 39), Vector3(13, -76, 25), Vector3(27, -76, 11)})
    test::click(viewport(), shownAt(placeOf(nearestVertex(place))));
  test::pressKey(viewport(), Qt::Key_Return);
  trigger("makeRigid");
  ASSERT_EQ(list().constraints.size(), 1u);
  const auto& rigid = std::get<RigidConstraint>(list().constraints.front().what);
  ASSERT_TRUE(std::holds_alternative<InsideCurve>(rigid.select.what));
  EXPECT_EQ(std::get<InsideCurve>(rigid.select.what).through.size(), 4u);
  EXPECT_TRUE(editor().selectedVertices().empty());
  EXPECT_EQ(editor().selectedConstraints(), (std::vector<Index>{0}));
}

TEST_F(RegionsOfHead, ACurveLeavesWhatIsHiddenInsideIt)
{
  const auto drawAroundEye = [this] {
    trigger("toolCurve");
    for (const Vector3& place :
         {Vector3(41, -76, 25), Vector3(27, -76, 39), Vector3(13, -76, 25), Vector3(27, -76, 11)})
      test::click(viewport(), shownAt(placeOf(nearestVertex(place))));
    test::pressKey(viewport(), Qt::Key_Return);
  };
  drawAroundEye();
  const std::vector<Index> inside = editor().selectedVertices();
  trigger("shrink");
  trigger("shrink");
  trigger("hideSelection");
  ASSERT_TRUE(settle());

  drawAroundEye();
  const std::vector<Index> shown = editor().selectedVertices();
  EXPECT_EQ(shown, viewport().shownAmong(inside));
  ASSERT_LT(shown.size(), inside.size());
  ASSERT_FALSE(shown.empty());
  trigger("makeRigid");
  const auto& rigid = std::get<RigidConstraint>(list().constraints.front().what);
  ASSERT_TRUE(std::holds_alternative<VertexIds>(rigid.select.what)) << "the curve would enclose what is hidden, too";
  EXPECT_EQ(std::get<VertexIds>(rigid.select.what).ids, shown);
}

TEST_F(RegionsOfHead, ARectangleSelectsWhatIsSeenInIt)
{
  trigger("toolRectangle");
  const QPointF a = shownAt({10, -76, 10});
  const QPointF b = shownAt({45, -76, 42});
  select({a, (a + b) / 2, b});
  const QRectF box = QRectF(a, b).normalized();
  const auto selected = editor().selectedVertices();
  EXPECT_GT(selected.size(), 20u);
  for (const Index vertex : selected) {
    EXPECT_TRUE(box.adjusted(-1, -1, 1, 1).contains(shownAt(placeOf(vertex))));
    EXPECT_LT(placeOf(vertex).y(), 0) << "the back of the head is hidden";
  }
  // With Alt what is hidden counts as well.
  select({a, (a + b) / 2, b}, Qt::AltModifier);
  EXPECT_GT(editor().selectedVertices().size(), selected.size());
  EXPECT_TRUE(std::includes(editor().selectedVertices().begin(), editor().selectedVertices().end(), selected.begin(),
                            selected.end()));
}

TEST_F(RegionsOfHead, TheSwitchReachesThroughAsAltDoes)
{
  trigger("toolRectangle");
  const QPointF a = shownAt({10, -76, 10});
  const QPointF b = shownAt({45, -76, 42});
  select({a, b}, Qt::AltModifier);
  const auto through = editor().selectedVertices();
  trigger("reachThrough");
  select({a, b});
  EXPECT_EQ(editor().selectedVertices(), through);
  trigger("reachThrough");
  select({a, b});
  EXPECT_LT(editor().selectedVertices().size(), through.size());
}

TEST_F(RegionsOfHead, TheStatusLineTellsTheSizeOfTheSelection)
{
  const auto label = [this](const char* name) { return window.findChild<QLabel*>(name); };
  EXPECT_TRUE(label("statusNumbers")->isVisible());
  window.resize(1024, 700);
  ASSERT_TRUE(settle());
  trigger("invert");
  ASSERT_TRUE(test::waitUntil([&] { return label("statusSelection")->text().contains("24\u202f838 triangles"); }))
      << label("statusSelection")->text().toStdString();
  EXPECT_TRUE(label("statusSelection")->text().startsWith("12\u202f421 vertices"));
  EXPECT_TRUE(label("statusSelection")->isVisible());
  EXPECT_FALSE(label("statusNumbers")->isVisible());
  ASSERT_TRUE(settle());
  EXPECT_EQ(window.width(), 1024) << "no text makes the window wider";
  editor().selectVertices({0});
  EXPECT_TRUE(test::waitUntil([&] { return label("statusSelection")->text().startsWith("1 vertex "); }));
  trigger("escape");
  EXPECT_FALSE(label("statusSelection")->isVisible());
  EXPECT_TRUE(label("statusNumbers")->toolTip().contains("ms decomposition"));
}

TEST_F(RegionsOfHead, ALassoSelectsAsTheRectangleOfTheSameOutline)
{
  const QPointF a = shownAt({10, -76, 10});
  const QPointF b = shownAt({45, -76, 42});
  trigger("toolRectangle");
  select({a, b});
  const auto byRectangle = editor().selectedVertices();
  trigger("toolLasso");
  select({a, {b.x(), a.y()}, b, {a.x(), b.y()}, a});
  EXPECT_EQ(editor().selectedVertices(), byRectangle);
}

TEST_F(RegionsOfHead, TheBrushPaintsAddsAndTakesAway)
{
  trigger("toolBrush");
  const QPointF eye = shownAt({27, -84, 25});
  test::drag(viewport(), {eye, eye + QPointF(20, 0), eye + QPointF(40, 0)});
  const auto painted = editor().selectedVertices();
  ASSERT_GT(painted.size(), 5u);
  const QPointF chin = shownAt({0, -84, -50});
  test::drag(viewport(), {chin, chin + QPointF(10, 0)}, Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_GT(editor().selectedVertices().size(), painted.size());
  test::drag(viewport(), {chin, chin + QPointF(10, 0)}, Qt::LeftButton, Qt::ControlModifier);
  EXPECT_EQ(editor().selectedVertices(), painted);
}

TEST_F(RegionsOfHead, EscapeDuringAStrokeBringsTheSelectionBack)
{
  editor().selectVertices({1, 2, 3});
  trigger("toolBrush");
  const QPointF eye = shownAt({27, -84, 25});
  test::pressMouse(viewport(), eye);
  test::moveMouse(viewport(), eye + QPointF(20, 0), Qt::LeftButton);
  EXPECT_NE(editor().selectedVertices(), (std::vector<Index>{1, 2, 3}));
  trigger("escape");
  EXPECT_EQ(editor().selectedVertices(), (std::vector<Index>{1, 2, 3}));
}

TEST_F(RegionsOfHead, GrowThenShrinkInsideTheSurfaceIsNothing)
{
  trigger("toolBrush");
  const QPointF eye = shownAt({27, -84, 25});
  test::drag(viewport(), {eye, eye + QPointF(15, 0)});
  const auto painted = editor().selectedVertices();
  trigger("grow");
  EXPECT_GT(editor().selectedVertices().size(), painted.size());
  trigger("shrink");
  EXPECT_TRUE(std::includes(editor().selectedVertices().begin(), editor().selectedVertices().end(), painted.begin(),
                            painted.end()));
  trigger("invert");
  trigger("invert");
  EXPECT_TRUE(std::includes(editor().selectedVertices().begin(), editor().selectedVertices().end(), painted.begin(),
                            painted.end()));
}

TEST_F(RegionsOfHead, BracketsSayHowMuchASideMayBend)
{
  trigger("toolFlood");
  const auto sideAfter = [this](Qt::Key key, int times) {
    for (int k = 0; k < times; ++k) test::pressKey(viewport(), key);
    test::click(viewport(), shownAt({27, -84, 25}));
    return editor().selectedVertices();
  };
  const auto usual = sideAfter(Qt::Key_BracketLeft, 0);
  EXPECT_LT(sideAfter(Qt::Key_BracketLeft, 3).size(), usual.size());
  EXPECT_EQ(sideAfter(Qt::Key_BracketRight, 3), usual);
}

TEST_F(RegionsOfHead, ADoubleClickSelectsTheWholePart)
{
  trigger("toolFlood");
  const QPointF eye = shownAt({27, -84, 25});
  test::doubleClick(viewport(), eye);
  EXPECT_EQ(static_cast<Index>(editor().selectedVertices().size()), editor().model()->mesh.vertexCount());
}

TEST_F(RegionsOfHead, OneKeyEachMakesConstraintsOfTheSelection)
{
  editor().selectVertices({1, 2, 3});
  trigger("makeFixed");
  editor().selectVertices({100, 101});
  trigger("makeHandle");
  editor().selectVertices({200, 201, 202});
  trigger("makeRigid");
  ASSERT_EQ(list().constraints.size(), 3u);
  EXPECT_STREQ(typeName(list().constraints[0]), "fixed");
  EXPECT_STREQ(typeName(list().constraints[1]), "handle");
  EXPECT_STREQ(typeName(list().constraints[2]), "rigid");
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().deformation()->report.solve.status, SolveStatus::Ok);
  trigger("deleteConstraints");
  EXPECT_EQ(list().constraints.size(), 2u) << "the newest is selected";
}

TEST_F(RegionsOfHead, ThePlaneAndWholePartsSelect)
{
  trigger("besidePlane");
  EXPECT_TRUE(editor().selectedVertices().empty()) << "first the plane is placed";
  ASSERT_TRUE(viewport().section());
  trigger("besidePlane");
  const SectionPlane plane = *viewport().section();
  const auto& selected = editor().selectedVertices();
  EXPECT_GT(selected.size(), 1000u);
  for (Index v = 0; v < editor().model()->mesh.vertexCount(); ++v)
    EXPECT_EQ(std::ranges::binary_search(selected, v), (placeOf(v) - plane.origin).dot(plane.normal) >= 0) << v;
  trigger("wholeParts");
  EXPECT_EQ(static_cast<Index>(editor().selectedVertices().size()), editor().model()->mesh.vertexCount());
  trigger("sectionPlane");
}

TEST_F(RegionsOfHead, AMirroredCopyIsOneEditAndSelected)
{
  const Index ear = nearestVertex({60, 0, 0});
  editor().selectVertices({ear});
  for (int k = 0; k < 4; ++k) trigger("grow");
  trigger("makeFixed");
  trigger("mirrorX");
  ASSERT_EQ(list().constraints.size(), 2u);
  EXPECT_EQ(editor().selectedConstraints(), (std::vector<Index>{1}));
  const auto& copy = std::get<FixedConstraint>(list().constraints[1].what).select;
  for (const Index v : std::get<VertexIds>(copy.what).ids) EXPECT_LT(placeOf(v).x(), 0);
  trigger("undo");
  EXPECT_EQ(list().constraints.size(), 1u);
}

}  // namespace
}  // namespace holdfast

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "gestures.h"
#include "open_window.h"

namespace holdfast {
namespace {

using test::PlainSight;
using test::plainSight;

/// The bracket from the front and above, without constraints, with the tool that holds points.
class PointToolOnBracket : public test::OpenWindow {
 protected:
  void SetUp() override
  {
    OpenWindow::SetUp();
    open("bracket.obj");
    view.eye = {60, 130, 420};
    view.target = {0, 0, 20};
    look(view);
    trigger("toolPoint");
  }

  [[nodiscard]] const Model& model() { return *editor().model(); }

  /// What is seen at the middle of the pixel that holds `screen`, found by looking at every triangle.
  [[nodiscard]] PlainSight seenAt(const Eigen::Vector2d& screen)
  {
    const Eigen::Vector2d middle(std::floor(screen.x()) + 0.5, std::floor(screen.y()) + 0.5);
    return plainSight(view, middle, model().mesh.positions, model().triangulation.triangles);
  }

  /// The middle of the largest triangle that is seen there, in pixels.
  [[nodiscard]] Index largestSeenTriangle()
  {
    Index best = -1;
    double largest = 0;
    for (Index t = 0; t < static_cast<Index>(model().triangulation.triangles.size()); ++t) {
      const double area = screenArea(t);
      if (area <= largest || seenAt(middleOf(t)).triangle != t) continue;
      best = t;
      largest = area;
    }
    return best;
  }

  [[nodiscard]] Eigen::Vector2d cornerOf(Index triangle, int corner)
  {
    const Index vertex = model().triangulation.triangles[triangle][corner];
    return view.shown(model().mesh.positions.row(vertex).transpose()).head<2>();
  }

  [[nodiscard]] Eigen::Vector2d middleOf(Index triangle)
  {
    return (cornerOf(triangle, 0) + cornerOf(triangle, 1) + cornerOf(triangle, 2)) / 3;
  }

  [[nodiscard]] double screenArea(Index triangle)
  {
    const Eigen::Vector2d a = cornerOf(triangle, 1) - cornerOf(triangle, 0);
    const Eigen::Vector2d b = cornerOf(triangle, 2) - cornerOf(triangle, 0);
    return std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
  }

  void clickAt(const Eigen::Vector2d& screen) { test::click(viewport(), inWidget(screen)); }

  /// One constraint, at a point of a face.
  void expectHeld(const PlainSight& sight)
  {
    ASSERT_EQ(list().constraints.size(), 1u);
    const auto* at = std::get_if<AtFace>(&lastPoint().at);
    ASSERT_NE(at, nullptr);
    EXPECT_EQ(at->face, model().triangulation.faceOf[sight.triangle]);
    ASSERT_EQ(at->weights.size(), 3u);
    for (int corner = 0; corner < 3; ++corner) {
      const Index cornerOfFace = model().triangulation.cornersOf(sight.triangle)[corner];
      EXPECT_NEAR(at->weights[cornerOfFace], sight.weights[corner], 1e-9);
    }
  }

  [[nodiscard]] const PointConstraint& lastPoint() { return std::get<PointConstraint>(list().constraints.back().what); }

  test::PlainView view;
};

TEST_F(PointToolOnBracket, AClickInAFaceHoldsThatPointWithItsWeights)
{
  test::pressKey(viewport(), Qt::Key_F);
  const Index triangle = largestSeenTriangle();
  ASSERT_GE(triangle, 0);
  clickAt(middleOf(triangle));
  expectHeld(seenAt(middleOf(triangle)));
}

/// The cursor of most mice is at whole numbers, the upper left of a pixel.
TEST_F(PointToolOnBracket, AClickAtTheUpperLeftOfAPixelHoldsWhatItsMiddleShows)
{
  test::pressKey(viewport(), Qt::Key_F);
  const Index triangle = largestSeenTriangle();
  ASSERT_GE(triangle, 0);
  test::click(viewport(), inWidget(middleOf(triangle)) - QPointF(0.5, 0.5));
  expectHeld(seenAt(middleOf(triangle)));
}

TEST_F(PointToolOnBracket, AClickNearAVertexHoldsTheVertex)
{
  const Index triangle = largestSeenTriangle();
  const Index vertex = model().triangulation.triangles[triangle][0];
  // A little towards the middle: the face is under the cursor, the vertex within reach.
  const Eigen::Vector2d corner = cornerOf(triangle, 0);
  clickAt(corner + 2.5 * (middleOf(triangle) - corner).normalized());

  ASSERT_EQ(list().constraints.size(), 1u);
  const auto* at = std::get_if<AtVertex>(&lastPoint().at);
  ASSERT_NE(at, nullptr);
  EXPECT_EQ(at->vertex, vertex);
  EXPECT_EQ(std::get<Target>(lastPoint().to).place, Vector3(editor().positions().row(vertex)));
}

TEST_F(PointToolOnBracket, AClickNearAnEdgeHoldsThePointOfTheEdge)
{
  const Index triangle = largestSeenTriangle();
  const Eigen::Vector2d from = cornerOf(triangle, 0);
  const Eigen::Vector2d to = cornerOf(triangle, 1);
  const Eigen::Vector2d middle = from + 0.4 * (to - from);
  test::pressKey(viewport(), Qt::Key_E);
  clickAt(middle + 1.5 * (middleOf(triangle) - middle).normalized());

  ASSERT_EQ(list().constraints.size(), 1u);
  const auto* at = std::get_if<AtEdge>(&lastPoint().at);
  ASSERT_NE(at, nullptr);
  const auto& corners = model().triangulation.triangles[triangle];
  EXPECT_EQ(at->i, std::min(corners[0], corners[1]));
  EXPECT_EQ(at->j, std::max(corners[0], corners[1]));
  // p = t p_i + (1 - t) p_j; a pixel and the foreshortening along the edge decide the rest.
  const double share = corners[0] < corners[1] ? 0.6 : 0.4;
  EXPECT_NEAR(at->t, share, 3 / (to - from).norm());
}

TEST_F(PointToolOnBracket, WhatAClickWouldTakeIsToldBefore)
{
  test::pressKey(viewport(), Qt::Key_V);
  const Index triangle = largestSeenTriangle();
  test::moveMouse(viewport(), inWidget(cornerOf(triangle, 0)));
  const Index vertex = model().triangulation.triangles[triangle][0];
  const auto& pick = editor().underCursor().pick;
  ASSERT_TRUE(pick);
  EXPECT_EQ(std::get<AtVertex>(pick->location).vertex, vertex);
  const auto* label = window.findChild<QLabel*>("statusHint");
  ASSERT_NE(label, nullptr);
  EXPECT_FALSE(label->toolTip().contains(QString::number(vertex))) << "the corner of the picture says it, once";
  EXPECT_TRUE(list().constraints.empty());
}

TEST_F(PointToolOnBracket, AClickBesideTheSurfaceHoldsNothing)
{
  clickAt({5, 5});
  EXPECT_TRUE(list().constraints.empty());
}

TEST_F(PointToolOnBracket, ADragTurnsThePictureAndHoldsNothing)
{
  const QPointF from = inWidget(middleOf(largestSeenTriangle()));
  test::drag(viewport(), {from, from + QPointF(30, 0), from + QPointF(60, 10)});
  EXPECT_TRUE(list().constraints.empty());
}

TEST_F(PointToolOnBracket, ItsKeysComeBeforeThoseOfMenus)
{
  const auto isTaken = [this](Qt::Key key) {
    QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier, test::textOf(key));
    event.ignore();
    QApplication::sendEvent(&viewport(), &event);
    return event.isAccepted();
  };
  for (const Qt::Key key : {Qt::Key_V, Qt::Key_E, Qt::Key_F, Qt::Key_A}) EXPECT_TRUE(isTaken(key));
  EXPECT_FALSE(isTaken(Qt::Key_H)) << "makes a handle";
  trigger("toolSelect");
  EXPECT_FALSE(isTaken(Qt::Key_E)) << "switches constraints off";
}

TEST_F(PointToolOnBracket, AHeldPointThatIsNotMovedMovesNothing)
{
  clickAt(middleOf(largestSeenTriangle()));
  ASSERT_TRUE(settle());
  const double moved = (editor().positions() - model().mesh.positions).cwiseAbs().maxCoeff();
  EXPECT_LE(moved, 1e-12 * model().solverMesh.diagonal);
}

}  // namespace
}  // namespace holdfast

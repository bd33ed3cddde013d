#include <QAction>
#include <QFontMetricsF>
#include <QImage>
#include <QLineF>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkAxisActor2D.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerWidget.h>
#include <holdfast/window/tools/tools.h>
#include <holdfast/window/viewport/viewport_overlay.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// The bracket, with a point of it to drag, and the ruler.
class RulerInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    viewport().setFocus();
    key(Qt::Key_D);
    ASSERT_TRUE(find<QAction>("toolRuler").isChecked());
  }

  [[nodiscard]] vtkHoldfastSurfaceRulerWidget& ruler()
  {
    return static_cast<ToolOf<vtkHoldfastSurfaceRulerWidget>*>(window.findChild<Tool*>("rulerTool"))->widget();
  }

  /// What is drawn.
  [[nodiscard]] std::string label()
  {
    vtkHoldfastSurfaceRulerRepresentation& shown = *ruler().GetRulerRepresentation();
    return shown.GetVisibility() != 0 && ruler().GetEnabled() != 0 ? shown.GetAxis()->GetTitle() : "";
  }
  /// What is written over the picture, and where.
  [[nodiscard]] const ViewportOverlay::RulerLabels& written() { return find<ViewportOverlay>("overlay").rulerLabels(); }
  /// How many pixels the window paints over the picture there, and how much the picture below has changed from
  /// `before`.
  [[nodiscard]] std::pair<int, int> paintedAndDrawn(const QRectF& place, const QImage& before)
  {
    auto& overlay = find<QWidget>("overlay");
    QImage painted(overlay.size(), QImage::Format_ARGB32_Premultiplied);
    painted.fill(Qt::transparent);
    overlay.render(&painted, QPoint(), QRegion(), {});
    const QImage drawn = viewport().grabFramebuffer();
    std::pair<int, int> count;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x) {
        if (!place.contains(QPointF(x, y))) continue;
        count.first += qAlpha(painted.pixel(x, y)) != 0 ? 1 : 0;
        count.second += drawn.pixel(x, y) != before.pixel(x, y) ? 1 : 0;
      }
    return count;
  }

  [[nodiscard]] static double distance(const Positions& positions, Index a, Index b)
  {
    return (positions.row(a) - positions.row(b)).norm();
  }

  [[nodiscard]] std::string expectedLabel(Index a, Index b)
  {
    return fmt::format("{:.4g} mm (rest {:.4g})", distance(editor().positions(), a, b),
                       distance(editor().model()->mesh.positions, a, b));
  }

  void measure(Index a, Index b)
  {
    test::click(viewport(), seenAt(a) + QPointF(1, -1));
    test::click(viewport(), seenAt(b) + QPointF(-1, 1));
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] bool isAt(int end, Index vertex)
  {
    const auto location = ruler().GetLocation(end);
    const auto* at = location ? std::get_if<AtVertex>(&*location) : nullptr;
    return at != nullptr && at->vertex == vertex;
  }

  /// Two vertices that are seen: one anywhere, and the one that is nearest to the point that is dragged.
  [[nodiscard]] std::pair<Index, Index> twoVertices()
  {
    const Index a = freeVertex();
    Index b = a;
    const Positions& positions = editor().positions();
    const PointConstraint& point = std::get<PointConstraint>(list().constraints[*indexOf(list(), "flange east")].what);
    const Vector3 dragged = std::get<Target>(point.to).place;
    const auto toDragged = [&](Index v) { return (positions.row(v).transpose() - dragged).norm(); };
    for (Index v = 0; v < positions.rows(); ++v) {
      const DisplayPoint pixel = toDisplay(viewport().renderer(), positions.row(v).transpose()).head<2>();
      const auto pick =
          SurfacePicker(viewport().surface()).pick(viewport().renderer(), pixel.x(), pixel.y(), PickKind::Vertex, 4);
      const auto* at = pick ? std::get_if<AtVertex>(&pick->location) : nullptr;
      if (at != nullptr && at->vertex == v && toDragged(v) < toDragged(b)) b = v;
    }
    return {a, b};
  }
};

TEST_F(RulerInWindow, MeasuresBetweenTheVerticesNearTwoClicks)
{
  const auto deformation = editor().deformation();
  const auto [a, b] = twoVertices();
  measure(a, b);
  EXPECT_TRUE(isAt(0, a));
  EXPECT_TRUE(isAt(1, b));
  EXPECT_DOUBLE_EQ(ruler().GetDistance(), distance(editor().positions(), a, b));
  EXPECT_EQ(label(), expectedLabel(a, b));
  EXPECT_EQ(editor().history().undoName(), "ruler 1");
  EXPECT_EQ(editor().deformation(), deformation) << "nothing is solved for it";
  EXPECT_TRUE(editor().isCurrent());
}

TEST_F(RulerInWindow, TheWindowWritesItsLabelInItsOwnFont)
{
  const auto [a, b] = twoVertices();
  ASSERT_TRUE(settle());
  const QImage before = viewport().grabFramebuffer();
  measure(a, b);
  ASSERT_EQ(written().size(), 1U);
  const auto [place, text] = written().front();
  EXPECT_EQ(text.toStdString(), expectedLabel(a, b));
  EXPECT_EQ(place.size(), QFontMetricsF(viewport().font()).boundingRect(viewport().rect(), Qt::AlignLeft, text).size());
  const QPointF middle = (seenAt(a) + seenAt(b)) / 2;
  EXPECT_LT(QLineF(place.center(), middle).length(), place.width());
  const auto [painted, drawn] = paintedAndDrawn(place, before);
  EXPECT_GT(painted, 500);
  EXPECT_EQ(drawn, 0) << "VTK writes nothing, and the line is beside it";
  key(Qt::Key_S);
  ASSERT_TRUE(settle());
  EXPECT_EQ(written().size(), 1U) << "it stays with every tool";
  trigger("removeMeasurements");
  ASSERT_TRUE(settle());
  EXPECT_TRUE(written().empty());
  EXPECT_EQ(paintedAndDrawn(place, before).first, 0);
}

TEST_F(RulerInWindow, ItsLabelFollowsTheCamera)
{
  const auto [a, b] = twoVertices();
  measure(a, b);
  const QRectF before = written().front().first;
  test::drag(viewport(), {{300, 300}, {320, 330}, {340, 330}}, Qt::MiddleButton);
  ASSERT_TRUE(settle());
  const QPointF moved = written().front().first.center() - before.center();
  EXPECT_NEAR(moved.x(), 40, 3);
  EXPECT_NEAR(moved.y(), 30, 3);
}

TEST_F(RulerInWindow, LeavesThePictureAroundItAsItIs)
{
  const auto [a, b] = twoVertices();
  ASSERT_TRUE(settle());
  const QImage before = viewport().grabFramebuffer();
  measure(a, b);
  const QImage after = viewport().grabFramebuffer();
  ASSERT_EQ(after.size(), before.size());
  int changed = 0;
  for (int y = 0; y < after.height(); ++y)
    for (int x = 0; x < after.width(); ++x) changed += after.pixel(x, y) != before.pixel(x, y) ? 1 : 0;
  EXPECT_GT(changed, 500);
  EXPECT_LT(changed, 20'000);
}

TEST_F(RulerInWindow, SaysTheDistanceNowAndAtRestWhereTheSurfaceHasMoved)
{
  const auto [a, b] = twoVertices();
  measure(a, b);
  const std::string before = label();
  // While a point is dragged by the gizmo.
  const Index point = *indexOf(list(), "flange east");
  editor().selectConstraints({point});
  ASSERT_TRUE(settle());
  const QPointF from = onArrow(2);
  test::drag(viewport(), {from, from + QPointF(0, -30), from + QPointF(0, -60)});
  ASSERT_TRUE(settle());
  ASSERT_NE(distance(editor().positions(), a, b), distance(editor().model()->mesh.positions, a, b));
  EXPECT_NE(label(), before);
  EXPECT_EQ(label(), expectedLabel(a, b));
  trigger("undo");
  ASSERT_TRUE(settle());
  EXPECT_EQ(label(), before);
}

TEST_F(RulerInWindow, EscapeTakesBackTheFirstEndThenTheRulerThenTheTool)
{
  const auto [a, b] = twoVertices();
  test::click(viewport(), seenAt(a));
  ASSERT_TRUE(ruler().GetLocation(0));
  key(Qt::Key_Escape);
  EXPECT_FALSE(ruler().GetLocation(0));
  measure(a, b);
  EXPECT_NE(label(), "");
  key(Qt::Key_Escape);
  EXPECT_EQ(label(), "");
  EXPECT_TRUE(find<QAction>("toolRuler").isChecked());
  key(Qt::Key_Escape);
  EXPECT_TRUE(find<QAction>("toolSelect").isChecked());
}

TEST_F(RulerInWindow, StaysAtItsKeyAndBeginsAnewWithTheTool)
{
  const auto [a, b] = twoVertices();
  measure(a, b);
  const std::string text = label();
  key(Qt::Key_D);
  EXPECT_EQ(label(), text);
  key(Qt::Key_S);
  EXPECT_EQ(label(), "");
  key(Qt::Key_D);
  EXPECT_EQ(label(), "");
  measure(b, a);
  EXPECT_EQ(label(), text);
}

TEST_F(RulerInWindow, DoesNotOutliveItsDocument)
{
  const auto [a, b] = twoVertices();
  measure(a, b);
  open("bar.obj");
  EXPECT_EQ(label(), "");
  EXPECT_FALSE(ruler().GetLocation(0));
  EXPECT_FALSE(ruler().GetLocation(1));
}

}  // namespace
}  // namespace holdfast

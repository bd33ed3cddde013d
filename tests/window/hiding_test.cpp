#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <algorithm>
#include <cstdlib>
#include <numeric>

#include <gtest/gtest.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// The twisted bar, whose foot is fixed and whose top is a handle, from the front.
class HidingInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bar.obj", "bar.twist_90.constraints.json");
    trigger("viewFront");
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] const std::vector<Triangle>& triangles() { return editor().model()->triangulation.triangles; }

  /// Chooses the tool by its key, and clicks the top of the bar, which looks to the eye from above.
  void selectTop()
  {
    trigger("viewTop");
    ASSERT_TRUE(settle());
    keys("w");
    test::click(viewport(), shownAt(top()));
    ASSERT_TRUE(test::waitUntil([this] { return !editor().selectedVertices().empty(); }));
  }

  [[nodiscard]] Vector3 top()
  {
    Index triangle = 0;
    double highest = -1e300;
    for (std::size_t t = 0; t < triangles().size(); ++t) {
      const double height = middleOf(triangles()[t]).z();
      if (height > highest) triangle = static_cast<Index>(t);
      highest = std::max(highest, height);
    }
    return middleOf(triangles()[triangle]);
  }

  [[nodiscard]] Vector3 middleOf(const Triangle& triangle)
  {
    return editor().positions()(triangle, Eigen::all).colwise().mean();
  }

  /// With all corners selected.
  [[nodiscard]] vtkIdType trianglesSelected()
  {
    const auto& selected = editor().selectedVertices();
    return std::ranges::count_if(triangles(), [&](const Triangle& triangle) {
      return std::ranges::all_of(triangle, [&](Index v) { return std::ranges::binary_search(selected, v); });
    });
  }

  [[nodiscard]] vtkIdType trianglesDrawn()
  {
    auto& mapper = *viewport().contents()->mesh().surface().GetMapper();
    return vtkPolyData::SafeDownCast(mapper.GetInputAsDataSet())->GetNumberOfPolys();
  }

  [[nodiscard]] bool isSurfaceUnder(const Vector3& place)
  {
    test::moveMouse(viewport(), shownAt(place) + QPointF(3, 3));
    test::moveMouse(viewport(), shownAt(place));
    return editor().underCursor().pick.has_value();
  }

  [[nodiscard]] static QImage copied()
  {
    return QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_ARGB32);
  }

  /// Of any channel of any pixel. Text that Qt blends differs by up to 2 from one drawing to the next.
  [[nodiscard]] static int largestDifference(const QImage& a, const QImage& b)
  {
    if (a.size() != b.size()) return 255;
    return std::transform_reduce(
        a.constBits(), a.constBits() + a.sizeInBytes(), b.constBits(), 0, [](int x, int y) { return std::max(x, y); },
        [](int x, int y) { return std::abs(x - y); });
  }
};

TEST_F(HidingInWindow, WhatIsHiddenIsNeitherDrawnNorPickedUntilAllIsShown)
{
  const vtkIdType all = trianglesDrawn();
  const Vector3 place = top();
  selectTop();
  const vtkIdType some = trianglesSelected();
  ASSERT_GT(some, 0);
  ASSERT_LT(some, all);
  ASSERT_TRUE(isSurfaceUnder(place));
  EXPECT_EQ(editor().underCursor().pick->place.z(), viewport().surface()->positions().col(2).maxCoeff());
  EXPECT_FALSE(find<QAction>("showHidden").isEnabled());
  const std::size_t marks = viewport().marks().size();

  key(Qt::Key_H, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  EXPECT_EQ(trianglesDrawn(), all - some);
  EXPECT_TRUE(editor().selectedVertices().empty());
  ASSERT_TRUE(isSurfaceUnder(place)) << "the inside of the foot";
  EXPECT_LT(editor().underCursor().pick->place.z(), place.z() - 1);
  EXPECT_LT(viewport().marks().size(), marks) << "those of the handle at the top";
  EXPECT_TRUE(find<QAction>("showHidden").isEnabled());

  key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(settle());
  EXPECT_EQ(trianglesDrawn(), all);
  EXPECT_EQ(viewport().marks().size(), marks);
  EXPECT_FALSE(find<QAction>("showHidden").isEnabled());
  EXPECT_FALSE(editor().history().canUndo()) << "no edit";
}

TEST_F(HidingInWindow, TheIsolatedSelectionIsAllThatIsShown)
{
  selectTop();
  const vtkIdType some = trianglesSelected();
  key(Qt::Key_I, Qt::ShiftModifier);
  ASSERT_TRUE(settle());
  EXPECT_EQ(trianglesDrawn(), some);
  EXPECT_FALSE(editor().selectedVertices().empty());
  // Show all shows what is left from near.
  const QPointF before = shownAt(top());
  key(Qt::Key_Home);
  ASSERT_TRUE(settle());
  const std::vector<Index>& selected = editor().selectedVertices();
  double widest = 0;
  for (const Index v : selected)
    widest = std::max(widest, std::abs(shownAt(editor().positions().row(v)).x() - before.x()));
  EXPECT_GT(widest, 0.2 * viewport().width());
  // A drag of a lasso, through the surface, reaches nothing that is hidden.
  trigger("deselect");
  find<QAction>("reachThrough").setChecked(true);
  keys("m");
  const QPointF corner(viewport().width() - 2.0, viewport().height() - 2.0);
  test::drag(viewport(), {{2, 2}, {100, 100}, corner});
  ASSERT_TRUE(test::waitUntil([this] { return !editor().selectedVertices().empty(); }));
  find<QAction>("reachThrough").setChecked(false);
  EXPECT_EQ(trianglesSelected(), some);
}

TEST_F(HidingInWindow, WhatMakesASelectionLargerLeavesHiddenVertices)
{
  selectTop();
  key(Qt::Key_I, Qt::ShiftModifier);
  ASSERT_TRUE(settle());
  const std::vector<Index> shown = editor().selectedVertices();
  const Index vertex = shown.front();
  ASSERT_LT(shown.size(), static_cast<std::size_t>(editor().model()->mesh.vertexCount()));
  key(Qt::Key_Plus);
  EXPECT_EQ(editor().selectedVertices(), shown) << "a ring around it is hidden";
  editor().selectVertices({vertex});
  key(Qt::Key_L, Qt::ControlModifier);
  EXPECT_EQ(editor().selectedVertices(), shown);
  editor().selectVertices({vertex});
  key(Qt::Key_I);
  EXPECT_EQ(editor().selectedVertices().size(), shown.size() - 1);
  EXPECT_FALSE(std::ranges::binary_search(editor().selectedVertices(), vertex));
  // Twice the same click: the tool, with its double click, takes whole parts.
  trigger("deselect");
  keys("w");
  test::click(viewport(), shownAt(top()));
  test::doubleClick(viewport(), shownAt(top()));
  EXPECT_EQ(editor().selectedVertices(), shown);
  key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
  key(Qt::Key_Plus);
  EXPECT_GT(editor().selectedVertices().size(), shown.size());
}

TEST_F(HidingInWindow, SelectionsWithoutAWholeFaceOrOfAllHideNothing)
{
  editor().selectVertices({0});
  key(Qt::Key_H, Qt::ControlModifier);
  EXPECT_EQ(viewport().hidden(), nullptr);
  EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("Nothing is hidden"));
  key(Qt::Key_I, Qt::ShiftModifier);
  EXPECT_EQ(viewport().hidden(), nullptr);
  trigger("invert");
  editor().selectVertices({});
  trigger("invert");
  key(Qt::Key_H, Qt::ControlModifier);
  EXPECT_EQ(viewport().hidden(), nullptr);
}

TEST_F(HidingInWindow, ThePictureSaysSoAndItsCopyFollows)
{
  const auto note = [this] {
    auto& overlay = find<QWidget>("overlay");
    QImage drawn(200, 40, QImage::Format_ARGB32_Premultiplied);
    drawn.fill(Qt::transparent);
    overlay.render(&drawn, QPoint(), QRegion(0, 0, 200, 40), {});
    return drawn;
  };
  selectTop();
  const QImage none = note();
  key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  const QImage whole = copied();
  trigger("hideSelection");
  ASSERT_TRUE(settle());
  EXPECT_NE(note(), none);
  key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_GT(largestDifference(copied(), whole), 50);
  trigger("showHidden");
  ASSERT_TRUE(settle());
  EXPECT_EQ(note(), none);
  key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_LE(largestDifference(copied(), whole), 3);
}

TEST_F(HidingInWindow, AnotherDocumentIsShownWhole)
{
  selectTop();
  trigger("hideSelection");
  open("bracket.obj");
  EXPECT_EQ(viewport().hidden(), nullptr);
  EXPECT_EQ(trianglesDrawn(), static_cast<vtkIdType>(triangles().size()));
  EXPECT_FALSE(find<QAction>("showHidden").isEnabled());
}

}  // namespace
}  // namespace holdfast

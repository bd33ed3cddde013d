#include <QElapsedTimer>

#include <gtest/gtest.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/window/tools/moved_region.h>
#include <holdfast/window/viewport/viewport_overlay.h>

#include "gestures.h"
#include "open_window.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

/// A closed surface, large enough to be drawn in slices, whose triangles before and behind are mixed in the file.
class LargeMeshInWindow : public test::OpenWindow {
 protected:
  void SetUp() override
  {
    OpenWindow::SetUp();
    MeshDocument document;
    document.mesh = test::icosphere(6);
    NoProgress quiet;
    editor().open(prepareMesh(std::move(document), "sphere", quiet), {});
    ASSERT_TRUE(isLarge(*editor().model()));
    ASSERT_TRUE(settle());
    ASSERT_GT(editor().mesh().contents->mesh().surfaceSlices().count(), 2);
  }

  [[nodiscard]] QImage shown() { return viewport().grabFramebuffer().convertToFormat(QImage::Format_RGB32); }

  /// Moves the cursor at every turn of the event loop, until the picture is full. False if that takes half a minute.
  [[nodiscard]] bool isDrawnInFullWhileTheCursorMoves()
  {
    int k = 0;
    const auto isFull = [&] {
      ++k;
      test::moveMouse(viewport(), {viewport().width() / 2.0 + k % 20, viewport().height() / 2.0});
      return viewport().isInFullDetail();
    };
    return test::waitUntil(isFull, std::chrono::seconds(30));
  }

  /// What is shown when all is at rest is what one call of the renderer draws, with smooth edges.
  void expectTheWholePicture()
  {
    ASSERT_TRUE(settle());
    const QImage rested = shown();
    editor().mesh().contents->setDetail(Detail::Full);
    viewport().renderer().GetRenderWindow()->Render();
    EXPECT_NE(rested, shown()) << "its edges are not smooth";
    viewport().scheduleWidgets();
    ASSERT_TRUE(settle());
    EXPECT_EQ(rested, shown());
  }
};

TEST_F(LargeMeshInWindow, RestsAsThePictureThatIsDrawnAtOnce)
{
  trigger("viewFront");
  expectTheWholePicture();
  const QImage plain = shown();
  trigger("invert");
  expectTheWholePicture();
  EXPECT_NE(shown(), plain) << "all is selected";
}

TEST_F(LargeMeshInWindow, EveryPictureOfAMovementIsSeen)
{
  int pictures = 0;
  int unseen = 0;
  bool isSeen = true;
  QElapsedTimer waiting;
  QObject::connect(&viewport(), &Viewport::aboutToRender, &viewport(), [&] {
    if (!isSeen && waiting.elapsed() < FrameScheduler::kMostMillisecondsUnseen) ++unseen;
  });
  QObject::connect(&viewport(), &Viewport::rendered, &viewport(), [&] {
    ++pictures;
    isSeen = false;
    waiting.start();
  });
  QObject::connect(&viewport(), &QOpenGLWidget::frameSwapped, &viewport(), [&] { isSeen = true; });
  QPointF at(100, 100);
  test::moveMouse(viewport(), at);
  test::pressMouse(viewport(), at, Qt::RightButton);
  EXPECT_TRUE(test::waitUntil([&] {
    at += QPointF(1, 0.5);
    test::moveMouse(viewport(), at, Qt::RightButton);
    return pictures >= 20;
  }));
  test::releaseMouse(viewport(), at, Qt::RightButton);
  EXPECT_EQ(unseen, 0);
  EXPECT_TRUE(test::waitUntil([&] { return isSeen; }));
}

TEST_F(LargeMeshInWindow, IsDrawnInFullWhileTheCursorMoves)
{
  trigger("toolPoint");
  test::drag(viewport(), {{100, 100}, {120, 110}, {140, 120}}, Qt::RightButton);
  ASSERT_TRUE(test::waitUntil([this] { return !viewport().isInFullDetail(); }));
  EXPECT_TRUE(isDrawnInFullWhileTheCursorMoves());
}

TEST_F(LargeMeshInWindow, IsDrawnInFullWhileEachPictureChangesTheWindowAgain)
{
  trigger("toolPoint");
  test::drag(viewport(), {{100, 100}, {120, 110}, {140, 120}}, Qt::RightButton);
  ASSERT_TRUE(test::waitUntil([this] { return !viewport().isInFullDetail(); }));
  int pictures = 0;
  // Each picture of the window changes it again.
  QObject::connect(&viewport(), &QOpenGLWidget::frameSwapped, &viewport(), [&, this] {
    ++pictures;
    viewport().update();
  });
  EXPECT_TRUE(isDrawnInFullWhileTheCursorMoves());
  // One between two slices, and some before the first.
  EXPECT_LT(pictures, 10 * editor().mesh().contents->mesh().surfaceSlices().count());
}

TEST_F(LargeMeshInWindow, PicturesAreOpaque)
{
  const QImage rested = viewport().grabFramebuffer();
  ASSERT_TRUE(rested.hasAlphaChannel());
  EXPECT_TRUE(test::isOpaque(rested));
  trigger("viewFront");
  ASSERT_TRUE(test::waitUntil([&] { return viewport().grabFramebuffer() != rested; }));
  EXPECT_TRUE(test::isOpaque(viewport().grabFramebuffer())) << "of fewer triangles";
}

TEST_F(LargeMeshInWindow, WhatElseChangesIsShownTogetherWithThePicture)
{
  auto* label = window.findChild<QWidget*>("statusNumbers");
  ASSERT_NE(label, nullptr);
  ASSERT_TRUE(settle());
  // Until the window shows what was drawn before.
  static_cast<void>(test::waitUntil([] { return false; }, std::chrono::milliseconds(100)));
  int shownTimes = 0;
  QObject::connect(&viewport(), &QOpenGLWidget::frameSwapped, &viewport(), [&] { ++shownTimes; });
  label->update();
  viewport().scheduleWidgets();
  EXPECT_TRUE(test::waitUntil([&] { return shownTimes > 0; }));
  static_cast<void>(test::waitUntil([] { return false; }, std::chrono::milliseconds(100)));
  EXPECT_EQ(shownTimes, 1);
}

/// The same, standing on its lower end; the upper one is a handle, and is selected.
class HandleOfLargeMesh : public LargeMeshInWindow {
 protected:
  void SetUp() override
  {
    LargeMeshInWindow::SetUp();
    const auto beyond = [](double z) { return Selection{InHalfSpace{{0, 0, z}, {0, 0, z}}}; };
    editor().edit("list", {"",
                           {{"base", true, FixedConstraint{beyond(-0.8)}},
                            {"top", true, HandleConstraint{beyond(0.8), RotationAboutFixed{}, {0, 0, 0}, {}}}}});
    editor().selectConstraints({1});
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] MovedRegion& region() { return window.gizmo().movedRegion(); }
};

TEST_F(HandleOfLargeMesh, IsDrawnWhereItIsToBeBeforeTheRestIsSolved)
{
  EXPECT_FALSE(region().isVisible());
  const QPointF from = onArrow(0);
  test::pressMouse(viewport(), from);
  test::moveMouse(viewport(), from + QPointF(60, 0), Qt::LeftButton);
  // Nothing was solved since: no event was handled.
  ASSERT_EQ(editor().solveState(), SolveState::Solving);
  ASSERT_TRUE(region().isVisible());
  const vtkIdType count = region().points().GetNumberOfPoints();
  ASSERT_GT(count, 1000);
  std::vector<Vector3> early;
  for (vtkIdType k = 0; k < count; ++k) early.emplace_back(region().points().GetPoint(k));
  test::releaseMouse(viewport(), from + QPointF(60, 0));
  EXPECT_TRUE(region().isVisible()) << "until the surface has followed";
  ASSERT_TRUE(settle());
  EXPECT_FALSE(region().isVisible());
  std::vector<Vector3> solved;
  for (Index vertex = 0; vertex < editor().positions().rows(); ++vertex)
    if (editor().model()->mesh.positions(vertex, 2) >= 0.8) solved.emplace_back(editor().positions().row(vertex));
  EXPECT_EQ(early, solved);
}

TEST_F(HandleOfLargeMesh, PanelsFollowADragTogetherWithThePicture)
{
  constexpr int kPictures = 12;
  int pictures = 0;
  int shownTimes = 0;
  QPointF at = onArrow(0);
  test::pressMouse(viewport(), at);
  QObject::connect(&viewport(), &Viewport::rendered, &viewport(), [&] { ++pictures; });
  QObject::connect(&viewport(), &QOpenGLWidget::frameSwapped, &viewport(), [&] { ++shownTimes; });
  EXPECT_TRUE(test::waitUntil([&] {
    at += QPointF(0.5, 0);
    test::moveMouse(viewport(), at, Qt::LeftButton);
    return pictures >= kPictures;
  }));
  EXPECT_LE(shownTimes, kPictures + 3) << "that of the press is among them";
  test::releaseMouse(viewport(), at);
}

TEST_F(HandleOfLargeMesh, EscapeTakesItAway)
{
  const QPointF from = onArrow(0);
  test::pressMouse(viewport(), from);
  test::moveMouse(viewport(), from + QPointF(60, 0), Qt::LeftButton);
  trigger("escape");
  EXPECT_FALSE(region().isVisible());
  test::releaseMouse(viewport(), from + QPointF(60, 0));
}

TEST_F(HandleOfLargeMesh, OfManyQuickUndosTheLastStateIsShownFirst)
{
  constexpr int kEdits = 40;
  const auto first = editor().history().state();
  for (int k = 1; k <= kEdits; ++k) {
    ConstraintList moved = list();
    std::get<HandleConstraint>(moved.constraints[1].what).translate.x() = 0.01 * k;
    editor().edit("move", std::move(moved));
    // Some are solved, as by a user who looks at them.
    const bool isSeen = k > kEdits - 3;
    ASSERT_TRUE(!isSeen || settle());
  }
  std::vector<std::shared_ptr<const DocumentState>> shown;
  QObject::connect(&editor(), &Editor::deformed, &viewport(), [&] { shown.push_back(editor().deformedState()); });
  for (int k = 0; k < kEdits; ++k) trigger("undo");
  EXPECT_EQ(editor().history().state(), first);
  ASSERT_TRUE(settle());
  EXPECT_EQ(shown, std::vector{first});
  EXPECT_EQ(editor().deformedState(), first);
}

TEST_F(HandleOfLargeMesh, ThePictureSaysForHowLongItHasBeenOlder)
{
  editor().solve();
  EXPECT_EQ(solveStateText(editor()), "Older than the constraints: solving");
  QElapsedTimer since;
  since.start();
  while (since.elapsed() < 600) {
    // No event is handled: whatever was solved is not shown.
  }
  const QString text = solveStateText(editor());
  EXPECT_TRUE(text.startsWith("Older than the constraints: solving, 0.")) << text.toStdString();
  ASSERT_TRUE(settle());
  EXPECT_EQ(solveStateText(editor()), "");
}

}  // namespace
}  // namespace holdfast

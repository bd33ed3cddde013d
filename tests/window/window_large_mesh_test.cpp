#include <QElapsedTimer>

#include <gtest/gtest.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

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

  /// What is shown when all is at rest is what one call of the renderer draws.
  void expectTheWholePicture()
  {
    ASSERT_TRUE(settle());
    const QImage rested = shown();
    editor().mesh().contents->setDetail(Detail::Full);
    viewport().renderer().GetRenderWindow()->Render();
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
    if (!isSeen && waiting.elapsed() < Viewport::kMostMillisecondsUnseen) ++unseen;
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
  int shownTimes = 0;
  QObject::connect(&viewport(), &QOpenGLWidget::frameSwapped, &viewport(), [&] { ++shownTimes; });
  label->update();
  viewport().scheduleWidgets();
  EXPECT_TRUE(test::waitUntil([&] { return shownTimes > 0; }));
  static_cast<void>(test::waitUntil([] { return false; }, std::chrono::milliseconds(100)));
  EXPECT_EQ(shownTimes, 1);
}

}  // namespace
}  // namespace holdfast

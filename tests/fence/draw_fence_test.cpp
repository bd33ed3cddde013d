#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <chrono>
#include <functional>
#include <memory>

#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <holdfast/window/viewport/draw_fence.h>

#include "slow_drawing_threads.h"

namespace holdfast {
namespace {

/// Somewhere to draw, in a context that is current.
class FenceOfDrawing : public ::testing::Test {
 protected:
  void SetUp() override
  {
    surface.create();
    ASSERT_TRUE(context.create());
    ASSERT_TRUE(context.makeCurrent(&surface));
    picture = std::make_unique<QOpenGLFramebufferObject>(512, 512);
    ASSERT_TRUE(picture->bind());
    if (!drawsOnThreads())
      GTEST_SKIP() << "this renderer, or this machine, draws without threads that could be held up";
  }
  void TearDown() override { test::holdUpDrawingThreads({}); }

  [[nodiscard]] QOpenGLExtraFunctions& gl() { return *context.extraFunctions(); }

  void orderPicture(long number)
  {
    gl().glClearColor(static_cast<float>(number % 7) / 7, 0, 0, 1);
    gl().glClear(GL_COLOR_BUFFER_BIT);
  }

  [[nodiscard]] bool drawsOnThreads()
  {
    test::holdUpDrawingThreads(std::chrono::microseconds(1));
    const long before = test::drawingThreadsHeldUp();
    for (long k = 0; k < 10; ++k) {
      orderPicture(k);
      gl().glFinish();
    }
    test::holdUpDrawingThreads({});
    return test::drawingThreadsHeldUp() > before;
  }

  /// Draws pictures one after the other, each as soon as the one before is said to be drawn, and counts how often that
  /// was too soon.
  long tooSoon(const std::function<void()>& set, const std::function<bool()>& pass)
  {
    const long before = test::locksDestroyedWhileHeld();
    for (long k = 0; k < kPictures; ++k) {
      orderPicture(k);
      set();
      while (!pass()) continue;
    }
    return test::locksDestroyedWhileHeld() - before;
  }

  static constexpr long kPictures = 200;

  QOffscreenSurface surface;
  QOpenGLContext context;
  std::unique_ptr<QOpenGLFramebufferObject> picture;
  vtkNew<vtkGenericOpenGLRenderWindow> window;  // draws in the current context
};

TEST_F(FenceOfDrawing, OutlivesTheThreadsThatPassIt)
{
  test::holdUpDrawingThreads(std::chrono::microseconds(300));
  DrawFence fence(*window);
  EXPECT_EQ(tooSoon([&] { fence.set(); }, [&] { return fence.pass(); }), 0);
  EXPECT_GE(test::drawingThreadsHeldUp(), kPictures);

  GLsync sync = nullptr;
  const long plainly = tooSoon(
      [&] {
        sync = gl().glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl().glFlush();
      },
      [&] {
        if (gl().glClientWaitSync(sync, 0, 0) == GL_TIMEOUT_EXPIRED) return false;
        gl().glDeleteSync(sync);
        return true;
      });
  if (plainly == 0) GTEST_SKIP() << "this renderer waits for its threads before it frees a fence";
}

TEST_F(FenceOfDrawing, IsPassedOnlyWhenThePictureIsDrawn)
{
  DrawFence fence(*window);
  EXPECT_TRUE(fence.pass()) << "none is set";
  test::holdUpDrawingThreads(std::chrono::milliseconds(200));
  orderPicture(0);
  fence.set();
  orderPicture(1);
  fence.set();
  EXPECT_FALSE(fence.pass()) << "the threads are still at the first picture";
  while (!fence.pass()) continue;
  EXPECT_TRUE(fence.pass()) << "it is no longer set";
}

TEST_F(FenceOfDrawing, TakesThePlaceOfTheOneBefore)
{
  DrawFence fence(*window);
  for (int k = 0; k < 20; ++k) {
    orderPicture(k);
    fence.set();
  }
  while (!fence.pass()) continue;
  EXPECT_TRUE(fence.pass());
  EXPECT_EQ(gl().glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace holdfast

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  const QGuiApplication application(argc, argv);
  return RUN_ALL_TESTS();
}

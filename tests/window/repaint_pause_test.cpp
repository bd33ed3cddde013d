#include <QCoreApplication>
#include <QPaintEvent>
#include <QWidget>

#include <gtest/gtest.h>

#include <holdfast/window/viewport/repaint_pause.h>

#include "gestures.h"

namespace holdfast {
namespace {

class PaintCounter : public QWidget {
 public:
  int count = 0;

 protected:
  void paintEvent(QPaintEvent* /*event*/) override { ++count; }
};

class RepaintPaused : public ::testing::Test {
 protected:
  void SetUp() override
  {
    counter.setParent(&window);
    window.resize(200, 150);
    counter.resize(100, 100);
    ASSERT_TRUE(test::showAndWait(window));
    ASSERT_TRUE(test::waitUntil([this] { return counter.count > 0; }));
    handleAll();
    painted = counter.count;
  }

  /// Runs as many turns of the event loop as a repaint takes, and some more.
  static void handleAll()
  {
    for (int k = 0; k < 5; ++k) {
      QCoreApplication::processEvents();
      QCoreApplication::sendPostedEvents();
    }
  }

  QWidget window;
  PaintCounter counter;
  RepaintPause pause{counter};
  int painted = 0;
};

TEST_F(RepaintPaused, PutsOffWhatIsToBeRepaintedAndLosesNothing)
{
  pause.begin();
  counter.update();
  handleAll();
  EXPECT_EQ(counter.count, painted);
  EXPECT_TRUE(pause.end());
  EXPECT_TRUE(test::waitUntil([this] { return counter.count > painted; }));
}

TEST_F(RepaintPaused, RepaintsNothingThatNobodyAskedFor)
{
  pause.begin();
  handleAll();
  EXPECT_FALSE(pause.end());
  handleAll();
  EXPECT_EQ(counter.count, painted);
}

TEST_F(RepaintPaused, BeginsAnewWithoutForgetting)
{
  pause.begin();
  counter.update();
  handleAll();
  pause.begin();
  handleAll();
  pause.end();
  EXPECT_TRUE(test::waitUntil([this] { return counter.count > painted; }));
}

TEST_F(RepaintPaused, WithoutAPauseEverythingIsRepainted)
{
  counter.update();
  EXPECT_TRUE(test::waitUntil([this] { return counter.count > painted; }));
  EXPECT_FALSE(pause.end());
}

}  // namespace
}  // namespace holdfast

#include <gtest/gtest.h>

#include "gestures.h"
#include "open_window.h"

namespace holdfast {
namespace {

/// How often the window is told that other constraints are drawn.
class MarksOfViewport : public test::OpenWindow {
 protected:
  void SetUp() override
  {
    OpenWindow::SetUp();
    QObject::connect(&viewport(), &Viewport::marksChanged, &viewport(), [this] { ++changes; });
  }

  int changes = 0;
};

TEST_F(MarksOfViewport, AreToldOnceForADocumentAndOnceForItsDeformation)
{
  open("bracket.obj", "bracket.constraints.json");
  EXPECT_EQ(changes, 2);
  editor().close();
  EXPECT_EQ(changes, 3);
  EXPECT_TRUE(viewport().marks().empty());
}

using PicturesOfViewport = test::OpenWindow;

TEST_F(PicturesOfViewport, ComeOnceForAllRequestsOfOneTurn)
{
  open("bracket.obj", "bracket.constraints.json");
  int pictures = 0;
  QObject::connect(&viewport(), &Viewport::rendered, &viewport(), [&] { ++pictures; });
  for (int k = 0; k < 3; ++k) viewport().scheduleRender();
  EXPECT_EQ(pictures, 0);
  ASSERT_TRUE(test::waitUntil([&] { return pictures > 0; }));
  EXPECT_EQ(pictures, 1);
}

}  // namespace
}  // namespace holdfast

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace holdfast

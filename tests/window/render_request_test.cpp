#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>

#include <holdfast/window/controls/render_request.h>

#include "gestures.h"

namespace holdfast {
namespace {

/// A view that counts how often it is drawn.
struct CountedView {
  CountedView()
  {
    view.resize(200, 200);
    view.renderWindow()->AddObserver(vtkCommand::EndEvent, this, &CountedView::count);
  }

  void count() { ++pictures; }

  QVTKOpenGLNativeWidget view;
  RenderRequest& request = *new RenderRequest(view);
  int pictures = 0;
};

class RenderRequests : public ::testing::Test {
 protected:
  void SetUp() override
  {
    ASSERT_TRUE(test::showAndWait(first.view));
    ASSERT_TRUE(test::showAndWait(second.view));
    ASSERT_TRUE(test::waitUntil([this] { return first.pictures > 0 && second.pictures > 0; }));
    letTheOtherBeDrawn();
    first.pictures = 0;
  }

  /// Requests are met in their order: by then those before are.
  void letTheOtherBeDrawn()
  {
    const int before = second.pictures;
    second.request.post();
    ASSERT_TRUE(test::waitUntil([&] { return second.pictures > before; }));
  }

  CountedView first;
  CountedView second;
};

TEST_F(RenderRequests, AreMetOnceForAllOfOneTurn)
{
  for (int k = 0; k < 3; ++k) first.request.post();
  EXPECT_EQ(first.pictures, 0);
  letTheOtherBeDrawn();
  EXPECT_EQ(first.pictures, 1);
  first.request.post();
  letTheOtherBeDrawn();
  EXPECT_EQ(first.pictures, 2);
}

TEST_F(RenderRequests, AreMetByAPictureForAnotherReason)
{
  first.request.post();
  first.view.renderWindow()->Render();
  EXPECT_EQ(first.pictures, 1);
  letTheOtherBeDrawn();
  EXPECT_EQ(first.pictures, 1);
}

TEST_F(RenderRequests, OfAHiddenViewAreForgotten)
{
  first.view.hide();
  first.request.post();
  letTheOtherBeDrawn();
  EXPECT_EQ(first.pictures, 0);
}

}  // namespace
}  // namespace holdfast

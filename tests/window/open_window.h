#pragma once
/// \file
/// The real window with one of the project's own meshes in it, for tests that use it as a user does.

#include <gtest/gtest.h>

#include "widgets/plain_view.h"
#include "window/driven_window.h"

namespace holdfast::test {

/// Shows the window, and opens documents in it.
class OpenWindow : public ::testing::Test, protected DrivenWindow {
 protected:
  void SetUp() override { show(1270, 1000); }

  /// Looks at the document as `view` says; its size becomes that of the viewport.
  void look(PlainView& view);

  /// The place in the viewport's own coordinates of the middle of a pixel, or of the pixel that holds a point of the
  /// screen as `PlainView` counts them: from the lower left.
  [[nodiscard]] QPointF inWidget(const Eigen::Vector2d& screen);
};

}  // namespace holdfast::test

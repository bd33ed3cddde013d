#pragma once
/// \file
/// The real window with one of the project's own meshes in it, for tests that use it as a user does.

#include <chrono>
#include <string>

#include <gtest/gtest.h>

#include <holdfast/window/viewport/viewport.h>
#include <holdfast/window/window/main_window.h>

#include "widgets/plain_view.h"

namespace holdfast::test {

/// Shows the window, and opens documents in it.
class OpenWindow : public ::testing::Test {
 protected:
  void SetUp() override;

  /// Opens a mesh of `data/` under constraints of `data/` (none where empty), and waits for it to be solved and drawn.
  void open(const std::string& mesh, const std::string& constraints = "");

  /// Until what is shown is what was asked for, and is drawn in full. False where it does not come to that in time.
  [[nodiscard]] bool settle(std::chrono::milliseconds limit = std::chrono::minutes(3));

  /// Triggers an action by its object name, as a menu does.
  void trigger(const char* action);

  /// Looks at the document as `view` says; its size becomes that of the viewport.
  void look(PlainView& view);

  /// The place in the viewport's own coordinates of the middle of a pixel, or of the pixel that holds a point of the
  /// screen as `PlainView` counts them: from the lower left.
  [[nodiscard]] QPointF inWidget(const Eigen::Vector2d& screen);

  /// Return where a place is shown, and the middle of the shaft of an arrow of the gizmo.
  [[nodiscard]] QPointF shownAt(const Vector3& place);
  [[nodiscard]] QPointF onArrow(int axis);

  [[nodiscard]] Editor& editor() { return window.editor(); }
  [[nodiscard]] Viewport& viewport() { return window.viewport(); }
  [[nodiscard]] const ConstraintList& list() { return editor().list(); }

  MainWindow window;
};

}  // namespace holdfast::test

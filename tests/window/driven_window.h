#pragma once
/// \file
/// The real window as a user drives it: documents, actions, and the places where things are shown.

#include <QPointF>
#include <chrono>
#include <stdexcept>
#include <string>

#include <holdfast/window/viewport/viewport.h>
#include <holdfast/window/window/main_window.h>

namespace holdfast::test {

/// Functions throw where what they do does not come, so that a test or a tour ends there.
class DrivenWindow {
 public:
  /// Shows the window in this size, and waits for it to be on the screen.
  void show(int width, int height);

  /// Opens a mesh of `data/` under constraints of `data/` (none where empty), and waits for it to be solved and drawn.
  /// Edits of the document before are lost.
  void open(const std::string& mesh, const std::string& constraints = "");

  /// Until what is shown is what was asked for, and is drawn in full. False where it does not come to that in time.
  [[nodiscard]] bool settle(std::chrono::milliseconds limit = std::chrono::minutes(3));

  /// Triggers an action by its object name, as a menu does.
  void trigger(const char* action);

  /// A child of the window, by its object name.
  template <class Child>
  [[nodiscard]] Child& find(const char* name)
  {
    auto* found = window.findChild<Child*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("nothing in the window is called ") + name);
    return *found;
  }

  /// Return where a place is shown, and the middle of the shaft of an arrow of the gizmo, in the viewport's
  /// coordinates.
  [[nodiscard]] QPointF shownAt(const Vector3& place);
  [[nodiscard]] QPointF onArrow(int axis);
  /// The vertex that is nearest to a place now.
  [[nodiscard]] Index nearestVertex(const Vector3& place);

  [[nodiscard]] Editor& editor() { return window.editor(); }
  [[nodiscard]] Viewport& viewport() { return window.viewport(); }
  [[nodiscard]] const ConstraintList& list() { return editor().list(); }

  MainWindow window;
};

}  // namespace holdfast::test

#pragma once
/// \file
/// What a user does in the window, by mouse and keys alone: opens panels, types into the table, holds points, answers
/// questions.

#include <QComboBox>
#include <QMessageBox>
#include <QPointF>
#include <string>

#include <holdfast/window/table/constraint_table.h>

#include "gestures.h"
#include "open_window.h"

namespace holdfast::test {

/// The window, which has the keys of the display.
class WindowUser : public OpenWindow {
 protected:
  void SetUp() override;

  /// Clicks the tab of a panel, which is in front afterwards. `title` is how its tab begins.
  void openPanel(const char* title);
  /// The words of the tab of a panel; empty where it has none.
  [[nodiscard]] QString tabOf(const char* title);

  void clickOn(QWidget& widget) { click(widget, QPointF(widget.rect().center())); }

  [[nodiscard]] ConstraintTable& table() { return find<ConstraintTable>("constraintTable"); }
  [[nodiscard]] QString shown(Index row, int column);
  /// Double click, the text, Enter.
  void typeInto(Index row, int column, const char* text);

  /// By the arrow keys.
  static void chooseEntry(QComboBox& box, int entry);

  /// Return where a place, or a vertex of the file, is seen.
  [[nodiscard]] QPointF seenAt(const Vector3& place);
  [[nodiscard]] QPointF seenAt(Index vertex);
  /// A vertex that is seen, away from all that constraints hold.
  [[nodiscard]] Index freeVertex();
  /// Chooses the tool that holds points and clicks the vertex. The constraint is the last of the list then.
  void holdVertex(Index vertex);

  /// A key, with what shortcuts make of it, for what has the focus.
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  /// Letters, one key each.
  void keys(const char* text);

  /// Goes on with Tab until this has the keys.
  [[nodiscard]] bool tabTo(QWidget& widget);
  /// In the table, by arrow keys: columns may stand in another order than they are counted.
  void goToColumn(int column);
  /// Into the cell that has the keys: F2, the text in the place of what is there, Enter.
  void typeIntoCell(const char* text);

  /// Presses a button of the next question. True from `wasAsked` once that has happened.
  void answer(QMessageBox::StandardButton button);
  [[nodiscard]] bool wasAsked() const { return wasAsked_; }

  /// Files are asked for no more: the answer is this path.
  void chooseFile(const std::string& path);

 private:
  [[nodiscard]] QWidget& keyOwner();

  bool wasAsked_ = false;
};

}  // namespace holdfast::test

#pragma once
/// \file
/// The panel that lists constraints: find, sort, reorder, switch, type targets, copy and paste.

#include <QTimer>
#include <QWidget>
#include <functional>
#include <vector>

#include <holdfast/window/table/constraint_filter.h>
#include <holdfast/window/table/constraint_table.h>

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;

namespace holdfast {

/// A table of the constraints of an editor. Its selection is `Editor::selectedConstraints`.
class ConstraintPanel : public QWidget {
  Q_OBJECT

 public:
  /// `editor` stays alive as long as this.
  explicit ConstraintPanel(Editor& editor, QWidget* parent = nullptr);

  [[nodiscard]] ConstraintTable& table() { return *table_; }
  /// Puts the cursor into the line that filters.
  void find();
  /// Begins to type a new name for the current row.
  void rename();

 Q_SIGNALS:
  /// Double click on a row, in a cell that cannot be edited.
  void activated(Index constraint);

 private:
  void makeTopLine();
  void makeTable();
  void makeActions();
  QAction* makeAction(const QString& text, const QKeySequence& keys, const char* name, const QString& tip,
                      void (ConstraintPanel::*run)());
  void separate();
  void attempt(const std::function<void()>& run);

  void switchSelected();
  void removeSelected();
  void duplicateSelected();
  void moveSelectedUp();
  void moveSelectedDown();
  void copySelected();
  void paste();
  void selectAll();

  void takeSelection();
  void showSelection();
  void filtersChanged();
  void updateActions();
  void updateTexts();
  void refuse(const QString& reason);

  Editor& editor_;
  ConstraintTableModel model_;
  ConstraintFilter filter_;
  ConstraintTable* table_ = nullptr;
  QLineEdit* text_ = nullptr;
  QComboBox* status_ = nullptr;
  QLabel* reason_ = nullptr;
  QLabel* count_ = nullptr;
  QAction* up_ = nullptr;
  QAction* down_ = nullptr;
  std::vector<QAction*> needSelection_;
  QTimer settled_;
  bool isShowing_ = false;  // the editor's selection, or rows that come and go: not the user's doing
};

}  // namespace holdfast

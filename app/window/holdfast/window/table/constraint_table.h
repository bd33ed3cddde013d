#pragma once
/// The table of the constraint panel. The user selects its rows, drags them and types into them.

#include <QTableView>
#include <functional>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// The table shows constraints. Keys of its actions work while it has the focus, whatever menus use them for. Clicks in
/// cells that set a value keep a selection of several rows: the value goes to all of them. Switch and name stay in
/// sight at the left when the other columns are scrolled. The first character of a number begins to edit a cell that
/// has a number.
class ConstraintTable : public QTableView {
  Q_OBJECT

 public:
  explicit ConstraintTable(QWidget* parent = nullptr);

  void setModel(QAbstractItemModel* model) override;
  void setEmptyText(const QString& text);
  void scrollTo(const QModelIndex& index, ScrollHint hint = EnsureVisible) override;
  /// Searches among the names alone. Digits typed in other columns would lead to the rows of any numbers.
  void keyboardSearch(const QString& search) override;
  /// Returns the part of a cell that lies neither under the columns that stay nor beyond an edge.
  [[nodiscard]] QRect seenPart(QRect cell) const;

 Q_SIGNALS:
  /// A title was clicked for the first, the second or the third time. The third click returns to the order of
  /// precedence: `column` is -1.
  void sortAsked(int column, Qt::SortOrder order);
  /// The user has stopped editing a cell, and the cell has what it had before.
  void editTakenBack();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void updateGeometries() override;
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
  [[nodiscard]] QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                                     const QEvent* event) const override;

 private:
  [[nodiscard]] QAction* actionOf(const QKeyEvent& event) const;
  [[nodiscard]] bool beginsNumber(const QKeyEvent& event) const;
  void cycleSorting(int column);
  void placePinned();

  QTableView* pinned_;  // the columns that stay, over the others while these are scrolled
  QString emptyText_;
  int sortedColumn_ = -1;
  Qt::SortOrder order_ = Qt::AscendingOrder;
};

/// Makes the panel. A double click on a row, in a cell that cannot be edited, calls `activated` with the row's place in
/// the list.
[[nodiscard]] QWidget* newConstraintPanel(Editor& editor, const std::function<void(Index)>& activated);

}  // namespace holdfast

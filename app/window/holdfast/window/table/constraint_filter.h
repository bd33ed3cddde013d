#pragma once
/// \file
/// The rows of the table of constraints that a user looks for, in the order that the user wants.

#include <QSortFilterProxyModel>
#include <QStringList>

#include <holdfast/window/table/constraint_table_model.h>

namespace holdfast {

/// Filters and sorts a `ConstraintTableModel`. Missing values come last in both directions; equal ones stay in the
/// order of precedence. What is typed into a cell of a selected row goes to all selected rows that are visible.
class ConstraintFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  /// Both stay alive as long as this.
  ConstraintFilter(Editor& editor, ConstraintTableModel& model, QObject* parent = nullptr);

  /// Rows whose name, kind or place has every word of `text` in it.
  void setText(const QString& text);
  /// Shows rows with `*status` only, which stays alive as long as this; null: all.
  void setStatus(const std::optional<ConstraintStatus>* status);
  [[nodiscard]] bool isSorted() const { return sortColumn() >= 0; }

  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// The place in the order of precedence, whatever the order of rows.
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  /// The row of a constraint of the list; -1 if it is not shown.
  [[nodiscard]] int visibleRow(Index constraint) const;

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  Editor& editor_;
  ConstraintTableModel& model_;
  QStringList words_;
  const std::optional<ConstraintStatus>* status_ = nullptr;
};

}  // namespace holdfast

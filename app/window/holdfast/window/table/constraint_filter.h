#pragma once
/// \file
/// The rows of the table of constraints that a user looks for, in the order that he wants to see them.

#include <QSortFilterProxyModel>
#include <QStringList>

#include <holdfast/window/table/constraint_table_model.h>

namespace holdfast {

/// Which statuses are shown.
enum class StatusFilter { All, Conflicting, Missed, Redundant, Met, Disabled, Unsolved };

/// Filters and sorts a `ConstraintTableModel`. Values that are missing come last in both directions; of equals the
/// order is that of precedence. What is typed into a cell of a selected row goes to all selected rows that are visible.
class ConstraintFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  /// Both stay alive as long as this.
  ConstraintFilter(Editor& editor, ConstraintTableModel& model, QObject* parent = nullptr);

  /// Rows whose name, kind or place has every word of `text` in it.
  void setText(const QString& text);
  void setStatus(StatusFilter status);
  [[nodiscard]] bool isFiltering() const { return !words_.isEmpty() || status_ != StatusFilter::All; }
  [[nodiscard]] bool isSorted() const { return sortColumn() >= 0; }

  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// The place in the order of precedence, wherever the row stands.
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  /// Of the constraint of the list; -1 where it is not shown.
  [[nodiscard]] int visibleRow(Index constraint) const;

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  [[nodiscard]] bool hasStatus(int row) const;

  Editor& editor_;
  ConstraintTableModel& model_;
  QStringList words_;
  StatusFilter status_ = StatusFilter::All;
};

}  // namespace holdfast

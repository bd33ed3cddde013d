#pragma once
/// Decides which constraints the table shows, and in which order.

#include <QCollator>
#include <QSortFilterProxyModel>
#include <optional>

#include <holdfast/window/table/constraint_table_model.h>

namespace holdfast {

/// The filter filters and sorts a `ConstraintTableModel`. Missing values come last in both directions. Equal ones stay
/// in the order of precedence. What is typed into a cell of a selected row goes to all selected rows that are visible.
class ConstraintFilter : public QSortFilterProxyModel {
  Q_OBJECT

  using Table = ConstraintTableModel;

 public:
  ConstraintFilter(Editor& editor, Table& model);

  /// Shows only rows whose name, kind or place has every word of `text` in it. Their status is also `*status`, unless
  /// `status` is null.
  void setFilter(const QString& text, const std::optional<ConstraintStatus>* status);

  [[nodiscard]] bool isSorted() const { return sortColumn() >= 0; }

  /// Returns the row of a constraint of the list; -1 if the constraint is not shown.
  [[nodiscard]] int visibleRow(Index constraint) const;
  [[nodiscard]] Rows visibleSelection() const;

  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

  /// Returns the titles of columns. For a row it returns the place in the order of precedence, whatever the order of
  /// rows.
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  Editor& editor_;
  Table& model_;
  QStringList words_;
  const std::optional<ConstraintStatus>* status_ = nullptr;
  QCollator collator_{QLocale(QLocale::English)};
};

}  // namespace holdfast

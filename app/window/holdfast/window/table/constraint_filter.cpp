#include "holdfast/window/table/constraint_filter.h"

#include <algorithm>

namespace holdfast {

ConstraintFilter::ConstraintFilter(Editor& editor, Table& model) : editor_(editor), model_(model)
{
  setSourceModel(&model);
  // "P2" before "P10".
  collator_.setNumericMode(true);
  collator_.setCaseSensitivity(Qt::CaseInsensitive);
}

void ConstraintFilter::setFilter(const QString& text, const std::optional<ConstraintStatus>* status)
{
  words_ = text.simplified().split(' ', Qt::SkipEmptyParts);
  status_ = status;
  invalidateFilter();
}

int ConstraintFilter::visibleRow(Index constraint) const
{
  return mapFromSource(model_.index(static_cast<int>(constraint), 0)).row();
}

Rows ConstraintFilter::visibleSelection() const
{
  Rows rows = editor_.selectedConstraints();
  std::erase_if(rows, [this](Index row) { return visibleRow(row) < 0; });
  return rows;
}

bool ConstraintFilter::setData(const QModelIndex& index, const QVariant& value, int role)
{
  const Index row = mapToSource(index).row();
  const Rows& selected = editor_.selectedConstraints();
  // A name is that of the row where it was typed.
  const bool isForAll = index.column() != Table::Name && std::binary_search(selected.begin(), selected.end(), row);
  return model_.setCells(isForAll ? visibleSelection() : Rows{row}, index.column(), value, role);
}

Qt::ItemFlags ConstraintFilter::flags(const QModelIndex& index) const
{
  const Qt::ItemFlags flags = QSortFilterProxyModel::flags(index);
  return isSorted() ? flags & ~(Qt::ItemIsDragEnabled | Qt::ItemIsDropEnabled) : flags;
}

QVariant ConstraintFilter::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation == Qt::Horizontal) return model_.headerData(section, orientation, role);
  return model_.headerData(mapToSource(index(section, 0)).row(), orientation, role);
}

bool ConstraintFilter::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const
{
  if (status_ != nullptr && model_.status(row) != *status_) return false;
  if (words_.isEmpty()) return true;
  QString text;
  for (const int column : {Table::Name, Table::Kind, Table::Where}) text += model_.text(row, column) + '\n';
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool ConstraintFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
  const int column = left.column();
  if (!model_.hasNumbers(column))
    return collator_.compare(model_.text(left.row(), column), model_.text(right.row(), column)) < 0;
  const std::optional<double> a = model_.number(left.row(), column);
  const std::optional<double> b = model_.number(right.row(), column);
  if (a && b) return *a < *b;
  const bool isMissingLess = sortOrder() == Qt::DescendingOrder;
  return isMissingLess ? b.has_value() && !a : a.has_value() && !b;
}

}  // namespace holdfast

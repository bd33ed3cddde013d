#include "holdfast/window/table/constraint_filter.h"

#include <algorithm>

namespace holdfast {
namespace {

/// The number of digits from `place` on.
int digitsAt(const QString& text, int place)
{
  int end = place;
  while (end < text.size() && text[end].isDigit()) ++end;
  return end - place;
}

/// Ignores letter case, and compares numbers by their value: "P2" before "P10".
bool comesBefore(const QString& a, const QString& b)
{
  int i = 0;
  int j = 0;
  while (i < a.size() && j < b.size()) {
    const int n = digitsAt(a, i);
    const int m = digitsAt(b, j);
    if (n > 0 && m > 0 && n != m) return n < m;
    const QChar x = a[i++].toLower();
    const QChar y = b[j++].toLower();
    if (x != y) return x < y;
  }
  return a.size() - i < b.size() - j;
}

}  // namespace

ConstraintFilter::ConstraintFilter(Editor& editor, ConstraintTableModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), editor_(editor), model_(model)
{
  setSourceModel(&model);
}

void ConstraintFilter::setText(const QString& text)
{
  const QStringList words = text.simplified().split(' ', Qt::SkipEmptyParts);
  if (words == words_) return;
  words_ = words;
  invalidateFilter();
}

void ConstraintFilter::setStatus(const std::optional<ConstraintStatus>* status)
{
  if (status == status_) return;
  status_ = status;
  invalidateFilter();
}

bool ConstraintFilter::setData(const QModelIndex& index, const QVariant& value, int role)
{
  const Index row = mapToSource(index).row();
  const std::vector<Index>& selected = editor_.selectedConstraints();
  if (!std::binary_search(selected.begin(), selected.end(), row))
    return model_.setCells({row}, index.column(), value, role);
  // A name is that of the row where it was typed.
  if (index.column() == ConstraintTableModel::Name) return model_.setCells({row}, index.column(), value, role);
  Rows visible;
  std::copy_if(selected.begin(), selected.end(), std::back_inserter(visible),
               [this](Index k) { return visibleRow(k) >= 0; });
  return model_.setCells(visible, index.column(), value, role);
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

int ConstraintFilter::visibleRow(Index constraint) const
{
  return mapFromSource(model_.index(static_cast<int>(constraint), 0)).row();
}

bool ConstraintFilter::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const
{
  if (status_ != nullptr && model_.status(row) != *status_) return false;
  if (words_.isEmpty()) return true;
  using Table = ConstraintTableModel;
  const QString text =
      model_.text(row, Table::Name) + '\n' + model_.text(row, Table::Kind) + '\n' + model_.text(row, Table::Where);
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool ConstraintFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
  const int column = left.column();
  if (!model_.hasNumbers(column)) return comesBefore(model_.text(left.row(), column), model_.text(right.row(), column));
  const std::optional<double> a = model_.number(left.row(), column);
  const std::optional<double> b = model_.number(right.row(), column);
  if (a && b) return *a < *b;
  const bool isMissingLess = sortOrder() == Qt::DescendingOrder;
  return isMissingLess ? b.has_value() && !a : a.has_value() && !b;
}

}  // namespace holdfast

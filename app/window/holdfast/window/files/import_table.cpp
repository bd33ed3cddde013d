#include "holdfast/window/files/import_table.h"

#include <QGuiApplication>
#include <algorithm>
#include <utility>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {

void ImportTable::setContents(ImportContents contents, double tolerance)
{
  beginResetModel();
  contents_ = std::move(contents);
  points_.assign(contents_.list.constraints.size(), nullptr);
  for (const ImportedPoint& point : contents_.preview.points) points_[point.index] = &point;
  isTicked_.resize(contents_.rows.size());
  tickNear(tolerance);
  endResetModel();
}

void ImportTable::setTolerance(double tolerance)
{
  tickNear(tolerance);
  reportChange();
}

void ImportTable::tickAll(bool isTicked)
{
  for (int row = 0; row < rowCount(); ++row) isTicked_[row] = isTicked && isReadable(row);
  reportChange();
}

std::vector<Index> ImportTable::tickedConstraints() const
{
  std::vector<Index> ticked;
  for (std::size_t row = 0; row < isTicked_.size(); ++row)
    if (isTicked_[row]) ticked.push_back(*contents_.rows[row].constraint);
  return ticked;
}

Index ImportTable::faultyRows() const
{
  return std::ranges::count_if(contents_.rows, [](const ImportRow& row) { return !row.fault.isEmpty(); });
}

Index ImportTable::farPoints() const
{
  Index count = 0;
  for (int row = 0; row < rowCount(); ++row) count += isFar(row) ? 1 : 0;
  return count;
}

int ImportTable::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(contents_.rows.size());
}

int ImportTable::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : Where + 1;
}

QVariant ImportTable::data(const QModelIndex& index, int role) const
{
  if (!index.isValid()) return {};
  const int row = index.row();
  const int column = index.column();
  if (role == Qt::DisplayRole) return text(row, column);
  if (role == Qt::ToolTipRole) return plainTip(toolTip(row, column));
  if (role == Qt::CheckStateRole && column == Name && isReadable(row))
    return isTicked_[row] ? Qt::Checked : Qt::Unchecked;
  if (role == Qt::ForegroundRole && isMarked(row))
    return statusColor(ConstraintStatus::Conflicting, QGuiApplication::palette());
  if (role != kSortRole) return {};
  if (column != Distance) return text(row, column);
  return point(row) == nullptr ? -1.0 : point(row)->distance;
}

QVariant ImportTable::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return QAbstractTableModel::headerData(section, orientation, role);
  return QStringList{tr("Name"), tr("Kind"), tr("Place"), tr("Target"), tr("Distance"), tr("On the surface")}[section];
}

Qt::ItemFlags ImportTable::flags(const QModelIndex& index) const
{
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.column() == Name && isReadable(index.row()) ? usual | Qt::ItemIsUserCheckable : usual;
}

bool ImportTable::setData(const QModelIndex& index, const QVariant& value, int role)
{
  if (!index.isValid() || role != Qt::CheckStateRole || index.column() != Name) return false;
  isTicked_[index.row()] = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index, {role});
  return true;
}

const Constraint& ImportTable::constraint(int row) const
{
  return contents_.list.constraints[*contents_.rows[row].constraint];
}

const ImportedPoint* ImportTable::point(int row) const
{
  return isReadable(row) ? points_[*contents_.rows[row].constraint] : nullptr;
}

void ImportTable::tickNear(double tolerance)
{
  tolerance_ = tolerance;
  for (int row = 0; row < rowCount(); ++row) isTicked_[row] = !isMarked(row);
}

void ImportTable::reportChange()
{
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Where));
}

QString ImportTable::text(int row, int column, bool isExact) const
{
  const ImportRow& of = contents_.rows[row];
  if (!of.constraint) return column == Name ? nameText(of.name) : column == Where ? of.fault : QString();
  const ImportedPoint* point = this->point(row);
  const auto number = [&](const auto& value) { return isExact ? exactText(value) : roundedText(value); };
  switch (column) {
    case Name: {
      const QString name = nameText(constraint(row).name);
      const std::string& newName = contents_.newNames[*of.constraint];
      return constraint(row).name == newName ? name : tr("%1 → %2").arg(name, nameText(newName));
    }
    case Kind:
      return kindText(constraint(row));
    case Place:
      return point == nullptr ? QString() : number(point->place);
    case Goal:
      return point == nullptr ? QString()
                              : number(placeOf(std::get<PointConstraint>(constraint(row).what), point->place));
    case Distance:
      return point == nullptr ? QString() : number(point->distance);
    default:
      return !of.fault.isEmpty() ? of.fault : point == nullptr ? whereText(constraint(row)) : locationText(point->at);
  }
}

QString ImportTable::toolTip(int row, int column) const
{
  QString exact = text(row, column, true);
  if (column == Distance && isFar(row))
    return tr("%1: farther from the surface than the tolerance. The point may be in another unit or coordinate "
              "system.")
        .arg(exact);
  if (!isReadable(row)) return contents_.rows[row].fault;
  const std::string& newName = contents_.newNames[*contents_.rows[row].constraint];
  if (column == Name && constraint(row).name != newName)
    return tr("The name is taken: the constraint will be called “%1”.").arg(nameText(newName));
  return exact;
}

}  // namespace holdfast

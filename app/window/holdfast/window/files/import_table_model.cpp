#include "holdfast/window/files/import_table_model.h"

#include <QGuiApplication>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <variant>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

constexpr Index kNoPoint = -1;

/// Where a point that lies at `place` is to go.
std::optional<Vector3> targetOf(const Constraint& constraint, const Vector3& place)
{
  const auto* point = std::get_if<PointConstraint>(&constraint.what);
  if (point == nullptr) return std::nullopt;
  if (const auto* target = std::get_if<Target>(&point->to)) return target->place;
  return Vector3(place + std::get<Move>(point->to).shift);
}

}  // namespace

ImportContents readImport(const std::filesystem::path& path, const ConstraintList& present, const Model& model)
{
  ImportContents contents;
  contents.list = readConstraints(path);
  contents.preview = previewImport(contents.list, present, model);
  const ConstraintList all = pasted(present, contents.list);
  for (std::size_t k = present.constraints.size(); k < all.constraints.size(); ++k)
    contents.newNames.push_back(all.constraints[k].name);
  return contents;
}

ConstraintList withImported(const ConstraintList& present, const ImportContents& contents,
                            const std::vector<Index>& rows)
{
  ConstraintList imported = extracted(contents.list, rows);
  for (std::size_t k = 0; k < rows.size(); ++k) imported.constraints[k].name = contents.newNames[rows[k]];
  return pasted(present, std::move(imported));
}

void ImportTableModel::setContents(ImportContents contents, double tolerance)
{
  beginResetModel();
  contents_ = std::move(contents);
  tolerance_ = tolerance;
  pointOfRow_.assign(contents_.list.constraints.size(), kNoPoint);
  for (std::size_t k = 0; k < contents_.preview.points.size(); ++k)
    pointOfRow_[contents_.preview.points[k].index] = static_cast<Index>(k);
  isTicked_.assign(pointOfRow_.size(), true);
  for (int row = 0; row < rowCount(); ++row) isTicked_[row] = !isFar(row);
  endResetModel();
  Q_EMIT ticksChanged();
}

void ImportTableModel::setTolerance(double tolerance)
{
  tolerance_ = tolerance;
  for (int row = 0; row < rowCount(); ++row) isTicked_[row] = !isFar(row);
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  Q_EMIT ticksChanged();
}

void ImportTableModel::tickAll(Qt::CheckState state)
{
  isTicked_.assign(isTicked_.size(), state == Qt::Checked);
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, Name), index(rowCount() - 1, Name), {Qt::CheckStateRole});
  Q_EMIT ticksChanged();
}

std::vector<Index> ImportTableModel::tickedRows() const
{
  std::vector<Index> rows;
  for (std::size_t row = 0; row < isTicked_.size(); ++row)
    if (isTicked_[row]) rows.push_back(static_cast<Index>(row));
  return rows;
}

Index ImportTableModel::farPoints() const
{
  const auto& points = contents_.preview.points;
  return std::count_if(points.begin(), points.end(),
                       [this](const ImportedPoint& point) { return point.distance > tolerance_; });
}

int ImportTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(contents_.list.constraints.size());
}

int ImportTableModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : ColumnCount;
}

const ImportedPoint* ImportTableModel::pointAt(int row) const
{
  return pointOfRow_[row] == kNoPoint ? nullptr : &contents_.preview.points[pointOfRow_[row]];
}

bool ImportTableModel::isFar(int row) const
{
  const ImportedPoint* point = pointAt(row);
  return point != nullptr && point->distance > tolerance_;
}

QString ImportTableModel::text(int row, int column, Digits digits) const
{
  const ImportedPoint* point = pointAt(row);
  const auto words = [&](const auto& number) {
    return digits == Digits::All ? exactText(number) : roundedText(number);
  };
  switch (column) {
    case Name: {
      const QString name = nameText(constraint(row).name);
      const std::string& newName = contents_.newNames[row];
      return constraint(row).name == newName ? name : tr("%1 → %2").arg(name, nameText(newName));
    }
    case Kind:
      return kindText(constraint(row));
    case Place:
      return point == nullptr ? QString() : words(point->place);
    case Target: {
      const auto target = point == nullptr ? std::nullopt : targetOf(constraint(row), point->place);
      return target ? words(*target) : QString();
    }
    case Distance:
      return point == nullptr ? QString() : words(point->distance);
    default:
      return point == nullptr ? whereText(constraint(row)) : locationText(point->at);
  }
}

QString ImportTableModel::toolTip(int row, int column) const
{
  if (column == Distance && isFar(row))
    return tr("%1: farther from the surface than the tolerance. The point may be in another unit or coordinate system.")
        .arg(text(row, column, Digits::All));
  if (column == Name && constraint(row).name != contents_.newNames[row])
    return tr("The name is taken: the constraint will be called “%1”.").arg(nameText(contents_.newNames[row]));
  return text(row, column, Digits::All);
}

QVariant ImportTableModel::data(const QModelIndex& index, int role) const
{
  if (!index.isValid()) return {};
  const int row = index.row();
  switch (role) {
    case Qt::DisplayRole:
      return text(row, index.column(), Digits::Few);
    case Qt::ToolTipRole:
      return toolTip(row, index.column());
    case Qt::CheckStateRole:
      return index.column() == Name ? QVariant(isTicked_[row] ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::ForegroundRole:
      return isFar(row) ? QVariant(statusColor(ConstraintStatus::Conflicting, lightnessOf(QGuiApplication::palette())))
                        : QVariant();
    case kSortRole: {
      if (index.column() != Distance) return text(row, index.column(), Digits::Few);
      const ImportedPoint* point = pointAt(row);
      return point == nullptr ? -1.0 : point->distance;
    }
    default:
      return {};
  }
}

QVariant ImportTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return QAbstractTableModel::headerData(section, orientation, role);
  const std::array<QString, ColumnCount> titles{tr("Name"),   tr("Kind"),     tr("Place"),
                                                tr("Target"), tr("Distance"), tr("On the surface")};
  return titles[static_cast<std::size_t>(section)];
}

Qt::ItemFlags ImportTableModel::flags(const QModelIndex& index) const
{
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.column() == Name ? usual | Qt::ItemIsUserCheckable : usual;
}

bool ImportTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  if (!index.isValid() || role != Qt::CheckStateRole || index.column() != Name) return false;
  isTicked_[index.row()] = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index, {role});
  Q_EMIT ticksChanged();
  return true;
}

}  // namespace holdfast

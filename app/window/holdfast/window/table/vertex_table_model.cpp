#include "holdfast/window/table/vertex_table_model.h"

#include <array>
#include <utility>

#include <holdfast/numbers/same_bits.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {

void VertexTableModel::show(std::shared_ptr<const DocumentState> state, Index constraint, std::optional<int> decimals)
{
  decimals_ = what_ == What::Targets ? decimals : std::nullopt;
  const auto& handle = std::get<HandleConstraint>(state->list.constraints[constraint].what);
  const bool isLonger = static_cast<int>(std::get<VertexIds>(handle.select.what).ids.size()) != rowCount();
  if (isLonger) beginResetModel();
  state_ = std::move(state);
  constraint_ = constraint;
  if (isLonger)
    endResetModel();
  else if (rowCount() > 0)
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

const HandleConstraint& VertexTableModel::handle() const
{
  return std::get<HandleConstraint>(state_->list.constraints[constraint_].what);
}

double VertexTableModel::number(int row, int column) const
{
  if (what_ == What::Targets) return std::get<VertexTargets>(handle().motion).places[row][column - X];
  const AxisAngle& turn = handle().rotations[row];
  return column == Degrees ? turn.degrees : turn.axis[column - X];
}

int VertexTableModel::rowCount(const QModelIndex& parent) const
{
  if (parent.isValid() || state_ == nullptr) return 0;
  return static_cast<int>(std::get<VertexIds>(handle().select.what).ids.size());
}

int VertexTableModel::columnCount(const QModelIndex& parent) const
{
  if (parent.isValid()) return 0;
  return what_ == What::Rotations ? Degrees + 1 : Z + 1;
}

QVariant VertexTableModel::data(const QModelIndex& index, int role) const
{
  if (!index.isValid()) return {};
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole) return {};
  if (index.column() == Vertex) return QString::number(vertex(index.row()));
  const double shown = number(index.row(), index.column());
  return role == Qt::DisplayRole ? coordinateText(shown, {{}, decimals_}) : exactText(shown);
}

QVariant VertexTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return QAbstractTableModel::headerData(section, orientation, role);
  const bool areAxes = what_ == What::Rotations;
  const std::array<QString, Degrees + 1> titles{tr("Vertex"), areAxes ? tr("Axis x") : tr("x"),
                                                areAxes ? tr("Axis y") : tr("y"), areAxes ? tr("Axis z") : tr("z"),
                                                tr("Degrees")};
  return titles[static_cast<std::size_t>(section)];
}

Qt::ItemFlags VertexTableModel::flags(const QModelIndex& index) const
{
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.column() == Vertex ? usual : usual | Qt::ItemIsEditable;
}

bool VertexTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  if (!index.isValid() || role != Qt::EditRole || index.column() == Vertex) return false;
  const std::optional<double> typed = typedNumber(value.toString());
  if (!typed) {
    Q_EMIT refused(notANumber(value.toString()));
    return false;
  }
  Q_EMIT righted();
  if (!hasSameBits(*typed, number(index.row(), index.column()))) Q_EMIT entered(index.row(), index.column(), *typed);
  return true;
}

}  // namespace holdfast

#include "holdfast/window/table/constraint_table_model.h"

#include <QBrush>
#include <QDataStream>
#include <QGuiApplication>
#include <QMimeData>
#include <algorithm>
#include <utility>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/numbers/same_bits.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

constexpr const char* kRowsFormat = "application/x-holdfast-constraint-rows";

const std::vector<Constraint>& constraintsOf(const std::shared_ptr<const DocumentState>& state)
{
  static const std::vector<Constraint> kNoConstraints;
  return state == nullptr ? kNoConstraints : state->list.constraints;
}

// The gravest first, as a user looks for them.
constexpr std::array<std::optional<ConstraintStatus>, 7> kRanks{
    ConstraintStatus::Conflicting, ConstraintStatus::Missed,      std::nullopt,
    ConstraintStatus::Redundant,   ConstraintStatus::Independent, ConstraintStatus::Met,
    ConstraintStatus::Disabled};

/// Of the row whose mark is under the cursor: fainter than what is selected.
QColor markedColor()
{
  QColor color = QGuiApplication::palette().color(QPalette::Highlight);
  color.setAlphaF(0.3);
  return color;
}

bool isCoordinate(int column)
{
  return column >= ConstraintTableModel::X && column <= ConstraintTableModel::Z;
}

bool isResult(int column)
{
  return column == ConstraintTableModel::Distance || column >= ConstraintTableModel::Residual;
}

/// Tells whether cells are nothing but digits.
bool isOfNumbers(int column)
{
  return column >= ConstraintTableModel::Distance && column < ConstraintTableModel::Status;
}

/// The numbers of constraints that two lists have in common at their beginnings and, in the rest, at their ends.
std::pair<std::size_t, std::size_t> commonEnds(const std::vector<Constraint>& a, const std::vector<Constraint>& b)
{
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t front = 0;
  while (front < shorter && a[front].name == b[front].name) ++front;
  std::size_t back = 0;
  while (back < shorter - front && a[a.size() - 1 - back].name == b[b.size() - 1 - back].name) ++back;
  return {front, back};
}

/// The rows of a drag that began in this program on this list.
Rows rowsOf(const QMimeData& data, const void* list)
{
  QDataStream stream(data.data(kRowsFormat));
  quint64 owner = 0;
  QVector<qint64> rows;
  stream >> owner >> rows;
  if (owner != reinterpret_cast<quintptr>(list)) return {};
  return {rows.begin(), rows.end()};
}

/// Tells whether the point is held along this coordinate by itself.
bool holds(const PointConstraint& point, Index axis)
{
  return point.directions().coordinates()[static_cast<std::size_t>(axis)];
}

}  // namespace

ConstraintTableModel::ConstraintTableModel(Editor& editor, QObject* parent)
    : QAbstractTableModel(parent), editor_(editor)
{
  connect(&editor, &Editor::opened, this, [this] {
    beginResetModel();
    shown_ = editor_.isOpen() ? editor_.history().state() : nullptr;
    endResetModel();
  });
  connect(&editor, &Editor::stateChanged, this, &ConstraintTableModel::follow);
  connect(&editor, &Editor::deformed, this, &ConstraintTableModel::resultsChanged);
  connect(&editor, &Editor::solveStateChanged, this, &ConstraintTableModel::resultsChanged);
  connect(&editor, &Editor::decimalsChanged, this, &ConstraintTableModel::follow);
  connect(&editor, &Editor::underCursorChanged, this, [this] {
    if (marked_ == editor_.underCursor().constraint) return;
    for (const auto& row : {std::exchange(marked_, editor_.underCursor().constraint), marked_})
      if (row && *row < rowCount())
        Q_EMIT dataChanged(index(static_cast<int>(*row), 0), index(static_cast<int>(*row), ColumnCount - 1),
                           {Qt::BackgroundRole});
  });
  if (editor.isOpen()) shown_ = editor.history().state();
}

int ConstraintTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(constraintsOf(shown_).size());
}

std::optional<double> ConstraintTableModel::coordinate(int row, int column) const
{
  if (const HandleConstraint* handle = std::get_if<HandleConstraint>(&constraint(row).what))
    return handle->translate[column - X];
  const PointConstraint* point = std::get_if<PointConstraint>(&constraint(row).what);
  if (point == nullptr || !holds(*point, column - X)) return std::nullopt;
  if (const Target* target = std::get_if<Target>(&point->to)) return target->place[column - X];
  const std::optional<Vector3> rest = restPlace(editor_, point->at);
  return rest ? std::optional(placeOf(*point, *rest)[column - X]) : std::nullopt;
}

std::optional<double> ConstraintTableModel::exactNumber(int row, int column) const
{
  if (isCoordinate(column)) return coordinate(row, column);
  const ConstraintOutcome* found = outcome(row);
  if (found == nullptr || !constraint(row).isEnabled) return std::nullopt;
  if (column == Distance) return found->nearDistance;
  if (column == Residual) return found->residual;
  return column == Force ? found->multiplier : std::nullopt;
}

std::optional<double> ConstraintTableModel::number(int row, int column) const
{
  if (column == On) return constraint(row).isEnabled ? 0 : 1;
  if (column == Status) return static_cast<double>(std::ranges::find(kRanks, status(row)) - kRanks.begin());
  return exactNumber(row, column);
}

QString ConstraintTableModel::text(int row, int column) const
{
  if (column == Name) return QString::fromStdString(printable(constraint(row).name));
  if (column == Kind) return kindText(constraint(row));
  if (column == Where) return whereText(constraint(row));
  if (column == Status) return statusText(status(row));
  const std::optional<double> number = exactNumber(row, column);
  if (!number) return {};
  if (isCoordinate(column) || column == Distance)
    return coordinateText(withoutNoise(*number, editor_.model()->solverMesh.diagonal), editor_.lengthStyle());
  return column == Residual ? residualText(*outcome(row)) : roundedText(*number);
}

QString ConstraintTableModel::residualText(const ConstraintOutcome& outcome) const
{
  if (isWithinLimit(outcome)) return metText(*outcome.limit, {});
  const std::optional<int> decimals = editor_.decimals();
  return decimals ? lengthText(*outcome.residual, {{}, decimals}) : shortText(*outcome.residual);
}

QVariant ConstraintTableModel::data(const QModelIndex& index, int role) const
{
  if (!index.isValid()) return {};
  const int row = index.row();
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return column == On ? QVariant() : text(row, column);
    case Qt::EditRole: {
      if (column == Name) return QString::fromStdString(constraint(row).name);
      const std::optional<double> number = exactNumber(row, column);
      return number ? exactText(*number) : text(row, column);
    }
    case Qt::CheckStateRole:
      return column == On ? QVariant(constraint(row).isEnabled ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::DecorationRole:
      return column == Status ? QVariant(statusIcon(status(row), QGuiApplication::palette())) : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant(isOfNumbers(column) ? static_cast<int>(Qt::AlignRight | Qt::AlignVCenter)
                                          : static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter));
    case Qt::BackgroundRole:
      return row == marked_ ? QVariant(QBrush(markedColor())) : QVariant();
    case Qt::ForegroundRole:
      if (constraint(row).isEnabled && (!isResult(column) || editor_.isCurrent())) return {};
      return quietColor(QGuiApplication::palette());
    case Qt::ToolTipRole:
      return plainTip(toolTip(row, column));
    case Qt::AccessibleTextRole:
      return column == On ? (constraint(row).isEnabled ? tr("enabled") : tr("disabled")) : text(row, column);
    default:
      return {};
  }
}

QString ConstraintTableModel::toolTip(int row, int column) const
{
  const std::optional<double> number = exactNumber(row, column);
  const QString exact = number ? exactText(*number) : QString();
  const bool isOld = isResult(column) && !editor_.isCurrent();
  const QString age = isOld ? tr("\nFrom before the latest edit.") : QString();
  if (column == On) return tr("Whether the constraint is enabled");
  if (column == Status) return statusMeaning(status(row)) + age;
  if (!number) return text(row, column);
  if (column == Residual && isWithinLimit(*outcome(row)))
    return tr("%1, within its limit of %2").arg(exact, exactText(*outcome(row)->limit)) + age;
  if (!isCoordinate(column)) return exact + age;
  const bool isHandle = std::holds_alternative<HandleConstraint>(constraint(row).what);
  return isHandle ? tr("%1, the handle's shift along %2").arg(exact, axisText(column - X))
                  : tr("%1, the target's %2").arg(exact, axisText(column - X));
}

QVariant ConstraintTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation == Qt::Vertical)
    return role == Qt::DisplayRole   ? QVariant(section + 1)
           : role == Qt::ToolTipRole ? QVariant(tr("Precedence: if constraints cannot all hold, the earlier ones do"))
                                     : QVariant();
  const QString units = shown_ == nullptr || shown_->list.units.empty()
                            ? QString()
                            : QString(" (%1)").arg(QString::fromStdString(shown_->list.units));
  const QString target = tr("Where a point goes%1; how far a handle is shifted").arg(units);
  const std::array<std::pair<QString, QString>, ColumnCount> titles{{
      {tr("On"), tr("Whether the constraint is enabled")},
      {tr("Name"), tr("The name in reports and messages")},
      {tr("Kind"), tr("What kind of constraint")},
      {tr("Where"), tr("The point or the vertices that it holds")},
      {tr("Distance"), tr("How far the surface is from the place that a point names by coordinates%1").arg(units)},
      {"x", target},
      {"y", target},
      {"z", target},
      {tr("Residual"), tr("Largest distance from where it should be%1").arg(units)},
      {tr("Force"), tr("How hard it pulls; only comparable within one solution")},
      {tr("Status"), tr("Whether it holds")},
  }};
  const auto& [title, meaning] = titles[static_cast<std::size_t>(section)];
  return role == Qt::DisplayRole ? QVariant(title) : role == Qt::ToolTipRole ? QVariant(plainTip(meaning)) : QVariant();
}

Qt::ItemFlags ConstraintTableModel::flags(const QModelIndex& index) const
{
  if (!index.isValid()) return Qt::ItemIsDropEnabled;
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren;
  if (index.column() == On) flags |= Qt::ItemIsUserCheckable;
  if (index.column() == Name || (isCoordinate(index.column()) && coordinate(index.row(), index.column())))
    flags |= Qt::ItemIsEditable;
  return flags;
}

bool ConstraintTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  return index.isValid() && setCells({index.row()}, index.column(), value, role);
}

bool ConstraintTableModel::setCells(const Rows& rows, int column, const QVariant& value, int role)
{
  if (rows.empty() || !isInStep()) return false;
  if (column == On && role == Qt::CheckStateRole) {
    switchConstraints(editor_, rows, value.toInt() == Qt::Checked ? Enabling::Enabled : Enabling::Disabled);
    return true;
  }
  if (role != Qt::EditRole) return false;
  if (column == Name) return rename(rows.front(), value.toString());
  return isCoordinate(column) && setCoordinate(rows, column, value.toString());
}

bool ConstraintTableModel::rename(Index row, const QString& name)
{
  try {
    renameConstraint(editor_, row, name);
    Q_EMIT righted();
    return true;
  } catch (const InputError& error) {
    Q_EMIT refused(QString::fromStdString(error.reason()));
    return false;
  }
}

bool ConstraintTableModel::setCoordinate(const Rows& rows, int column, const QString& typed)
{
  const std::optional<double> value = typedNumber(typed);
  if (!value) {
    Q_EMIT refused(notANumber(typed));
    return false;
  }
  Q_EMIT righted();
  const Index axis = column - X;
  const QString name = tr("move %1 to %2 = %3").arg(subjectOf(editor_, rows), axisText(column - X), exactText(*value));
  changeConstraints(editor_, name, rows, [&](Constraint constraint) -> std::optional<Constraint> {
    if (HandleConstraint* handle = std::get_if<HandleConstraint>(&constraint.what)) {
      if (hasSameBits(handle->translate[axis], *value)) return std::nullopt;
      handle->translate[axis] = *value;
      return constraint;
    }
    PointConstraint* point = std::get_if<PointConstraint>(&constraint.what);
    const std::optional<Vector3> rest = point == nullptr ? std::nullopt : restPlace(editor_, point->at);
    if (!rest || !holds(*point, axis)) return std::nullopt;
    Vector3 place = placeOf(*point, *rest);
    if (hasSameBits(place[axis], *value)) return std::nullopt;
    place[axis] = *value;
    point->setTarget(place, [&](const SurfaceLocation& /*at*/) { return *rest; });
    return constraint;
  });
  return true;
}

QStringList ConstraintTableModel::mimeTypes() const
{
  return {kRowsFormat};
}

QMimeData* ConstraintTableModel::mimeData(const QModelIndexList& indexes) const
{
  Rows rows;
  for (const QModelIndex& index : indexes) rows.push_back(index.row());
  rows = sortedOnce(std::move(rows));
  QByteArray bytes;
  QDataStream stream(&bytes, QIODevice::WriteOnly);
  stream << static_cast<quint64>(reinterpret_cast<quintptr>(shown_.get())) << QVector<qint64>(rows.begin(), rows.end());
  auto* data = new QMimeData;
  data->setData(kRowsFormat, bytes);
  return data;
}

bool ConstraintTableModel::canDropMimeData(const QMimeData* data, Qt::DropAction action, int /*row*/, int /*column*/,
                                           const QModelIndex& parent) const
{
  return action == Qt::MoveAction && !parent.isValid() && data->hasFormat(kRowsFormat) &&
         !rowsOf(*data, shown_.get()).empty();
}

bool ConstraintTableModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                        const QModelIndex& parent)
{
  if (!canDropMimeData(data, action, row, column, parent)) return false;
  moveConstraints(editor_, rowsOf(*data, shown_.get()), row < 0 ? rowCount() : row);
  return true;
}

/// Leaves rows in front and at the end as they are, so that views keep their place.
void ConstraintTableModel::follow()
{
  const std::shared_ptr<const DocumentState> next = editor_.history().state();
  const auto& before = constraintsOf(shown_);
  const auto& after = next->list.constraints;
  const auto [front, back] = commonEnds(before, after);
  const std::size_t kept = front + back;
  if (before.size() != after.size() && kept == before.size()) {
    beginInsertRows({}, static_cast<int>(front), static_cast<int>(after.size() - back) - 1);
    shown_ = next;
    endInsertRows();
  } else if (before.size() != after.size() && kept == after.size()) {
    beginRemoveRows({}, static_cast<int>(front), static_cast<int>(before.size() - back) - 1);
    shown_ = next;
    endRemoveRows();
  } else if (before.size() != after.size()) {
    beginResetModel();
    shown_ = next;
    endResetModel();
  }
  shown_ = next;
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void ConstraintTableModel::resultsChanged()
{
  // Not of columns between them: what is being typed there would be lost.
  for (const auto& [first, last] : {std::pair(Distance, Distance), std::pair(Residual, Status)})
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, first), index(rowCount() - 1, last));
}

}  // namespace holdfast

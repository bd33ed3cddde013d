#include "holdfast/window/table/constraint_table.h"

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/table/constraint_table_model.h>

namespace holdfast {
namespace {

bool setsValue(int column, const QEvent& event)
{
  const bool isMouse = event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonRelease ||
                       event.type() == QEvent::MouseButtonDblClick;
  return isMouse && static_cast<const QMouseEvent&>(event).modifiers() == Qt::NoModifier &&
         (column == ConstraintTableModel::On ||
          (column >= ConstraintTableModel::X && column <= ConstraintTableModel::Z));
}

}  // namespace

ConstraintTable::ConstraintTable(QWidget* parent) : QTableView(parent)
{
  setSelectionBehavior(SelectRows);
  setSelectionMode(ExtendedSelection);
  setEditTriggers(DoubleClicked | EditKeyPressed);
  setTableLook(*this);
  setDragEnabled(true);
  setDragDropMode(DragDrop);
  setDefaultDropAction(Qt::MoveAction);
  // A drop goes between rows, and what was dragged is not removed by the view.
  setDragDropOverwriteMode(false);
  setDropIndicatorShown(true);
  horizontalHeader()->setSectionsClickable(true);
  horizontalHeader()->setSortIndicatorShown(false);
  connect(horizontalHeader(), &QHeaderView::sectionClicked, this, &ConstraintTable::cycleSorting);
}

void ConstraintTable::setEmptyText(const QString& text)
{
  emptyText_ = text;
  viewport()->update();
}

void ConstraintTable::cycleSorting(int column)
{
  const bool isSame = column == sortedColumn_;
  const bool isThird = isSame && order_ == Qt::DescendingOrder;
  order_ = isSame && !isThird ? Qt::DescendingOrder : Qt::AscendingOrder;
  sortedColumn_ = isThird ? -1 : column;
  horizontalHeader()->setSortIndicatorShown(sortedColumn_ >= 0);
  horizontalHeader()->setSortIndicator(sortedColumn_, order_);
  Q_EMIT sortAsked(sortedColumn_, order_);
}

QAction* ConstraintTable::actionOf(const QKeyEvent& event) const
{
  const QKeySequence keys(event.key() | static_cast<int>(event.modifiers() & ~Qt::KeypadModifier));
  for (QAction* action : actions())
    if (action->shortcuts().contains(keys)) return action;
  return nullptr;
}

bool ConstraintTable::event(QEvent* event)
{
  if (event->type() == QEvent::ShortcutOverride && actionOf(static_cast<QKeyEvent&>(*event)) != nullptr) {
    event->accept();
    return true;
  }
  return QTableView::event(event);
}

void ConstraintTable::keyPressEvent(QKeyEvent* event)
{
  QAction* action = actionOf(*event);
  if (action == nullptr) return QTableView::keyPressEvent(event);
  action->trigger();
  event->accept();
}

void ConstraintTable::paintEvent(QPaintEvent* event)
{
  QTableView::paintEvent(event);
  if (model() == nullptr || model()->rowCount() > 0) return;
  QPainter painter(viewport());
  painter.setPen(quietColor(palette()));
  const int margin = 2 * fontMetrics().height();
  painter.drawText(viewport()->rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                   emptyText_);
}

QItemSelectionModel::SelectionFlags ConstraintTable::selectionCommand(const QModelIndex& index,
                                                                      const QEvent* event) const
{
  if (event != nullptr && index.isValid() && setsValue(index.column(), *event) && selectionModel()->isSelected(index))
    return QItemSelectionModel::NoUpdate;
  return QTableView::selectionCommand(index, event);
}

}  // namespace holdfast

#include "holdfast/window/table/constraint_table.h"

#include <QAction>
#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStyle>
#include <QStyledItemDelegate>
#include <algorithm>
#include <optional>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/table/constraint_table_model.h>
#include <holdfast/window/text/number_text.h>

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

bool keepsSelection(const QTableView& table, const QModelIndex& index, const QEvent* event)
{
  return event != nullptr && index.isValid() && setsValue(index.column(), *event) &&
         table.selectionModel()->isSelected(index);
}

bool staysInSight(int column)
{
  return column == ConstraintTableModel::On || column == ConstraintTableModel::Name;
}

/// A number has as many digits as there is room for, and is never cut: what is left of 55.673 would read as 5.673.
class NumberCells : public QStyledItemDelegate {
 public:
  explicit NumberCells(ConstraintTable& table) : QStyledItemDelegate(&table), table_(table) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    QStyleOptionViewItem seen = option;
    seen.rect = table_.seenPart(option.rect);
    if (!seen.rect.isEmpty()) QStyledItemDelegate::paint(painter, seen, index);
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
  {
    QStyledItemDelegate::initStyleOption(option, index);
    const std::optional<double> number = typedNumber(index.data(Qt::EditRole).toString());
    if (!number) return;
    // Styles leave this margin free beside a text.
    const int margin = option->widget->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, option, option->widget) + 1;
    const int room = option->rect.width() - 2 * margin;
    option->text = fittingText(*number, option->text, [&](const QString& text) {
      return option->fontMetrics.horizontalAdvance(text) <= room;
    });
  }

 private:
  ConstraintTable& table_;
};

class PinnedColumns : public QTableView {
 public:
  using QTableView::QTableView;

 protected:
  [[nodiscard]] QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                                     const QEvent* event) const override
  {
    if (keepsSelection(*this, index, event)) return QItemSelectionModel::NoUpdate;
    return QTableView::selectionCommand(index, event);
  }
};

void setSelecting(QTableView& table)
{
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::ExtendedSelection);
  table.horizontalHeader()->setSectionsClickable(true);
  table.setTextElideMode(Qt::ElideMiddle);
  setTableLook(table);
}

}  // namespace

ConstraintTable::ConstraintTable(QWidget* parent) : QTableView(parent), pinned_(new PinnedColumns(this))
{
  setSelecting(*this);
  setSelecting(*pinned_);
  pinned_->hide();
  pinned_->setFocusPolicy(Qt::NoFocus);
  pinned_->setContextMenuPolicy(Qt::NoContextMenu);
  pinned_->setEditTriggers(NoEditTriggers);
  pinned_->setFrameShape(NoFrame);
  pinned_->setStyleSheet("QTableView { border-right: 1px solid palette(mid); }");
  pinned_->verticalHeader()->hide();
  pinned_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  pinned_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setHorizontalScrollMode(ScrollPerPixel);
  auto* numbers = new NumberCells(*this);
  for (int column = ConstraintTableModel::X; column <= ConstraintTableModel::Force; ++column)
    setItemDelegateForColumn(column, numbers);
  connect(verticalScrollBar(), &QScrollBar::valueChanged, pinned_->verticalScrollBar(), &QScrollBar::setValue);
  connect(pinned_->verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(), &QScrollBar::setValue);
  connect(horizontalScrollBar(), &QScrollBar::valueChanged, this, [this] {
    placePinned();
    // Other parts of the cells at the edges are seen; Qt would shift their pictures.
    viewport()->update();
  });
  connect(pinned_->horizontalHeader(), &QHeaderView::sectionClicked, this, &ConstraintTable::cycleSorting);
  // In the table itself, which scrolls back for it.
  connect(pinned_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    if (index.column() == ConstraintTableModel::Name) edit(index);
  });
  setEditTriggers(DoubleClicked | EditKeyPressed);
  setDragEnabled(true);
  setDragDropMode(DragDrop);
  setDefaultDropAction(Qt::MoveAction);
  // A drop goes between rows, and what was dragged is not removed by the view.
  setDragDropOverwriteMode(false);
  setDropIndicatorShown(true);
  horizontalHeader()->setSortIndicatorShown(false);
  connect(horizontalHeader(), &QHeaderView::sectionClicked, this, &ConstraintTable::cycleSorting);
}

void ConstraintTable::setModel(QAbstractItemModel* model)
{
  QTableView::setModel(model);
  pinned_->setModel(model);
  pinned_->setSelectionModel(selectionModel());
  for (int column = 0; column < model->columnCount(); ++column) pinned_->setColumnHidden(column, !staysInSight(column));
}

void ConstraintTable::updateGeometries()
{
  QTableView::updateGeometries();
  placePinned();
}

void ConstraintTable::placePinned()
{
  int width = 0;
  for (const int column : {ConstraintTableModel::On, ConstraintTableModel::Name}) {
    pinned_->setColumnWidth(column, columnWidth(column));
    width += columnWidth(column);
  }
  const QRect cells = viewport()->geometry();
  pinned_->setGeometry(cells.left(), frameWidth(), width, cells.bottom() + 1 - frameWidth());
  pinned_->horizontalHeader()->setFixedHeight(horizontalHeader()->height());
  pinned_->setVisible(horizontalScrollBar()->value() > 0 && width < cells.width() / 2);
}

void ConstraintTable::scrollTo(const QModelIndex& index, ScrollHint hint)
{
  QTableView::scrollTo(index, hint);
  const int hidden = pinned_->width() - visualRect(index).left();
  if (pinned_->isVisible() && !staysInSight(index.column()) && hidden > 0)
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - hidden);
}

QRect ConstraintTable::seenPart(QRect cell) const
{
  const int left = pinned_->isVisible() ? pinned_->width() : 0;
  cell.setLeft(std::max(cell.left(), left));
  cell.setRight(std::min(cell.right(), viewport()->width() - 1));
  return cell;
}

void ConstraintTable::keyboardSearch(const QString& search)
{
  if (currentIndex().column() == ConstraintTableModel::Name) QTableView::keyboardSearch(search);
}

void ConstraintTable::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint)
{
  QTableView::closeEditor(editor, hint);
  if (hint == QAbstractItemDelegate::RevertModelCache) Q_EMIT editTakenBack();
  // In a table that is sorted the row has gone where the number belongs.
  scrollTo(currentIndex());
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

bool ConstraintTable::beginsNumber(const QKeyEvent& event) const
{
  const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  const bool isOfNumber = event.text().size() == 1 && QStringLiteral("0123456789-.").contains(event.text());
  const int column = currentIndex().column();
  return isPlain && isOfNumber && state() != EditingState && column >= ConstraintTableModel::X &&
         column <= ConstraintTableModel::Z && (currentIndex().flags() & Qt::ItemIsEditable) != 0;
}

bool ConstraintTable::event(QEvent* event)
{
  // A menu may have the sign of a number as its key.
  if (event->type() == QEvent::ShortcutOverride &&
      (actionOf(static_cast<QKeyEvent&>(*event)) != nullptr || beginsNumber(static_cast<QKeyEvent&>(*event)))) {
    event->accept();
    return true;
  }
  return QTableView::event(event);
}

void ConstraintTable::keyPressEvent(QKeyEvent* event)
{
  if (beginsNumber(*event)) {
    edit(currentIndex());
    // All of it is selected, and gives way.
    if (QWidget* line = indexWidget(currentIndex())) QCoreApplication::sendEvent(line, event);
    return;
  }
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
  if (keepsSelection(*this, index, event)) return QItemSelectionModel::NoUpdate;
  return QTableView::selectionCommand(index, event);
}

}  // namespace holdfast

#include "holdfast/window/table/constraint_panel.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <stdexcept>

#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

using Table = ConstraintTableModel;

QToolButton* toolButton(QAction* action, Qt::ArrowType arrow, const char* name)
{
  QToolButton* button = new QToolButton;
  button->setDefaultAction(action);
  button->setArrowType(arrow);
  button->setAutoRaise(true);
  button->setAccessibleName(action->text().remove('&'));
  button->setObjectName(name);
  return button;
}

/// The rows of a selection, which ranges of whole rows make up.
Rows rowsIn(const QItemSelection& selection)
{
  Rows rows;
  for (const QItemSelectionRange& range : selection)
    for (int row = range.top(); row <= range.bottom(); ++row) rows.push_back(row);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

}  // namespace

ConstraintPanel::ConstraintPanel(Editor& editor, QWidget* parent)
    : QWidget(parent), editor_(editor), model_(editor), filter_(editor, model_)
{
  setObjectName("constraintPanel");
  QVBoxLayout* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);
  makeTable();
  makeActions();
  makeTopLine();
  reason_ = new QLabel;
  reason_->setObjectName("constraintRefusal");
  reason_->setWordWrap(true);
  reason_->setVisible(false);
  layout->addWidget(reason_);
  layout->addWidget(table_);
  count_ = new QLabel;
  count_->setObjectName("constraintCount");
  layout->addWidget(count_);

  connect(&model_, &Table::refused, this, &ConstraintPanel::refuse);
  connect(&editor_, &Editor::opened, this, [this] {
    table_->horizontalScrollBar()->setValue(0);
    showSelection();
  });
  connect(&editor_, &Editor::stateChanged, this, [this] {
    reason_->setVisible(false);
    showSelection();
  });
  connect(&editor_, &Editor::constraintSelectionChanged, this, &ConstraintPanel::showSelection);
  showSelection();
}

void ConstraintPanel::makeTable()
{
  table_ = new ConstraintTable;
  table_->setObjectName("constraintTable");
  table_->setAccessibleName(tr("Constraints, in the order of precedence"));
  // Rows that leave or join the table are told of here before the view hears of them.
  const auto comeAndGo = [this](const QModelIndex&, int, int) { isShowing_ = true; };
  connect(&filter_, &QAbstractItemModel::rowsAboutToBeRemoved, this, comeAndGo);
  connect(&filter_, &QAbstractItemModel::rowsAboutToBeInserted, this, comeAndGo);
  table_->setModel(&filter_);
  const auto stay = [this](const QModelIndex&, int, int) {
    isShowing_ = false;
    settled_.start();
  };
  connect(&filter_, &QAbstractItemModel::rowsRemoved, this, stay);
  connect(&filter_, &QAbstractItemModel::rowsInserted, this, stay);
  // Rows come and go in many pieces; the selection is shown once they are done.
  settled_.setSingleShot(true);
  settled_.setInterval(0);
  connect(&settled_, &QTimer::timeout, this, &ConstraintPanel::showSelection);

  const int wide = table_->fontMetrics().horizontalAdvance('0');
  const std::vector<std::pair<int, int>> widths = {
      {Table::On, 4}, {Table::Name, 17}, {Table::Kind, 8},     {Table::Where, 20}, {Table::X, 11},
      {Table::Y, 11}, {Table::Z, 11},    {Table::Residual, 9}, {Table::Force, 8},  {Table::Status, 13}};
  for (const auto& [column, characters] : widths) table_->setColumnWidth(column, characters * wide);
  QHeaderView& titles = *table_->horizontalHeader();
  // A narrow panel shows first what is read and typed most.
  int place = 0;
  for (const int column : {Table::On, Table::Name, Table::Status, Table::X, Table::Y, Table::Z})
    titles.moveSection(titles.visualIndex(column), place++);
  titles.setStretchLastSection(true);
  connect(table_, &ConstraintTable::sortAsked, this, [this](int column, Qt::SortOrder order) {
    filter_.sort(column, order);
    updateActions();
  });
  connect(table_, &ConstraintTable::precedenceAsked, this, [this] {
    filter_.sort(-1);
    updateActions();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ConstraintPanel::takeSelection);
  connect(table_, &QAbstractItemView::doubleClicked, this, [this](const QModelIndex& index) {
    if (!(index.flags() & Qt::ItemIsEditable) && index.column() != Table::On)
      Q_EMIT activated(filter_.mapToSource(index).row());
  });
}

void ConstraintPanel::makeTopLine()
{
  text_ = new QLineEdit;
  text_->setObjectName("constraintFilter");
  text_->setPlaceholderText(tr("Find by name, kind or place"));
  text_->setAccessibleName(tr("Find constraints"));
  text_->setClearButtonEnabled(true);
  status_ = new QComboBox;
  status_->setObjectName("constraintStatusFilter");
  status_->setAccessibleName(tr("Status of the constraints shown"));
  for (const auto& [title, status] :
       std::initializer_list<std::pair<QString, StatusFilter>>{{tr("Any status"), StatusFilter::All},
                                                               {tr("Conflicting"), StatusFilter::Conflicting},
                                                               {tr("Missed"), StatusFilter::Missed},
                                                               {tr("Redundant"), StatusFilter::Redundant},
                                                               {tr("Met"), StatusFilter::Met},
                                                               {tr("Disabled"), StatusFilter::Disabled},
                                                               {tr("Not solved"), StatusFilter::Unsolved}})
    status_->addItem(title, static_cast<int>(status));
  connect(text_, &QLineEdit::textChanged, this, &ConstraintPanel::filtersChanged);
  connect(status_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ConstraintPanel::filtersChanged);

  QMenu* menu = new QMenu(this);
  menu->addActions(table_->actions());
  QToolButton* more = new QToolButton;
  more->setObjectName("constraintMenu");
  // The style's own sign of a menu is cut off beside a text.
  more->setText(tr("Edit") + QStringLiteral(" \u25be"));
  more->setStyleSheet("QToolButton::menu-indicator { image: none; }");
  more->setAccessibleName(tr("Edit the selected constraints"));
  more->setAutoRaise(true);
  more->setPopupMode(QToolButton::InstantPopup);
  more->setMenu(menu);

  QHBoxLayout* line = new QHBoxLayout;
  line->setSpacing(6);
  line->addWidget(text_, 1);
  line->addWidget(status_);
  line->addWidget(toolButton(up_, Qt::UpArrow, "constraintUp"));
  line->addWidget(toolButton(down_, Qt::DownArrow, "constraintDown"));
  line->addWidget(more);
  static_cast<QVBoxLayout*>(layout())->insertLayout(0, line);
}

QAction* ConstraintPanel::makeAction(const QString& text, const QKeySequence& keys, const char* name,
                                     const QString& tip, void (ConstraintPanel::*run)())
{
  QAction* action = new QAction(text, this);
  action->setObjectName(name);
  action->setShortcut(keys);
  action->setToolTip(tip);
  // Pressed keys are found by the table: menus of a window may use the same ones.
  action->setShortcutContext(Qt::WidgetShortcut);
  action->setShortcutVisibleInContextMenu(true);
  connect(action, &QAction::triggered, this, run);
  table_->addAction(action);
  return action;
}

void ConstraintPanel::separate()
{
  QAction* separator = new QAction(this);
  separator->setSeparator(true);
  table_->addAction(separator);
}

void ConstraintPanel::makeActions()
{
  using Panel = ConstraintPanel;
  needSelection_.push_back(makeAction(tr("&Switch On or Off"), Qt::Key_Space, "constraintSwitch",
                                      tr("Switches the selected constraints off, or on again"),
                                      &Panel::switchSelected));
  needSelection_.push_back(makeAction(tr("Re&name"), {}, "constraintRename",
                                      tr("Gives the current constraint another name"), &Panel::rename));
  separate();
  up_ = makeAction(tr("Move &Up"), QKeySequence(QStringLiteral("Alt+Up")), "constraintMoveUp",
                   tr("Gives the selected constraints precedence over the one above"), &Panel::moveSelectedUp);
  down_ = makeAction(tr("Move Do&wn"), QKeySequence(QStringLiteral("Alt+Down")), "constraintMoveDown",
                     tr("Gives the one below precedence over the selected constraints"), &Panel::moveSelectedDown);
  separate();
  needSelection_.push_back(makeAction(tr("&Copy"), QKeySequence::Copy, "constraintCopy",
                                      tr("Copies the selected constraints: points as a table"), &Panel::copySelected));
  makeAction(tr("&Paste"), QKeySequence::Paste, "constraintPaste",
             tr("Adds the constraints or the table of points that were copied"), &Panel::paste);
  needSelection_.push_back(makeAction(tr("&Duplicate"), QKeySequence(QStringLiteral("Ctrl+D")), "constraintDuplicate",
                                      tr("Adds the selected constraints once more"), &Panel::duplicateSelected));
  needSelection_.push_back(makeAction(tr("De&lete"), QKeySequence::Delete, "constraintDelete",
                                      tr("Deletes the selected constraints"), &Panel::removeSelected));
  separate();
  makeAction(tr("Select &All"), QKeySequence::SelectAll, "constraintSelectAll",
             tr("Selects all constraints that are shown"), &Panel::selectAll);
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void ConstraintPanel::find()
{
  text_->setFocus();
  text_->selectAll();
}

void ConstraintPanel::rename()
{
  const QModelIndex current = table_->currentIndex();
  if (current.isValid()) table_->edit(current.siblingAtColumn(Table::Name));
}

void ConstraintPanel::attempt(const std::function<void()>& run)
{
  if (!editor_.isOpen()) return;
  try {
    run();
  } catch (const std::runtime_error& error) {
    refuse(QString::fromStdString(error.what()));
  }
}

void ConstraintPanel::switchSelected()
{
  const Rows& rows = editor_.selectedConstraints();
  const auto& constraints = editor_.list().constraints;
  const bool areOn = std::all_of(rows.begin(), rows.end(), [&](Index row) { return constraints[row].isEnabled; });
  areOn ? disableConstraints(editor_, rows) : enableConstraints(editor_, rows);
}

void ConstraintPanel::removeSelected()
{
  removeConstraints(editor_, Rows(editor_.selectedConstraints()));
}

void ConstraintPanel::duplicateSelected()
{
  duplicateConstraints(editor_, Rows(editor_.selectedConstraints()));
}

void ConstraintPanel::moveSelectedUp()
{
  moveConstraintsUp(editor_, Rows(editor_.selectedConstraints()));
}

void ConstraintPanel::moveSelectedDown()
{
  moveConstraintsDown(editor_, Rows(editor_.selectedConstraints()));
}

void ConstraintPanel::copySelected()
{
  attempt([this] { copyConstraints(editor_, editor_.selectedConstraints()); });
}

void ConstraintPanel::paste()
{
  attempt([this] { pasteConstraints(editor_); });
}

void ConstraintPanel::selectAll()
{
  table_->selectAll();
}

void ConstraintPanel::takeSelection()
{
  if (isShowing_ || !model_.isInStep()) return;
  editor_.selectConstraints(rowsIn(filter_.mapSelectionToSource(table_->selectionModel()->selection())));
  updateActions();
}

void ConstraintPanel::showSelection()
{
  if (isShowing_ || !model_.isInStep()) return;
  const QScopedValueRollback<bool> showing(isShowing_, true);
  Rows rows;
  for (const Index constraint : editor_.selectedConstraints())
    if (const int row = filter_.visibleRow(constraint); row >= 0) rows.push_back(row);
  std::sort(rows.begin(), rows.end());
  QItemSelectionModel& shown = *table_->selectionModel();
  if (rows != rowsIn(shown.selection())) {
    QItemSelection selection;
    for (std::size_t first = 0, last = 0; first < rows.size(); first = ++last) {
      while (last + 1 < rows.size() && rows[last + 1] == rows[last] + 1) ++last;
      selection.append({filter_.index(static_cast<int>(rows[first]), 0),
                        filter_.index(static_cast<int>(rows[last]), Table::Status)});
    }
    shown.select(selection, QItemSelectionModel::ClearAndSelect);
    if (!rows.empty() && !std::binary_search(rows.begin(), rows.end(), table_->currentIndex().row())) {
      const QModelIndex first = filter_.index(static_cast<int>(rows.front()), Table::Name);
      shown.setCurrentIndex(first, QItemSelectionModel::NoUpdate);
      table_->scrollTo(first);
    }
  }
  updateActions();
  updateTexts();
}

void ConstraintPanel::filtersChanged()
{
  filter_.setText(text_->text());
  filter_.setStatus(static_cast<StatusFilter>(status_->currentData().toInt()));
  // What the user cannot see is not what he means to change.
  Rows visible;
  for (const Index constraint : editor_.selectedConstraints())
    if (filter_.visibleRow(constraint) >= 0) visible.push_back(constraint);
  editor_.selectConstraints(std::move(visible));
  updateTexts();
}

void ConstraintPanel::updateActions()
{
  const bool isAny = editor_.isOpen() && !editor_.selectedConstraints().empty();
  for (QAction* action : needSelection_) action->setEnabled(isAny);
  up_->setEnabled(isAny && !filter_.isSorted());
  down_->setEnabled(isAny && !filter_.isSorted());
}

void ConstraintPanel::updateTexts()
{
  const int all = model_.rowCount();
  const int shown = filter_.rowCount();
  const auto selected = editor_.selectedConstraints().size();
  table_->setEmptyText(!editor_.isOpen() ? tr("No mesh is open.")
                       : all == 0 ? tr("No constraints yet.\n\nPick a point on the surface, paste a point list, or "
                                       "open a constraint file.")
                                  : tr("Nothing matches.\n\nClear the filter to see all constraints."));
  QString text = all == 1 ? tr("1 constraint") : tr("%1 constraints").arg(countText(all));
  if (shown != all) text += tr(", %1 shown").arg(countText(shown));
  if (selected > 1) text += tr(", %1 selected").arg(countText(static_cast<Index>(selected)));
  count_->setText(text);
}

void ConstraintPanel::refuse(const QString& reason)
{
  const QColor color = statusColor(ConstraintStatus::Conflicting, lightnessOf(palette()));
  QPalette own = palette();
  own.setColor(QPalette::WindowText, color);
  reason_->setPalette(own);
  reason_->setText(reason);
  reason_->setVisible(true);
}

}  // namespace holdfast

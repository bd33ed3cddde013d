#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <stdexcept>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/table/constraint_filter.h>
#include <holdfast/window/table/constraint_table.h>
#include <holdfast/window/table/constraint_table_model.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

using Table = ConstraintTableModel;

// The entries of the filter after "Any status".
constexpr std::array<std::optional<ConstraintStatus>, 6> kStatuses{
    ConstraintStatus::Conflicting, ConstraintStatus::Missed,   ConstraintStatus::Redundant,
    ConstraintStatus::Met,         ConstraintStatus::Disabled, std::nullopt};

QToolButton* toolButton(QAction* action, Qt::ArrowType arrow, const char* name)
{
  auto* button = new QToolButton;
  button->setDefaultAction(action);
  button->setArrowType(arrow);
  button->setAutoRaise(true);
  named(button, name, action->text().remove('&'));
  return button;
}

Rows rowsIn(const QItemSelection& selection)
{
  Rows rows;
  for (const QItemSelectionRange& range : selection)
    for (int row = range.top(); row <= range.bottom(); ++row) rows.push_back(row);
  return sortedOnce(std::move(rows));
}

class ConstraintPanel : public QWidget {
 public:
  ConstraintPanel(Editor& editor, const std::function<void(Index)>& activated)
      : editor_(editor), activated_(activated), model_(editor), filter_(editor, model_)
  {
    setObjectName("constraintPanel");
    auto* layout = newLayout<QVBoxLayout>(this, 6, 6);
    makeTable();
    makeActions();
    makeTopLine();
    // Below the table, so that no row moves.
    reason_ = newText("constraintRefusal");
    reason_->setVisible(false);
    count_ = named(new QLabel, "constraintCount");
    for (QWidget* widget : std::initializer_list<QWidget*>{table_, reason_, count_}) layout->addWidget(widget);

    connect(&model_, &Table::refused, this, [this](const QString& reason) { showRefusal(*reason_, reason); });
    connect(&model_, &Table::righted, reason_, &QWidget::hide);
    connect(table_, &ConstraintTable::editTakenBack, reason_, &QWidget::hide);
    connect(&editor_, &Editor::opened, this, [this] {
      reason_->setVisible(false);
      // What was looked for was in the document before.
      text_->clear();
      status_->setCurrentIndex(0);
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

 private:
  void makeTopLine()
  {
    text_ = named(new QLineEdit, "constraintFilter", tr("Find constraints"));
    text_->setPlaceholderText(tr("Find by name, kind or place"));
    text_->setClearButtonEnabled(true);
    status_ = named(new QComboBox, "constraintStatusFilter", tr("Status of the constraints shown"));
    status_->addItem(tr("Any status"));
    for (const auto& status : kStatuses) {
      const QString text = statusText(status);
      status_->addItem(text.left(1).toUpper() + text.mid(1));
    }
    connect(text_, &QLineEdit::textChanged, this, &ConstraintPanel::filtersChanged);
    connect(status_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ConstraintPanel::filtersChanged);

    auto* menu = new QMenu(this);
    menu->addActions(table_->actions());
    menu->addSeparator();
    menu->addMenu(tr("Col&umns"))->addActions(table_->horizontalHeader()->actions());
    auto* more = named(new QToolButton, "constraintMenu", tr("Edit the selected constraints"));
    // The style cuts its own sign of a menu off beside a text, and a style sheet would keep the colours of one theme.
    more->setText(tr("Edit") + QStringLiteral(" \u25be"));
    more->setAutoRaise(true);
    connect(more, &QToolButton::clicked, menu, [=] { menu->popup(more->mapToGlobal(more->rect().bottomLeft())); });

    auto* line = newLayout<QHBoxLayout>(nullptr, 0, 6,
                                        {text_, status_, toolButton(up_, Qt::UpArrow, "constraintUp"),
                                         toolButton(down_, Qt::DownArrow, "constraintDown"), more});
    line->setStretch(0, 1);
    static_cast<QVBoxLayout*>(layout())->insertLayout(0, line);
  }

  void makeTable()
  {
    table_ = named(new ConstraintTable, "constraintTable", tr("Constraints, in the order of precedence"));
    // Connected before the view is, which changes the selection when rows leave or join the table.
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
    int sized = 0;
    for (const double characters : {3.0, 12.5, 8.0, 20.0, 8.3, 8.3, 8.3, 8.3, 7.5, 8.0, 12.0})
      table_->setColumnWidth(sized++, static_cast<int>(characters * wide));
    QHeaderView& titles = *table_->horizontalHeader();
    // A narrow panel shows first what is read and typed most.
    int place = 0;
    for (const int first : {Table::On, Table::Name, Table::X, Table::Y, Table::Z, Table::Residual, Table::Status})
      titles.moveSection(titles.visualIndex(first), place++);
    titles.setStretchLastSection(true);
    makeColumnChoice(titles);
    connect(table_, &ConstraintTable::sortAsked, this, [this](int column, Qt::SortOrder order) {
      filter_.sort(column, order);
      updateActions();
    });
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ConstraintPanel::takeSelection);
    connect(table_, &QAbstractItemView::doubleClicked, this, [this](const QModelIndex& index) {
      if (!(index.flags() & Qt::ItemIsEditable) && index.column() != Table::On)
        activated_(filter_.mapToSource(index).row());
    });
  }

  /// The titles' own menu shows and hides the columns.
  void makeColumnChoice(QHeaderView& titles)
  {
    for (int place = 2; place < Table::ColumnCount; ++place) {
      const int column = titles.logicalIndex(place);
      const QString title = filter_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
      auto* action = named(new QAction(title, &titles), "column" + title);
      action->setToolTip(tr("Show or hide the column “%1”").arg(title));
      action->setCheckable(true);
      action->setChecked(true);
      connect(action, &QAction::toggled, this,
              [this, column](bool isShown) { table_->setColumnHidden(column, !isShown); });
      titles.addAction(action);
    }
    titles.setContextMenuPolicy(Qt::ActionsContextMenu);
  }

  void makeActions()
  {
    const auto onSelected = [this](void (*edit)(Editor&, const Rows&)) {
      return [this, edit] { edit(editor_, Rows(editor_.selectedConstraints())); };
    };
    const auto separate = [this] {
      table_->addAction(new QAction(this));
      table_->actions().back()->setSeparator(true);
    };
    addCommand({tr("&Enable or disable"), "constraintSwitch",
                tr("Disable the selected constraints, or enable them again"), Qt::Key_Space,
                onSelected(toggleConstraints)});
    addCommand(
        {tr("Re&name"), "constraintRename", tr("Give the current constraint another name"), {}, [this] { rename(); }});
    separate();
    up_ = addCommand({tr("Move &up"), "constraintMoveUp",
                      tr("Give the selected constraints precedence over the one above"), QKeySequence("Alt+Up"),
                      onSelected(moveConstraintsUp)});
    down_ = addCommand({tr("Move do&wn"), "constraintMoveDown",
                        tr("Give the one below precedence over the selected constraints"), QKeySequence("Alt+Down"),
                        onSelected(moveConstraintsDown)});
    separate();
    addCommand({tr("&Copy"), "constraintCopy", tr("Copy the selected constraints: points as a table"),
                QKeySequence::Copy,
                [this] { attempt([this] { copyConstraints(editor_, editor_.selectedConstraints()); }); }});
    addCommand({tr("&Paste"), "constraintPaste", tr("Add the constraints or the table of points that were copied"),
                QKeySequence::Paste, [this] { attempt([this] { pasteConstraints(editor_); }); }, false});
    addCommand({tr("&Duplicate"), "constraintDuplicate", tr("Add copies of the selected constraints"),
                QKeySequence("Ctrl+D"), onSelected(duplicateConstraints)});
    addCommand({tr("De&lete"), "constraintDelete", tr("Delete the selected constraints"), QKeySequence::Delete,
                onSelected(removeConstraints)});
    separate();
    addCommand({tr("Select &all"), "constraintSelectAll", tr("Select all constraints that are shown"),
                QKeySequence::SelectAll, [this] { table_->selectAll(); }, false});
    table_->setContextMenuPolicy(Qt::ActionsContextMenu);
  }

  struct Command {
    QString text;
    const char* name;
    QString tip;
    QKeySequence keys;
    std::function<void()> run;
    bool needsSelection = true;
  };

  QAction* addCommand(const Command& command)
  {
    QAction* action = named(new QAction(command.text, this), command.name);
    action->setShortcut(command.keys);
    action->setToolTip(command.tip);
    // The table finds pressed keys: menus of a window may use the same ones.
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setShortcutVisibleInContextMenu(true);
    connect(action, &QAction::triggered, this, command.run);
    table_->addAction(action);
    if (command.needsSelection) needSelection_.push_back(action);
    return action;
  }

  void attempt(const std::function<void()>& run)
  {
    if (!editor_.isOpen()) return;
    try {
      run();
    } catch (const std::runtime_error& error) {
      showRefusal(*reason_, QString::fromStdString(error.what()));
    }
  }

  void rename()
  {
    const QModelIndex current = table_->currentIndex();
    if (current.isValid()) table_->edit(current.siblingAtColumn(Table::Name));
  }

  void takeSelection()
  {
    if (isShowing_ || !model_.isInStep()) return;
    editor_.selectConstraints(rowsIn(filter_.mapSelectionToSource(table_->selectionModel()->selection())));
    updateActions();
  }

  void showSelection()
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

  void filtersChanged()
  {
    const int status = status_->currentIndex();
    filter_.setFilter(text_->text(), status == 0 ? nullptr : &kStatuses[static_cast<std::size_t>(status - 1)]);
    // Users do not mean to change rows that they cannot see.
    editor_.selectConstraints(filter_.visibleSelection());
    updateTexts();
  }

  void updateActions()
  {
    const bool isAny = editor_.isOpen() && !editor_.selectedConstraints().empty();
    for (QAction* action : needSelection_) action->setEnabled(isAny);
    up_->setEnabled(isAny && !filter_.isSorted());
    down_->setEnabled(isAny && !filter_.isSorted());
  }

  void updateTexts()
  {
    const int all = model_.rowCount();
    const int shown = filter_.rowCount();
    const auto selected = editor_.selectedConstraints().size();
    table_->setEmptyText(!editor_.isOpen() ? tr("No mesh is open.")
                         : all == 0 ? tr("No constraints yet.\n\nPick a point on the surface, paste a point list, or "
                                         "open a constraint file.")
                                    : tr("Nothing matches.\n\nClear the filter to see all constraints."));
    QString text = countText(all, "1 constraint", "%1 constraints");
    if (shown != all) text += tr(", %1 shown").arg(countText(shown));
    if (selected > 1) text += tr(", %1 selected").arg(countText(static_cast<Index>(selected)));
    count_->setText(text);
  }

  Editor& editor_;
  std::function<void(Index)> activated_;
  ConstraintTableModel model_;
  ConstraintFilter filter_;
  ConstraintTable* table_ = nullptr;
  QLineEdit* text_ = nullptr;
  QComboBox* status_ = nullptr;
  QLabel* reason_ = nullptr;
  QLabel* count_ = nullptr;
  QAction* up_ = nullptr;
  QAction* down_ = nullptr;
  std::vector<QAction*> needSelection_;
  QTimer settled_;
  bool isShowing_ = false;  // the editor's selection or a change of rows: the user has not selected anything
};

}  // namespace

QWidget* newConstraintPanel(Editor& editor, const std::function<void(Index)>& activated)
{
  return new ConstraintPanel(editor, activated);
}

}  // namespace holdfast

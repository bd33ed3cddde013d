// The panel of saved selections.

#include <QAction>
#include <QHeaderView>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include <holdfast/window/controls/command_tree.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/model/saved_selections.h>
#include <holdfast/window/panels/panels.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

enum SelectionColumn { NameOfSelection, WhatIsSelected, SelectionColumnCount };

class SelectionsPanel final : public RefreshedPanel {
 public:
  explicit SelectionsPanel(Editor& editor) : editor_(editor)
  {
    setObjectName("selectionsPanel");
    makeTree();
    save_ = named(new QPushButton(tr("Save the selection")), "selectionSave");
    save_->setToolTip(tr("Keep the selected vertices under a name"));
    select_ = named(new QPushButton(tr("Select")), "selectionSelect");
    select_->setToolTip(tr("Select these vertices again, and nothing else"));
    connect(save_, &QPushButton::clicked, this, [this] { saveSelection(editor_); });
    connect(select_, &QPushButton::clicked, this, &SelectionsPanel::selectCurrent);
    auto* content = new QWidget;
    auto* layout = newLayout<QVBoxLayout>(content, 6, 6, {tree_});
    reason_ = newText("selectionRefusal");
    reason_->setVisible(false);
    layout->addWidget(reason_);
    auto* buttons = newLayout<QHBoxLayout>(nullptr, 0, 6, {save_, select_});
    buttons->addStretch(1);
    layout->addLayout(buttons);
    pages_ = new HintedContent(content, "selectionsHint");
    fill(*this, pages_);
    for (const auto& signal : {&Editor::opened, &Editor::annotationsChanged})
      connect(&editor, signal, this, [this] {
        reason_->setVisible(false);
        refresh();
      });
    connect(&editor, &Editor::vertexSelectionChanged, this, &SelectionsPanel::updateCommands);
    refresh();
  }

 private:
  void makeTree()
  {
    tree_ = named(new CommandTree, "selectionTree", tr("Saved selections"));
    tree_->setColumnCount(SelectionColumnCount);
    tree_->setHeaderLabels({tr("Name"), tr("Selects")});
    tree_->setRootIsDecorated(false);
    tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->header()->setSectionResizeMode(NameOfSelection, QHeaderView::Stretch);
    tree_->addCommand(tr("&Select"), "selectionRecall", tr("Selects these vertices again"), Qt::Key_Return,
                      [this] { selectCurrent(); });
    tree_->addCommand(tr("&Rename"), "selectionRename", tr("Gives the selection another name"), Qt::Key_F2,
                      [this] { tree_->editItem(tree_->currentItem(), NameOfSelection); });
    tree_->addCommand(tr("&Delete"), "selectionDelete", tr("Deletes the saved selections, not what they select"),
                      QKeySequence::Delete, [this] { removeSelected(); });
    connect(tree_, &QTreeWidget::itemDoubleClicked, this, &SelectionsPanel::selectCurrent);
    connect(tree_, &QTreeWidget::itemChanged, this, &SelectionsPanel::rename);
    connect(tree_, &QTreeWidget::currentItemChanged, this, &SelectionsPanel::updateCommands);
  }

  void refresh() override
  {
    if (!isVisible()) return;
    if (!editor_.isOpen()) return pages_->showHint(tr("No mesh is open."));
    pages_->showContent();
    const QScopedValueRollback<bool> filling(isFilling_, true);
    const auto& selections = editor_.annotations().selections;
    const int count = static_cast<int>(selections.size());
    while (tree_->topLevelItemCount() > count) delete tree_->takeTopLevelItem(count);
    for (int row = 0; row < count; ++row) {
      if (row == tree_->topLevelItemCount()) addRow();
      const auto& [name, select] = selections[static_cast<std::size_t>(row)];
      QTreeWidgetItem& item = *tree_->topLevelItem(row);
      item.setText(NameOfSelection, QString::fromStdString(name));
      item.setText(WhatIsSelected, selectionText(select));
    }
    updateCommands();
  }

  void addRow()
  {
    auto* item = new QTreeWidgetItem(tree_);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    tree_->setCurrentItem(item);
  }

  void updateCommands()
  {
    save_->setEnabled(editor_.isOpen() && !editor_.selectedVertices().empty());
    const bool isAny = tree_->currentItem() != nullptr;
    select_->setEnabled(isAny);
    for (QAction* action : tree_->actions()) action->setEnabled(isAny);
  }

  /// What `change` refuses is said below the list.
  template <class Change>
  void attempt(const Change& change)
  {
    try {
      change();
      reason_->setVisible(false);
    } catch (const InputError& error) {
      showRefusal(*reason_, QString::fromStdString(error.reason()));
      refresh();
    }
  }

  void selectCurrent()
  {
    const int row = tree_->indexOfTopLevelItem(tree_->currentItem());
    if (row >= 0) attempt([&] { selectSaved(editor_, row); });
  }

  void rename(QTreeWidgetItem* item)
  {
    if (isFilling_) return;
    const int row = tree_->indexOfTopLevelItem(item);
    attempt([&] { renameSavedSelection(editor_, row, item->text(NameOfSelection)); });
  }

  void removeSelected()
  {
    Rows rows;
    for (int row = 0; row < tree_->topLevelItemCount(); ++row)
      if (tree_->topLevelItem(row)->isSelected()) rows.push_back(row);
    removeSavedSelections(editor_, rows);
  }

  Editor& editor_;
  HintedContent* pages_ = nullptr;
  CommandTree* tree_ = nullptr;
  QLabel* reason_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* select_ = nullptr;
  bool isFilling_ = false;  // by this panel, not by the user
};

}  // namespace

QWidget* newSelectionsPanel(Editor& editor)
{
  return new SelectionsPanel(editor);
}

}  // namespace holdfast

#include "holdfast/window/window/saved_selection_menu.h"

#include <QAction>
#include <QDockWidget>
#include <QTimer>
#include <QTreeWidget>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/model/saved_selections.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

void fillMenu(QMenu& menu, Editor& editor, QMainWindow& window)
{
  menu.clear();
  const auto& selections = editor.annotations().selections;
  for (std::size_t place = 0; place < selections.size(); ++place) {
    const auto select = [&editor, &window, place] {
      try {
        selectSaved(editor, static_cast<Index>(place));
      } catch (const InputError& error) {
        showProblem(&window, QObject::tr("This selection is not on the mesh."), QString::fromStdString(error.reason()));
      }
    };
    QAction* action = menu.addAction(nameText(selections[place].name).replace('&', "&&"), &window, select);
    action->setToolTip(plainTip(QObject::tr("Select %1 again").arg(quoted(selections[place].name))));
  }
  menu.setEnabled(!selections.empty());
}

}  // namespace

void saveAndNameSelection(Editor& editor, QMainWindow& window)
{
  saveSelection(editor);
  auto* dock = window.findChild<QDockWidget*>("selectionsDock");
  dock->show();
  dock->raise();
  auto* tree = window.findChild<QTreeWidget*>("selectionTree");
  auto* rename = window.findChild<QAction*>("selectionRename");
  // The panel is shown by the next turn of the event loop.
  QTimer::singleShot(0, tree, [tree, rename] {
    if (tree->topLevelItemCount() == 0) return;
    tree->setFocus();
    tree->setCurrentItem(tree->topLevelItem(tree->topLevelItemCount() - 1));
    rename->trigger();
  });
}

QMenu* newSavedSelectionMenu(Editor& editor, QMainWindow& window)
{
  auto* menu = named(new QMenu(QObject::tr("Save&d selections"), &window), "savedSelections");
  const auto fill = [menu, &editor, &window] { fillMenu(*menu, editor, window); };
  QObject::connect(&editor, &Editor::opened, menu, fill);
  QObject::connect(&editor, &Editor::annotationsChanged, menu, fill);
  fill();
  return menu;
}

}  // namespace holdfast

#include "holdfast/window/controls/command_tree.h"

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>

#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {

CommandTree::CommandTree()
{
  setAlternatingRowColors(true);
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  header()->setStretchLastSection(false);
}

QAction* CommandTree::addCommand(const QString& text, const char* name, const QString& tip, const QKeySequence& keys,
                                 const std::function<void()>& run)
{
  auto* action = named(new QAction(text, this), name);
  action->setToolTip(tip);
  action->setShortcut(keys);
  action->setShortcutContext(Qt::WidgetShortcut);
  connect(action, &QAction::triggered, this, run);
  addAction(action);
  return action;
}

bool CommandTree::event(QEvent* event)
{
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return QTreeWidget::event(event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  for (QAction* action : actions()) {
    if (action->shortcut() != QKeySequence(key.key() | static_cast<int>(key.modifiers()))) continue;
    if (event->type() == QEvent::KeyPress) action->trigger();
    event->accept();
    return true;
  }
  return QTreeWidget::event(event);
}

}  // namespace holdfast

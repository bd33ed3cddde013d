#pragma once
/// Lists all commands and keys of the window, and finds them by words.

#include <QAction>
#include <QList>
#include <QString>
#include <QWidget>

namespace holdfast {

/// Something that a user can do: an action, or what a key or the mouse does inside a tool.
struct Command {
  QString name;  ///< with the menus that lead to it
  QString key;
  QAction* action = nullptr;
};

/// Returns the commands of a menu or a menu bar, and of all menus in it. `path` is written before their names.
[[nodiscard]] QList<Command> commandsOf(const QList<QAction*>& actions, const QString& path = {});

/// Returns what keys and the mouse do without an action.
[[nodiscard]] QList<Command> gestures();

/// Shows the list over `window`, and triggers the action that the user chooses.
void showCommands(const QList<Command>& commands, QWidget* window);

}  // namespace holdfast

#pragma once
/// A tree of rows with commands. A right click opens their menu, and their keys work while the tree has the focus.

#include <QTreeWidget>
#include <functional>

class QAction;

namespace holdfast {

class CommandTree : public QTreeWidget {
  Q_OBJECT

 public:
  CommandTree();

  /// Adds a command. While the tree has the focus, `keys` belong to this command, whatever menus use them for.
  QAction* addCommand(const QString& text, const char* name, const QString& tip, const QKeySequence& keys,
                      const std::function<void()>& run);

 protected:
  bool event(QEvent* event) override;
};

}  // namespace holdfast

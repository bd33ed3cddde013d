#pragma once
/// A tree of rows with commands: a menu by a right click, and keys while the tree has the focus.

#include <QTreeWidget>
#include <functional>

class QAction;

namespace holdfast {

class CommandTree : public QTreeWidget {
  Q_OBJECT

 public:
  CommandTree();

  /// `keys` are this command's while the tree has the focus, whatever menus use them for.
  QAction* addCommand(const QString& text, const char* name, const QString& tip, const QKeySequence& keys,
                      const std::function<void()>& run);

 protected:
  bool event(QEvent* event) override;
};

}  // namespace holdfast

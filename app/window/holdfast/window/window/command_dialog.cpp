#include "holdfast/window/window/command_dialog.h"

#include <QCoreApplication>
#include <QDialog>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QTreeWidget>
#include <algorithm>

#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {
namespace {

class CommandDialog : public QDialog {
 public:
  CommandDialog(const QList<Command>& commands, QWidget* parent) : QDialog(parent), commands_(commands)
  {
    setObjectName("commandDialog");
    setWindowTitle(tr("Commands and keys"));
    text_ = named(new QLineEdit, "commandText", tr("Find a command or a key"));
    text_->setPlaceholderText(text_->accessibleName());
    text_->setClearButtonEnabled(true);
    text_->installEventFilter(this);
    list_ = named(new QTreeWidget, "commandList", tr("Commands and their keys"));
    list_->setHeaderLabels({tr("Command"), tr("Key")});
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    newLayout<QVBoxLayout>(this, 10, 8, {text_, list_});
    resize(fontMetrics().averageCharWidth() * 90, fontMetrics().height() * 30);
    connect(text_, &QLineEdit::textChanged, this, &CommandDialog::find);
    connect(text_, &QLineEdit::returnPressed, this, &CommandDialog::choose);
    connect(list_, &QTreeWidget::itemActivated, this, &CommandDialog::choose);
    find();
  }

  [[nodiscard]] QAction* chosen() const { return chosen_; }

 protected:
  /// Arrow keys go through the list while the user types.
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Up && key != Qt::Key_Down && key != Qt::Key_PageUp && key != Qt::Key_PageDown) return false;
    return QCoreApplication::sendEvent(list_, event);
  }

 private:
  void find()
  {
    const QStringList words = text_->text().simplified().split(' ', Qt::SkipEmptyParts);
    const auto hasAll = [&](const QString& text) {
      return std::all_of(words.begin(), words.end(),
                         [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
    };
    list_->clear();
    QTreeWidgetItem* best = nullptr;
    int bestRank = 0;
    for (int k = 0; k < commands_.size(); ++k) {
      const auto& [name, key, action] = commands_[k];
      const QString tip = action != nullptr ? action->toolTip() : QString();
      if (!hasAll(name + ' ' + key + ' ' + tip)) continue;
      auto* item = new QTreeWidgetItem(list_, {name, key});
      item->setData(0, Qt::UserRole, k);
      item->setToolTip(0, tip);
      if (action != nullptr) item->setDisabled(!action->isEnabled());
      if (action == nullptr) continue;
      // What is called so goes before what is in such a menu, and that before what only speaks of it.
      const int rank = hasAll(action->text().remove('&')) ? 0 : hasAll(name) ? 1 : 2;
      const bool isBetter = best == nullptr || rank < bestRank;
      if (!isBetter && (rank > bestRank || !best->isDisabled() || item->isDisabled())) continue;
      best = item;
      bestRank = rank;
    }
    // Where what is meant cannot be done now, Enter does nothing else in its place.
    list_->setCurrentItem(best == nullptr || best->isDisabled() ? nullptr : best);
    if (best != nullptr) list_->scrollToItem(best);
  }

  void choose()
  {
    const QTreeWidgetItem* item = list_->currentItem();
    if (item == nullptr || item->isDisabled()) return;
    chosen_ = commands_[item->data(0, Qt::UserRole).toInt()].action;
    if (chosen_ != nullptr) accept();
  }

  QList<Command> commands_;
  QLineEdit* text_ = nullptr;
  QTreeWidget* list_ = nullptr;
  QAction* chosen_ = nullptr;
};

}  // namespace

QList<Command> commandsOf(const QList<QAction*>& actions, const QString& path)
{
  QList<Command> commands;
  for (QAction* action : actions) {
    const QString name = path + action->text().remove('&');
    if (action->menu() != nullptr)
      commands += commandsOf(action->menu()->actions(), name + QStringLiteral(" \u203a "));
    else if (!action->isSeparator())
      commands.push_back({name, action->shortcut().toString(QKeySequence::NativeText), action});
  }
  return commands;
}

QList<Command> gestures()
{
  const auto tr = [](const char* text) { return QCoreApplication::translate("Commands", text); };
  return {{tr("Picture \u203a Rotate it"), tr("right button, drag")},
          {tr("Picture \u203a Shift it"), tr("middle button, drag; or Shift and the right one")},
          {tr("Picture \u203a Nearer and farther"), tr("wheel")},
          {tr("Picture \u203a Menu for the selection"), tr("right button, click")},
          {tr("Arrows and rings \u203a Move or turn by an exact amount"), tr("digits over one, Enter")},
          {tr("Arrows and rings \u203a Choose an arrow"), "X, Y, Z"},
          {tr("Arrows and rings \u203a Choose a ring"), "Shift+X, Shift+Y, Shift+Z"},
          {tr("Arrows and rings \u203a Round lengths, 15 degrees"), tr("Ctrl, drag")},
          {tr("Regions \u203a Add to the selection"), tr("Shift, with any tool")},
          {tr("Regions \u203a Take away from the selection"), tr("Ctrl, with any tool")},
          {tr("Hold point \u203a On vertices, edges, faces, whatever is nearest"), "V, E, F, A"},
          {tr("Brush \u203a Smaller, larger"), "[, ]"},
          {tr("Side \u203a Bend less, more at an edge"), "[, ]"},
          {tr("Side \u203a The whole connected part"), tr("double click")},
          {tr("Curve \u203a Close it"), tr("Enter, double click, or click the first place")},
          {tr("Curve \u203a Take the last place back"), "Backspace"},
          {tr("Rotation sphere \u203a Rotate it"), tr("arrow keys")},
          {tr("Rotation sphere \u203a Zoom, show everything"), "+, -, Home"},
          {tr("Distributions \u203a Choose a bar, select what it counts"), tr("Left, Right, Enter")},
          {tr("Table \u203a Edit a cell"), tr("F2, double click")}};
}

void showCommands(const QList<Command>& commands, QWidget* window)
{
  CommandDialog dialog(commands, window);
  if (dialog.exec() == QDialog::Accepted) dialog.chosen()->trigger();
}

}  // namespace holdfast

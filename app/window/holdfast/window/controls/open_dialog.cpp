#include "holdfast/window/controls/open_dialog.h"

#include <QApplication>
#include <QEvent>
#include <QTimer>
#include <QWidget>
#include <utility>

namespace holdfast {
namespace {

/// Looks again each time that a dialog has gone: another one may have come in its place.
class WaitingForDialogs final : public QObject {
 public:
  WaitingForDialogs(QObject& owner, std::function<void()> act) : QObject(&owner), act_(std::move(act))
  {
    lookAgain_.setSingleShot(true);
    lookAgain_.setInterval(0);
    connect(&lookAgain_, &QTimer::timeout, this, [this] { look(); });
    look();
  }

 protected:
  bool eventFilter(QObject* /*dialog*/, QEvent* event) override
  {
    // What waits for the dialog's answer goes on first.
    if (event->type() == QEvent::Hide) lookAgain_.start();
    return false;
  }

 private:
  void look()
  {
    if (QWidget* dialog = QApplication::activeModalWidget()) {
      dialog->installEventFilter(this);
      connect(dialog, &QObject::destroyed, &lookAgain_, qOverload<>(&QTimer::start));
      return;
    }
    const auto act = std::exchange(act_, nullptr);
    deleteLater();
    if (act) act();
  }

  std::function<void()> act_;
  QTimer lookAgain_;
};

}  // namespace

bool isDialogOpen()
{
  return QApplication::activeModalWidget() != nullptr;
}

void whenNoDialogIsOpen(QObject& owner, std::function<void()> act)
{
  if (!isDialogOpen()) return act();
  new WaitingForDialogs(owner, std::move(act));
}

}  // namespace holdfast

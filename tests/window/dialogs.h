#pragma once
/// \file
/// Dialogs that stop a program until they are answered, answered by events that a user would send.

#include <QString>
#include <QTimer>
#include <functional>

class QDialog;

namespace holdfast::test {

/// Answers one dialog with this object name as soon as it is on the screen and has the keys, while other code waits in
/// it. Fails the test where none has come by the end of its life.
class DialogAnswer {
 public:
  DialogAnswer(QString objectName, std::function<void(QDialog&)> answer);
  ~DialogAnswer();
  DialogAnswer(const DialogAnswer&) = delete;
  DialogAnswer& operator=(const DialogAnswer&) = delete;

  [[nodiscard]] bool isGiven() const noexcept { return isGiven_; }

 private:
  void look();

  QString objectName_;
  std::function<void(QDialog&)> answer_;
  QTimer timer_;
  bool isGiven_ = false;
};

/// The dialog of this name that is on the screen; null where none is.
[[nodiscard]] QDialog* findDialog(const QString& objectName);

/// Tells whether nothing lies over the dialog, as the display itself says: at its middle and near its corners.
[[nodiscard]] bool isOnTop(QDialog& dialog);

/// Handles events for longer than a progress dialog, of work that has begun by now, takes to come.
void passProgressDelay();

/// Clicks the button with this object name, or with this text (mnemonics aside). Fails the test where there is none.
void clickButton(QDialog& dialog, const QString& button);

/// All that a message box says.
[[nodiscard]] QString textOf(QDialog& messageBox);

}  // namespace holdfast::test

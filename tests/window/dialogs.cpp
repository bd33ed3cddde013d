#include "dialogs.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QMessageBox>
#include <QWindow>
#include <utility>

#include <gtest/gtest.h>

#include <holdfast/window/files/progress_dialog.h>

#include "gestures.h"

namespace holdfast::test {

DialogAnswer::DialogAnswer(QString objectName, std::function<void(QDialog&)> answer)
    : objectName_(std::move(objectName)), answer_(std::move(answer))
{
  QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { look(); });
  timer_.start(5);
}

DialogAnswer::~DialogAnswer()
{
  EXPECT_TRUE(isGiven_) << "no dialog called " << objectName_.toStdString() << " came";
}

void DialogAnswer::look()
{
  QDialog* dialog = findDialog(objectName_);
  // Keys go where the focus is: before the dialog has it, a file dialog takes what is typed for a choice in its list.
  if (isGiven_ || dialog == nullptr || !dialog->isActiveWindow()) return;
  isGiven_ = true;
  timer_.stop();
  if (objectName_ == "messageBox") {
    EXPECT_EQ(dialog->windowTitle(), "Holdfast");
  }
  answer_(*dialog);
}

QDialog* findDialog(const QString& objectName)
{
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (widget->objectName() == objectName && widget->isVisible() && widget->windowHandle()->isExposed())
      return qobject_cast<QDialog*>(widget);
  return nullptr;
}

bool isOnTop(QDialog& dialog)
{
  const QRect inside = QRect(dialog.mapToGlobal(QPoint(0, 0)), dialog.size()).adjusted(3, 3, -3, -3);
  for (const QPoint& place :
       {inside.center(), inside.topLeft(), inside.topRight(), inside.bottomLeft(), inside.bottomRight()})
    if (QApplication::topLevelAt(place) != &dialog) return false;
  return true;
}

void passProgressDelay()
{
  bool isOver = false;
  QTimer::singleShot(2 * kMillisecondsWithoutProgress, [&] { isOver = true; });
  EXPECT_TRUE(waitUntil([&] { return isOver; }));
}

void clickButton(QDialog& dialog, const QString& button)
{
  for (QAbstractButton* candidate : dialog.findChildren<QAbstractButton*>())
    if (candidate->objectName() == button || candidate->text().remove('&') == button)
      return click(*candidate, QRectF(candidate->rect()).center());
  ADD_FAILURE() << "no button " << button.toStdString();
  dialog.reject();
}

QString textOf(QDialog& messageBox)
{
  const auto* box = qobject_cast<QMessageBox*>(&messageBox);
  return box == nullptr ? QString() : box->text() + '\n' + box->informativeText();
}

}  // namespace holdfast::test

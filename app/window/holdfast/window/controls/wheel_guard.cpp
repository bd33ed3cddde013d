#include "holdfast/window/controls/wheel_guard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace holdfast {
namespace {

bool isEditedByWheel(QObject* object)
{
  return qobject_cast<QComboBox*>(object) != nullptr || qobject_cast<QAbstractSpinBox*>(object) != nullptr ||
         (qobject_cast<QAbstractSlider*>(object) != nullptr && qobject_cast<QScrollBar*>(object) == nullptr);
}

}  // namespace

bool WheelGuard::eventFilter(QObject* watched, QEvent* event)
{
  if ((event->type() != QEvent::Show && event->type() != QEvent::Wheel) || !isEditedByWheel(watched)) return false;
  auto& widget = static_cast<QWidget&>(*watched);
  if (widget.focusPolicy() == Qt::WheelFocus) widget.setFocusPolicy(Qt::StrongFocus);
  if (event->type() == QEvent::Show || widget.hasFocus()) return false;
  event->ignore();
  return true;
}

}  // namespace holdfast

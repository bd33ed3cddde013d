#include "holdfast/window/viewport/tool.h"

#include <QKeyEvent>

#include <vtkAbstractWidget.h>

#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

Tool::Tool(Editor& editor, Viewport& viewport, vtkAbstractWidget& widget, QObject* parent)
    : QObject(parent), editor_(editor), viewport_(viewport), vtkWidget_(widget)
{
  widget.SetInteractor(viewport.interactor());
  widget.SetDefaultRenderer(&viewport.widgetRenderer());
  // VTK would have "i" switch it on and off.
  widget.KeyPressActivationOff();
  connect(&viewport, &Viewport::surfaceChanged, this, [this] { followSurface(); });
  connect(&viewport, &Viewport::aboutToRender, this, [this] { followDisplay(); });
  connect(&viewport, &Viewport::closing, this, [this] { vtkWidget_.SetInteractor(nullptr); });
}

void Tool::begin()
{
  vtkWidget_.On();
}

void Tool::end()
{
  cancel();
  vtkWidget_.Off();
}

char Tool::characterOf(const QKeyEvent& event)
{
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return '\0';
  if (event.key() == Qt::Key_Enter) return '\r';
  return event.text().isEmpty() ? '\0' : event.text().front().toLatin1();
}

}  // namespace holdfast

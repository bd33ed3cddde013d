#include "holdfast/window/tools/widget_tool.h"

#include <QKeyEvent>

#include <QVTKInteractor.h>
#include <vtkAbstractWidget.h>
#include <vtkRenderer.h>

#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

void WidgetTool::attach(vtkAbstractWidget& widget)
{
  widget_ = &widget;
  widget.SetInteractor(viewport_.interactor());
  widget.SetDefaultRenderer(&viewport_.widgetRenderer());
  // VTK would have "i" switch it on and off.
  widget.KeyPressActivationOff();
  connect(&viewport_, &Viewport::surfaceChanged, this, [this] { followSurface(); });
  connect(&viewport_, &Viewport::aboutToRender, this, [this] { followDisplay(); });
  connect(&viewport_, &Viewport::closing, this, [this] { widget_->SetInteractor(nullptr); });
}

void WidgetTool::begin()
{
  widget_->On();
}

void WidgetTool::end()
{
  cancel();
  widget_->Off();
}

char characterOf(const QKeyEvent& event)
{
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return '\0';
  if (event.key() == Qt::Key_Enter) return '\r';
  return event.text().isEmpty() ? '\0' : event.text().front().toLatin1();
}

}  // namespace holdfast

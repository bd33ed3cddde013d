#include "holdfast/window/controls/vtk_view.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScopedValueRollback>
#include <cmath>
#include <utility>

#include <QVTKRenderWindowAdapter.h>
#include <vtkCommand.h>
#include <vtkInteractorStyle.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>

#include <holdfast/widgets/scene/context_window.h>

namespace holdfast {
namespace {

// In Qt's units.
constexpr double kNotch = 120;

/// VTK copies one framebuffer to the other; this exchanges them. The back buffer holds an older picture afterwards.
class ExchangingWindow : public ContextWindow {
 public:
  static ExchangingWindow* New();
  vtkTypeMacro(ExchangingWindow, ContextWindow)

  void Frame() override
  {
    if (this->GetSwapBuffers() != 0) std::swap(this->RenderFramebuffer, this->DisplayFramebuffer);
    this->InvokeEvent(vtkCommand::WindowFrameEvent);
  }
};

vtkStandardNewMacro(ExchangingWindow);

unsigned long vtkEventOf(const QMouseEvent& event)
{
  if (event.type() == QEvent::MouseMove) return vtkCommand::MouseMoveEvent;
  const bool isRelease = event.type() == QEvent::MouseButtonRelease;
  switch (event.button()) {
    case Qt::LeftButton:
      return isRelease ? vtkCommand::LeftButtonReleaseEvent : vtkCommand::LeftButtonPressEvent;
    case Qt::MiddleButton:
      return isRelease ? vtkCommand::MiddleButtonReleaseEvent : vtkCommand::MiddleButtonPressEvent;
    case Qt::RightButton:
      return isRelease ? vtkCommand::RightButtonReleaseEvent : vtkCommand::RightButtonPressEvent;
    default:
      return vtkCommand::NoEvent;
  }
}

}  // namespace

VtkView::VtkView(QWidget* parent) : QVTKOpenGLNativeWidget(parent)
{
  // Sizes are in pixels of the window; scaled by the resolution as well, texts would be too large.
  setEnableHiDPI(false);
  // Each painting replaces the whole picture, so Qt need not clear it.
  setUpdateBehavior(PartialUpdate);
  setRenderWindow(vtkNew<ExchangingWindow>());
  renderWindow()->SetMultiSamples(0);
  interactor()->EnableRenderOff();
  interactor()->AddObserver(vtkCommand::RenderEvent, this, &VtkView::tellRender);
}

void VtkView::tellRender()
{
  if (!isPainting_) Q_EMIT renderWanted();
}

void VtkView::paintGL()
{
  // Draws now what Qt wants painted and is not drawn yet.
  const QScopedValueRollback<bool> painting(isPainting_, true);
  interactor()->EnableRenderOn();
  vtkOpenGLRenderWindow& window = *RenderWindow;
  vtkOpenGLState& state = *window.GetState();
  state.Reset();
  state.Push();
  state.vtkglDepthFunc(GL_LEQUAL);
  RenderWindowAdapter->paint();
  interactor()->EnableRenderOff();
  // This paints as VTK does, but does not set the opacity of all pixels, for which the window would wait.
  makeCurrent();
  context()->functions()->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  window.BlitDisplayFramebuffer();
  state.Pop();
}

bool VtkView::event(QEvent* event)
{
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
      sendMouse(static_cast<const QMouseEvent&>(*event));
      return true;
    case QEvent::Wheel:
      sendWheel(static_cast<const QWheelEvent&>(*event));
      return true;
    default:
      return QVTKOpenGLNativeWidget::event(event);
  }
}

void VtkView::setInformation(const QPointF& place, Qt::KeyboardModifiers modifiers, int repeatCount)
{
  const auto pixel = [this](double coordinate) { return static_cast<int>(std::floor(coordinate * pixelRatio())); };
  interactor()->SetEventInformationFlipY(pixel(place.x()), pixel(place.y()),
                                         modifiers.testFlag(Qt::ControlModifier) ? 1 : 0,
                                         modifiers.testFlag(Qt::ShiftModifier) ? 1 : 0, '\0', repeatCount);
  interactor()->SetAltKey(modifiers.testFlag(Qt::AltModifier) ? 1 : 0);
}

void VtkView::sendMouse(const QMouseEvent& event)
{
  setInformation(event.localPos(), event.modifiers(), event.type() == QEvent::MouseButtonDblClick ? 1 : 0);
  if (const unsigned long id = vtkEventOf(event); id != vtkCommand::NoEvent) interactor()->InvokeEvent(id);
}

void VtkView::sendWheel(const QWheelEvent& event)
{
  setInformation(event.position(), event.modifiers(), 0);
  const double notches = event.angleDelta().y() / kNotch;
  if (auto* style = vtkInteractorStyle::SafeDownCast(interactor()->GetInteractorStyle()))
    style->SetMouseWheelMotionFactor(std::abs(notches));
  interactor()->InvokeEvent(notches > 0 ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent);
}

}  // namespace holdfast

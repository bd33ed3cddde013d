#include "holdfast/widgets/interaction/surface_point_widget.h"

#include <utility>

#include <vtkEvent.h>
#include <vtkWidgetEventTranslator.h>

namespace holdfast {

vtkStandardNewMacro(SurfacePointWidget);

SurfacePointWidget::SurfacePointWidget()
{
  using Widget = SurfacePointWidget;
  vtkWidgetCallbackMapper& mapper = *this->CallbackMapper;
  mapper.SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, &call<&Widget::Hover>);
  for (const unsigned long event :
       {vtkCommand::LeaveEvent, vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent})
    mapper.SetCallbackMethod(event, vtkWidgetEvent::HoverLeave, this, &call<&Widget::Leave>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this, &call<&Widget::Press>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::AddPoint, this, &call<&Widget::Release>);
  const auto bindKey = [&](char key, unsigned long widgetEvent, void (*action)(vtkAbstractWidget*)) {
    mapper.SetCallbackMethod(vtkCommand::CharEvent, vtkEvent::NoModifier, key, 0, nullptr, widgetEvent, this, action);
  };
  bindKey('v', ChooseVertices, &call<&Widget::Choose<PickKind::Vertex>>);
  bindKey('e', ChooseEdges, &call<&Widget::Choose<PickKind::Edge>>);
  bindKey('f', ChooseFaces, &call<&Widget::Choose<PickKind::Face>>);
  bindKey('a', ChooseNearest, &call<&Widget::Choose<PickKind::Nearest>>);
}

void SurfacePointWidget::SetRepresentation(SurfacePointRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
  this->InformRepresentation();
}

void SurfacePointWidget::CreateDefaultRepresentation()
{
  if (this->WidgetRep != nullptr) return;
  this->WidgetRep = SurfacePointRepresentation::New();
  this->InformRepresentation();
}

void SurfacePointWidget::InformRepresentation()
{
  this->GetSurfacePointRepresentation()->SetSurface(this->Placer->GetSurface());
  this->GetSurfacePointRepresentation()->SetPixelRatio(this->GetPixelRatio());
}

void SurfacePointWidget::SetEnabled(int enabling)
{
  if (enabling == 0 && this->Enabled != 0) this->Leave();
  this->LeftClick.Forget();
  this->Superclass::SetEnabled(enabling);
}

void SurfacePointWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  this->Placer->SetSurface(std::move(surface));
  this->InformRepresentation();
}

void SurfacePointWidget::SetKind(PickKind kind)
{
  if (this->GetKind() == kind) return;
  this->Placer->SetKind(kind);
  if (this->IsHovering) this->Show(this->PickAtCursor());
}

void SurfacePointWidget::SetPixelRatio(double ratio)
{
  this->Placer->SetPixelRatio(ratio);
  this->InformRepresentation();
}

void SurfacePointWidget::SetPreview(std::optional<SurfacePick> pick)
{
  this->GetSurfacePointRepresentation()->SetPreview(std::move(pick));
  if (this->Enabled != 0) this->Render();
}

bool SurfacePointWidget::WantsKey(char key) const
{
  return this->EventTranslator->GetTranslation(vtkCommand::CharEvent, vtkEvent::NoModifier, key, 0, nullptr) !=
         vtkWidgetEvent::NoEvent;
}

std::optional<SurfacePick> SurfacePointWidget::PickAtCursor() const
{
  return this->Placer->Pick(*this->CurrentRenderer, cursorOf(*this->Interactor).data());
}

void SurfacePointWidget::Show(std::optional<SurfacePick> pick)
{
  if (!pick && !this->GetPreview()) return;
  if (this->ManagesCursor != 0) this->RequestCursorShape(pick ? VTK_CURSOR_CROSSHAIR : VTK_CURSOR_DEFAULT);
  this->SetPreview(pick);
  this->InvokeEvent(vtkCommand::InteractionEvent, pick ? &*pick : nullptr);
}

void SurfacePointWidget::Hover()
{
  const bool isDrag = this->LeftClick.LeaveAt(cursorOf(*this->Interactor), this->GetPixelRatio());
  const bool isInside = isCursorIn(*this->CurrentRenderer, *this->Interactor);
  if (isDrag || !isInside || isCameraMoving(*this->Interactor)) return this->Leave();
  this->IsHovering = true;
  this->Show(this->PickAtCursor());
}

void SurfacePointWidget::Leave()
{
  this->IsHovering = false;
  this->Show(std::nullopt);
}

void SurfacePointWidget::Press()
{
  this->LeftClick.Forget();
  if (isSecondPress(*this->Interactor) || !isCursorIn(*this->CurrentRenderer, *this->Interactor)) return;
  this->LeftClick.Press(cursorOf(*this->Interactor));
}

void SurfacePointWidget::Release()
{
  if (!this->LeftClick.Release(cursorOf(*this->Interactor), this->GetPixelRatio())) return;
  if (auto pick = this->PickAtCursor()) this->InvokeEvent(vtkCommand::PlacePointEvent, &*pick);
}

template <PickKind Kind>
void SurfacePointWidget::Choose()
{
  this->EventCallbackCommand->SetAbortFlag(1);
  if (this->GetKind() == Kind) return;
  this->SetKind(Kind);
  PickKind kind = Kind;
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent, &kind);
}

}  // namespace holdfast

#include "holdfast/widgets/interaction/surface_ruler_widget.h"

#include <array>
#include <utility>

#include <vtkEvent.h>
#include <vtkHandleWidget.h>

namespace holdfast {

vtkStandardNewMacro(SurfaceRulerWidget);

SurfaceRulerWidget::SurfaceRulerWidget()
{
  using Widget = SurfaceRulerWidget;
  this->CurrentHandle = -1;
  vtkWidgetCallbackMapper& mapper = *this->CallbackMapper;
  mapper.SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::AddPoint, this, &call<&Widget::Press>);
  mapper.SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, &call<&Widget::Move>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                           &call<&Widget::Release>);
  mapper.SetCallbackMethod(vtkCommand::KeyPressEvent, vtkEvent::AnyModifier, 0, 0, "Escape", vtkWidgetEvent::Reset,
                           this, &call<&Widget::Escape>);
}

void SurfaceRulerWidget::SetEnabled(int enabling)
{
  if (enabling == 0) this->Cancel();
  this->LeftClick.Forget();
  // VTK asks for it before it makes one.
  this->CreateDefaultRepresentation();
  if (enabling != 0 && this->Interactor != nullptr) this->PrepareHandles();
  this->Superclass::SetEnabled(enabling);
}

/// VTK would show the handles in the renderer under the cursor.
void SurfaceRulerWidget::PrepareHandles()
{
  const int* cursor = this->Interactor->GetEventPosition();
  if (this->CurrentRenderer == nullptr)
    this->SetCurrentRenderer(this->Interactor->FindPokedRenderer(cursor[0], cursor[1]));
  const std::array widgets{this->Point1Widget, this->Point2Widget};
  for (const int end : {0, 1}) {
    widgets[end]->SetRepresentation(&this->GetRulerRepresentation()->GetHandle(end));
    widgets[end]->SetInteractor(this->Interactor);
    widgets[end]->SetCurrentRenderer(this->CurrentRenderer);
  }
}

void SurfaceRulerWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  SurfaceRulerRepresentation& ruler = *this->GetRulerRepresentation();
  const bool isHalfDrawn = this->WidgetState == vtkDistanceWidget::Define;
  ruler.SetSurface(std::move(surface));
  if (this->WidgetState != vtkDistanceWidget::Start && !ruler.IsPlaced()) this->Clear();
  if (isHalfDrawn && this->WidgetState == vtkDistanceWidget::Start) this->InvokeEvent(CancelInteractionEvent);
}

void SurfaceRulerWidget::SetLocations(const SurfaceLocation& a, const SurfaceLocation& b)
{
  SurfaceRulerRepresentation& ruler = *this->GetRulerRepresentation();
  if (!ruler.GetPlacer()->GetSurface()) {
    vtkErrorMacro("The ruler must have a surface before it has locations");
    return;
  }
  this->Cancel();
  const std::optional<SurfacePlacement> before = ruler.GetHandle(0).GetPlacement();
  ruler.GetHandle(0).SetLocation(a);
  try {
    ruler.GetHandle(1).SetLocation(b);
  } catch (...) {
    ruler.GetHandle(0).SetPlacement(before);
    throw;
  }
  ruler.VisibilityOn();
  this->SetWidgetStateToManipulate();
  this->Render();
}

std::optional<SurfaceLocation> SurfaceRulerWidget::GetLocation(int end)
{
  const auto& placement = this->GetRulerRepresentation()->GetHandle(end).GetPlacement();
  return placement ? std::optional(placement->location) : std::nullopt;
}

void SurfaceRulerWidget::Clear()
{
  if (this->GrabbedAt) this->StopDrag();
  for (const int end : {0, 1}) this->GetRulerRepresentation()->GetHandle(end).SetPlacement(std::nullopt);
  this->Point1Widget->SetEnabled(0);
  this->Point2Widget->SetEnabled(0);
  this->GetRulerRepresentation()->VisibilityOff();
  this->WidgetState = vtkDistanceWidget::Start;
  this->Render();
}

void SurfaceRulerWidget::Cancel()
{
  if (!this->IsUnderWay()) return;
  if (this->WidgetState == vtkDistanceWidget::Define) {
    this->Clear();
  } else {
    this->GetRulerRepresentation()->GetHandle(this->CurrentHandle).SetPlacement(this->GrabbedAt);
    this->StopDrag();
    this->Render();
  }
  this->InvokeEvent(CancelInteractionEvent);
}

/// Leaves the grabbed end where it is, without events.
void SurfaceRulerWidget::StopDrag()
{
  this->GrabbedAt.reset();
  this->ReleaseFocus();
  this->EndInteraction();
  vtkHandleWidget& handle = this->CurrentHandle == 0 ? *this->Point1Widget : *this->Point2Widget;
  this->CurrentHandle = -1;
  // Otherwise VTK would invoke EndInteractionEvent.
  handle.SetEnabled(0);
  handle.SetCurrentRenderer(this->CurrentRenderer);
  handle.SetEnabled(1);
}

void SurfaceRulerWidget::Press()
{
  this->LeftClick.Forget();
  if (!isCursorIn(*this->CurrentRenderer, *this->Interactor)) return;
  if (this->WidgetState == vtkDistanceWidget::Manipulate) return this->Grab();
  if (!isSecondPress(*this->Interactor)) this->LeftClick.Press(cursorOf(*this->Interactor));
}

void SurfaceRulerWidget::Grab()
{
  this->Hover();
  this->CurrentHandle = -1;
  AddPointAction(this);
  if (this->CurrentHandle >= 0)
    this->GrabbedAt = this->GetRulerRepresentation()->GetHandle(this->CurrentHandle).GetPlacement();
}

void SurfaceRulerWidget::Move()
{
  this->LeftClick.LeaveAt(cursorOf(*this->Interactor), this->GetRulerRepresentation()->GetPixelRatio());
  if (this->WidgetState == vtkDistanceWidget::Define) return this->MoveSecondEnd();
  if (this->GrabbedAt) return MoveAction(this);
  if (this->WidgetState == vtkDistanceWidget::Manipulate) this->Hover();
}

void SurfaceRulerWidget::MoveSecondEnd()
{
  if (isCameraMoving(*this->Interactor) || !isCursorIn(*this->CurrentRenderer, *this->Interactor)) return;
  DisplayPoint cursor = cursorOf(*this->Interactor);
  this->GetRulerRepresentation()->WidgetInteraction(cursor.data());
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->Render();
}

/// Finds the end under the cursor, and shows it.
void SurfaceRulerWidget::Hover()
{
  bool isChanged = false;
  for (const int end : {0, 1}) {
    SurfaceHandleRepresentation& handle = this->GetRulerRepresentation()->GetHandle(end);
    const int before = handle.GetInteractionState();
    handle.BuildRepresentation();
    isChanged = stateAtCursor(handle, *this->Interactor) != before || isChanged;
  }
  if (isChanged) this->Render();
}

void SurfaceRulerWidget::Release()
{
  if (this->GrabbedAt) {
    this->GrabbedAt.reset();
    return EndSelectAction(this);
  }
  const DisplayPoint cursor = cursorOf(*this->Interactor);
  if (this->LeftClick.Release(cursor, this->GetRulerRepresentation()->GetPixelRatio())) this->PlaceEnd();
}

void SurfaceRulerWidget::PlaceEnd()
{
  DisplayPoint cursor = cursorOf(*this->Interactor);
  if (!this->GetPlacer()->Pick(*this->CurrentRenderer, cursor.data())) return;
  if (this->WidgetState == vtkDistanceWidget::Define) this->GetRulerRepresentation()->WidgetInteraction(cursor.data());
  this->PrepareHandles();
  AddPointAction(this);
  // VTK keeps all events until the second end is placed; the camera needs them.
  this->ReleaseFocus();
  this->EventCallbackCommand->SetAbortFlag(0);
}

void SurfaceRulerWidget::Escape()
{
  if (!this->IsUnderWay()) return;
  this->Cancel();
  this->EventCallbackCommand->SetAbortFlag(1);
}

}  // namespace holdfast

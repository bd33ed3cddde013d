#include "holdfast/widgets/interaction/vtkHoldfastSurfaceRulerWidget.h"

#include <array>
#include <utility>

#include <vtkHandleWidget.h>

#include <holdfast/widgets/interaction/vtkHoldfastSurfaceHandleRepresentation.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfaceRulerWidget);

vtkHoldfastSurfaceRulerWidget::vtkHoldfastSurfaceRulerWidget()
{
  this->CurrentHandle = -1;
  this->Bind<&vtkHoldfastSurfaceRulerWidget::Press>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::AddPoint);
  this->Bind<&vtkHoldfastSurfaceRulerWidget::Move>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  this->Bind<&vtkHoldfastSurfaceRulerWidget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  this->BindKey<&vtkHoldfastSurfaceRulerWidget::Cancel>("Escape", vtkWidgetEvent::Reset);
}

void vtkHoldfastSurfaceRulerWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkHoldfastSurfaceRulerWidget::SetEnabled(int enabling)
{
  if (enabling == 0) this->Cancel();
  // VTK asks for it before it makes one.
  this->CreateDefaultRepresentation();
  if (enabling != 0 && this->Interactor != nullptr) this->PrepareHandles();
  this->WidgetOf::SetEnabled(enabling);
}

/// VTK would show the handles in the renderer under the cursor.
void vtkHoldfastSurfaceRulerWidget::PrepareHandles()
{
  const int* cursor = this->Interactor->GetEventPosition();
  if (this->CurrentRenderer == nullptr)
    this->SetCurrentRenderer(this->Interactor->FindPokedRenderer(cursor[0], cursor[1]));
  const std::array widgets{this->Point1Widget, this->Point2Widget};
  for (const int end : {0, 1}) {
    widgets[end]->SetRepresentation(&this->Drawn().GetHandle(end));
    widgets[end]->SetInteractor(this->Interactor);
    widgets[end]->SetCurrentRenderer(this->CurrentRenderer);
  }
}

void vtkHoldfastSurfaceRulerWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  vtkHoldfastSurfaceRulerRepresentation& ruler = this->Drawn();
  const bool isHalfDrawn = this->WidgetState == vtkDistanceWidget::Define;
  ruler.SetSurface(std::move(surface));
  if (this->WidgetState != vtkDistanceWidget::Start && !ruler.IsPlaced()) this->Clear();
  if (isHalfDrawn && this->WidgetState == vtkDistanceWidget::Start) this->InvokeEvent(CancelInteractionEvent);
}

void vtkHoldfastSurfaceRulerWidget::SetLocations(const SurfaceLocation& a, const SurfaceLocation& b)
{
  vtkHoldfastSurfaceRulerRepresentation& ruler = this->Drawn();
  if (!ruler.GetPlacer()->GetSurface()) {
    vtkErrorMacro("The ruler must have a surface before it has locations");
    return;
  }
  this->Cancel();
  const SurfacePlacement first = ruler.GetHandle(0).PlacementAt(a);
  ruler.GetHandle(1).SetLocation(b);
  ruler.GetHandle(0).SetPlacement(&first);
  ruler.VisibilityOn();
  this->SetWidgetStateToManipulate();
  this->Render();
}

const SurfaceLocation* vtkHoldfastSurfaceRulerWidget::GetLocation(int end)
{
  const SurfacePlacement* const placement = this->Drawn().GetHandle(end).GetPlacement();
  return placement != nullptr ? &placement->location : nullptr;
}

void vtkHoldfastSurfaceRulerWidget::Clear()
{
  if (this->GrabbedAt) this->StopDrag();
  for (const int end : {0, 1}) this->Drawn().GetHandle(end).SetPlacement(nullptr);
  this->Point1Widget->SetEnabled(0);
  this->Point2Widget->SetEnabled(0);
  this->Drawn().VisibilityOff();
  this->WidgetState = vtkDistanceWidget::Start;
  this->Render();
}

bool vtkHoldfastSurfaceRulerWidget::Cancel()
{
  if (!this->IsUnderWay()) return false;
  if (this->WidgetState == vtkDistanceWidget::Define) {
    this->Clear();
  } else {
    this->Drawn().GetHandle(this->CurrentHandle).SetPlacement(&*this->GrabbedAt);
    this->StopDrag();
    this->Render();
  }
  this->InvokeEvent(CancelInteractionEvent);
  return true;
}

/// Leaves the grabbed end where it is, without events.
void vtkHoldfastSurfaceRulerWidget::StopDrag()
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

void vtkHoldfastSurfaceRulerWidget::Press()
{
  if (this->WidgetState != vtkDistanceWidget::Manipulate) return this->PressClick();
  this->LeftClick.Forget();
  if (!this->IsCursorInside()) return;
  this->Hover();
  this->CurrentHandle = -1;
  AddPointAction(this);
  if (this->CurrentHandle >= 0)
    this->GrabbedAt = *this->Drawn().GetHandle(this->CurrentHandle).GetPlacement();
  else
    this->PressClick();
}

void vtkHoldfastSurfaceRulerWidget::Move()
{
  DisplayPoint cursor = this->Cursor();
  this->LeftClick.LeaveAt(cursor, this->Drawn().GetPixelRatio());
  if (this->GrabbedAt) return MoveAction(this);
  if (this->WidgetState == vtkDistanceWidget::Manipulate) return this->Hover();
  if (this->WidgetState != vtkDistanceWidget::Define) return;
  if (isCameraMoving(*this->Interactor) || !this->IsCursorInside()) return;
  this->Drawn().WidgetInteraction(cursor.data());
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->Render();
}

void vtkHoldfastSurfaceRulerWidget::Hover()
{
  bool isChanged = false;
  for (const int end : {0, 1}) {
    vtkHoldfastSurfaceHandleRepresentation& handle = this->Drawn().GetHandle(end);
    const int before = handle.GetInteractionState();
    handle.BuildRepresentation();
    isChanged = stateAtCursor(handle, *this->Interactor) != before || isChanged;
  }
  if (isChanged) this->Render();
}

void vtkHoldfastSurfaceRulerWidget::Release()
{
  if (this->GrabbedAt) {
    this->GrabbedAt.reset();
    return EndSelectAction(this);
  }
  DisplayPoint cursor = this->Cursor();
  if (!this->LeftClick.Release(cursor, this->Drawn().GetPixelRatio())) return;
  SurfacePick pick;
  if (!this->GetPlacer()->Pick(*this->CurrentRenderer, cursor.data(), pick)) return;
  if (this->WidgetState == vtkDistanceWidget::Manipulate) {
    this->InvokeEvent(NextRulerEvent);
    this->Clear();
  }
  if (this->WidgetState == vtkDistanceWidget::Define) this->Drawn().WidgetInteraction(cursor.data());
  this->PrepareHandles();
  AddPointAction(this);
  // VTK keeps all events until the second end is placed; the camera needs them.
  this->ReleaseFocus();
  this->EventCallbackCommand->SetAbortFlag(0);
}

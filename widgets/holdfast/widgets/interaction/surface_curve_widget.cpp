#include "holdfast/widgets/interaction/surface_curve_widget.h"

#include <utility>

#include <vtkEvent.h>
#include <vtkWidgetEventTranslator.h>

namespace holdfast {

vtkStandardNewMacro(SurfaceCurveWidget);

SurfaceCurveWidget::SurfaceCurveWidget()
{
  this->FollowCursor = 1;
  this->ManagesCursor = 1;
  // That of VTK is there already.
  this->SetRepresentation(vtkNew<SurfaceCurveRepresentation>());
  this->EventTranslator->ClearEvents();
  vtkWidgetCallbackMapper& mapper = *this->CallbackMapper;
  mapper.SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this,
                           &call<&SurfaceCurveWidget::Press>);
  mapper.SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, &call<&SurfaceCurveWidget::MoveTo>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                           &call<&SurfaceCurveWidget::Release>);
  mapper.SetCallbackMethod(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave, this, &call<&SurfaceCurveWidget::Leave>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonDoubleClickEvent, vtkWidgetEvent::AddFinalPoint, this,
                           &call<&SurfaceCurveWidget::CloseByHand>);
  const auto bindKey = [&](const char* key, unsigned long widgetEvent, void (*action)(vtkAbstractWidget*)) {
    mapper.SetCallbackMethod(vtkCommand::KeyPressEvent, vtkEvent::AnyModifier, 0, 0, key, widgetEvent, this, action);
  };
  for (const char* const key : {"Return", "KP_Enter"})
    bindKey(key, vtkWidgetEvent::AddFinalPoint, &call<&SurfaceCurveWidget::CloseByHand>);
  for (const char* const key : {"BackSpace", "Delete"})
    bindKey(key, vtkWidgetEvent::Delete, &call<&SurfaceCurveWidget::RemoveByHand>);
  bindKey("Escape", vtkWidgetEvent::Reset, &call<&SurfaceCurveWidget::Escape>);
}

void SurfaceCurveWidget::CreateDefaultRepresentation()
{
  // Not by SetRepresentation, which would disable the widget and enable it again: that asks for a representation.
  if (this->WidgetRep == nullptr) this->WidgetRep = SurfaceCurveRepresentation::New();
}

void SurfaceCurveWidget::SetEnabled(int enabling)
{
  if (enabling == 0 && this->Enabled != 0) {
    if (this->IsDragging()) this->Cancel();
    this->LeftClick.Forget();
    this->GetSurfaceCurveRepresentation()->SetPreview(std::nullopt);
    this->RequestCursorShape(VTK_CURSOR_DEFAULT);
  }
  this->Superclass::SetEnabled(enabling);
  // VTK hides what has no point yet: here the vertex under the cursor is shown.
  this->GetSurfaceCurveRepresentation()->VisibilityOn();
}

void SurfaceCurveWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  this->GetSurfaceCurveRepresentation()->SetSurface(std::move(surface));
  this->ShowChanges();
}

bool SurfaceCurveWidget::SetPlaces(const std::vector<Index>& vertices)
{
  SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  curve.ClearAllNodes();
  bool isPossible = true;
  for (const Index vertex : vertices) isPossible = isPossible && curve.InsertPlace(curve.GetNumberOfNodes(), vertex);
  if (!isPossible) curve.ClearAllNodes();
  this->ShowChanges();
  return isPossible;
}

void SurfaceCurveWidget::Clear()
{
  this->GetSurfaceCurveRepresentation()->ClearAllNodes();
  this->ShowChanges();
}

bool SurfaceCurveWidget::AddPlace(Index vertex)
{
  SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  const int count = curve.GetNumberOfNodes();
  if (this->IsClosed() || !curve.InsertPlace(count, vertex)) return false;
  curve.SetPreview(std::nullopt);
  if (count == 0) this->Tell(vtkCommand::StartInteractionEvent);
  this->InvokeEvent(vtkCommand::PlacePointEvent, &vertex);
  this->Changed();
  return true;
}

bool SurfaceCurveWidget::Close()
{
  SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  if (!curve.IsClosable()) return false;
  curve.SetPreview(std::nullopt);
  curve.ClosedLoopOn();
  this->Changed();
  this->Tell(vtkCommand::EndInteractionEvent);
  return true;
}

bool SurfaceCurveWidget::RemoveLast()
{
  SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  curve.ClosedLoopOff();
  if (curve.DeleteLastNode() == 0) return false;
  curve.SetPreview(std::nullopt);
  this->Changed();
  return true;
}

bool SurfaceCurveWidget::Cancel()
{
  if (this->GetPlaces().empty()) return false;
  const bool isDrag = this->IsDragging();
  this->Clear();
  if (isDrag) {
    this->SetPlaces(this->PlacesBefore);
    this->CloseLoop();
  }
  this->Tell(CancelInteractionEvent);
  return true;
}

void SurfaceCurveWidget::Initialize(vtkPolyData* line, int state, vtkIdList* vertices)
{
  if (line == nullptr) return this->Clear();
  this->Superclass::Initialize(line, state, vertices);
  this->ShowChanges();
}

void SurfaceCurveWidget::Tell(unsigned long event)
{
  std::vector<Index> places = this->GetPlaces();
  this->InvokeEvent(event, &places);
}

void SurfaceCurveWidget::UpdateState()
{
  if (this->IsClosed())
    this->WidgetState = Manipulate;
  else
    this->WidgetState = this->GetPlaces().empty() ? Start : Define;
}

void SurfaceCurveWidget::ShowChanges()
{
  this->UpdateState();
  SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  if (curve.GetNeedToRender() == 0) return;
  curve.NeedToRenderOff();
  this->Render();
}

void SurfaceCurveWidget::Changed()
{
  this->ShowChanges();
  this->Tell(vtkCommand::WidgetValueChangedEvent);
}

void SurfaceCurveWidget::Press()
{
  if (!isCursorIn(*this->CurrentRenderer, *this->Interactor)) return;
  if (isSecondPress(*this->Interactor)) return this->CloseByHand();
  this->LeftClick.Press(cursorOf(*this->Interactor));
  if (this->IsClosed()) this->BeginDrag();
}

void SurfaceCurveWidget::BeginDrag()
{
  SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  DisplayPoint cursor = cursorOf(*this->Interactor);
  const std::vector<Index> before = this->GetPlaces();
  const auto activate = [&] { return curve.ActivateNode(cursor.data()) != 0; };
  const auto add = [&] {
    return curve.AddNodeOnContour(static_cast<int>(cursor.x()), static_cast<int>(cursor.y())) != 0;
  };
  if (!activate() && !(add() && activate())) return this->ShowChanges();
  this->Use();
  this->LeftClick.Forget();
  this->PlacesBefore = before;
  curve.SetCurrentOperationToTranslate();
  this->Tell(vtkCommand::StartInteractionEvent);
  if (this->GetPlaces() != before) this->Changed();
  this->ShowChanges();
}

void SurfaceCurveWidget::DragTo(const DisplayPoint& cursor)
{
  const std::vector<Index> before = this->GetPlaces();
  DisplayPoint pixel = cursor;
  this->GetSurfaceCurveRepresentation()->WidgetInteraction(pixel.data());
  if (this->GetPlaces() == before) return;
  this->ShowChanges();
  this->Tell(vtkCommand::InteractionEvent);
  this->Tell(vtkCommand::WidgetValueChangedEvent);
}

void SurfaceCurveWidget::EndDrag()
{
  this->GetSurfaceCurveRepresentation()->SetCurrentOperationToInactive();
  this->ShowChanges();
  this->Tell(vtkCommand::EndInteractionEvent);
}

void SurfaceCurveWidget::MoveTo()
{
  const DisplayPoint cursor = cursorOf(*this->Interactor);
  if (this->IsDragging()) {
    this->Use();
    return this->DragTo(cursor);
  }
  this->LeftClick.LeaveAt(cursor, this->GetPixelRatio());
  if (!isCameraMoving(*this->Interactor)) this->Hover(cursor);
}

void SurfaceCurveWidget::Hover(const DisplayPoint& cursor)
{
  if (!isCursorIn(*this->CurrentRenderer, *this->Interactor)) return this->Leave();
  SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  bool isOverPlace = curve.IsAtFirst(cursor);
  if (this->IsClosed())
    isOverPlace = curve.ActivateNode(static_cast<int>(cursor.x()), static_cast<int>(cursor.y())) != 0;
  else if (this->FollowCursor != 0)
    curve.SetPreview(isOverPlace ? curve.GetPlaces().front() : curve.VertexAt(cursor));
  if (this->ManagesCursor != 0) this->RequestCursorShape(isOverPlace ? VTK_CURSOR_HAND : VTK_CURSOR_CROSSHAIR);
  this->ShowChanges();
}

void SurfaceCurveWidget::Leave()
{
  if (this->ManagesCursor != 0) this->RequestCursorShape(VTK_CURSOR_DEFAULT);
  this->GetSurfaceCurveRepresentation()->SetPreview(std::nullopt);
  this->ShowChanges();
}

void SurfaceCurveWidget::Release()
{
  if (this->IsDragging()) {
    this->Use();
    return this->EndDrag();
  }
  const DisplayPoint cursor = cursorOf(*this->Interactor);
  if (this->LeftClick.Release(cursor, this->GetPixelRatio())) this->ClickAt(cursor);
}

void SurfaceCurveWidget::ClickAt(const DisplayPoint& cursor)
{
  const SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  if (this->GetSurfaceCurveRepresentation()->IsAtFirst(cursor))
    this->Close();
  else if (const auto vertex = curve.VertexAt(cursor))
    this->AddPlace(*vertex);
}

void SurfaceCurveWidget::RemoveByHand()
{
  SurfaceCurveRepresentation& curve = *this->GetSurfaceCurveRepresentation();
  if (this->GetPlaces().empty() || this->IsDragging()) return;
  this->Use();
  if (!this->IsClosed() || curve.ActivateNode(cursorOf(*this->Interactor).data()) == 0) {
    this->RemoveLast();
    return;
  }
  curve.DeleteActiveNode();
  if (curve.GetNumberOfNodes() < 3) curve.ClosedLoopOff();
  this->Changed();
}

}  // namespace holdfast

#include "holdfast/widgets/interaction/vtkHoldfastSurfaceCurveWidget.h"

#include <vtkWidgetEventTranslator.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfaceCurveWidget);

vtkHoldfastSurfaceCurveWidget::vtkHoldfastSurfaceCurveWidget()
{
  this->FollowCursor = 1;
  this->ManagesCursor = 1;
  // The base class has made a representation of VTK already.
  this->SetRepresentation(vtkNew<vtkHoldfastSurfaceCurveRepresentation>());
  this->EventTranslator->ClearEvents();
  using Widget = vtkHoldfastSurfaceCurveWidget;
  this->Bind<&Widget::Press>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select);
  this->Bind<&Widget::MoveTo>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  this->Bind<&Widget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  this->Bind<&Widget::Leave>(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave);
  this->Bind<&Widget::Close>(vtkCommand::LeftButtonDoubleClickEvent, vtkWidgetEvent::AddFinalPoint);
  for (const char* const key : {"Return", "KP_Enter"})
    this->BindKey<&Widget::Close>(key, vtkWidgetEvent::AddFinalPoint);
  for (const char* const key : {"BackSpace", "Delete"})
    this->BindKey<&Widget::RemoveByHand>(key, vtkWidgetEvent::Delete);
  this->BindKey<&Widget::Cancel>("Escape", vtkWidgetEvent::Reset);
}

void vtkHoldfastSurfaceCurveWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkHoldfastSurfaceCurveWidget::SetEnabled(int enabling)
{
  this->WidgetOf::SetEnabled(enabling);
  // VTK hides what has no point yet: here the vertex under the cursor is shown.
  this->Drawn().VisibilityOn();
}

void vtkHoldfastSurfaceCurveWidget::Stop()
{
  if (this->IsDragging()) this->Cancel();
  this->Drawn().HidePreview();
  this->RequestCursorShape(VTK_CURSOR_DEFAULT);
}

void vtkHoldfastSurfaceCurveWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  this->Drawn().SetSurface(std::move(surface));
  this->ShowChanges();
}

bool vtkHoldfastSurfaceCurveWidget::SetPlaces(const std::vector<Index>& vertices)
{
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  curve.ClearAllNodes();
  bool isPossible = true;
  for (const Index vertex : vertices) isPossible = isPossible && curve.InsertPlace(curve.GetNumberOfNodes(), vertex);
  if (!isPossible) curve.ClearAllNodes();
  this->ShowChanges();
  return isPossible;
}

void vtkHoldfastSurfaceCurveWidget::Clear()
{
  this->Drawn().ClearAllNodes();
  this->ShowChanges();
}

bool vtkHoldfastSurfaceCurveWidget::AddPlace(Index vertex)
{
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  const int count = curve.GetNumberOfNodes();
  if (this->IsClosed() || !curve.InsertPlace(count, vertex)) return false;
  curve.HidePreview();
  if (count == 0) this->Tell(vtkCommand::StartInteractionEvent);
  this->InvokeEvent(vtkCommand::PlacePointEvent, &vertex);
  this->Changed();
  return true;
}

bool vtkHoldfastSurfaceCurveWidget::Close()
{
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  if (!curve.IsClosable()) return false;
  curve.HidePreview();
  curve.ClosedLoopOn();
  this->Changed();
  this->Tell(vtkCommand::EndInteractionEvent);
  return true;
}

bool vtkHoldfastSurfaceCurveWidget::RemoveLast()
{
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  curve.ClosedLoopOff();
  if (curve.DeleteLastNode() == 0) return false;
  curve.HidePreview();
  this->Changed();
  return true;
}

bool vtkHoldfastSurfaceCurveWidget::Cancel()
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

void vtkHoldfastSurfaceCurveWidget::Initialize(vtkPolyData* line, int state, vtkIdList* vertices)
{
  if (line == nullptr) return this->Clear();
  this->Superclass::Initialize(line, state, vertices);
  this->ShowChanges();
}

void vtkHoldfastSurfaceCurveWidget::Tell(unsigned long event)
{
  std::vector<Index> places = this->GetPlaces();
  this->InvokeEvent(event, &places);
}

void vtkHoldfastSurfaceCurveWidget::ShowChanges()
{
  if (this->IsClosed())
    this->WidgetState = Manipulate;
  else
    this->WidgetState = this->GetPlaces().empty() ? Start : Define;
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  if (curve.GetNeedToRender() == 0) return;
  curve.NeedToRenderOff();
  this->Render();
}

void vtkHoldfastSurfaceCurveWidget::Changed()
{
  this->ShowChanges();
  this->Tell(vtkCommand::WidgetValueChangedEvent);
}

bool vtkHoldfastSurfaceCurveWidget::Press()
{
  if (!this->IsCursorInside()) return false;
  if (isSecondPress(*this->Interactor)) return this->Close();
  this->LeftClick.Press(this->Cursor());
  return this->IsClosed() && this->BeginDrag();
}

bool vtkHoldfastSurfaceCurveWidget::BeginDrag()
{
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  DisplayPoint cursor = this->Cursor();
  const std::vector<Index> before = this->GetPlaces();
  const auto activate = [&] { return curve.ActivateNode(cursor.data()) != 0; };
  const auto add = [&] {
    return curve.AddNodeOnContour(static_cast<int>(cursor.x()), static_cast<int>(cursor.y())) != 0;
  };
  const bool isDrag = activate() || (add() && activate());
  if (isDrag) {
    this->LeftClick.Forget();
    this->PlacesBefore = before;
    curve.SetCurrentOperationToTranslate();
    this->Tell(vtkCommand::StartInteractionEvent);
    if (this->GetPlaces() != before) this->Changed();
  }
  this->ShowChanges();
  return isDrag;
}

bool vtkHoldfastSurfaceCurveWidget::MoveTo()
{
  DisplayPoint cursor = this->Cursor();
  if (this->IsDragging()) {
    const std::vector<Index> before = this->GetPlaces();
    this->Drawn().WidgetInteraction(cursor.data());
    if (this->GetPlaces() == before) return true;
    this->ShowChanges();
    this->Tell(vtkCommand::InteractionEvent);
    this->Tell(vtkCommand::WidgetValueChangedEvent);
    return true;
  }
  this->LeftClick.LeaveAt(cursor, this->GetPixelRatio());
  if (!isCameraMoving(*this->Interactor)) this->Hover(cursor);
  return false;
}

void vtkHoldfastSurfaceCurveWidget::Hover(const DisplayPoint& cursor)
{
  if (!this->IsCursorInside()) return this->Leave();
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  bool isOverPlace = curve.IsAtFirst(cursor);
  if (this->IsClosed())
    isOverPlace = curve.ActivateNode(static_cast<int>(cursor.x()), static_cast<int>(cursor.y())) != 0;
  else if (this->FollowCursor != 0)
    curve.SetPreview(isOverPlace ? curve.GetPlaces().front() : curve.VertexAt(cursor));
  this->ShowCursor(isOverPlace ? VTK_CURSOR_HAND : VTK_CURSOR_CROSSHAIR);
  this->ShowChanges();
}

void vtkHoldfastSurfaceCurveWidget::Leave()
{
  this->ShowCursor(VTK_CURSOR_DEFAULT);
  this->Drawn().HidePreview();
  this->ShowChanges();
}

bool vtkHoldfastSurfaceCurveWidget::Release()
{
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  if (this->IsDragging()) {
    curve.SetCurrentOperationToInactive();
    this->ShowChanges();
    this->Tell(vtkCommand::EndInteractionEvent);
    return true;
  }
  const DisplayPoint cursor = this->Cursor();
  if (!this->LeftClick.Release(cursor, this->GetPixelRatio())) return false;
  if (curve.IsAtFirst(cursor))
    this->Close();
  else if (const Index vertex = curve.VertexAt(cursor); vertex >= 0)
    this->AddPlace(vertex);
  return false;
}

bool vtkHoldfastSurfaceCurveWidget::RemoveByHand()
{
  if (this->GetPlaces().empty() || this->IsDragging()) return false;
  vtkHoldfastSurfaceCurveRepresentation& curve = this->Drawn();
  if (!this->IsClosed() || curve.ActivateNode(this->Cursor().data()) == 0) return this->RemoveLast();
  curve.DeleteActiveNode();
  if (curve.GetNumberOfNodes() < 3) curve.ClosedLoopOff();
  this->Changed();
  return true;
}

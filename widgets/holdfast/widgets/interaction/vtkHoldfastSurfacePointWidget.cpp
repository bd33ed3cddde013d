#include "holdfast/widgets/interaction/vtkHoldfastSurfacePointWidget.h"

#include <utility>

#include <vtkWidgetEventTranslator.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfacePointWidget);

vtkHoldfastSurfacePointWidget::vtkHoldfastSurfacePointWidget()
{
  this->Bind<&vtkHoldfastSurfacePointWidget::Hover>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  for (const unsigned long event :
       {vtkCommand::LeaveEvent, vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent})
    this->Bind<&vtkHoldfastSurfacePointWidget::Leave>(event, vtkWidgetEvent::HoverLeave);
  this->Bind<&vtkHoldfastSurfacePointWidget::PressClick>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select);
  this->Bind<&vtkHoldfastSurfacePointWidget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::AddPoint);
  const auto bindKey = [&](char key, unsigned long widgetEvent, void (*action)(vtkAbstractWidget*)) {
    this->CallbackMapper->SetCallbackMethod(vtkCommand::CharEvent, vtkEvent::NoModifier, key, 0, nullptr, widgetEvent,
                                            this, action);
  };
  bindKey('v', ChooseVertices, &Call<&vtkHoldfastSurfacePointWidget::Choose<PickKind::Vertex>>);
  bindKey('e', ChooseEdges, &Call<&vtkHoldfastSurfacePointWidget::Choose<PickKind::Edge>>);
  bindKey('f', ChooseFaces, &Call<&vtkHoldfastSurfacePointWidget::Choose<PickKind::Face>>);
  bindKey('a', ChooseNearest, &Call<&vtkHoldfastSurfacePointWidget::Choose<PickKind::Nearest>>);
}

void vtkHoldfastSurfacePointWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Placer: " << this->Placer.Get() << '\n';
  os << indent << "Kind: " << static_cast<int>(this->GetKind()) << '\n';
  os << indent << "PixelRatio: " << this->GetPixelRatio() << '\n';
}

void vtkHoldfastSurfacePointWidget::Inform(vtkHoldfastSurfacePointRepresentation& representation)
{
  representation.SetSurface(this->Placer->GetSurface());
  representation.SetPixelRatio(this->GetPixelRatio());
}

void vtkHoldfastSurfacePointWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  this->Placer->SetSurface(std::move(surface));
  this->Inform(this->Drawn());
}

void vtkHoldfastSurfacePointWidget::SetKind(PickKind kind)
{
  if (this->GetKind() == kind) return;
  this->Placer->SetKind(kind);
  if (this->IsHovering) this->ShowPickAtCursor();
}

void vtkHoldfastSurfacePointWidget::SetPixelRatio(double ratio)
{
  this->Placer->SetPixelRatio(ratio);
  this->Inform(this->Drawn());
}

void vtkHoldfastSurfacePointWidget::SetPreview(const SurfacePick* pick)
{
  this->Drawn().SetPreview(pick);
  if (this->Enabled != 0) this->Render();
}

bool vtkHoldfastSurfacePointWidget::WantsKey(char key) const
{
  return this->EventTranslator->GetTranslation(vtkCommand::CharEvent, vtkEvent::NoModifier, key, 0, nullptr) !=
         vtkWidgetEvent::NoEvent;
}

void vtkHoldfastSurfacePointWidget::ShowPickAtCursor()
{
  SurfacePick pick;
  this->Show(this->PickAtCursor(pick) ? &pick : nullptr);
}

void vtkHoldfastSurfacePointWidget::Show(SurfacePick* pick)
{
  if (pick == nullptr && this->GetPreview() == nullptr) return;
  this->ShowCursor(pick != nullptr ? VTK_CURSOR_CROSSHAIR : VTK_CURSOR_DEFAULT);
  this->SetPreview(pick);
  this->InvokeEvent(vtkCommand::InteractionEvent, pick);
}

void vtkHoldfastSurfacePointWidget::Hover()
{
  const bool isDrag = this->LeftClick.LeaveAt(this->Cursor(), this->GetPixelRatio());
  if (isDrag || !this->IsCursorInside() || isCameraMoving(*this->Interactor)) return this->Leave();
  this->IsHovering = true;
  this->ShowPickAtCursor();
}

void vtkHoldfastSurfacePointWidget::Leave()
{
  this->IsHovering = false;
  this->Show(nullptr);
}

void vtkHoldfastSurfacePointWidget::Release()
{
  if (!this->LeftClick.Release(this->Cursor(), this->GetPixelRatio())) return;
  SurfacePick pick;
  if (this->PickAtCursor(pick)) this->InvokeEvent(vtkCommand::PlacePointEvent, &pick);
}

template <PickKind Kind>
bool vtkHoldfastSurfacePointWidget::Choose()
{
  if (this->GetKind() == Kind) return true;
  this->SetKind(Kind);
  PickKind kind = Kind;
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent, &kind);
  return true;
}

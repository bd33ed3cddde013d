#include "holdfast/widgets/interaction/surface_point_widget.h"

#include <array>
#include <utility>

#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

// Pixels of a display of ordinary resolution.
constexpr double kPreviewBallPixels = 9;
constexpr double kHaloPixels = 3.5;
constexpr double kOutlinePixels = 1.6;

constexpr Color kHaloColor{1, 1, 1};

}  // namespace

vtkStandardNewMacro(SurfacePointRepresentation);

SurfacePointRepresentation::SurfacePointRepresentation()
{
  const auto addLine = [this](vtkActor& actor, const Color& color) {
    showData(actor, *this->Outline);
    setColor(actor, color);
    actor.GetProperty()->LightingOff();
    this->Props.push_back(&actor);
  };
  addLine(*this->LineBehind, kAccentColor);
  addLine(*this->LineHalo, kHaloColor);
  addLine(*this->Line, kAccentColor);
  for (vtkActor* const actor : this->Point.actors()) this->Props.push_back(actor);
  this->SetPixelRatio(1);
}

void SurfacePointRepresentation::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  if (this->Surface == surface) return;
  if (!surface || !this->Surface || !surface->isSameMesh(*this->Surface)) this->Preview.reset();
  this->Surface = std::move(surface);
  this->SetPreview(std::exchange(this->Preview, std::nullopt));
}

void SurfacePointRepresentation::SetPreview(std::optional<SurfacePick> pick)
{
  this->Preview = this->Surface ? std::move(pick) : std::nullopt;
  if (this->Preview)
    this->Preview->place =
        positionOf(pointOf(this->Preview->location, this->Surface->model().mesh), this->Surface->positions());
  this->Modified();
}

void SurfacePointRepresentation::SetPixelRatio(double ratio)
{
  this->PixelRatio = ratio;
  this->Point.setBallPixels(kPreviewBallPixels * ratio);
  setLineWidth(*this->LineBehind, kOutlinePixels * ratio);
  setLineWidth(*this->LineHalo, kHaloPixels * ratio);
  setLineWidth(*this->Line, kOutlinePixels * ratio);
  this->Modified();
}

void SurfacePointRepresentation::BuildRepresentation()
{
  if (this->BuildTime > this->GetMTime()) return;
  std::vector<Vector3> outline;
  const auto add = [&](Index vertex) { outline.emplace_back(this->Surface->positions().row(vertex)); };
  const SurfaceLocation* const at = this->Preview ? &this->Preview->location : nullptr;
  if (const auto* edge = std::get_if<AtEdge>(at)) {
    add(edge->i);
    add(edge->j);
  }
  if (const auto* face = std::get_if<AtFace>(at))
    for (const Index corner : this->Surface->model().mesh.faces[face->face]) add(corner);
  if (!outline.empty()) outline.push_back(outline.front());
  setLines(*this->Outline, {outline});
  std::optional<PreviewedPoint> point;
  // In the order of `SurfaceLocation`; no pick is near a place.
  constexpr std::array kKinds{MarkKind::Vertex, MarkKind::Edge, MarkKind::Face};
  static_assert(std::variant_size_v<SurfaceLocation> == kKinds.size() + 1);
  if (this->Preview) point.emplace(PreviewedPoint{this->Preview->place, kKinds.at(this->Preview->location.index())});
  this->Point.set(point);
  this->BuildTime.Modified();
}

vtkStandardNewMacro(SurfacePointWidget);

SurfacePointWidget::SurfacePointWidget()
{
  this->Bind<&SurfacePointWidget::Hover>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  for (const unsigned long event :
       {vtkCommand::LeaveEvent, vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent})
    this->Bind<&SurfacePointWidget::Leave>(event, vtkWidgetEvent::HoverLeave);
  this->Bind<&SurfacePointWidget::PressClick>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select);
  this->Bind<&SurfacePointWidget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::AddPoint);
  const auto bindKey = [&](char key, unsigned long widgetEvent, void (*action)(vtkAbstractWidget*)) {
    this->CallbackMapper->SetCallbackMethod(vtkCommand::CharEvent, vtkEvent::NoModifier, key, 0, nullptr, widgetEvent,
                                            this, action);
  };
  bindKey('v', ChooseVertices, &Call<&SurfacePointWidget::Choose<PickKind::Vertex>>);
  bindKey('e', ChooseEdges, &Call<&SurfacePointWidget::Choose<PickKind::Edge>>);
  bindKey('f', ChooseFaces, &Call<&SurfacePointWidget::Choose<PickKind::Face>>);
  bindKey('a', ChooseNearest, &Call<&SurfacePointWidget::Choose<PickKind::Nearest>>);
}

void SurfacePointWidget::Inform(SurfacePointRepresentation& representation)
{
  representation.SetSurface(this->Placer->GetSurface());
  representation.SetPixelRatio(this->GetPixelRatio());
}

void SurfacePointWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  this->Placer->SetSurface(std::move(surface));
  this->Inform(this->Drawn());
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
  this->Inform(this->Drawn());
}

void SurfacePointWidget::SetPreview(std::optional<SurfacePick> pick)
{
  this->Drawn().SetPreview(std::move(pick));
  if (this->Enabled != 0) this->Render();
}

bool SurfacePointWidget::WantsKey(char key) const
{
  return this->EventTranslator->GetTranslation(vtkCommand::CharEvent, vtkEvent::NoModifier, key, 0, nullptr) !=
         vtkWidgetEvent::NoEvent;
}

void SurfacePointWidget::Show(std::optional<SurfacePick> pick)
{
  if (!pick && !this->GetPreview()) return;
  this->ShowCursor(pick ? VTK_CURSOR_CROSSHAIR : VTK_CURSOR_DEFAULT);
  this->SetPreview(pick);
  this->InvokeEvent(vtkCommand::InteractionEvent, pick ? &*pick : nullptr);
}

void SurfacePointWidget::Hover()
{
  const bool isDrag = this->LeftClick.LeaveAt(this->Cursor(), this->GetPixelRatio());
  if (isDrag || !this->IsCursorInside() || isCameraMoving(*this->Interactor)) return this->Leave();
  this->IsHovering = true;
  this->Show(this->PickAtCursor());
}

void SurfacePointWidget::Leave()
{
  this->IsHovering = false;
  this->Show(std::nullopt);
}

void SurfacePointWidget::Release()
{
  if (!this->LeftClick.Release(this->Cursor(), this->GetPixelRatio())) return;
  if (auto pick = this->PickAtCursor()) this->InvokeEvent(vtkCommand::PlacePointEvent, &*pick);
}

template <PickKind Kind>
bool SurfacePointWidget::Choose()
{
  if (this->GetKind() == Kind) return true;
  this->SetKind(Kind);
  PickKind kind = Kind;
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent, &kind);
  return true;
}

}  // namespace holdfast

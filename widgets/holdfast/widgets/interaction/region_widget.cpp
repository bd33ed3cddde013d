#include "holdfast/widgets/interaction/region_widget.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkEvent.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/interaction/region_representation.h>

namespace holdfast {
namespace {

// A share of the radius.
constexpr double kDabSpacing = 0.4;

constexpr double kLeastBrushPixels = 4;
constexpr double kMostBrushPixels = 300;
constexpr double kBrushStep = 1.2;

constexpr double kMostSideDegrees = 175;
constexpr double kSideStepDegrees = 5;

// A smaller outline is a click, and selects nothing.
constexpr double kLeastOutlinePixels = 3;

// Vertices in one turn of the event loop: some 15 milliseconds at the most.
constexpr Index kVerticesOfTurn = 12'000;
constexpr unsigned long kTurnMilliseconds = 1;

double extentOf(const std::vector<DisplayPoint>& points)
{
  DisplayPoint least = points.front();
  DisplayPoint most = points.front();
  for (const DisplayPoint& point : points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  return (most - least).maxCoeff();
}

}  // namespace

bool BrushStroke::dab(const DisplayPoint& pixel, double radiusPixels, const SurfacePicker& picker,
                      vtkRenderer& renderer)
{
  const auto pick = picker.pick(renderer, pixel.x(), pixel.y(), PickKind::Face, 0);
  if (!pick) return false;
  const Vector3 center = atDepthOf(renderer, pick->place, pixel);
  const Vector3 border = atDepthOf(renderer, pick->place, pixel + DisplayPoint(radiusPixels, 0));
  const VisibleSurface& surface = *picker.surface();
  auto touched = regions_->within((border - center).norm(), pick->place, pick->face, surface.positions());
  std::erase_if(touched, [&](Index v) { return !surface.isKept(surface.positions().row(v)); });
  reached_ = joined(reached_, touched, SelectionMode::Add);
  return true;
}

bool BrushStroke::paintTo(const DisplayPoint& pixel, double radiusPixels,
                          const std::shared_ptr<const VisibleSurface>& surface, vtkRenderer& renderer)
{
  const SurfacePicker picker(surface);
  const DisplayPoint from = at_.value_or(pixel);
  const double dabs = std::ceil((pixel - from).norm() / (kDabSpacing * radiusPixels));
  const int count = std::max(1, static_cast<int>(dabs));
  bool isOnSurface = false;
  for (int k = 1; k <= count; ++k) isOnSurface = dab(from + (pixel - from) * k / count, radiusPixels, picker, renderer);
  at_ = pixel;
  return isOnSurface;
}

vtkStandardNewMacro(RegionWidget);

RegionWidget::RegionWidget()
{
  vtkWidgetCallbackMapper& mapper = *this->CallbackMapper;
  mapper.SetCallbackMethod(vtkCommand::LeftButtonDoubleClickEvent, vtkWidgetEvent::Completed, this,
                           &call<&RegionWidget::PressAgain>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this, &call<&RegionWidget::Press>);
  mapper.SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, &call<&RegionWidget::MoveTo>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                           &call<&RegionWidget::Release>);
  mapper.SetCallbackMethod(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave, this, &call<&RegionWidget::Leave>);
  mapper.SetCallbackMethod(vtkCommand::TimerEvent, vtkWidgetEvent::TimedOut, this, &call<&RegionWidget::TimeOut>);
  const auto bindKey = [&](const char* key, unsigned long widgetEvent, void (*action)(vtkAbstractWidget*)) {
    mapper.SetCallbackMethod(vtkCommand::KeyPressEvent, vtkEvent::AnyModifier, 0, 0, key, widgetEvent, this, action);
  };
  bindKey("bracketleft", vtkWidgetEvent::Down, &call<&RegionWidget::Step<-1>>);
  bindKey("bracketright", vtkWidgetEvent::Up, &call<&RegionWidget::Step<1>>);
  bindKey("Escape", vtkWidgetEvent::Reset, &call<&RegionWidget::Escape>);
}

void RegionWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << static_cast<int>(this->Shape) << '\n';
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Regions: " << this->Regions.get() << '\n';
  os << indent << "BrushRadius: " << this->BrushRadius << '\n';
  os << indent << "SideAngle: " << this->SideAngle << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
}

void RegionWidget::SetRepresentation(RegionRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
  if (representation != nullptr) representation->SetPixelRatio(this->PixelRatio);
}

RegionRepresentation* RegionWidget::GetRegionRepresentation()
{
  return static_cast<RegionRepresentation*>(this->GetRepresentation());
}

void RegionWidget::CreateDefaultRepresentation()
{
  if (this->WidgetRep != nullptr) return;
  // Not by SetRepresentation, which would disable the widget and enable it again: that asks for a representation.
  auto* representation = RegionRepresentation::New();
  representation->SetPixelRatio(this->PixelRatio);
  this->WidgetRep = representation;
}

void RegionWidget::SetEnabled(int enabling)
{
  if (enabling == 0 && this->Enabled != 0) {
    this->Cancel();
    this->GetRegionRepresentation()->ShowNothing();
    if (this->ManagesCursor != 0) this->RequestCursorShape(VTK_CURSOR_DEFAULT);
  }
  this->Superclass::SetEnabled(enabling);
}

void RegionWidget::SetShape(RegionShape shape)
{
  if (this->Shape == shape) return;
  this->Cancel();
  this->Shape = shape;
  this->GetRegionRepresentation()->ShowNothing();
  this->Modified();
}

void RegionWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  if (this->Surface == surface) return;
  if (!surface || !this->Surface || &surface->model() != &this->Surface->model()) this->Cancel();
  this->Surface = std::move(surface);
  this->Modified();
}

void RegionWidget::SetRegions(std::shared_ptr<VertexRegions> regions)
{
  if (this->Regions == regions) return;
  this->Cancel();
  this->Regions = std::move(regions);
  this->Modified();
}

void RegionWidget::SetBrushRadius(double pixels)
{
  const double radius = std::clamp(pixels, kLeastBrushPixels, kMostBrushPixels);
  if (radius == this->BrushRadius) return;
  this->BrushRadius = radius;
  if (!this->GetRegionRepresentation()->GetOutline().empty() && this->Shape == RegionShape::Brush) this->ShowBrush();
  this->Modified();
}

void RegionWidget::SetSideAngle(double degrees)
{
  const double angle = std::clamp(degrees, 0.0, kMostSideDegrees);
  if (angle == this->SideAngle) return;
  this->SideAngle = angle;
  this->Modified();
}

void RegionWidget::SetPixelRatio(double ratio)
{
  if (ratio == this->PixelRatio) return;
  this->PixelRatio = std::clamp(ratio, 0.1, 100.0);
  this->GetRegionRepresentation()->SetPixelRatio(this->PixelRatio);
  this->Modified();
}

std::optional<SurfacePick> RegionWidget::FaceUnderCursor() const
{
  const DisplayPoint cursor = cursorOf(*this->Interactor);
  return SurfacePicker(this->Surface).pick(*this->CurrentRenderer, cursor.x(), cursor.y(), PickKind::Face, 0);
}

void RegionWidget::Tell(unsigned long event, std::vector<Index> reached)
{
  RegionCallData data{std::move(reached), this->Mode};
  this->InvokeEvent(event, &data);
}

void RegionWidget::Press()
{
  if (this->Shape == RegionShape::Side && isSecondPress(*this->Interactor)) return this->SelectPart();
  this->Cancel();
  if (!this->Surface || !isCursorIn(*this->CurrentRenderer, *this->Interactor)) return;
  this->Trail = {cursorOf(*this->Interactor)};
  this->Mode = selectionModeOf(*this->Interactor);
  switch (this->Shape) {
    case RegionShape::Brush:
      return this->BeginStroke();
    case RegionShape::Rectangle:
    case RegionShape::Lasso:
      return this->BeginOutline();
    case RegionShape::Side:
      this->LeftClick.Press(cursorOf(*this->Interactor));
  }
}

void RegionWidget::PressAgain()
{
  if (this->Shape == RegionShape::Side) return this->SelectPart();
  this->Press();
}

void RegionWidget::MoveTo()
{
  switch (this->Current) {
    case Gesture::Stroke:
      this->Use();
      return this->PaintTo(cursorOf(*this->Interactor));
    case Gesture::Outline:
      this->Use();
      this->Trail.push_back(cursorOf(*this->Interactor));
      return this->ShowOutline();
    case Gesture::None:
    case Gesture::Search:
      this->LeftClick.LeaveAt(cursorOf(*this->Interactor), this->PixelRatio);
      if (!isCameraMoving(*this->Interactor)) this->Hover();
  }
}

void RegionWidget::Release()
{
  switch (this->Current) {
    case Gesture::Stroke:
      this->Use();
      this->Current = Gesture::None;
      return this->Tell(vtkCommand::EndInteractionEvent, std::exchange(this->Stroke, std::nullopt)->reached());
    case Gesture::Outline:
      this->Use();
      this->Trail.push_back(cursorOf(*this->Interactor));
      return this->EndOutline();
    case Gesture::None:
    case Gesture::Search:
      if (this->LeftClick.Release(cursorOf(*this->Interactor), this->PixelRatio)) this->SelectSide();
  }
}

void RegionWidget::BeginStroke()
{
  if (!this->Regions || !this->FaceUnderCursor()) return;
  this->Use();
  this->Current = Gesture::Stroke;
  this->Stroke.emplace(this->Regions);
  this->Tell(vtkCommand::StartInteractionEvent, {});
  this->PaintTo(cursorOf(*this->Interactor));
}

void RegionWidget::PaintTo(const DisplayPoint& cursor)
{
  // An observer may have removed the surface.
  if (!this->Stroke) return;
  this->Stroke->paintTo(cursor, this->BrushRadius * this->PixelRatio, this->Surface, *this->CurrentRenderer);
  this->ShowBrush();
  this->Tell(vtkCommand::InteractionEvent, this->Stroke->reached());
}

void RegionWidget::BeginOutline()
{
  this->Use();
  this->Current = Gesture::Outline;
  this->Tell(vtkCommand::StartInteractionEvent, {});
}

std::vector<DisplayPoint> RegionWidget::Polygon() const
{
  if (this->Shape == RegionShape::Lasso) return this->Trail;
  const DisplayPoint& a = this->Trail.front();
  const DisplayPoint& b = this->Trail.back();
  return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
}

void RegionWidget::EndOutline()
{
  const std::vector<DisplayPoint> polygon = this->Polygon();
  if (extentOf(polygon) < kLeastOutlinePixels * this->PixelRatio) {
    this->Cancel();
    return;
  }
  this->GetRegionRepresentation()->ShowNothing();
  this->Render();
  this->Mode = selectionModeOf(*this->Interactor);
  const ScreenReach reach = this->Interactor->GetAltKey() != 0 ? ScreenReach::Through : ScreenReach::VisibleOnly;
  this->Found = std::make_unique<ScreenSelection>(*this->CurrentRenderer, this->Surface, polygon, reach);
  this->Current = Gesture::Search;
  this->Search();
}

void RegionWidget::Search()
{
  do {
    this->Found->advance(kVerticesOfTurn);
    if (this->Found->isDone()) {
      this->Current = Gesture::None;
      return this->Tell(vtkCommand::EndInteractionEvent, std::exchange(this->Found, nullptr)->inside());
    }
    this->TimerId = this->Interactor->CreateOneShotTimer(kTurnMilliseconds);
  } while (this->TimerId == 0);
}

void RegionWidget::TimeOut()
{
  if (this->Current != Gesture::Search || this->CallData == nullptr) return;
  if (*static_cast<int*>(this->CallData) == this->TimerId) this->Search();
}

void RegionWidget::SelectSide()
{
  if (!this->Regions) return;
  if (const auto pick = this->FaceUnderCursor()) this->SelectAtOnce(this->Regions->smooth(pick->face, this->SideAngle));
}

void RegionWidget::SelectPart()
{
  this->Cancel();
  if (!this->Surface || !this->Regions || !isCursorIn(*this->CurrentRenderer, *this->Interactor)) return;
  const auto pick = this->FaceUnderCursor();
  if (!pick) return;
  this->Use();
  this->SelectAtOnce(this->Regions->connected(this->Surface->model().mesh.faces[pick->face].front()));
}

void RegionWidget::SelectAtOnce(std::vector<Index> reached)
{
  this->Mode = selectionModeOf(*this->Interactor);
  this->Tell(vtkCommand::StartInteractionEvent, {});
  this->Tell(vtkCommand::EndInteractionEvent, std::move(reached));
}

bool RegionWidget::Cancel()
{
  this->LeftClick.Forget();
  const Gesture gesture = std::exchange(this->Current, Gesture::None);
  if (gesture == Gesture::None) return false;
  this->Stroke.reset();
  this->Found.reset();
  if (gesture == Gesture::Search) this->Interactor->DestroyTimer(this->TimerId);
  if (gesture == Gesture::Outline) this->GetRegionRepresentation()->ShowNothing();
  this->Render();
  this->Tell(CancelInteractionEvent, {});
  return true;
}

template <int Direction>
void RegionWidget::Step()
{
  if (this->Shape == RegionShape::Brush)
    this->SetBrushRadius(this->BrushRadius * std::pow(kBrushStep, Direction));
  else if (this->Shape == RegionShape::Side)
    this->SetSideAngle(this->SideAngle + Direction * kSideStepDegrees);
  else
    return;
  this->Use();
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
}

void RegionWidget::Leave()
{
  if (this->ManagesCursor != 0) this->RequestCursorShape(VTK_CURSOR_DEFAULT);
  if (this->Current == Gesture::Stroke || this->Current == Gesture::Outline) return;
  if (this->GetRegionRepresentation()->GetOutline().empty()) return;
  this->GetRegionRepresentation()->ShowNothing();
  this->Render();
}

void RegionWidget::Hover()
{
  if (!this->Surface || !isCursorIn(*this->CurrentRenderer, *this->Interactor)) return this->Leave();
  if (this->ManagesCursor != 0) this->RequestCursorShape(VTK_CURSOR_CROSSHAIR);
  if (this->Shape == RegionShape::Brush) this->ShowBrush();
}

void RegionWidget::ShowBrush()
{
  this->GetRegionRepresentation()->ShowCircle(cursorOf(*this->Interactor), this->BrushRadius * this->PixelRatio);
  this->Render();
}

void RegionWidget::ShowOutline()
{
  this->GetRegionRepresentation()->ShowPolygon(this->Polygon());
  this->Render();
}

}  // namespace holdfast

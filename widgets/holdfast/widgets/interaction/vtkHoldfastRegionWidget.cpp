#include "holdfast/widgets/interaction/vtkHoldfastRegionWidget.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <holdfast/widgets/camera/camera_state.h>

using namespace holdfast;

namespace {

// A share of the radius.
constexpr double kDabSpacing = 0.4;

constexpr double kLeastBrushPixels = 4;
constexpr double kMostBrushPixels = 300;
constexpr double kBrushStep = 1.2;

constexpr double kSideStepDegrees = 5;

// A smaller outline is a click, and selects nothing.
constexpr double kLeastOutlinePixels = 3;

// Vertices in one turn of the event loop: some 15 milliseconds at the most.
constexpr Index kVerticesOfTurn = 12'000;
constexpr unsigned long kTurnMilliseconds = 1;

}  // namespace

vtkStandardNewMacro(vtkHoldfastRegionWidget);

vtkHoldfastRegionWidget::vtkHoldfastRegionWidget()
{
  this->Bind<&vtkHoldfastRegionWidget::PressAgain>(vtkCommand::LeftButtonDoubleClickEvent, vtkWidgetEvent::Completed);
  this->Bind<&vtkHoldfastRegionWidget::Press>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select);
  this->Bind<&vtkHoldfastRegionWidget::MoveTo>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  this->Bind<&vtkHoldfastRegionWidget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  this->Bind<&vtkHoldfastRegionWidget::Leave>(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave);
  this->Bind<&vtkHoldfastRegionWidget::TimeOut>(vtkCommand::TimerEvent, vtkWidgetEvent::TimedOut);
  this->BindKey<&vtkHoldfastRegionWidget::Step<-1>>("bracketleft", vtkWidgetEvent::Down);
  this->BindKey<&vtkHoldfastRegionWidget::Step<1>>("bracketright", vtkWidgetEvent::Up);
  this->BindKey<&vtkHoldfastRegionWidget::ChangeBendFrom>("n", vtkWidgetEvent::ModifyEvent);
  this->BindKey<&vtkHoldfastRegionWidget::Cancel>("Escape", vtkWidgetEvent::Reset);
}

void vtkHoldfastRegionWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << static_cast<int>(this->Shape) << '\n';
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Regions: " << this->Regions.get() << '\n';
  os << indent << "BrushRadius: " << this->BrushRadius << '\n';
  os << indent << "SideAngle: " << this->SideAngle << '\n';
  os << indent << "BendFrom: " << static_cast<int>(this->SideBendFrom) << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
  os << indent << "Reach: " << static_cast<int>(this->Reach) << '\n';
}

void vtkHoldfastRegionWidget::Stop()
{
  this->Cancel();
  this->Drawn().ShowNothing();
  this->ShowCursor(VTK_CURSOR_DEFAULT);
}

void vtkHoldfastRegionWidget::SetShape(RegionShape shape)
{
  if (this->Shape == shape) return;
  this->Cancel();
  this->Shape = shape;
  this->Drawn().ShowNothing();
  this->Modified();
}

void vtkHoldfastRegionWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  if (this->Surface == surface) return;
  if (!surface || !this->Surface || &surface->model() != &this->Surface->model()) this->Cancel();
  this->Surface = std::move(surface);
  this->Modified();
}

void vtkHoldfastRegionWidget::SetRegions(std::shared_ptr<VertexRegions> regions)
{
  if (this->Regions == regions) return;
  this->Cancel();
  this->Regions = std::move(regions);
  this->Modified();
}

void vtkHoldfastRegionWidget::SetBrushRadius(double pixels)
{
  const double radius = std::clamp(pixels, kLeastBrushPixels, kMostBrushPixels);
  if (radius == this->BrushRadius) return;
  this->BrushRadius = radius;
  if (!this->Drawn().GetOutline().empty() && this->Shape == RegionShape::Brush) this->ShowBrush();
  this->Modified();
}

void vtkHoldfastRegionWidget::SetPixelRatio(double ratio)
{
  if (ratio == this->PixelRatio) return;
  this->PixelRatio = std::clamp(ratio, 0.1, 100.0);
  this->Drawn().SetPixelRatio(this->PixelRatio);
  this->Modified();
}

void vtkHoldfastRegionWidget::Tell(unsigned long event, std::vector<Index> reached)
{
  RegionCallData data{std::move(reached), this->Mode};
  this->InvokeEvent(event, &data);
}

bool vtkHoldfastRegionWidget::Press()
{
  if (this->Shape == RegionShape::Side && isSecondPress(*this->Interactor)) return this->SelectPart();
  this->Cancel();
  if (!this->Surface || !this->IsCursorInside()) return false;
  this->Trail = {this->Cursor()};
  this->Mode = selectionModeOf(*this->Interactor);
  if (this->Shape == RegionShape::Brush) return this->BeginStroke();
  if (this->Shape == RegionShape::Side) {
    this->LeftClick.Press(this->Cursor());
    return false;
  }
  this->Current = Gesture::Outline;
  this->Tell(vtkCommand::StartInteractionEvent);
  return true;
}

bool vtkHoldfastRegionWidget::MoveTo()
{
  const DisplayPoint cursor = this->Cursor();
  if (this->Current == Gesture::Stroke) {
    this->PaintTo(cursor);
    return true;
  }
  if (this->Current == Gesture::Outline) {
    this->Trail.push_back(cursor);
    this->Drawn().ShowPolygon(this->Polygon());
    this->Render();
    return true;
  }
  this->LeftClick.LeaveAt(cursor, this->PixelRatio);
  if (isCameraMoving(*this->Interactor)) {
    this->HideCircle();
    return false;
  }
  if (!this->Surface || !this->IsCursorInside()) {
    this->Leave();
    return false;
  }
  this->ShowCursor(VTK_CURSOR_CROSSHAIR);
  if (this->Shape == RegionShape::Brush) this->ShowBrush();
  return false;
}

bool vtkHoldfastRegionWidget::Release()
{
  const DisplayPoint cursor = this->Cursor();
  switch (this->Current) {
    case Gesture::Stroke:
      this->Current = Gesture::None;
      this->Tell(vtkCommand::EndInteractionEvent, std::exchange(this->Reached, {}));
      return true;
    case Gesture::Outline:
      this->Trail.push_back(cursor);
      this->EndOutline();
      return true;
    case Gesture::None:
    case Gesture::Search:
      if (!this->LeftClick.Release(cursor, this->PixelRatio) || !this->Regions) return false;
      if (const auto pick = this->FaceAt(this->Cursor()))
        this->SelectAtOnce(this->Regions->smooth(pick->face, this->SideAngle, this->SideBendFrom));
  }
  return false;
}

bool vtkHoldfastRegionWidget::BeginStroke()
{
  if (!this->Regions || !this->FaceAt(this->Cursor())) return false;
  this->Current = Gesture::Stroke;
  this->Reached.clear();
  this->Tell(vtkCommand::StartInteractionEvent);
  this->PaintTo(this->Cursor());
  return true;
}

void vtkHoldfastRegionWidget::PaintTo(const DisplayPoint& cursor)
{
  // An observer may have removed the surface.
  if (this->Current != Gesture::Stroke) return;
  const DisplayPoint from = this->Trail.back();
  const double dabs = std::ceil((cursor - from).norm() / (kDabSpacing * this->BrushRadius * this->PixelRatio));
  const int count = std::max(1, static_cast<int>(dabs));
  for (int k = 1; k <= count; ++k) this->Dab(from + (cursor - from) * k / count);
  this->Trail.push_back(cursor);
  this->ShowBrush();
  this->Tell(vtkCommand::InteractionEvent, this->Reached);
}

/// A ball around a place of the surface, with the radius of the brush there. It reaches along edges only, and nothing
/// that a section cuts away or that is not shown.
void vtkHoldfastRegionWidget::Dab(const DisplayPoint& pixel)
{
  const auto pick = this->FaceAt(pixel);
  if (!pick) return;
  const DisplayPoint radius(this->BrushRadius * this->PixelRatio, 0);
  const Vector3 center = atDepthOf(*this->CurrentRenderer, pick->place, pixel);
  const Vector3 border = atDepthOf(*this->CurrentRenderer, pick->place, pixel + radius);
  const Positions& positions = this->Surface->positions();
  auto touched = this->Regions->within((border - center).norm(), pick->place, pick->face, positions);
  std::erase_if(touched,
                [&](Index v) { return !this->Surface->isShown(v) || !this->Surface->isKept(positions.row(v)); });
  this->Reached = joined(this->Reached, touched, SelectionMode::Add);
}

std::vector<DisplayPoint> vtkHoldfastRegionWidget::Polygon() const
{
  if (this->Shape == RegionShape::Lasso) return this->Trail;
  const DisplayPoint& a = this->Trail.front();
  const DisplayPoint& b = this->Trail.back();
  return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
}

void vtkHoldfastRegionWidget::EndOutline()
{
  const std::vector<DisplayPoint> polygon = this->Polygon();
  Eigen::AlignedBox2d box;
  for (const DisplayPoint& corner : polygon) box.extend(corner);
  if (box.sizes().maxCoeff() < kLeastOutlinePixels * this->PixelRatio) {
    this->Cancel();
    return;
  }
  this->Drawn().ShowNothing();
  this->Render();
  this->Mode = selectionModeOf(*this->Interactor);
  const ScreenReach reach = this->Interactor->GetAltKey() != 0 ? ScreenReach::Through : this->Reach;
  this->Found = std::make_unique<ScreenSelection>(*this->CurrentRenderer, this->Surface, polygon, reach);
  this->Current = Gesture::Search;
  this->Search();
}

void vtkHoldfastRegionWidget::Search()
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

void vtkHoldfastRegionWidget::TimeOut()
{
  if (this->Current != Gesture::Search || this->CallData == nullptr) return;
  if (*static_cast<int*>(this->CallData) == this->TimerId) this->Search();
}

bool vtkHoldfastRegionWidget::SelectPart()
{
  this->Cancel();
  if (!this->Surface || !this->Regions || !this->IsCursorInside()) return false;
  const auto pick = this->FaceAt(this->Cursor());
  if (!pick) return false;
  const Index vertex = this->Surface->model().mesh.faces[pick->face].front();
  this->SelectAtOnce(this->Regions->connected({&vertex, 1}));
  return true;
}

void vtkHoldfastRegionWidget::SelectAtOnce(std::vector<Index> reached)
{
  this->Mode = selectionModeOf(*this->Interactor);
  this->Tell(vtkCommand::StartInteractionEvent);
  this->Tell(vtkCommand::EndInteractionEvent, std::move(reached));
}

bool vtkHoldfastRegionWidget::Cancel()
{
  this->LeftClick.Forget();
  const Gesture gesture = std::exchange(this->Current, Gesture::None);
  if (gesture == Gesture::None) return false;
  this->Reached.clear();
  this->Found.reset();
  if (gesture == Gesture::Search) this->Interactor->DestroyTimer(this->TimerId);
  if (gesture == Gesture::Outline) this->Drawn().ShowNothing();
  this->Render();
  this->Tell(CancelInteractionEvent);
  return true;
}

template <int Direction>
bool vtkHoldfastRegionWidget::Step()
{
  if (this->Shape == RegionShape::Brush)
    this->SetBrushRadius(this->BrushRadius * std::pow(kBrushStep, Direction));
  else if (this->Shape == RegionShape::Side)
    this->SetSideAngle(this->SideAngle + Direction * kSideStepDegrees);
  else
    return false;
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  return true;
}

bool vtkHoldfastRegionWidget::ChangeBendFrom()
{
  if (this->Shape != RegionShape::Side) return false;
  const bool wasNeighbour = this->SideBendFrom == BendFrom::Neighbour;
  this->SetBendFrom(wasNeighbour ? BendFrom::FirstFace : BendFrom::Neighbour);
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  return true;
}

void vtkHoldfastRegionWidget::Leave()
{
  this->ShowCursor(VTK_CURSOR_DEFAULT);
  this->HideCircle();
}

void vtkHoldfastRegionWidget::HideCircle()
{
  if (this->Current == Gesture::Stroke || this->Current == Gesture::Outline) return;
  if (this->Drawn().GetOutline().empty()) return;
  this->Drawn().ShowNothing();
  this->Render();
}

void vtkHoldfastRegionWidget::ShowBrush()
{
  this->Drawn().ShowCircle(this->Cursor(), this->BrushRadius * this->PixelRatio);
  this->Render();
}

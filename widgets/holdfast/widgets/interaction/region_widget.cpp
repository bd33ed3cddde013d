#include "holdfast/widgets/interaction/region_widget.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <vtkCoordinate.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

constexpr Color kFillColor{0.12, 0.47, 1.00};
constexpr Color kPolygonColor{0.08, 0.35, 0.82};
constexpr Color kCircleColor{0.08, 0.09, 0.10};
constexpr double kFillOpacity = 0.16;
constexpr double kLightOpacity = 0.82;
constexpr double kLightPixels = 3;
constexpr double kDarkPixels = 1.2;

DisplayPoint centerOf(const DisplayPoint& pixel)
{
  return centerOfPixel(pixel.x(), pixel.y());
}

/// Returns the places where the sides of the polygon cross the middle of each row of pixels, row after row from
/// `bottom`, ascending.
std::vector<std::vector<double>> crossingsOfRows(const std::vector<DisplayPoint>& corners, double bottom, double top)
{
  std::vector<std::vector<double>> rows(static_cast<std::size_t>(top - bottom) + 1);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    DisplayPoint low = centerOf(corners[k]);
    DisplayPoint high = centerOf(corners[(k + 1) % corners.size()]);
    if (low.y() > high.y()) std::swap(low, high);
    for (double y = std::ceil(low.y() - 0.5); y + 0.5 < high.y(); ++y)
      rows[static_cast<std::size_t>(y - bottom)].push_back(low.x() + (y + 0.5 - low.y()) / (high.y() - low.y()) *
                                                                         (high.x() - low.x()));
  }
  for (std::vector<double>& row : rows) std::ranges::sort(row);
  return rows;
}

/// The inside of the polygon in strips of a pixel's height, between odd and even crossings.
std::vector<std::vector<Vector3>> stripsOf(const std::vector<DisplayPoint>& corners)
{
  const auto [lowest, highest] = std::ranges::minmax_element(corners, {}, [](const DisplayPoint& p) { return p.y(); });
  const double bottom = std::floor(lowest->y());
  std::vector<std::vector<Vector3>> strips;
  double y = bottom;
  for (const std::vector<double>& row : crossingsOfRows(corners, bottom, std::ceil(highest->y()))) {
    for (std::size_t k = 0; k + 1 < row.size(); k += 2)
      strips.push_back({{row[k], y, 0}, {row[k + 1], y, 0}, {row[k + 1], y + 1, 0}, {row[k], y + 1, 0}});
    ++y;
  }
  return strips;
}

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

vtkStandardNewMacro(RegionRepresentation);

RegionRepresentation::RegionRepresentation()
{
  vtkNew<vtkCoordinate> display;
  display->SetCoordinateSystemToDisplay();
  const auto show = [&](vtkActor2D& actor, vtkPolyData& data) {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(&data);
    mapper->SetTransformCoordinate(display);
    mapper->TransformCoordinateUseDoubleOn();
    actor.SetMapper(mapper);
    this->Props.push_back(&actor);
  };
  show(*this->Fill, *this->FillData);
  show(*this->LightLine, *this->LineData);
  show(*this->DarkLine, *this->LineData);
  setColor(*this->Fill, kFillColor);
  this->Fill->GetProperty()->SetOpacity(kFillOpacity);
  this->LightLine->GetProperty()->SetOpacity(kLightOpacity);
  this->ShowNothing();
}

void RegionRepresentation::Show(std::vector<DisplayPoint> outline, bool isFilled)
{
  this->Outline = std::move(outline);
  this->IsFilled = isFilled;
  this->Modified();
}

void RegionRepresentation::BuildRepresentation()
{
  if (this->GetMTime() <= this->BuildTime) return;
  this->BuildTime.Modified();
  const bool isLine = this->Outline.size() > 1;
  for (vtkActor2D* const line : {this->LightLine.Get(), this->DarkLine.Get()}) line->SetVisibility(isLine);
  this->Fill->SetVisibility(isLine && this->IsFilled);
  std::vector<Vector3> line;
  for (const DisplayPoint& corner : this->Outline) line.emplace_back(centerOf(corner).x(), centerOf(corner).y(), 0);
  if (isLine) line.push_back(line.front());
  setLines(*this->LineData, {line});
  if (isLine && this->IsFilled) setPolygons(*this->FillData, stripsOf(this->Outline));
  setColor(*this->DarkLine, this->IsFilled ? kPolygonColor : kCircleColor);
  this->LightLine->GetProperty()->SetLineWidth(static_cast<float>(kLightPixels * this->PixelRatio));
  this->DarkLine->GetProperty()->SetLineWidth(static_cast<float>(kDarkPixels * this->PixelRatio));
}

vtkStandardNewMacro(RegionWidget);

RegionWidget::RegionWidget()
{
  this->Bind<&RegionWidget::PressAgain>(vtkCommand::LeftButtonDoubleClickEvent, vtkWidgetEvent::Completed);
  this->Bind<&RegionWidget::Press>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select);
  this->Bind<&RegionWidget::MoveTo>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  this->Bind<&RegionWidget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  this->Bind<&RegionWidget::Leave>(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave);
  this->Bind<&RegionWidget::TimeOut>(vtkCommand::TimerEvent, vtkWidgetEvent::TimedOut);
  this->BindKey<&RegionWidget::Step<-1>>("bracketleft", vtkWidgetEvent::Down);
  this->BindKey<&RegionWidget::Step<1>>("bracketright", vtkWidgetEvent::Up);
  this->BindKey<&RegionWidget::ChangeBendFrom>("n", vtkWidgetEvent::ModifyEvent);
  this->BindKey<&RegionWidget::Cancel>("Escape", vtkWidgetEvent::Reset);
}

void RegionWidget::PrintSelf(ostream& os, vtkIndent indent)
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

void RegionWidget::Stop()
{
  this->Cancel();
  this->Drawn().ShowNothing();
  this->ShowCursor(VTK_CURSOR_DEFAULT);
}

void RegionWidget::SetShape(RegionShape shape)
{
  if (this->Shape == shape) return;
  this->Cancel();
  this->Shape = shape;
  this->Drawn().ShowNothing();
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
  if (!this->Drawn().GetOutline().empty() && this->Shape == RegionShape::Brush) this->ShowBrush();
  this->Modified();
}

void RegionWidget::SetPixelRatio(double ratio)
{
  if (ratio == this->PixelRatio) return;
  this->PixelRatio = std::clamp(ratio, 0.1, 100.0);
  this->Drawn().SetPixelRatio(this->PixelRatio);
  this->Modified();
}

void RegionWidget::Tell(unsigned long event, std::vector<Index> reached)
{
  RegionCallData data{std::move(reached), this->Mode};
  this->InvokeEvent(event, &data);
}

bool RegionWidget::Press()
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

bool RegionWidget::MoveTo()
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

bool RegionWidget::Release()
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

bool RegionWidget::BeginStroke()
{
  if (!this->Regions || !this->FaceAt(this->Cursor())) return false;
  this->Current = Gesture::Stroke;
  this->Reached.clear();
  this->Tell(vtkCommand::StartInteractionEvent);
  this->PaintTo(this->Cursor());
  return true;
}

void RegionWidget::PaintTo(const DisplayPoint& cursor)
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
void RegionWidget::Dab(const DisplayPoint& pixel)
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

bool RegionWidget::SelectPart()
{
  this->Cancel();
  if (!this->Surface || !this->Regions || !this->IsCursorInside()) return false;
  const auto pick = this->FaceAt(this->Cursor());
  if (!pick) return false;
  const Index vertex = this->Surface->model().mesh.faces[pick->face].front();
  this->SelectAtOnce(this->Regions->connected({&vertex, 1}));
  return true;
}

void RegionWidget::SelectAtOnce(std::vector<Index> reached)
{
  this->Mode = selectionModeOf(*this->Interactor);
  this->Tell(vtkCommand::StartInteractionEvent);
  this->Tell(vtkCommand::EndInteractionEvent, std::move(reached));
}

bool RegionWidget::Cancel()
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
bool RegionWidget::Step()
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

bool RegionWidget::ChangeBendFrom()
{
  if (this->Shape != RegionShape::Side) return false;
  const bool wasNeighbour = this->SideBendFrom == BendFrom::Neighbour;
  this->SetBendFrom(wasNeighbour ? BendFrom::FirstFace : BendFrom::Neighbour);
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  return true;
}

void RegionWidget::Leave()
{
  this->ShowCursor(VTK_CURSOR_DEFAULT);
  this->HideCircle();
}

void RegionWidget::HideCircle()
{
  if (this->Current == Gesture::Stroke || this->Current == Gesture::Outline) return;
  if (this->Drawn().GetOutline().empty()) return;
  this->Drawn().ShowNothing();
  this->Render();
}

void RegionWidget::ShowBrush()
{
  this->Drawn().ShowCircle(this->Cursor(), this->BrushRadius * this->PixelRatio);
  this->Render();
}

}  // namespace holdfast

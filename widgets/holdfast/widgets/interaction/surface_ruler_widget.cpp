#include "holdfast/widgets/interaction/surface_ruler_widget.h"

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <vtkAxisActor2D.h>
#include <vtkCoordinate.h>
#include <vtkHandleWidget.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkWindow.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

// Pixels of a display of ordinary resolution.
constexpr double kRulerPixels = 1.8;
constexpr double kRulerHaloPixels = 4.2;
constexpr double kEndRadiusPixels = 5;
constexpr double kActiveEndRadiusPixels = 7;
constexpr double kGrabPixels = 9;
constexpr double kLetterPixels = 14;
constexpr double kLabelGapPixels = 12;

constexpr double kBarbPixels = 12;
constexpr double kBarbDegrees = 25;

constexpr int kRingCorners = 32;

// A font of so many points has as many pixels.
constexpr double kPointsPerInch = 72;

/// `format` of printf for a text as it is.
std::string verbatim(const std::string& text)
{
  std::string format;
  for (const char letter : text) format += letter == '%' ? "%%" : std::string(1, letter);
  return format;
}

/// With four digits of the longest; what is less than these is 0.
std::string componentsText(const Vector3& vector)
{
  constexpr double kFourDigits = 1e-4;
  const double least = kFourDigits * vector.cwiseAbs().maxCoeff();
  const auto shown = [&](double value) { return std::abs(value) < least ? 0 : value; };
  return fmt::format("{:.4g}, {:.4g}, {:.4g}", shown(vector.x()), shown(vector.y()), shown(vector.z()));
}

void setLabelLook(vtkAxisActor2D& axis)
{
  axis.AxisVisibilityOff();
  axis.TickVisibilityOff();
  axis.UseFontSizeFromPropertyOn();
  vtkTextProperty& text = *axis.GetTitleTextProperty();
  text.BoldOff();
  text.ItalicOff();
  text.ShadowOff();
  text.SetColor(0.08, 0.10, 0.14);
  text.SetBackgroundColor(1, 1, 1);
  text.SetBackgroundOpacity(0.85);
}

void addLine(std::vector<std::vector<Vector3>>& lines, const std::vector<DisplayPoint>& points)
{
  std::vector<Vector3>& line = lines.emplace_back();
  for (const DisplayPoint& point : points) line.emplace_back(point.x(), point.y(), 0);
}

}  // namespace

vtkStandardNewMacro(SurfaceHandleRepresentation);

const VisibleSurface* SurfaceHandleRepresentation::GetSurface() const
{
  const auto* placer = SurfacePointPlacer::SafeDownCast(this->PointPlacer);
  return placer != nullptr ? placer->GetSurface().get() : nullptr;
}

SurfacePlacement SurfaceHandleRepresentation::PlacementAt(const SurfaceLocation& location) const
{
  const SurfaceLocator locator = this->GetSurface()->model().locator();
  return {location, locator.locate(location, {})};
}

void SurfaceHandleRepresentation::SetLocation(const SurfaceLocation& location)
{
  if (this->GetSurface() != nullptr)
    this->SetPlacement(this->PlacementAt(location));
  else
    vtkErrorMacro("The placer must have a surface before the handle has a location");
}

void SurfaceHandleRepresentation::SetPlacement(std::optional<SurfacePlacement> placement)
{
  this->Placement = std::move(placement);
  this->FollowSurface();
  this->Modified();
}

void SurfaceHandleRepresentation::FollowSurface()
{
  if (!this->Placement) return;
  Vector3 place = this->GetPlace();
  this->SetWorldPosition(place.data());
}

void SurfaceHandleRepresentation::SetDisplayPosition(double display[3])
{
  auto* placer = SurfacePointPlacer::SafeDownCast(this->PointPlacer);
  if (placer == nullptr || this->Renderer == nullptr) return this->Superclass::SetDisplayPosition(display);
  const auto pick = placer->Pick(*this->Renderer, display);
  if (pick)
    this->SetPlacement(SurfacePlacement{pick->location, pointOf(pick->location, this->GetSurface()->model().mesh)});
}

vtkStandardNewMacro(SurfaceRulerRepresentation);

SurfaceRulerRepresentation::SurfaceRulerRepresentation()
{
  const vtkNew<SurfaceHandleRepresentation> handle;
  // Rings are drawn with the line.
  handle->GetProperty()->SetOpacity(0);
  handle->GetSelectedProperty()->SetOpacity(0);
  this->SetHandleRepresentation(handle);
  this->InstantiateHandleRepresentation();
  for (const int end : {0, 1}) this->GetHandle(end).SetPointPlacer(this->Placer);
  setLabelLook(*this->GetAxis());
  vtkNew<vtkCoordinate> pixels;
  pixels->SetCoordinateSystemToDisplay();
  for (vtkActor2D* const actor : {this->Halo.Get(), this->Line.Get()}) {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(this->Lines);
    mapper->SetTransformCoordinate(pixels);
    actor->SetMapper(mapper);
  }
  this->Halo->GetProperty()->SetColor(1, 1, 1);
  setColor(*this->Line, kAccentColor);
  this->SetPixelRatio(1);
}

void SurfaceRulerRepresentation::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  const auto before = this->Placer->GetSurface();
  if (before == surface) return;
  const bool isSameMesh = before && surface && surface->isSameMesh(*before);
  this->Placer->SetSurface(std::move(surface));
  for (const int end : {0, 1})
    if (isSameMesh)
      this->GetHandle(end).FollowSurface();
    else
      this->GetHandle(end).SetPlacement(std::nullopt);
  this->Modified();
}

std::string SurfaceRulerRepresentation::GetLabel()
{
  const std::string units = this->Units.empty() ? "" : ' ' + this->Units;
  const std::string vector = this->ShowVector ? ": " + componentsText(this->GetVector()) : "";
  return fmt::format("{:.4g}{}{} (rest {:.4g})", this->GetDistance(), units, vector, this->GetRestDistance());
}

void SurfaceRulerRepresentation::SetPixelRatio(double ratio)
{
  this->Placer->SetPixelRatio(ratio);
  this->Halo->GetProperty()->SetLineWidth(static_cast<float>(kRulerHaloPixels * this->GetPixelRatio()));
  this->Line->GetProperty()->SetLineWidth(static_cast<float>(kRulerPixels * this->GetPixelRatio()));
  this->SetTolerance(static_cast<int>(std::lround(kGrabPixels * this->GetPixelRatio())));
  this->GetAxis()->SetTickLength(static_cast<int>(std::lround(kLabelGapPixels * this->GetPixelRatio())));
  this->Modified();
}

void SurfaceRulerRepresentation::BuildRepresentation()
{
  this->SetLabelFormat(verbatim(this->GetLabel()).c_str());
  if (this->Renderer != nullptr && this->Renderer->GetVTKWindow() != nullptr) {
    const double letter =
        kLetterPixels * this->GetPixelRatio() * kPointsPerInch / this->Renderer->GetVTKWindow()->GetDPI();
    this->GetAxis()->GetTitleTextProperty()->SetFontSize(static_cast<int>(std::lround(letter)));
    this->BuildLines();
  }
  this->Superclass::BuildRepresentation();
}

void SurfaceRulerRepresentation::BuildLines()
{
  std::vector<std::vector<Vector3>> lines;
  this->IsInView = false;
  if (this->IsPlaced()) {
    const DisplayTransform toDisplay(*this->Renderer);
    const DisplayTransform::Shown a = toDisplay.show(this->GetHandle(0).GetPlace());
    const DisplayTransform::Shown b = toDisplay.show(this->GetHandle(1).GetPlace());
    this->IsInView = a.depth > 0 && b.depth > 0;
    const auto radius = [&](int end) {
      const bool isActive = this->GetHandle(end).GetInteractionState() != vtkHandleRepresentation::Outside;
      return (isActive ? kActiveEndRadiusPixels : kEndRadiusPixels) * this->GetPixelRatio();
    };
    const auto addRing = [&](const DisplayPoint& center, double ringRadius) {
      addLine(lines, circle(center, ringRadius, kRingCorners));
      lines.back().push_back(lines.back().front());
    };
    addRing(a.point, radius(0));
    addRing(b.point, radius(1));
    // The line leaves the places in the rings free to be seen.
    const DisplayPoint along = b.point - a.point;
    if (along.norm() > radius(0) + radius(1)) {
      const DisplayPoint from = a.point + radius(0) * along.normalized();
      const DisplayPoint to = b.point - radius(1) * along.normalized();
      addLine(lines, {from, to});
      for (const double degrees : {-kBarbDegrees, kBarbDegrees})
        if (this->ShowVector) {
          const DisplayPoint back = Eigen::Rotation2Dd(degrees * kDegree) * -along.normalized();
          addLine(lines, {to, to + kBarbPixels * this->GetPixelRatio() * back});
        }
    }
  }
  setLines(*this->Lines, lines);
}

void SurfaceRulerRepresentation::GetActors2D(vtkPropCollection* actors)
{
  for (vtkActor2D* const actor : {this->Halo.Get(), this->Line.Get(), static_cast<vtkActor2D*>(this->GetAxis())})
    actors->AddItem(actor);
}

void SurfaceRulerRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Halo->ReleaseGraphicsResources(window);
  this->Line->ReleaseGraphicsResources(window);
}

int SurfaceRulerRepresentation::RenderOverlay(vtkViewport* viewport)
{
  this->BuildRepresentation();
  if (!this->IsInView) return 0;
  const int drawn = this->Halo->RenderOverlay(viewport) + this->Line->RenderOverlay(viewport);
  return this->LabelVisibility ? drawn + this->Superclass::RenderOverlay(viewport) : drawn;
}

vtkStandardNewMacro(SurfaceRulerWidget);

SurfaceRulerWidget::SurfaceRulerWidget()
{
  this->CurrentHandle = -1;
  this->Bind<&SurfaceRulerWidget::Press>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::AddPoint);
  this->Bind<&SurfaceRulerWidget::Move>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  this->Bind<&SurfaceRulerWidget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  this->BindKey<&SurfaceRulerWidget::Cancel>("Escape", vtkWidgetEvent::Reset);
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
    widgets[end]->SetRepresentation(&this->Drawn().GetHandle(end));
    widgets[end]->SetInteractor(this->Interactor);
    widgets[end]->SetCurrentRenderer(this->CurrentRenderer);
  }
}

void SurfaceRulerWidget::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  SurfaceRulerRepresentation& ruler = this->Drawn();
  const bool isHalfDrawn = this->WidgetState == vtkDistanceWidget::Define;
  ruler.SetSurface(std::move(surface));
  if (this->WidgetState != vtkDistanceWidget::Start && !ruler.IsPlaced()) this->Clear();
  if (isHalfDrawn && this->WidgetState == vtkDistanceWidget::Start) this->InvokeEvent(CancelInteractionEvent);
}

void SurfaceRulerWidget::SetLocations(const SurfaceLocation& a, const SurfaceLocation& b)
{
  SurfaceRulerRepresentation& ruler = this->Drawn();
  if (!ruler.GetPlacer()->GetSurface()) {
    vtkErrorMacro("The ruler must have a surface before it has locations");
    return;
  }
  this->Cancel();
  const SurfacePlacement first = ruler.GetHandle(0).PlacementAt(a);
  ruler.GetHandle(1).SetLocation(b);
  ruler.GetHandle(0).SetPlacement(first);
  ruler.VisibilityOn();
  this->SetWidgetStateToManipulate();
  this->Render();
}

std::optional<SurfaceLocation> SurfaceRulerWidget::GetLocation(int end)
{
  const auto& placement = this->Drawn().GetHandle(end).GetPlacement();
  return placement ? std::optional(placement->location) : std::nullopt;
}

void SurfaceRulerWidget::Clear()
{
  if (this->GrabbedAt) this->StopDrag();
  for (const int end : {0, 1}) this->Drawn().GetHandle(end).SetPlacement(std::nullopt);
  this->Point1Widget->SetEnabled(0);
  this->Point2Widget->SetEnabled(0);
  this->Drawn().VisibilityOff();
  this->WidgetState = vtkDistanceWidget::Start;
  this->Render();
}

bool SurfaceRulerWidget::Cancel()
{
  if (!this->IsUnderWay()) return false;
  if (this->WidgetState == vtkDistanceWidget::Define) {
    this->Clear();
  } else {
    this->Drawn().GetHandle(this->CurrentHandle).SetPlacement(this->GrabbedAt);
    this->StopDrag();
    this->Render();
  }
  this->InvokeEvent(CancelInteractionEvent);
  return true;
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
  if (this->WidgetState != vtkDistanceWidget::Manipulate) return this->PressClick();
  this->LeftClick.Forget();
  if (!this->IsCursorInside()) return;
  this->Hover();
  this->CurrentHandle = -1;
  AddPointAction(this);
  if (this->CurrentHandle >= 0)
    this->GrabbedAt = this->Drawn().GetHandle(this->CurrentHandle).GetPlacement();
  else
    this->PressClick();
}

void SurfaceRulerWidget::Move()
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

void SurfaceRulerWidget::Hover()
{
  bool isChanged = false;
  for (const int end : {0, 1}) {
    SurfaceHandleRepresentation& handle = this->Drawn().GetHandle(end);
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
  DisplayPoint cursor = this->Cursor();
  if (!this->LeftClick.Release(cursor, this->Drawn().GetPixelRatio())) return;
  if (!this->GetPlacer()->Pick(*this->CurrentRenderer, cursor.data())) return;
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

}  // namespace holdfast

#include "holdfast/widgets/interaction/vtkHoldfastSurfaceRulerRepresentation.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <vtkAxisActor2D.h>
#include <vtkCoordinate.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkWindow.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/mesh/poly_data.h>

using namespace holdfast;

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

vtkStandardNewMacro(vtkHoldfastSurfaceRulerRepresentation);

vtkHoldfastSurfaceRulerRepresentation::vtkHoldfastSurfaceRulerRepresentation()
{
  const vtkNew<vtkHoldfastSurfaceHandleRepresentation> handle;
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

void vtkHoldfastSurfaceRulerRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Placer: " << this->Placer.Get() << '\n';
  os << indent << "ShowVector: " << this->ShowVector << '\n';
  os << indent << "Units: " << this->Units << '\n';
  os << indent << "LabelVisibility: " << this->LabelVisibility << '\n';
  os << indent << "PixelRatio: " << this->GetPixelRatio() << '\n';
}

void vtkHoldfastSurfaceRulerRepresentation::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  const auto before = this->Placer->GetSurface();
  if (before == surface) return;
  const bool isSameMesh = before && surface && surface->isSameMesh(*before);
  this->Placer->SetSurface(std::move(surface));
  for (const int end : {0, 1})
    if (isSameMesh)
      this->GetHandle(end).FollowSurface();
    else
      this->GetHandle(end).SetPlacement(nullptr);
  this->Modified();
}

std::string vtkHoldfastSurfaceRulerRepresentation::GetLabel()
{
  const std::string units = this->Units.empty() ? "" : ' ' + this->Units;
  const std::string vector = this->ShowVector ? ": " + componentsText(this->GetVector()) : "";
  return fmt::format("{:.4g}{}{} (rest {:.4g})", this->GetDistance(), units, vector, this->GetRestDistance());
}

void vtkHoldfastSurfaceRulerRepresentation::SetPixelRatio(double ratio)
{
  this->Placer->SetPixelRatio(ratio);
  this->Halo->GetProperty()->SetLineWidth(static_cast<float>(kRulerHaloPixels * this->GetPixelRatio()));
  this->Line->GetProperty()->SetLineWidth(static_cast<float>(kRulerPixels * this->GetPixelRatio()));
  this->SetTolerance(static_cast<int>(std::lround(kGrabPixels * this->GetPixelRatio())));
  this->GetAxis()->SetTickLength(static_cast<int>(std::lround(kLabelGapPixels * this->GetPixelRatio())));
  this->Modified();
}

void vtkHoldfastSurfaceRulerRepresentation::BuildRepresentation()
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

void vtkHoldfastSurfaceRulerRepresentation::BuildLines()
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

void vtkHoldfastSurfaceRulerRepresentation::GetActors2D(vtkPropCollection* actors)
{
  for (vtkActor2D* const actor : {this->Halo.Get(), this->Line.Get(), static_cast<vtkActor2D*>(this->GetAxis())})
    actors->AddItem(actor);
}

void vtkHoldfastSurfaceRulerRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Halo->ReleaseGraphicsResources(window);
  this->Line->ReleaseGraphicsResources(window);
}

int vtkHoldfastSurfaceRulerRepresentation::RenderOverlay(vtkViewport* viewport)
{
  this->BuildRepresentation();
  if (!this->IsInView) return 0;
  const int drawn = this->Halo->RenderOverlay(viewport) + this->Line->RenderOverlay(viewport);
  return this->LabelVisibility ? drawn + this->Superclass::RenderOverlay(viewport) : drawn;
}

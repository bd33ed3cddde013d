#include "holdfast/widgets/interaction/vtkHoldfastRegionRepresentation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkCoordinate.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>

#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/mesh/poly_data.h>

using namespace holdfast;

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

}  // namespace

vtkStandardNewMacro(vtkHoldfastRegionRepresentation);

vtkHoldfastRegionRepresentation::vtkHoldfastRegionRepresentation()
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

void vtkHoldfastRegionRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Outline: " << this->Outline.size() << '\n';
  os << indent << "IsFilled: " << this->IsFilled << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
}

void vtkHoldfastRegionRepresentation::Show(std::vector<DisplayPoint> outline, bool isFilled)
{
  this->Outline = std::move(outline);
  this->IsFilled = isFilled;
  this->Modified();
}

void vtkHoldfastRegionRepresentation::BuildRepresentation()
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

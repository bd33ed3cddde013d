#include "holdfast/widgets/interaction/region_representation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkProperty2D.h>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {
namespace {

constexpr Color kFillColor{0.12, 0.47, 1.00};
constexpr Color kPolygonColor{0.08, 0.35, 0.82};
constexpr Color kCircleColor{0.08, 0.09, 0.10};
constexpr double kFillOpacity = 0.16;
constexpr double kLightOpacity = 0.82;
constexpr double kLightPixels = 3;
constexpr double kDarkPixels = 1.2;

constexpr int kCircleCorners = 72;

DisplayPoint centerOf(const DisplayPoint& pixel)
{
  return centerOfPixel(pixel.x(), pixel.y());
}

vtkSmartPointer<vtkPolyData> closedLine(const std::vector<DisplayPoint>& corners)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(corners.size()) + 1);
  for (const DisplayPoint& corner : corners)
    lines->InsertCellPoint(points->InsertNextPoint(centerOf(corner).x(), centerOf(corner).y(), 0));
  lines->InsertCellPoint(0);
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/// Where the sides of the polygon cross the middle of each row of pixels, row after row from `bottom`, ascending.
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
  for (std::vector<double>& row : rows) std::sort(row.begin(), row.end());
  return rows;
}

/// The inside of the polygon in strips of a pixel's height, between odd and even crossings.
vtkSmartPointer<vtkPolyData> filled(const std::vector<DisplayPoint>& corners)
{
  const auto [lowest, highest] = std::minmax_element(
      corners.begin(), corners.end(), [](const DisplayPoint& a, const DisplayPoint& b) { return a.y() < b.y(); });
  const double bottom = std::floor(lowest->y());
  const auto rows = crossingsOfRows(corners, bottom, std::ceil(highest->y()));
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> strips;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double y = bottom + static_cast<double>(row);
    for (std::size_t k = 0; k + 1 < rows[row].size(); k += 2) {
      const double left = rows[row][k];
      const double right = rows[row][k + 1];
      strips->InsertNextCell({points->InsertNextPoint(left, y, 0), points->InsertNextPoint(right, y, 0),
                              points->InsertNextPoint(right, y + 1, 0), points->InsertNextPoint(left, y + 1, 0)});
    }
  }
  data->SetPoints(points);
  data->SetPolys(strips);
  return data;
}

void setColor(vtkActor2D& actor, const Color& color)
{
  actor.GetProperty()->SetColor(color.red, color.green, color.blue);
}

}  // namespace

vtkStandardNewMacro(RegionRepresentation);

RegionRepresentation::RegionRepresentation()
{
  vtkNew<vtkCoordinate> display;
  display->SetCoordinateSystemToDisplay();
  for (vtkPolyDataMapper2D* const mapper : {this->FillMapper.Get(), this->LineMapper.Get()}) {
    mapper->SetTransformCoordinate(display);
    mapper->TransformCoordinateUseDoubleOn();
  }
  this->Fill->SetMapper(this->FillMapper);
  this->LightLine->SetMapper(this->LineMapper);
  this->DarkLine->SetMapper(this->LineMapper);
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

void RegionRepresentation::ShowCircle(const DisplayPoint& center, double radius)
{
  std::vector<DisplayPoint> corners;
  for (int k = 0; k < kCircleCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCircleCorners;
    corners.push_back(center + radius * DisplayPoint(std::cos(angle), std::sin(angle)));
  }
  this->Show(std::move(corners), false);
}

void RegionRepresentation::BuildRepresentation()
{
  if (this->GetMTime() <= this->BuildTime) return;
  this->BuildTime.Modified();
  const bool isLine = this->Outline.size() > 1;
  for (vtkActor2D* const line : {this->LightLine.Get(), this->DarkLine.Get()}) line->SetVisibility(isLine);
  this->Fill->SetVisibility(isLine && this->IsFilled);
  if (isLine) this->LineMapper->SetInputData(closedLine(this->Outline));
  if (isLine && this->IsFilled) this->FillMapper->SetInputData(filled(this->Outline));
  setColor(*this->DarkLine, this->IsFilled ? kPolygonColor : kCircleColor);
  this->LightLine->GetProperty()->SetLineWidth(static_cast<float>(kLightPixels * this->PixelRatio));
  this->DarkLine->GetProperty()->SetLineWidth(static_cast<float>(kDarkPixels * this->PixelRatio));
}

void RegionRepresentation::GetActors2D(vtkPropCollection* actors)
{
  for (vtkActor2D* const actor : {this->Fill.Get(), this->LightLine.Get(), this->DarkLine.Get()})
    actors->AddItem(actor);
}

void RegionRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkActor2D* const actor : {this->Fill.Get(), this->LightLine.Get(), this->DarkLine.Get()})
    actor->ReleaseGraphicsResources(window);
}

int RegionRepresentation::RenderOverlay(vtkViewport* viewport)
{
  this->BuildRepresentation();
  int drawn = 0;
  for (vtkActor2D* const actor : {this->Fill.Get(), this->LightLine.Get(), this->DarkLine.Get()})
    if (actor->GetVisibility() != 0) drawn += actor->RenderOverlay(viewport);
  return drawn;
}

}  // namespace holdfast

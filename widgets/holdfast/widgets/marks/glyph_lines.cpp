#include "holdfast/widgets/marks/glyph_lines.h"

#include <cmath>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace holdfast {
namespace {

// A dash is as long as a gap, and a line begins and ends with one.
constexpr int kDashes = 11;

}  // namespace

GlyphLines::GlyphLines()
{
  points_->SetDataTypeToDouble();
  colors_->SetNumberOfComponents(3);
  data_->SetPoints(points_);
  data_->GetPointData()->SetScalars(colors_);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data_);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->LightingOff();
}

GlyphLines::~GlyphLines() = default;

void GlyphLines::set(const std::vector<GlyphLine>& lines)
{
  points_->Reset();
  colors_->Reset();
  vtkNew<vtkCellArray> cells;
  const auto addPoint = [&](const Vector3& place, const Color& color) {
    colors_->InsertNextTuple3(std::round(255 * color.red), std::round(255 * color.green), std::round(255 * color.blue));
    return points_->InsertNextPoint(place.data());
  };
  for (const GlyphLine& line : lines) {
    const int dashes = line.style == LineStyle::Dashed ? kDashes : 1;
    const Vector3 step = (line.to - line.from) / (2 * dashes - 1);
    for (int k = 0; k < dashes; ++k) {
      const Vector3 end = k == dashes - 1 ? line.to : Vector3(line.from + (2 * k + 1) * step);
      cells->InsertNextCell({addPoint(line.from + 2 * k * step, line.color), addPoint(end, line.color)});
    }
  }
  points_->Modified();
  colors_->Modified();
  data_->SetLines(cells);
  actor_->SetVisibility(!lines.empty());
}

void GlyphLines::setWidth(double pixels)
{
  actor_->GetProperty()->SetLineWidth(static_cast<float>(pixels));
}

}  // namespace holdfast

#include "holdfast/window/tools/moved_region.h"

#include <array>
#include <unordered_map>

#include <vtkCellArray.h>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/mesh/actors.h>

namespace holdfast {
namespace {

constexpr double kRegionOpacity = 0.75;

// Of the others as many are left out as it takes to draw them at once.
constexpr std::size_t kMostTriangles = 20000;

}  // namespace

MovedRegion::MovedRegion(Viewport& viewport) : viewport_(viewport)
{
  points_->SetDataTypeToDouble();
  data_->SetPoints(points_);
  showData(*actor_, *data_);
  setColor(*actor_, kAccentColor);
  actor_->GetProperty()->SetOpacity(kRegionOpacity);
  // Without a pass of its own, which would wait for the picture.
  actor_->ForceOpaqueOn();
  actor_->PickableOff();
  actor_->VisibilityOff();
  viewport_.widgetRenderer().AddActor(actor_);
}

void MovedRegion::begin(const std::vector<Index>& vertices)
{
  const VisibleSurface& surface = *viewport_.surface();
  std::unordered_map<Index, vtkIdType> placeOf;
  for (const Index vertex : vertices) placeOf.emplace(vertex, static_cast<vtkIdType>(placeOf.size()));
  std::vector<std::array<vtkIdType, 3>> triangles;
  for (const Index vertex : vertices)
    for (const Index triangle : surface.trianglesAt(vertex)) {
      const auto& corners = surface.model().triangulation.triangles[triangle];
      // Each once: at its first corner.
      if (corners[0] != vertex || !placeOf.contains(corners[1]) || !placeOf.contains(corners[2])) continue;
      triangles.push_back({placeOf.at(corners[0]), placeOf.at(corners[1]), placeOf.at(corners[2])});
    }
  const std::size_t step = triangles.size() / kMostTriangles + 1;
  vtkNew<vtkCellArray> cells;
  for (std::size_t k = 0; k < triangles.size(); k += step) cells->InsertNextCell(3, triangles[k].data());
  data_->SetPolys(cells);
}

void MovedRegion::moveTo(const Positions& places)
{
  points_->SetNumberOfPoints(places.rows());
  for (Index row = 0; row < places.rows(); ++row)
    points_->SetPoint(row, places(row, 0), places(row, 1), places(row, 2));
  points_->Modified();
  actor_->VisibilityOn();
  viewport_.scheduleWidgets();
}

void MovedRegion::hide()
{
  if (!isVisible()) return;
  actor_->VisibilityOff();
  viewport_.scheduleWidgets();
}

}  // namespace holdfast

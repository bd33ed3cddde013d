#include "holdfast/widgets/mesh/guide_actor.h"

#include <utility>

#include <vtkCellArray.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>

namespace holdfast {
namespace {

constexpr Color kGuideColor{0.20, 0.50, 0.72};
constexpr double kGuideOpacity = 0.28;

}  // namespace

GuideActor::GuideActor(vtkPlaneCollection& sectionPlanes)
{
  showData(*actor_, *data_).SetClippingPlanes(&sectionPlanes);
  setColor(*actor_, kGuideColor);
  actor_->GetProperty()->SetOpacity(kGuideOpacity);
  actor_->VisibilityOff();
}

void GuideActor::show(std::vector<std::shared_ptr<const GuideSurface>> surfaces)
{
  if (surfaces == surfaces_) return;
  surfaces_ = std::move(surfaces);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const auto& surface : surfaces_) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (const auto& place : surface->positions().rowwise()) points->InsertNextPoint(place[0], place[1], place[2]);
    for (const auto& [a, b, c] : surface->triangles()) cells->InsertNextCell({first + a, first + b, first + c});
  }
  data_->SetPoints(points);
  data_->SetPolys(cells);
  actor_->SetVisibility(!surfaces_.empty());
}

}  // namespace holdfast

#include "holdfast/widgets/marks/selection_overlay.h"

#include <vtkCellArray.h>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/marks/evenly_spread.h>

namespace holdfast {

SelectionOverlay::SelectionOverlay(const Model& model, const MeshActor& mesh)
    : model_(model), mesh_(mesh), tint_(mesh, kAccentColor)
{
  dotData_->SetPoints(&mesh.points());
  showData(*dots_, *dotData_).SetClippingPlanes(&mesh.sectionPlanes());
  showPointsAsBalls(*dots_, kAccentColor);
  set({});
}

void SelectionOverlay::set(const std::vector<Index>& fileVertices)
{
  selected_ = fileVertices;
  refresh();
}

void SelectionOverlay::refresh()
{
  const auto count = static_cast<std::size_t>(selected_.empty() ? 0 : model_.mesh.vertexCount());
  std::vector<char> isSelected(count, 0);
  for (const Index vertex : selected_) isSelected[vertex] = 1;
  tint_.set(isSelected);
  std::vector<Index> pointOf(count, -1);
  const Polygons& triangles = mesh_.shaded()->triangles;
  for (Index t = 0; count > 0 && t < triangles.size(); ++t)
    for (const Index point : triangles[t])
      if (!mesh_.isHidden(t)) pointOf[mesh_.vertexOf()[point]] = point;
  std::vector<Index> drawn;
  for (std::size_t vertex = 0; vertex < isSelected.size(); ++vertex)
    if (isSelected[vertex] != 0 && pointOf[vertex] >= 0 && !tint_.covers(static_cast<Index>(vertex)))
      drawn.push_back(static_cast<Index>(vertex));
  vtkNew<vtkCellArray> dots;
  for (const Index vertex : evenlySpread(model_.mesh.positions, drawn, kMostSelectionDots))
    dots->InsertNextCell({pointOf[vertex]});
  dotData_->SetVerts(dots);
  dots_->SetVisibility(dots->GetNumberOfCells() > 0);
}

}  // namespace holdfast

#include "holdfast/widgets/marks/selection_overlay.h"

#include <utility>

#include <vtkCellArray.h>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/marks/evenly_spread.h>

namespace holdfast {

SelectionOverlay::SelectionOverlay(const Model& model, const MeshActor& mesh)
    : model_(model), pointOf_(mesh.shaded()->pointOf(model.mesh.vertexCount())), tint_(mesh, kAccentColor)
{
  dotData_->SetPoints(&mesh.points());
  showData(*dots_, *dotData_).SetClippingPlanes(&mesh.sectionPlanes());
  showPointsAsBalls(*dots_, kAccentColor);
  set({});
}

void SelectionOverlay::set(const std::vector<Index>& fileVertices)
{
  std::vector<char> isSelected(fileVertices.empty() ? 0 : pointOf_.size(), 0);
  for (const Index vertex : fileVertices) isSelected[vertex] = 1;
  tint_.set(isSelected);
  std::vector<Index> drawn;
  for (std::size_t vertex = 0; vertex < isSelected.size(); ++vertex)
    if (isSelected[vertex] != 0 && pointOf_[vertex] >= 0 && !tint_.covers(static_cast<Index>(vertex)))
      drawn.push_back(static_cast<Index>(vertex));
  vtkNew<vtkCellArray> dots;
  for (const Index vertex : evenlySpread(model_.mesh.positions, drawn, kMostSelectionDots))
    dots->InsertNextCell({pointOf_[vertex]});
  dotData_->SetVerts(dots);
  dots_->SetVisibility(dots->GetNumberOfCells() > 0);
}

}  // namespace holdfast

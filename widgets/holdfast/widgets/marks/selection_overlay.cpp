#include "holdfast/widgets/marks/selection_overlay.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/marks/evenly_spread.h>

namespace holdfast {
namespace {

constexpr double kTintOpacity = 0.45;

// The tint lies on the surface, below the lines of edges.
constexpr double kTintFactor = -0.5;
constexpr double kTintUnits = -2;

}  // namespace

SelectionOverlay::SelectionOverlay(const Model& model, const MeshActor& mesh)
    : model_(model), mesh_(mesh), pointOf_(mesh.shaded()->pointOf(model.mesh.vertexCount()))
{
  dotData_->SetPoints(&mesh.points());
  showData(*dots_, *dotData_).SetClippingPlanes(&mesh.sectionPlanes());
  showPointsAsBalls(*dots_, kAccentColor);
  tintData_->SetPoints(&mesh.points());
  tintData_->GetPointData()->SetNormals(&mesh.normals());
  tintMapper_->SetInputData(tintData_);
  coarseTintMapper_->SetInputData(coarseTintData_);
  for (vtkPolyDataMapper* const mapper : {tintMapper_.Get(), coarseTintMapper_.Get()}) {
    mapper->SetClippingPlanes(&mesh.sectionPlanes());
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(kTintFactor, kTintUnits);
  }
  setColor(*tint_, kAccentColor);
  tint_->GetProperty()->SetOpacity(kTintOpacity);
  // The shades are those of the surface that shines through.
  tint_->GetProperty()->LightingOff();
  // It hides nothing that the surface below it does not hide, and needs no order.
  tint_->ForceOpaqueOn();
  set({});
}

void SelectionOverlay::set(const std::vector<Index>& fileVertices)
{
  isSelected_.assign(pointOf_.size(), 0);
  for (const Index vertex : fileVertices) isSelected_[vertex] = 1;
  std::vector<Index> drawn;
  drawn.reserve(pointOf_.size());
  for (std::size_t vertex = 0; vertex < pointOf_.size(); ++vertex)
    if (isSelected_[vertex] != 0 && pointOf_[vertex] >= 0) drawn.push_back(static_cast<Index>(vertex));
  vtkNew<vtkCellArray> dots;
  for (const Index vertex : evenlySpread(model_.mesh.positions, drawn, kMostSelectionDots))
    dots->InsertNextCell({pointOf_[vertex]});
  dotData_->SetVerts(dots);
  dots_->SetVisibility(dots->GetNumberOfCells() > 0);
  tinted_ = tintedOf(mesh_.shaded()->triangles, mesh_.vertexOf());
  // Made when they are to be drawn.
  for (vtkPolyData* const data : {tintData_.Get(), coarseTintData_.Get()}) data->SetPolys(nullptr);
  tint_->SetVisibility(tinted_ > 0);
  updateTint();
}

vtkIdType SelectionOverlay::tintedOf(const Polygons& triangles, const std::vector<Index>& vertexOf) const
{
  vtkIdType count = 0;
  for (Index t = 0; t < triangles.size(); ++t) count += areSelected(triangles[t], vertexOf) ? 1 : 0;
  return count;
}

void SelectionOverlay::setTint(vtkPolyData& data, const Polygons& triangles, const std::vector<Index>& vertexOf) const
{
  const vtkIdType count = tintedOf(triangles, vertexOf);
  vtkNew<vtkCellArray> tinted;
  // Fresh memory takes longer than what is written into it.
  tinted->Use32BitStorage();
  tinted->AllocateExact(count, 3 * count);
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto corners = triangles[t];
    if (areSelected(corners, vertexOf)) tinted->InsertNextCell({corners[0], corners[1], corners[2]});
  }
  data.SetPolys(tinted);
}

void SelectionOverlay::setDetail(Detail detail)
{
  detail_ = detail;
  updateTint();
}

void SelectionOverlay::updateTint()
{
  // Small tints would lose their shape.
  const bool isCoarse = detail_ == Detail::Coarse && tinted_ > kCoarseTriangles;
  if (!isCoarse && tintData_->GetNumberOfPolys() < tinted_)
    setTint(*tintData_, mesh_.shaded()->triangles, mesh_.vertexOf());
  if (isCoarse && coarseTintData_->GetNumberOfPolys() == 0) {
    const CoarseSurface& coarse = mesh_.coarse();
    coarseTintData_->SetPoints(coarse.data().GetPoints());
    coarseTintData_->GetPointData()->SetNormals(coarse.data().GetPointData()->GetNormals());
    setTint(*coarseTintData_, coarse.triangles(), coarse.vertexOf());
  }
  tint_->SetMapper(isCoarse ? coarseTintMapper_ : tintMapper_);
}

}  // namespace holdfast

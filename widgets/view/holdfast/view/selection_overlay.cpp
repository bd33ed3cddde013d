#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/view/constraint_glyphs.h>
#include <holdfast/view/evenly_spread.h>
#include <holdfast/view/selection_overlay.h>

namespace holdfast {
namespace {

constexpr double kTintOpacity = 0.45;

// The tint lies on the surface, below the lines of edges.
constexpr double kTintFactor = -0.5;
constexpr double kTintUnits = -2;

std::vector<Index> pointsOfVertices(const MeshActor& mesh, Index vertexCount)
{
  std::vector<Index> pointOf(static_cast<std::size_t>(vertexCount), -1);
  const std::vector<Index>& vertexOf = mesh.vertexOf();
  for (std::size_t k = vertexOf.size(); k-- > 0;) pointOf[vertexOf[k]] = static_cast<Index>(k);
  return pointOf;
}

void setTintLook(vtkProperty& property)
{
  property.SetColor(kAccentColor.red, kAccentColor.green, kAccentColor.blue);
  property.SetOpacity(kTintOpacity);
  property.SetInterpolationToPhong();
  property.SetAmbient(0.5);
  property.SetDiffuse(0.5);
}

}  // namespace

SelectionOverlay::SelectionOverlay(const Model& model, const MeshActor& mesh)
    : model_(model), mesh_(mesh), pointOf_(pointsOfVertices(mesh, model.mesh.vertexCount()))
{
  dotData_->SetPoints(&mesh.points());
  tintData_->SetPoints(&mesh.points());
  tintData_->GetPointData()->SetNormals(&mesh.normals());
  vtkNew<vtkPolyDataMapper> dotMapper;
  dotMapper->SetInputData(dotData_);
  dots_->SetMapper(dotMapper);
  vtkNew<vtkPolyDataMapper> tintMapper;
  tintMapper->SetInputData(tintData_);
  tintMapper->SetResolveCoincidentTopologyToPolygonOffset();
  tintMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(kTintFactor, kTintUnits);
  tint_->SetMapper(tintMapper);
  showPointsAsBalls(*dots_, kAccentColor);
  setTintLook(*tint_->GetProperty());
  set({});
}

SelectionOverlay::~SelectionOverlay() = default;

void SelectionOverlay::set(const std::vector<Index>& fileVertices)
{
  std::vector<Index> points;
  std::vector<char> isSelected(pointOf_.size(), 0);
  for (const Index vertex : fileVertices) {
    isSelected[vertex] = 1;
    if (pointOf_[vertex] >= 0) points.push_back(pointOf_[vertex]);
  }
  Positions rest(static_cast<Index>(points.size()), 3);
  for (Index k = 0; k < rest.rows(); ++k) rest.row(k) = model_.mesh.positions.row(mesh_.vertexOf()[points[k]]);
  vtkNew<vtkCellArray> dots;
  for (const Index k : evenlySpread(rest, kMostSelectionDots)) dots->InsertNextCell({points[k]});
  vtkNew<vtkCellArray> tinted;
  const Polygons& triangles = mesh_.shaded()->triangles;
  const auto isTinted = [&](Index point) { return isSelected[mesh_.vertexOf()[point]] != 0; };
  for (Index t = 0; t < triangles.size() && !points.empty(); ++t) {
    const auto corners = triangles[t];
    if (isTinted(corners[0]) && isTinted(corners[1]) && isTinted(corners[2]))
      tinted->InsertNextCell({corners[0], corners[1], corners[2]});
  }
  dotData_->SetVerts(dots);
  tintData_->SetPolys(tinted);
  dots_->SetVisibility(dots->GetNumberOfCells() > 0);
  tint_->SetVisibility(tinted->GetNumberOfCells() > 0);
}

void SelectionOverlay::setDotPixels(double pixels)
{
  dots_->GetProperty()->SetPointSize(static_cast<float>(pixels));
}

}  // namespace holdfast

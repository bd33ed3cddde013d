#include <algorithm>
#include <cassert>
#include <cmath>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/view/mesh_actor.h>
#include <holdfast/view/poly_data.h>

namespace holdfast {
namespace {

constexpr double kEdgePixels = 1.1;

// Lines lie on the surface: without a shift towards the eye they would come and go.
constexpr double kEdgeFactor = -1;
constexpr double kEdgeUnits = -4;

vtkSmartPointer<vtkCellArray> trianglesOf(const ShadedSurface& surface)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(surface.triangles.size(), surface.triangles.cornerCount());
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    const auto corners = surface.triangles[t];
    cells->InsertNextCell({corners[0], corners[1], corners[2]});
  }
  return cells;
}

vtkSmartPointer<vtkCellArray> creasesOf(const ShadedSurface& surface)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& [a, b] : surface.creases) cells->InsertNextCell({a, b});
  return cells;
}

vtkSmartPointer<vtkFloatArray> normalsOf(const ShadedSurface& surface, const Positions& points)
{
  const Positions normals =
      areaWeightedNormals(points, surface.triangles, cornerVertices(surface.triangles), points.rows());
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(normals.rows());
  std::transform(normals.data(), normals.data() + normals.size(), array->GetPointer(0),
                 [](double value) { return static_cast<float>(value); });
  return array;
}

void setSurfaceLook(vtkProperty& property)
{
  property.SetColor(kPlainColor.red, kPlainColor.green, kPlainColor.blue);
  property.SetInterpolationToPhong();
  property.SetAmbient(0.16);
  property.SetDiffuse(0.84);
  property.SetSpecular(0.10);
  property.SetSpecularPower(24);
}

void setEdgeLook(vtkProperty& property)
{
  property.SetColor(0.13, 0.15, 0.19);
  property.SetOpacity(0.75);
  property.LightingOff();
  property.SetLineWidth(static_cast<float>(kEdgePixels));
}

}  // namespace

MeshActor::MeshActor(const Model& model) : shaded_(cutAtSharpEdges(model))
{
  surfaceData_->SetPolys(trianglesOf(shaded_));
  edgeData_->SetLines(creasesOf(shaded_));
  surfaceMapper_->SetInputData(surfaceData_);
  surfaceMapper_->ScalarVisibilityOff();
  edgeMapper_->SetInputData(edgeData_);
  edgeMapper_->ScalarVisibilityOff();
  edgeMapper_->SetResolveCoincidentTopologyToPolygonOffset();
  edgeMapper_->SetRelativeCoincidentTopologyLineOffsetParameters(kEdgeFactor, kEdgeUnits);
  surface_->SetMapper(surfaceMapper_);
  edges_->SetMapper(edgeMapper_);
  setSurfaceLook(*surface_->GetProperty());
  setEdgeLook(*edges_->GetProperty());
  setPositions(model.mesh.positions);
}

MeshActor::~MeshActor() = default;

void MeshActor::setPositions(const Positions& positions)
{
  const Positions points = pointsOf(shaded_, positions);
  const auto shared = toPoints(points);
  surfaceData_->SetPoints(shared);
  surfaceData_->GetPointData()->SetNormals(normalsOf(shaded_, points));
  edgeData_->SetPoints(shared);
}

void MeshActor::setColors(const std::vector<double>& values, const ColorScale& scale)
{
  vtkNew<vtkDoubleArray> shares;
  shares->SetName("shares of the scale");
  shares->SetNumberOfValues(static_cast<vtkIdType>(shaded_.vertexOf.size()));
  bool isComplete = true;
  for (std::size_t k = 0; k < shaded_.vertexOf.size(); ++k) {
    assert(shaded_.vertexOf[k] < static_cast<Index>(values.size()));
    const double share = shareOf(scale, values[shaded_.vertexOf[k]]);
    isComplete = isComplete && !std::isnan(share);
    shares->SetValue(static_cast<vtkIdType>(k), share);
  }
  surfaceData_->GetPointData()->SetScalars(shares);
  surfaceMapper_->SetLookupTable(toLookupTable());
  surfaceMapper_->UseLookupTableScalarRangeOn();
  surfaceMapper_->SetInterpolateScalarsBeforeMapping(isComplete);
  surfaceMapper_->ScalarVisibilityOn();
}

void MeshActor::setPixelRatio(double ratio)
{
  edges_->GetProperty()->SetLineWidth(static_cast<float>(kEdgePixels * ratio));
}

}  // namespace holdfast

#include "holdfast/widgets/mesh/coarse_surface.h"

#include <algorithm>

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <holdfast/mesh/solid.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {

CoarseSurface::CoarseSurface(const Model& model, const ShadedSurface& surface)
    : isSolid_(holdfast::isSolid(model.solverMesh))
{
  const Polygons coarse = coarseTriangles(model, surface, kCoarseTriangles);
  std::vector<Index> newPointOf(surface.vertexOf.size(), -1);
  const auto newPoint = [&](Index point) {
    if (newPointOf[point] < 0) {
      newPointOf[point] = static_cast<Index>(pointOf_.size());
      pointOf_.push_back(point);
      vertexOf_.push_back(surface.vertexOf[point]);
    }
    return newPointOf[point];
  };
  for (Index t = 0; t < coarse.size(); ++t)
    triangles_.add({newPoint(coarse[t][0]), newPoint(coarse[t][1]), newPoint(coarse[t][2])});
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    const auto corners = surface.triangles[t];
    if (std::all_of(corners.begin(), corners.end(), [&](Index point) { return newPointOf[point] < 0; })) continue;
    around_.add(corners);
    for (const Index point : corners) cornerOf_.push_back(newPointOf[point]);
  }

  const auto count = static_cast<vtkIdType>(pointOf_.size());
  places_->SetNumberOfComponents(3);
  places_->SetNumberOfTuples(count);
  normals_->SetName("Normals");
  normals_->SetNumberOfComponents(3);
  normals_->SetNumberOfTuples(count);
  vtkNew<vtkPoints> points;
  points->SetData(places_);
  data_->SetPoints(points);
  data_->GetPointData()->SetNormals(normals_);
  data_->SetPolys(toCells(triangles_));
}

CoarseSurface::~CoarseSurface() = default;

void CoarseSurface::follow(const Positions& places)
{
  doubleNormals_.resize(static_cast<Index>(pointOf_.size()), 3);
  areaWeightedNormals(places, around_, cornerOf_, doubleNormals_);
  for (std::size_t k = 0; k < pointOf_.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const auto to = static_cast<Index>(k);
      places_->SetTypedComponent(to, axis, places(pointOf_[k], axis));
      normals_->SetTypedComponent(to, axis, static_cast<float>(doubleNormals_(to, axis)));
    }
  places_->Modified();
  normals_->Modified();
  data_->GetPoints()->Modified();
}

bool CoarseSurface::isNear(const Vector3& place) const
{
  return vtkBoundingBox(data_->GetBounds()).ContainsPoint(place.data()) != 0;
}

void CoarseSurface::color(const vtkDoubleArray* shares)
{
  if (shares == nullptr) {
    data_->GetPointData()->SetScalars(nullptr);
    return;
  }
  vtkNew<vtkDoubleArray> own;
  own->SetName("shares of the scale");
  own->SetNumberOfValues(static_cast<vtkIdType>(pointOf_.size()));
  for (std::size_t k = 0; k < pointOf_.size(); ++k)
    own->SetValue(static_cast<vtkIdType>(k), shares->GetValue(pointOf_[k]));
  data_->GetPointData()->SetScalars(own);
}

}  // namespace holdfast

#include "holdfast/widgets/mesh/coarse_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <holdfast/check/mesh_check.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

constexpr double kTooFew = 0.75;
constexpr double kTooMany = 1.25;
constexpr int kMostAttempts = 5;

// Cells along the diagonal: their numbers fit into a third of a key.
constexpr double kMostCellsAcross = 1e5;

/// The unknowns as places in units of the mesh's diagonal, and the octant into which each faces.
struct Cloud {
  Positions places;
  std::vector<int> octant;
};

Cloud cloudOf(const SolverMesh& mesh)
{
  Cloud cloud{restInDiagonals(mesh), {}};
  Positions normals = Positions::Zero(mesh.unknownCount(), 3);
  for (const Triangle& triangle : mesh.triangles) {
    const Vector3 area = areaVector(cloud.places, triangle);
    for (const Index vertex : triangle) normals.row(vertex) += area;
  }
  for (Index v = 0; v < normals.rows(); ++v)
    cloud.octant.push_back((normals(v, 0) < 0 ? 1 : 0) + (normals(v, 1) < 0 ? 2 : 0) + (normals(v, 2) < 0 ? 4 : 0));
  return cloud;
}

/// The unknowns sorted by the cells of a grid and by octant, each with the key of its cell.
std::vector<std::pair<std::int64_t, Index>> byCell(const Cloud& cloud, double cellSize)
{
  constexpr int kBits = 20;
  const Eigen::RowVector3d origin = cloud.places.colwise().minCoeff();
  std::vector<std::pair<std::int64_t, Index>> cells;
  cells.reserve(cloud.octant.size());
  for (Index v = 0; v < cloud.places.rows(); ++v) {
    const Eigen::RowVector3d cell = (cloud.places.row(v) - origin) / cellSize;
    std::int64_t key = cloud.octant[v];
    for (const double number : cell) key = (key << kBits) + static_cast<std::int64_t>(number);
    cells.emplace_back(key, v);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// The one of some unknowns that is nearest to their mean.
Index middleOf(const Positions& places, std::span<const std::pair<std::int64_t, Index>> cell)
{
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
  for (const auto& [key, v] : cell) mean += places.row(v);
  mean /= static_cast<double>(cell.size());
  const auto nearest = std::min_element(cell.begin(), cell.end(), [&](const auto& a, const auto& b) {
    return (places.row(a.second) - mean).squaredNorm() < (places.row(b.second) - mean).squaredNorm();
  });
  return nearest->second;
}

std::vector<int> representatives(const Cloud& cloud, double cellSize)
{
  const auto cells = byCell(cloud, cellSize);
  std::vector<int> representativeOf(cells.size());
  for (std::size_t first = 0; first < cells.size();) {
    std::size_t last = first + 1;
    while (last < cells.size() && cells[last].first == cells[first].first) ++last;
    const auto middle = static_cast<int>(middleOf(cloud.places, std::span(cells).subspan(first, last - first)));
    for (std::size_t k = first; k < last; ++k) representativeOf[cells[k].second] = middle;
    first = last;
  }
  return representativeOf;
}

/// Three representatives, and the first triangle between them.
using Between = std::array<Index, 4>;

/// The triangles between different representatives, each once, its smallest corner first.
std::vector<Between> between(const std::vector<Triangle>& all, const std::vector<int>& representativeOf)
{
  std::vector<Between> triangles;
  for (std::size_t t = 0; t < all.size(); ++t) {
    Triangle coarse{representativeOf[all[t][0]], representativeOf[all[t][1]], representativeOf[all[t][2]]};
    if (coarse[0] == coarse[1] || coarse[1] == coarse[2] || coarse[2] == coarse[0]) continue;
    std::rotate(coarse.begin(), std::min_element(coarse.begin(), coarse.end()), coarse.end());
    triangles.push_back({coarse[0], coarse[1], coarse[2], static_cast<Index>(t)});
  }
  std::ranges::sort(triangles);
  const auto isRepeated = [](const Between& a, const Between& b) {
    return std::equal(a.begin(), a.begin() + 3, b.begin());
  };
  triangles.erase(std::unique(triangles.begin(), triangles.end(), isRepeated), triangles.end());
  return triangles;
}

std::vector<Between> aboutAsMany(const SolverMesh& mesh, const std::vector<Triangle>& all, Index target)
{
  const Cloud cloud = cloudOf(mesh);
  const auto wanted = static_cast<double>(target);
  double cellSize = 1 / std::sqrt(wanted);
  std::vector<Between> triangles;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    triangles = between(all, representatives(cloud, cellSize));
    const double share = static_cast<double>(triangles.size()) / wanted;
    if (share >= kTooFew && share <= kTooMany) break;
    cellSize = std::clamp(cellSize * std::sqrt(std::max(share, 0.01)), 1 / kMostCellsAcross, 1.0);
  }
  return triangles;
}

}  // namespace

CoarseTriangles coarseTriangles(const Model& model, const ShadedSurface& surface, Index target)
{
  CoarseTriangles coarse;
  if (2 * surface.triangles.size() <= 3 * target) {
    coarse.triangles = surface.triangles;
    coarse.sources.resize(static_cast<std::size_t>(surface.triangles.size()));
    std::iota(coarse.sources.begin(), coarse.sources.end(), Index{0});
    return coarse;
  }
  const Weld& weld = model.solverMesh.weld;
  std::vector<Index> pointOf(static_cast<std::size_t>(weld.unknownCount), -1);
  for (std::size_t k = surface.vertexOf.size(); k-- > 0;)
    pointOf[weld.unknownOf[surface.vertexOf[k]]] = static_cast<Index>(k);
  for (const auto& [a, b, c, source] : aboutAsMany(model.solverMesh, trianglesOverUnknowns(model), target)) {
    coarse.triangles.add({pointOf[a], pointOf[b], pointOf[c]});
    coarse.sources.push_back(source);
  }
  return coarse;
}

CoarseSurface::CoarseSurface(const Model& model, const ShadedSurface& surface)
    : isSolid_(holdfast::isSolid(model.solverMesh))
{
  CoarseTriangles chosen = coarseTriangles(model, surface, kCoarseTriangles);
  sources_ = std::move(chosen.sources);
  const Polygons& coarse = chosen.triangles;
  std::vector<int> newPointOf(surface.vertexOf.size(), -1);
  const auto newPoint = [&](Index point) {
    if (newPointOf[point] < 0) {
      newPointOf[point] = static_cast<int>(pointOf_.size());
      pointOf_.push_back(point);
      vertexOf_.push_back(surface.vertexOf[point]);
    }
    return newPointOf[point];
  };
  for (Index t = 0; t < coarse.size(); ++t)
    triangles_.add({newPoint(coarse[t][0]), newPoint(coarse[t][1]), newPoint(coarse[t][2])});
  std::vector<int> pointOfCorner;  // of the triangles around; -1 where it has none
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    const auto corners = surface.triangles[t];
    if (std::all_of(corners.begin(), corners.end(), [&](Index point) { return newPointOf[point] < 0; })) continue;
    around_.add(corners);
    for (const Index point : corners) pointOfCorner.push_back(newPointOf[point]);
  }
  doubleNormals_ = std::make_unique<AreaWeightedNormals>(around_, pointOfCorner, static_cast<Index>(pointOf_.size()));

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
  setHidden({});
}

CoarseSurface::~CoarseSurface() = default;

void CoarseSurface::setHidden(const std::vector<char>& isHidden)
{
  drawn_ = {};
  for (Index t = 0; t < triangles_.size(); ++t)
    if (isHidden.empty() || isHidden[sources_[t]] == 0) drawn_.add(triangles_[t]);
  data_->SetPolys(toCells(drawn_));
}

void CoarseSurface::follow(const Positions& places)
{
  const Positions& normals = doubleNormals_->at(places);
  for (std::size_t k = 0; k < pointOf_.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const auto to = static_cast<Index>(k);
      places_->SetTypedComponent(to, axis, places(pointOf_[k], axis));
      normals_->SetTypedComponent(to, axis, static_cast<float>(normals(to, axis)));
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

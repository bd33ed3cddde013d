#include "holdfast/view/visible_surface.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace holdfast {
namespace {

// Parts of the surface that touch a place do not hide it, though rounding may put them this share of the way nearer.
constexpr double kBeforePlace = 1 - 1e-9;

}  // namespace

VisibleSurface::VisibleSurface(const Model& model)
    : model_(&model),
      rays_(model.mesh.positions, model.triangulation.triangles),
      trianglesOf_(
          std::make_shared<const VertexTriangles>(trianglesOverUnknowns(model), model.solverMesh.unknownCount()))
{
}

VisibleSurface VisibleSurface::movedTo(std::shared_ptr<const Positions> positions) const
{
  VisibleSurface moved(*this);
  moved.rays_ = rays_.movedTo(std::move(positions));
  return moved;
}

std::span<const Index> VisibleSurface::trianglesAt(Index vertex) const
{
  return trianglesOf_->of(model_->solverMesh.weld.unknownOf[vertex]);
}

bool VisibleSurface::isVertexVisible(Index vertex, const DisplayTransform& display) const
{
  return !rays_.isBlocked(display.rayTo(positions().row(vertex)), kBeforePlace, trianglesAt(vertex));
}

bool VisibleSurface::isEdgeVisible(Index i, Index j, const Vector3& place, const DisplayTransform& display) const
{
  const std::span<const Index> atI = trianglesAt(i);
  const std::span<const Index> atJ = trianglesAt(j);
  std::vector<Index> both;
  std::set_intersection(atI.begin(), atI.end(), atJ.begin(), atJ.end(), std::back_inserter(both));
  return !rays_.isBlocked(display.rayTo(place), kBeforePlace, both);
}

}  // namespace holdfast

#include "holdfast/widgets/picking/visible_surface.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace holdfast {

VisibleSurface::VisibleSurface(const Model& model)
    : model_(&model),
      rays_(model.mesh.positions, model.triangulation.triangles),
      trianglesOf_(std::make_shared<const IndexLists>(
          trianglesOfVertices(trianglesOverUnknowns(model), model.solverMesh.unknownCount())))
{
}

VisibleSurface VisibleSurface::withSection(const std::optional<SectionPlane>& section) const
{
  VisibleSurface cut(*this);
  cut.section_ = section;
  return cut;
}

VisibleSurface VisibleSurface::withHidden(std::shared_ptr<const std::vector<char>> isHidden) const
{
  VisibleSurface some(*this);
  some.rays_ = rays_.without(std::move(isHidden));
  return some;
}

bool VisibleSurface::isShown(Index vertex) const
{
  return std::ranges::any_of(trianglesAt(vertex), [this](Index triangle) { return !isHidden(triangle); });
}

VisibleSurface VisibleSurface::movedTo(std::shared_ptr<const Positions> positions) const
{
  VisibleSurface moved(*this);
  moved.rays_ = rays_.movedTo(std::move(positions));
  return moved;
}

RayRange VisibleSurface::keptPart(const Ray& ray, const RayRange& range) const
{
  if (!section_) return range;
  constexpr RayRange kNothing{1, 0};
  const double height = (ray.origin - section_->origin).dot(section_->normal);
  const double slope = ray.direction.dot(section_->normal);
  if (slope == 0) return height >= 0 ? range : kNothing;
  const double crossing = -height / slope;
  if (slope > 0) return {std::max(range.begin, crossing), range.end};
  return {range.begin, std::min(range.end, crossing)};
}

/// Tells whether triangles other than `own` lie between the ray's origin and its place at t = 1.
bool VisibleSurface::isBlocked(const Ray& toPlace, std::span<const Index> own) const
{
  // Parts of the surface that touch a place do not hide it, though rounding may put them this share of the way nearer.
  constexpr double kBeforePlace = 1 - 1e-9;
  const RayRange kept = keptPart(toPlace, {0, kBeforePlace});
  return rays_.isBlocked(toPlace, kept.end, own, kept.begin);
}

bool VisibleSurface::isVertexVisible(Index vertex, const DisplayTransform& display) const
{
  const Vector3 place = positions().row(vertex);
  return isKept(place) && !isBlocked(display.rayTo(place), trianglesAt(vertex));
}

bool VisibleSurface::isEdgeVisible(Index i, Index j, const Vector3& place, const DisplayTransform& display) const
{
  const std::span<const Index> atI = trianglesAt(i);
  const std::span<const Index> atJ = trianglesAt(j);
  std::vector<Index> both;
  std::set_intersection(atI.begin(), atI.end(), atJ.begin(), atJ.end(), std::back_inserter(both));
  return !isBlocked(display.rayTo(place), both);
}

}  // namespace holdfast

#include "holdfast/constraints/selector.h"

#include <limits>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include <holdfast/surface/curve_region.h>

namespace holdfast {
namespace {

std::string keyOfPlace(std::size_t place)
{
  return fmt::format(".through[{}]", place);
}

/// Walks the expression: checks its ids, and puts the vertices that curves select in their place.
struct Resolver {
  const Mesh& mesh;
  Index componentCount;
  CurveSelector& curves;
  InputLocation where;

  [[nodiscard]] Selection resolved(const Selection& selection) const
  {
    return std::visit([this](const auto& what) { return Selection{(*this)(what)}; }, selection.what);
  }

  VertexIds operator()(const VertexIds& vertices) const
  {
    for (const Index v : vertices.ids) requireVertex(mesh, v, where, ".vertices");
    return vertices;
  }
  InComponent operator()(const InComponent& component) const
  {
    if (component.component < 0 || component.component >= componentCount)
      throw InputError(below(where, ".component"),
                       fmt::format("there is no part {}; the mesh has {} connected parts, numbered from 0",
                                   component.component, componentCount));
    return component;
  }
  VertexIds operator()(const InsideCurve& curve) const { return {curves.select(curve, below(where, ".curve"))}; }
  AllOf operator()(const AllOf& all) const { return {parts(all.parts, ".all")}; }
  AnyOf operator()(const AnyOf& any) const { return {parts(any.parts, ".any")}; }
  NotIn operator()(const NotIn& none) const
  {
    return {std::make_shared<const Selection>(at(".not").resolved(*none.part))};
  }
  template <class Shape>
  Shape operator()(const Shape& shape) const
  {
    return shape;
  }

 private:
  [[nodiscard]] Resolver at(const std::string& key) const { return {mesh, componentCount, curves, below(where, key)}; }

  [[nodiscard]] std::vector<Selection> parts(const std::vector<Selection>& parts, const char* key) const
  {
    std::vector<Selection> result;
    for (std::size_t k = 0; k < parts.size(); ++k)
      result.push_back(at(fmt::format("{}[{}]", key, k)).resolved(parts[k]));
    return result;
  }
};

}  // namespace

Selector::Selector(const Mesh& mesh, const SolverMesh& solverMesh, SurfaceLocator locator)
    : mesh_(mesh),
      componentOf_(componentOfVertices(solverMesh)),
      componentCount_(solverMesh.componentCount),
      curves_(mesh, solverMesh, std::move(locator))
{
}

std::vector<Index> Selector::select(const Selection& selection, const InputLocation& where)
{
  const Selection resolved = Resolver{mesh_, componentCount_, curves_, where}.resolved(selection);
  std::vector<Index> vertices = holdfast::select(resolved, mesh_.positions, componentOf_);
  if (vertices.empty())
    throw InputError(where, "selects no vertex of the mesh; check its place and size, or remove the constraint");
  return vertices;
}

std::vector<Index> CurveSelector::select(const InsideCurve& curve, const InputLocation& where)
{
  const std::vector<Index> places = placesOf(curve, where);
  if (!graph_) graph_.emplace(solverMesh_);
  const CurveRegion region = regionOfCurve(*graph_, closedCurve(*graph_, places));
  if (region.inside.empty())
    throw InputError(where,
                     "the curve does not divide the surface in two, so nothing is inside: it runs around a handle or "
                     "along the border, or so tightly that no vertex is left within; lead it around a region that it "
                     "cuts off, or select the vertices in another way");
  return verticesOf({region.curve, curve.side == CurveSide::Smaller ? region.inside : region.outside});
}

/// The vertex of the file at which the curve takes a place.
Index CurveSelector::nearestVertex(const SurfaceLocation& location, const InputLocation& where)
{
  const SurfacePoint point = locator_.locate(location, where).point;
  const Vector3 place = positionOf(point, mesh_.positions);
  Index nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const Term& term : point.terms) {
    const double distance = (mesh_.positions.row(term.index).transpose() - place).stableNorm();
    if (distance >= least) continue;
    nearest = term.index;
    least = distance;
  }
  return nearest;
}

/// The unknowns that the curve is led through, all apart from one another and in one part.
std::vector<Index> CurveSelector::placesOf(const InsideCurve& curve, const InputLocation& where)
{
  std::vector<Index> places;
  std::map<Index, std::size_t> placeAt;
  for (std::size_t k = 0; k < curve.through.size(); ++k) {
    const InputLocation here = below(where, keyOfPlace(k));
    const Index vertex = nearestVertex(curve.through[k], here);
    const Index unknown = solverMesh_.weld.unknownOf[vertex];
    if (solverMesh_.componentOf[unknown] < 0)
      throw InputError(here, fmt::format("no face uses vertex {}; name a place of the surface", vertex));
    if (const auto [other, isNew] = placeAt.emplace(unknown, k); !isNew)
      throw InputError(here, fmt::format("goes to vertex {}, as through[{}] does; leave one of them out, or move them "
                                         "apart",
                                         vertex, other->second));
    places.push_back(unknown);
    if (solverMesh_.componentOf[unknown] != solverMesh_.componentOf[places.front()])
      throw InputError(here,
                       fmt::format("lies on part {} of the mesh, through[0] on part {}, and no edges join the two; "
                                   "keep a curve to one connected part",
                                   solverMesh_.componentOf[unknown], solverMesh_.componentOf[places.front()]));
  }
  return places;
}

/// All vertices of the file that are one of these unknowns.
std::vector<Index> CurveSelector::verticesOf(const std::vector<std::vector<Index>>& unknowns) const
{
  std::vector<bool> isSelected(static_cast<std::size_t>(solverMesh_.unknownCount()), false);
  for (const std::vector<Index>& list : unknowns)
    for (const Index unknown : list) isSelected[unknown] = true;
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh_.vertexCount(); ++v)
    if (isSelected[solverMesh_.weld.unknownOf[v]]) vertices.push_back(v);
  return vertices;
}

}  // namespace holdfast

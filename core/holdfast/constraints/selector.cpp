#include "holdfast/constraints/selector.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>

#include <holdfast/mesh/labels.h>

namespace holdfast {
namespace {

/// One byte a vertex: 1 where it is selected.
using Mask = std::vector<unsigned char>;

std::vector<Index> idsOf(const Mask& selected)
{
  std::vector<Index> ids;
  for (std::size_t v = 0; v < selected.size(); ++v)
    if (selected[v] != 0) ids.push_back(static_cast<Index>(v));
  return ids;
}

/// The normal of about unit length, scaled by a power of two: exact, so that points on the plane stay on it, and the
/// products with it neither overflow nor vanish.
Vector3 moderate(const Vector3& normal)
{
  const int exponent = std::ilogb(normal.cwiseAbs().maxCoeff());
  return normal.unaryExpr([&](double x) { return std::scalbn(x, -exponent); });
}

/// What edges select, on meshes that have some.
struct EdgeSelections {
  std::function<std::vector<Index>(const InsideCurve&, const InputLocation&)> within;
  std::function<std::vector<Index>(const std::vector<Index>&, Index rings)> around;
};

/// Walks an expression: checks its ids, and makes a mask of each kind of selection.
class MaskMaker {
 public:
  MaskMaker(const Positions& positions, const std::vector<int>& componentOf, Index componentCount,
            const std::vector<Index>& withoutPlace, EdgeSelections byEdges)
      : positions_(positions),
        componentOf_(componentOf),
        componentCount_(componentCount),
        withoutPlace_(withoutPlace),
        byEdges_(std::move(byEdges))
  {
  }

  /// Vertices without a place are in none.
  [[nodiscard]] Mask mask(const Selection& selection, const InputLocation& where) const
  {
    Mask selected = std::visit([&](const auto& what) { return maskOf(what, where); }, selection.what);
    for (const Index v : withoutPlace_) selected[v] = 0;
    return selected;
  }

 private:
  [[nodiscard]] Mask maskOf(const VertexIds& vertices, const InputLocation& where) const
  {
    Mask selected(positions_.rows(), 0);
    for (const Index id : vertices.ids) {
      requireVertex(positions_.rows(), id, where, ".vertices");
      requirePlace(withoutPlace_, id, where, ".vertices");
      selected[id] = 1;
    }
    return selected;
  }

  [[nodiscard]] Mask maskOf(const InBox& box, const InputLocation& /*where*/) const
  {
    return inside(
        [&](const Vector3& p) { return (p.array() >= box.min.array()).all() && (p.array() <= box.max.array()).all(); });
  }

  [[nodiscard]] Mask maskOf(const InSphere& sphere, const InputLocation& /*where*/) const
  {
    // Not by squares, which round twice as far: a point that is meant to lie on the sphere is inside.
    return inside([&](const Vector3& p) { return (p - sphere.center).norm() <= sphere.radius; });
  }

  [[nodiscard]] Mask maskOf(const InHalfSpace& half, const InputLocation& /*where*/) const
  {
    const Vector3 normal = moderate(half.normal);
    return inside([&](const Vector3& p) { return (p - half.point).dot(normal) >= 0; });
  }

  [[nodiscard]] Mask maskOf(const InComponent& part, const InputLocation& where) const
  {
    if (part.component < 0 || part.component >= componentCount_)
      throw InputError(below(where, ".component"),
                       fmt::format("there is no part {}; the mesh has {} connected parts, numbered from 0",
                                   part.component, componentCount_));
    assert(static_cast<Index>(componentOf_.size()) == positions_.rows());
    Mask selected(componentOf_.size());
    std::transform(componentOf_.begin(), componentOf_.end(), selected.begin(),
                   [&](Index component) { return component == part.component; });
    return selected;
  }

  [[nodiscard]] Mask maskOf(const InsideCurve& curve, const InputLocation& where) const
  {
    assert(byEdges_.within);
    return maskOf(VertexIds{byEdges_.within(curve, below(where, ".curve"))}, where);
  }

  [[nodiscard]] Mask maskOf(const Grown& grown, const InputLocation& where) const
  {
    assert(byEdges_.around && grown.part != nullptr);
    const std::vector<Index> part = idsOf(mask(*grown.part, below(where, ".grown.select")));
    return maskOf(VertexIds{byEdges_.around(part, grown.rings)}, where);
  }

  [[nodiscard]] Mask maskOf(const AllOf& all, const InputLocation& where) const
  {
    return combined(all.parts, below(where, ".all"), 1, std::bit_and<>());
  }

  [[nodiscard]] Mask maskOf(const AnyOf& any, const InputLocation& where) const
  {
    return combined(any.parts, below(where, ".any"), 0, std::bit_or<>());
  }

  [[nodiscard]] Mask maskOf(const NotIn& none, const InputLocation& where) const
  {
    assert(none.part != nullptr);
    Mask selected = mask(*none.part, below(where, ".not"));
    for (unsigned char& isSelected : selected) isSelected ^= 1;
    return selected;
  }

  template <class Predicate>
  [[nodiscard]] Mask inside(Predicate isInside) const
  {
    Mask selected(positions_.rows());
    for (Index v = 0; v < positions_.rows(); ++v) selected[v] = isInside(Vector3(positions_.row(v)));
    return selected;
  }

  template <class Operation>
  [[nodiscard]] Mask combined(const std::vector<Selection>& parts, const InputLocation& where, unsigned char ofNothing,
                              Operation operation) const
  {
    Mask selected(positions_.rows(), ofNothing);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Mask other = mask(parts[k], below(where, fmt::format("[{}]", k)));
      std::transform(selected.begin(), selected.end(), other.begin(), selected.begin(), operation);
    }
    return selected;
  }

  const Positions& positions_;
  const std::vector<int>& componentOf_;
  Index componentCount_;
  const std::vector<Index>& withoutPlace_;
  EdgeSelections byEdges_;
};

}  // namespace

bool operator==(const AllOf& x, const AllOf& y)
{
  return x.parts == y.parts;
}

bool operator==(const AnyOf& x, const AnyOf& y)
{
  return x.parts == y.parts;
}

bool operator==(const NotIn& x, const NotIn& y)
{
  return x.part == y.part || *x.part == *y.part;
}

bool operator==(const Grown& x, const Grown& y)
{
  return x.rings == y.rings && (x.part == y.part || *x.part == *y.part);
}

bool operator==(const Selection& x, const Selection& y)
{
  return x.what == y.what;
}

std::vector<Index> select(const Selection& selection, const Positions& positions, const std::vector<int>& componentOf)
{
  return idsOf(MaskMaker(positions, componentOf, std::numeric_limits<Index>::max(), {}, {}).mask(selection, {}));
}

std::vector<Index> Selector::select(const Selection& selection, const InputLocation& where)
{
  if (componentOf_.empty()) componentOf_ = componentOfVertices(solverMesh_);
  const MaskMaker maker(mesh_.positions, componentOf_, solverMesh_.componentCount, solverMesh_.withoutPlace,
                        {[this](const InsideCurve& curve, const InputLocation& place) { return within(curve, place); },
                         [this](const std::vector<Index>& vertices, Index rings) { return around(vertices, rings); }});
  std::vector<Index> vertices = idsOf(maker.mask(selection, where));
  if (vertices.empty())
    throw InputError(where, "it selects no vertex of the mesh; check its place and size, or remove the constraint");
  return vertices;
}

std::vector<Index> Selector::within(const InsideCurve& curve, const InputLocation& where)
{
  const std::vector<Index> places = placesOf(curve, where);
  const CurveRegion region = regionOfCurve(graph(), closedCurve(graph(), places));
  if (region.inside.empty())
    throw InputError(
        where,
        "the curve does not divide the surface in two, so nothing is inside: it runs around a hole as of "
        "a torus, along the border, or so tightly that no vertex is left within; lead it around a region that it "
        "cuts off, or select the vertices in another way");
  std::vector<bool> isSelected(static_cast<std::size_t>(solverMesh_.unknownCount()), false);
  for (const std::vector<Index>& part :
       {region.curve, curve.side == CurveSide::Smaller ? region.inside : region.outside})
    for (const Index unknown : part) isSelected[unknown] = true;
  return verticesWhere(isSelected);
}

std::vector<Index> Selector::around(const std::vector<Index>& vertices, Index rings)
{
  std::vector<bool> isSelected(static_cast<std::size_t>(solverMesh_.unknownCount()), false);
  std::vector<Index> border;
  const auto add = [&](Index unknown) {
    if (!isSelected[unknown]) border.push_back(unknown);
    isSelected[unknown] = true;
  };
  for (const Index v : vertices) add(solverMesh_.weld.unknownOf[v]);
  for (Index ring = 0; ring < rings && !border.empty(); ++ring)
    for (const Index unknown : std::exchange(border, {}))
      for (const Index neighbour : graph().neighbours(unknown)) add(neighbour);
  return verticesWhere(isSelected);
}

const EdgeGraph& Selector::graph()
{
  if (!graph_) graph_.emplace(solverMesh_);
  return *graph_;
}

std::vector<Index> Selector::verticesWhere(const std::vector<bool>& isSelected) const
{
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh_.vertexCount(); ++v)
    if (isSelected[solverMesh_.weld.unknownOf[v]]) vertices.push_back(v);
  return vertices;
}

/// The vertex of the file at which a curve takes a place: the nearest, at rest, of those that the place hangs on.
Index Selector::nearestVertex(const SurfaceLocation& location, const InputLocation& where)
{
  const SurfacePoint point = locator_.locate(location, where);
  const Vector3 place = positionOf(point, mesh_.positions);
  const auto distance = [&](const Term& term) {
    return (mesh_.positions.row(term.index).transpose() - place).stableNorm();
  };
  return std::ranges::min_element(point.terms, {}, distance)->index;
}

std::vector<Index> Selector::placesOf(const InsideCurve& curve, const InputLocation& where)
{
  std::vector<Index> places;
  std::map<Index, std::size_t> placeAt;
  for (std::size_t k = 0; k < curve.through.size(); ++k) {
    const InputLocation here = below(where, fmt::format(".through[{}]", k));
    const Index vertex = nearestVertex(curve.through[k], here);
    const Index unknown = solverMesh_.weld.unknownOf[vertex];
    if (solverMesh_.componentOf[unknown] < 0)
      throw InputError(here, fmt::format("no face uses {}; name a place of the surface", vertexText(mesh_, vertex)));
    if (const auto [other, isNew] = placeAt.emplace(unknown, k); !isNew)
      throw InputError(here,
                       fmt::format("it goes to {}, as through[{}] does; leave one of them out, or move them apart",
                                   vertexText(mesh_, vertex), other->second));
    places.push_back(unknown);
    if (solverMesh_.componentOf[unknown] != solverMesh_.componentOf[places.front()])
      throw InputError(here, fmt::format("it lies on part {} of the mesh, through[0] on part {}, and no edges join the "
                                         "two; keep a curve to one connected part",
                                         solverMesh_.componentOf[unknown], solverMesh_.componentOf[places.front()]));
  }
  return places;
}

}  // namespace holdfast

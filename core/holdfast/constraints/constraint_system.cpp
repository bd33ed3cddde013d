#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/constraints/constraint_system.h>
#include <holdfast/mesh/edges.h>
#include <holdfast/surface/closest_point.h>

namespace holdfast {
namespace {

/// A rigid motion p -> R (p - center) + center + translate.
struct RigidMotion {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Vector3 center = Vector3::Zero();
  Vector3 translate = Vector3::Zero();

  [[nodiscard]] Vector3 operator()(const Vector3& p) const { return R * (p - center) + center + translate; }
};

/// Rotations by quarter turns come out exact, as a user expects who types 90.
double exactCosine(double degrees)
{
  const double quarter = std::fmod(std::abs(degrees), 360.0);
  if (quarter == 90 || quarter == 270) return 0;
  return std::cos(degrees * std::numbers::pi / 180);
}

Eigen::Matrix3d rotationMatrix(const Turn& turn)
{
  const Vector3 axis = turn.axis.stableNormalized();
  const double c = exactCosine(turn.degrees);
  const double s = exactCosine(turn.degrees - 90);
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return c * Eigen::Matrix3d::Identity() + s * cross + (1 - c) * axis * axis.transpose();
}

/// Makes the rows of one list; remembers what several constraints share.
class SystemBuilder {
 public:
  SystemBuilder(const ConstraintList& list, const Mesh& mesh, const Triangulation& triangulation,
                const SolverMesh& solverMesh, const std::string& source)
      : list_(list),
        mesh_(mesh),
        triangulation_(triangulation),
        solverMesh_(solverMesh),
        source_(source),
        componentOf_(componentOfVertices(solverMesh))
  {
    system_.points.resize(list.constraints.size());
    system_.surfaceDistances.resize(list.constraints.size(), 0);
  }

  ConstraintSystem build()
  {
    for (current_ = 0; current_ < static_cast<Index>(list_.constraints.size()); ++current_)
      std::visit([this](const auto& what) { add(what); }, list_.constraints[current_].what);
    return std::move(system_);
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& reason) const
  {
    throw InputError(
        {source_, 0, fmt::format("constraints[{}]{} (\"{}\")", current_, key, list_.constraints[current_].name)},
        reason);
  }

  [[nodiscard]] bool isEnabled() const { return list_.constraints[current_].isEnabled; }

  void add(const Fixed& fixed)
  {
    for (const Index v : selected(fixed.select)) addPin(v, mesh_.positions.row(v));
  }

  void add(const Handle& handle)
  {
    const std::vector<Index> vertices = selected(handle.select);
    RigidMotion motion;
    motion.translate = handle.translate;
    if (handle.rotate) {
      motion.R = rotationMatrix(*handle.rotate);
      motion.center = handle.rotate->center.value_or(centroid(vertices));
    }
    for (const Index v : vertices)
      addPin(v, handle.rotate ? motion(mesh_.positions.row(v))
                              : Vector3(mesh_.positions.row(v).transpose() + handle.translate));
  }

  void add(const Point& point)
  {
    const SurfacePoint at = std::visit([this](const auto& location) { return locate(location); }, point.at);
    system_.points[current_] = at;
    const Vector3 rest = positionOf(at, mesh_.positions);
    if (const Target* target = std::get_if<Target>(&point.to))
      addRow(at, target->place, target->place - rest);
    else
      addRow(at, rest + std::get<Move>(point.to).shift, std::get<Move>(point.to).shift);
  }

  void add(const Rigid& /*rigid*/) { fail(".type", "rigid regions are not supported by this version; remove it"); }

  void add(const Relative& /*relative*/)
  {
    fail(".type", "relative constraints are not supported by this version; remove it");
  }

  [[nodiscard]] Vector3 centroid(const std::vector<Index>& vertices) const
  {
    Vector3 sum = Vector3::Zero();
    for (const Index v : vertices) sum += mesh_.positions.row(v).transpose();
    return sum / static_cast<double>(vertices.size());
  }

  // A target of a vertex is taken as it is: it is what the written file must hold.
  void addPin(Index vertex, const Vector3& target)
  {
    addRow({{{vertex, 1.0}}}, target, target - mesh_.positions.row(vertex).transpose());
  }

  void addRow(const SurfacePoint& at, const Vector3& target, const Vector3& shift)
  {
    if (!isEnabled()) return;
    std::vector<PointTerm> terms = at.terms;
    for (PointTerm& term : terms) term.vertex = solverMesh_.weld.unknownOf[term.vertex];
    ConstraintRow row{canonical(std::move(terms)).terms, target, shift, current_};
    if (!isRepeatOfOwnPin(row)) system_.rows.push_back(std::move(row));
  }

  /// Vertices of one selection that are one unknown ask for the same thing once.
  [[nodiscard]] bool isRepeatOfOwnPin(const ConstraintRow& row)
  {
    if (!row.isPin()) return false;
    if (pinnedBy_.empty()) pinnedBy_.resize(static_cast<std::size_t>(solverMesh_.unknownCount()), -1);
    return std::exchange(pinnedBy_[row.terms.front().vertex], current_) == current_;
  }

  std::vector<Index> selected(const Selection& selection)
  {
    checkIds(selection, ".select");
    std::vector<Index> vertices = select(selection, mesh_.positions, componentOf_);
    if (vertices.empty())
      fail(".select", "selects no vertex of the mesh; check its place and size, or remove the constraint");
    return vertices;
  }

  void checkIds(const Selection& selection, const std::string& path) const
  {
    if (const auto* vertices = std::get_if<VertexIds>(&selection.what))
      for (const Index v : vertices->ids) checkVertex(v, path + ".vertices");
    if (const auto* component = std::get_if<InComponent>(&selection.what))
      if (component->component < 0 || component->component >= solverMesh_.componentCount)
        fail(path + ".component", fmt::format("there is no part {}; the mesh has {} connected parts, numbered from 0",
                                              component->component, solverMesh_.componentCount));
    if (const auto* all = std::get_if<AllOf>(&selection.what)) checkParts(all->parts, path + ".all");
    if (const auto* any = std::get_if<AnyOf>(&selection.what)) checkParts(any->parts, path + ".any");
    if (const auto* none = std::get_if<NotIn>(&selection.what)) checkIds(*none->part, path + ".not");
  }

  void checkParts(const std::vector<Selection>& parts, const std::string& path) const
  {
    for (std::size_t k = 0; k < parts.size(); ++k) checkIds(parts[k], fmt::format("{}[{}]", path, k));
  }

  void checkVertex(Index v, const std::string& path) const
  {
    if (v < 0 || v >= mesh_.vertexCount())
      fail(path,
           fmt::format("there is no vertex {}; the mesh has {} vertices, numbered from 0", v, mesh_.vertexCount()));
  }

  [[nodiscard]] SurfacePoint locate(const AtVertex& at) const
  {
    checkVertex(at.vertex, ".at.vertex");
    return {{{at.vertex, 1.0}}};
  }

  [[nodiscard]] SurfacePoint locate(const AtEdge& at)
  {
    checkVertex(at.i, ".at.edge[0]");
    checkVertex(at.j, ".at.edge[1]");
    if (!isEdge(at.i, at.j))
      fail(".at.edge", fmt::format("no face has an edge between the vertices {} and {}; name the ends of one edge, or "
                                   "give the place as \"near\"",
                                   at.i, at.j));
    return canonical({{at.i, at.t}, {at.j, 1 - at.t}});
  }

  [[nodiscard]] SurfacePoint locate(const AtFace& at) const
  {
    if (at.face < 0 || at.face >= mesh_.faces.size())
      fail(".at.face",
           fmt::format("there is no face {}; the mesh has {} faces, numbered from 0", at.face, mesh_.faces.size()));
    const auto corners = mesh_.faces[at.face];
    if (corners.size() != at.weights.size())
      fail(".at.weights", fmt::format("face {} has {} corners but {} weights are given; give one for each corner in "
                                      "the order of the file",
                                      at.face, corners.size(), at.weights.size()));
    std::vector<PointTerm> terms;
    for (std::size_t k = 0; k < corners.size(); ++k) terms.push_back({corners[k], at.weights[k]});
    return canonical(std::move(terms));
  }

  [[nodiscard]] SurfacePoint locate(const AtNear& at)
  {
    if (!search_) search_.emplace(mesh_.positions, triangulation_.triangles);
    const ClosestPointSearch::Result found = search_->find(at.place);
    system_.surfaceDistances[current_] = found.distance;
    return found.point;
  }

  [[nodiscard]] bool isEdge(Index i, Index j)
  {
    if (halfEdges_.empty()) halfEdges_ = sortedHalfEdges(triangulation_.triangles);
    const std::pair<Index, Index> key = std::minmax(i, j);
    const auto found = std::lower_bound(
        halfEdges_.begin(), halfEdges_.end(), key,
        [](const HalfEdge& edge, const std::pair<Index, Index>& wanted) { return std::pair(edge.a, edge.b) < wanted; });
    return found != halfEdges_.end() && std::pair(found->a, found->b) == key;
  }

  const ConstraintList& list_;
  const Mesh& mesh_;
  const Triangulation& triangulation_;
  const SolverMesh& solverMesh_;
  const std::string& source_;
  std::vector<Index> componentOf_;
  std::optional<ClosestPointSearch> search_;
  std::vector<HalfEdge> halfEdges_;
  std::vector<Index> pinnedBy_;  // of each unknown: the constraint that pinned it last
  Index current_ = 0;
  ConstraintSystem system_;
};

}  // namespace

ConstraintSystem makeConstraintSystem(const ConstraintList& list, const Mesh& mesh, const Triangulation& triangulation,
                                      const SolverMesh& solverMesh, const std::string& source)
{
  return SystemBuilder(list, mesh, triangulation, solverMesh, source).build();
}

}  // namespace holdfast

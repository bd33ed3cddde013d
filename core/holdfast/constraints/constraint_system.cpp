#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/constraints/constraint_system.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/rotation/rotation_log.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

/// A rigid motion p -> R (p - center) + center + translate.
struct RigidMotion {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Vector3 center = Vector3::Zero();
  Vector3 translate = Vector3::Zero();

  [[nodiscard]] Vector3 operator()(const Vector3& p) const { return R * (p - center) + center + translate; }
};

/// Makes the rows of one list; remembers what several constraints share.
class SystemBuilder {
 public:
  SystemBuilder(const ConstraintList& list, const Mesh& mesh, const Triangulation& triangulation,
                const SolverMesh& solverMesh, const std::string& source)
      : list_(list),
        mesh_(mesh),
        solverMesh_(solverMesh),
        source_(source),
        locator_(mesh, triangulation),
        selector_(mesh, solverMesh, locator_)
  {
    system_.points.resize(list.constraints.size());
    system_.surfaceDistances.resize(list.constraints.size(), 0);
  }

  ConstraintSystem build()
  {
    for (current_ = 0; current_ < static_cast<Index>(list_.constraints.size()); ++current_) addCurrent();
    return std::move(system_);
  }

 private:
  void addCurrent()
  {
    const Constraint& constraint = list_.constraints[current_];
    try {
      std::visit([this](const auto& what) { add(what); }, constraint.what);
    } catch (const InputError& error) {
      throw InputError(error.location(), fmt::format("\"{}\": {}", constraint.name, error.reason()));
    }
  }

  [[nodiscard]] InputLocation key(const std::string& name) const
  {
    return {source_, 0, fmt::format("constraints[{}]{}", current_, name)};
  }

  [[nodiscard]] bool isEnabled() const { return list_.constraints[current_].isEnabled; }

  void add(const Fixed& fixed)
  {
    const std::vector<Index> vertices = selected(fixed.select);
    for (const Index v : vertices) addPin(v, mesh_.positions.row(v));
    giveRotation(vertices, Vector3::Zero());
  }

  void add(const Handle& handle)
  {
    const std::vector<Index> vertices = selected(handle.select);
    RigidMotion motion;
    motion.translate = handle.translate;
    if (handle.rotate) {
      motion.R = rotationMatrix(handle.rotate->axis, handle.rotate->degrees);
      motion.center = handle.rotate->center.value_or(centroid(vertices));
    }
    for (const Index v : vertices)
      addPin(v, handle.rotate ? motion(mesh_.positions.row(v))
                              : Vector3(mesh_.positions.row(v).transpose() + handle.translate));
    giveRotation(vertices,
                 handle.rotate ? rotationLog(handle.rotate->axis, handle.rotate->degrees) : Vector3(Vector3::Zero()));
  }

  void add(const Point& point)
  {
    const SurfacePoint at = located(point.at, ".at");
    system_.points[current_] = at;
    const Vector3 rest = positionOf(at, mesh_.positions);
    if (const Target* target = std::get_if<Target>(&point.to))
      addRow(at, target->place, target->place - rest);
    else
      addRow(at, rest + std::get<Move>(point.to).shift, std::get<Move>(point.to).shift);
  }

  void add(const Rigid& rigid)
  {
    const std::vector<Index> body = unknownsOf(selected(rigid.select));
    if (!isEnabled()) return;
    const Index reference = body.front();
    for (const Index u : body)
      if (u != reference) addCarried(RowKind::Body, {{{u, 1.0}}}, {{{reference, 1.0}}}, {{reference, 1.0}});
    system_.bodies.push_back(body);
  }

  void add(const Relative& relative)
  {
    const SurfacePoint from = overUnknowns(located(relative.from, ".from"));
    const SurfacePoint to = overUnknowns(located(relative.to, ".to"));
    if (!isEnabled()) return;
    if (!relative.offset) return addCarried(RowKind::Relative, from, to, midpoint(from, to).terms);
    const Vector3 rest = restVector(from, to);
    system_.rows.push_back(
        {difference(from, to), *relative.offset, *relative.offset - rest, current_, RowKind::Relative});
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
    ConstraintRow row{overUnknowns(at).terms, target, shift, current_};
    if (!isRepeatOfOwnPin(row)) system_.rows.push_back(std::move(row));
  }

  /// The row from - to whose d is what it is at rest, turned by the rotation of `rotation`.
  void addCarried(RowKind kind, const SurfacePoint& from, const SurfacePoint& to, std::vector<PointTerm> rotation)
  {
    const Vector3 rest = restVector(from, to);
    system_.carried.push_back({static_cast<Index>(system_.rows.size()), rest, std::move(rotation)});
    system_.rows.push_back({difference(from, to), rest, Vector3::Zero(), current_, kind});
  }

  void giveRotation(const std::vector<Index>& vertices, const Vector3& q)
  {
    if (!isEnabled()) return;
    isTurned_.resize(static_cast<std::size_t>(solverMesh_.unknownCount()), false);
    for (const Index u : unknownsOf(vertices)) {
      if (!isTurned_[u]) system_.rotations.push_back({u, q, current_});
      isTurned_[u] = true;
    }
  }

  [[nodiscard]] SurfacePoint located(const SurfaceLocation& location, const char* where)
  {
    auto [point, distance] = locator_.locate(location, key(where));
    system_.surfaceDistances[current_] = std::max(system_.surfaceDistances[current_], distance);
    return std::move(point);
  }

  [[nodiscard]] SurfacePoint overUnknowns(SurfacePoint point) const
  {
    for (PointTerm& term : point.terms) term.vertex = solverMesh_.weld.unknownOf[term.vertex];
    return canonical(std::move(point.terms));
  }

  /// Ascending, each once.
  [[nodiscard]] std::vector<Index> unknownsOf(std::vector<Index> vertices) const
  {
    for (Index& v : vertices) v = solverMesh_.weld.unknownOf[v];
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  /// Between two points of unknowns.
  [[nodiscard]] Vector3 restVector(const SurfacePoint& from, const SurfacePoint& to) const
  {
    return positionOf(from, solverMesh_.rest) - positionOf(to, solverMesh_.rest);
  }

  /// Vertices of one selection that are one unknown ask for the same thing once.
  [[nodiscard]] bool isRepeatOfOwnPin(const ConstraintRow& row)
  {
    if (!row.isPin()) return false;
    if (pinnedBy_.empty()) pinnedBy_.resize(static_cast<std::size_t>(solverMesh_.unknownCount()), -1);
    return std::exchange(pinnedBy_[row.terms.front().vertex], current_) == current_;
  }

  [[nodiscard]] std::vector<Index> selected(const Selection& selection)
  {
    return selector_.select(selection, key(".select"));
  }

  const ConstraintList& list_;
  const Mesh& mesh_;
  const SolverMesh& solverMesh_;
  const std::string& source_;
  SurfaceLocator locator_;
  Selector selector_;
  std::vector<Index> pinnedBy_;  // of each unknown: the constraint that pinned it last
  std::vector<bool> isTurned_;   // of each unknown: its rotation is given
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

#include "holdfast/document/mirrored.h"

#include <algorithm>
#include <set>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

// Of the diagonal: a mirrored place farther from the surface has no counterpart there.
constexpr double kReach = 0.01;

class Mirror {
 public:
  Mirror(const MirrorPlane& plane, const Model& model)
      : plane_(plane), model_(model), selector_(model.mesh, model.solverMesh, model.locator())
  {
  }

  void mirror(FixedConstraint& fixed) { mirror(fixed.select); }
  void mirror(RigidConstraint& rigid) { mirror(rigid.select); }

  void mirror(PointConstraint& point)
  {
    const Vector3 rest = restOf(point.at);
    point.at = AtNear{reflected(rest)};
    if (const auto* coordinates = std::get_if<Coordinates>(&point.to)) point.to = reflected(*coordinates, rest);
    std::visit([&](auto& to) { reflect(to); }, point.to);
    auto* slab = std::get_if<WithinSlab>(&point.within);
    if (slab != nullptr && slab->normal) reflectVector(*slab->normal);
    if (std::holds_alternative<WithinBox>(point.within) && !isAlongAxis())
      throw InputError({}, "its box is along coordinate axes, which this plane mirrors into others; give it a ball");
  }

  void mirror(RelativeConstraint& relative)
  {
    mirrorEnds(relative);
    if (relative.offset) reflectVector(*relative.offset);
  }

  void mirror(CoincidentConstraint& coincident) { mirrorEnds(coincident); }

  void mirror(SlideConstraint& slide)
  {
    mirror(slide.select);
    std::visit([&](auto& on) { reflect(on); }, slide.on);
  }

  void mirror(MirrorConstraint& own)
  {
    mirror(own.select);
    reflectPlace(own.point);
    reflectVector(own.normal);
    for (auto& pair : own.pairs)
      for (Index& vertex : pair) vertex = requiredCounterpart(vertex);
  }

  void mirror(HandleConstraint& handle)
  {
    if (std::holds_alternative<VertexTargets>(handle.motion) || !handle.rotations.empty())
      mirrorEach(std::get<VertexIds>(handle.select.what));
    else
      mirror(handle.select);
    if (!isUniform(handle.scale) && !std::holds_alternative<FrameMotion>(handle.motion) && !isAlongAxis())
      throw InputError(
          {}, "its factors are along coordinate axes, which this plane mirrors into others; scale it in a frame");
    reflectVector(handle.translate);
    for (AxisAngle& turn : handle.rotations) reflectTurn(turn);
    std::visit([&](auto& motion) { reflect(motion); }, handle.motion);
  }

 private:
  void mirrorEnds(auto& what) const
  {
    for (SurfaceLocation* at : {&what.from, &what.to}) *at = AtNear{reflected(restOf(*at))};
  }

  [[nodiscard]] bool isAlongAxis() const { return plane_.normal.cwiseAbs().maxCoeff() == 1; }

  [[nodiscard]] Vector3 reflected(const Vector3& place) const
  {
    return place - 2 * plane_.normal.dot(place - plane_.point) * plane_.normal;
  }
  /// Coordinates as the plane or the line that they hold, which `reflect` goes on with. Those that the mirror keeps
  /// apart stay coordinates.
  [[nodiscard]] decltype(PointConstraint::to) reflected(Coordinates coordinates, const Vector3& rest) const
  {
    const Vector3 place = coordinates.placeFrom(rest);
    if (!isAlongAxis()) {
      const RowDirections held = coordinates.directions();
      if (held.areAlongAxis()) return OnPlane{place, held.axis(), 0};
      return OnLine{place, held.axis()};
    }
    const Vector3 opposite = reflected(place);
    for (std::size_t k = 0; k < 3; ++k)
      if (coordinates.values[k]) coordinates.values[k] = opposite[static_cast<Index>(k)];
    return coordinates;
  }
  void reflectPlace(Vector3& place) const { place = reflected(place); }
  void reflect(Target& target) const { reflectPlace(target.place); }
  void reflect(Move& move) const { reflectVector(move.shift); }
  void reflect(Coordinates& /*reflected*/) const {}
  void reflect(FittedPlane& /*plane*/) const {}
  void reflect(FittedLine& /*line*/) const {}
  void reflect(OnPlane& plane) const
  {
    if (plane.point) reflectPlace(*plane.point);
    reflectVector(plane.normal);
  }
  void reflect(OnMesh& /*surface*/) const
  {
    throw InputError({}, "the mirror image of another mesh is not at hand; mirror its file, and name that");
  }
  void reflect(OnLine& line) const
  {
    if (line.point) reflectPlace(*line.point);
    reflectVector(line.direction);
  }

  void reflect(std::monostate& /*none*/) const {}
  void reflect(AxisRotation& turn) const
  {
    reflectTurn(turn);
    if (turn.center) reflectPlace(*turn.center);
  }
  void reflect(RotationAboutFixed& turn) const
  {
    if (turn.near) reflectTurn(*turn.near);
  }
  void reflect(FrameMotion& motion) const
  {
    for (Frame* frame : {&motion.from, &motion.to}) {
      if (frame->origin) reflectPlace(*frame->origin);
      reflectVector(frame->x);
      reflectVector(frame->y);
    }
  }
  void reflect(VertexTargets& targets) const
  {
    for (Vector3& place : targets.places) reflectPlace(place);
  }

  void reflectVector(Vector3& vector) const { vector -= 2 * plane_.normal.dot(vector) * plane_.normal; }
  /// What turns one way turns the other way in a mirror.
  void reflectTurn(auto& turn) const
  {
    reflectVector(turn.axis);
    turn.degrees = -turn.degrees;
  }

  [[nodiscard]] Vector3 restOf(const SurfaceLocation& at) const
  {
    return positionOf(model_.locator().locate(at, {}), model_.mesh.positions);
  }

  /// The vertex nearest to the mirrored place of a vertex; -1 if the surface is not there.
  [[nodiscard]] Index counterpart(Index vertex) const
  {
    const auto found = model_.locator().closestTo(reflected(model_.mesh.positions.row(vertex)));
    if (found.distance > kReach * model_.solverMesh.diagonal) return -1;
    return std::ranges::max(found.point.terms, {}, &Term::coefficient).index;
  }

  void mirror(Selection& selection)
  {
    if (auto* sphere = std::get_if<InSphere>(&selection.what)) return reflectPlace(sphere->center);
    if (auto* half = std::get_if<InHalfSpace>(&selection.what)) {
      reflectPlace(half->point);
      return reflectVector(half->normal);
    }
    if (auto* curve = std::get_if<InsideCurve>(&selection.what)) {
      for (SurfaceLocation& at : curve->through) at = AtNear{reflected(restOf(at))};
      return;
    }
    if (auto* all = std::get_if<AllOf>(&selection.what)) return mirror(all->parts);
    if (auto* any = std::get_if<AnyOf>(&selection.what)) return mirror(any->parts);
    if (auto* no = std::get_if<NotIn>(&selection.what)) return mirror(no->part);
    if (auto* grown = std::get_if<Grown>(&selection.what)) return mirror(grown->part);
    auto* box = std::get_if<InBox>(&selection.what);
    if (box != nullptr && isAlongAxis()) {
      const Vector3 a = reflected(box->min);
      const Vector3 b = reflected(box->max);
      *box = {a.cwiseMin(b), a.cwiseMax(b)};
      return;
    }
    const std::vector<Index> selected = selector_.select(selection, {});
    const double reach = kReach * model_.solverMesh.diagonal;
    Eigen::AlignedBox3d around;
    for (const Index v : selected) around.extend(Vector3(model_.mesh.positions.row(v)));
    VertexIds mirrored;
    for (Index v = 0; v < model_.mesh.vertexCount(); ++v)
      if (around.squaredExteriorDistance(reflected(model_.mesh.positions.row(v))) <= reach * reach &&
          std::ranges::binary_search(selected, counterpart(v)))
        mirrored.ids.push_back(v);
    if (mirrored.ids.empty()) throw InputError({}, "the mesh has no vertices beyond the plane where the copy would be");
    selection.what = std::move(mirrored);
  }

  void mirror(std::shared_ptr<const Selection>& part)
  {
    Selection copy = *part;
    mirror(copy);
    part = std::make_shared<const Selection>(std::move(copy));
  }

  void mirror(std::vector<Selection>& parts)
  {
    for (Selection& part : parts) mirror(part);
  }

  /// In the order of the list, which others follow.
  void mirrorEach(VertexIds& vertices) const
  {
    std::set<Index> taken;
    for (Index& vertex : vertices.ids) {
      vertex = requiredCounterpart(vertex);
      if (!taken.insert(vertex).second)
        throw InputError({},
                         "two of its single vertices have one counterpart beyond the plane; take one motion for all");
    }
  }

  [[nodiscard]] Index requiredCounterpart(Index vertex) const
  {
    const Index found = counterpart(vertex);
    if (found < 0) throw InputError({}, fmt::format("vertex {} has no counterpart beyond the plane", vertex));
    return found;
  }

  const MirrorPlane& plane_;
  const Model& model_;
  Selector selector_;
};

}  // namespace

ConstraintList mirrored(const ConstraintList& list, const std::vector<Index>& indices, const MirrorPlane& plane,
                        const Model& model)
{
  Mirror mirror(plane, model);
  ConstraintList copies = extracted(list, indices);
  for (Constraint& copy : copies.constraints) {
    try {
      std::visit([&](auto& what) { mirror.mirror(what); }, copy.what);
    } catch (const InputError& error) {
      throw InputError({}, inQuotes(copy.name) + " cannot be mirrored: " + error.reason());
    }
    copy.name += " mirrored";
  }
  return copies;
}

}  // namespace holdfast

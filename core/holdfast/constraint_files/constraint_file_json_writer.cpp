#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_json_internal.h>
#include <holdfast/constraint_files/json_text_internal.h>

namespace holdfast {
namespace {

struct LocationJson {
  std::string operator()(const AtVertex& at) const { return fmt::format(R"({{"vertex": {}}})", numberJson(at.vertex)); }
  std::string operator()(const AtEdge& at) const
  {
    return fmt::format(R"({{"edge": [{}, {}], "t": {}}})", numberJson(at.i), numberJson(at.j), numberJson(at.t));
  }
  std::string operator()(const AtFace& at) const
  {
    return fmt::format(R"({{"face": {}, "weights": {}}})", numberJson(at.face),
                       listJson(at.weights, [](double weight) { return numberJson(weight); }));
  }
  std::string operator()(const AtNear& at) const { return fmt::format(R"({{"near": {}}})", vectorJson(at.place)); }

  static std::string json(const SurfaceLocation& location) { return std::visit(LocationJson{}, location); }
};

struct SelectionJson {
  std::string operator()(const VertexIds& vertices) const
  {
    return fmt::format(R"({{"vertices": {}}})", listJson(vertices.ids, [](Index id) { return numberJson(id); }));
  }
  std::string operator()(const InBox& box) const
  {
    return fmt::format(R"({{"box": {{"min": {}, "max": {}}}}})", vectorJson(box.min), vectorJson(box.max));
  }
  std::string operator()(const InSphere& sphere) const
  {
    return fmt::format(R"({{"sphere": {{"center": {}, "radius": {}}}}})", vectorJson(sphere.center),
                       numberJson(sphere.radius));
  }
  std::string operator()(const InHalfSpace& half) const
  {
    return fmt::format(R"({{"halfspace": {{"point": {}, "normal": {}}}}})", vectorJson(half.point),
                       vectorJson(half.normal));
  }
  std::string operator()(const InComponent& part) const
  {
    return fmt::format(R"({{"component": {}}})", numberJson(part.component));
  }
  std::string operator()(const InsideCurve& curve) const
  {
    return fmt::format(R"({{"curve": {{"through": {}, "side": "{}"}}}})", listJson(curve.through, LocationJson::json),
                       curve.side == CurveSide::Smaller ? "smaller" : "larger");
  }
  std::string operator()(const AllOf& all) const { return fmt::format(R"({{"all": {}}})", partsJson(all.parts)); }
  std::string operator()(const AnyOf& any) const { return fmt::format(R"({{"any": {}}})", partsJson(any.parts)); }
  std::string operator()(const NotIn& none) const { return fmt::format(R"({{"not": {}}})", json(*none.part)); }

  static std::string json(const Selection& selection) { return std::visit(SelectionJson{}, selection.what); }
  static std::string partsJson(const std::vector<Selection>& parts) { return listJson(parts, json); }
};

std::string frameJson(const Frame& frame)
{
  const std::string origin = frame.origin ? fmt::format(R"("origin": {}, )", vectorJson(*frame.origin)) : "";
  return fmt::format(R"({{{}"x": {}, "y": {}}})", origin, vectorJson(frame.x), vectorJson(frame.y));
}

std::string axisAngleJson(const AxisAngle& turn)
{
  return fmt::format(R"({{"axis": {}, "degrees": {}}})", vectorJson(turn.axis), numberJson(turn.degrees));
}

/// What moves a handle besides `translate`, after a comma.
struct MotionJson {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(const AxisRotation& turn) const
  {
    const std::string center = turn.center ? fmt::format(R"(, "center": {})", vectorJson(*turn.center)) : "";
    return fmt::format(R"(, "rotate": {{"axis": {}, "degrees": {}{}}})", vectorJson(turn.axis),
                       numberJson(turn.degrees), center);
  }
  std::string operator()(const RotationAboutFixed& turn) const
  {
    return R"(, "turn": "about-fixed")" + (turn.near ? R"(, "turn_near": )" + axisAngleJson(*turn.near) : "");
  }
  std::string operator()(const FrameMotion& motion) const
  {
    const std::string turns = motion.turns == 0 ? "" : fmt::format(R"(, "turns": {})", numberJson(motion.turns));
    return fmt::format(R"(, "frame": {{"from": {}, "to": {}{}}})", frameJson(motion.from), frameJson(motion.to), turns);
  }
  std::string operator()(const VertexTargets& targets) const
  {
    return fmt::format(R"(, "targets": {})", listJson(targets.places, vectorJson));
  }
};

std::string rotationsJson(const std::vector<AxisAngle>& rotations)
{
  return rotations.empty() ? "" : fmt::format(R"(, "rotations": {})", listJson(rotations, axisAngleJson));
}

/// The keys that only this type of constraint has, each after a comma.
struct OwnKeysJson {
  std::string operator()(const FixedConstraint& fixed) const { return selectJson(fixed.select); }
  std::string operator()(const RigidConstraint& rigid) const { return selectJson(rigid.select); }
  std::string operator()(const HandleConstraint& handle) const
  {
    return fmt::format(R"({}{}, "translate": {}{})", selectJson(handle.select), std::visit(MotionJson{}, handle.motion),
                       vectorJson(handle.translate), rotationsJson(handle.rotations));
  }
  std::string operator()(const PointConstraint& point) const
  {
    return fmt::format(R"(, "at": {}{})", LocationJson::json(point.at), std::visit(*this, point.to));
  }
  std::string operator()(const Target& target) const
  {
    return fmt::format(R"(, "target": {})", vectorJson(target.place));
  }
  std::string operator()(const Move& move) const { return fmt::format(R"(, "move": {})", vectorJson(move.shift)); }
  std::string operator()(const RelativeConstraint& relative) const
  {
    const std::string offset = relative.offset ? fmt::format(R"(, "offset": {})", vectorJson(*relative.offset)) : "";
    return fmt::format(R"(, "from": {}, "to": {}{})", LocationJson::json(relative.from),
                       LocationJson::json(relative.to), offset);
  }

  static std::string selectJson(const Selection& selection)
  {
    return fmt::format(R"(, "select": {})", SelectionJson::json(selection));
  }
};

std::string constraintJson(const Constraint& constraint)
{
  return fmt::format(R"({{ "type": "{}", "name": {}{}{} }})", typeName(constraint), textJson(constraint.name),
                     constraint.isEnabled ? "" : R"(, "enabled": false)", std::visit(OwnKeysJson{}, constraint.what));
}

std::string constraintArrayJson(const std::vector<Constraint>& constraints)
{
  std::string json;
  for (const Constraint& constraint : constraints)
    json += (json.empty() ? "\n    " : ",\n    ") + constraintJson(constraint);
  return json.empty() ? "[]" : fmt::format("[{}\n  ]", json);
}

void requireReadableConstraints(const std::string& json)
{
  try {
    static_cast<void>(parseConstraintsJson(json, ""));
  } catch (const InputError& error) {
    throw OutputError("constraint file",
                      std::string("the constraints cannot be written so that they can be read; ") + error.what());
  }
}

}  // namespace

std::string constraintMembersJson(const ConstraintList& list)
{
  const std::string units = list.units.empty() ? "" : fmt::format("\n  \"units\": {},", textJson(list.units));
  return fmt::format(
      "\n  \"format\": \"holdfast-constraints\",\n  \"version\": 1,{}\n"
      "  \"constraints\": {}\n",
      units, constraintArrayJson(list.constraints));
}

std::string constraintsToJson(const ConstraintList& list)
{
  const std::string json = fmt::format("{{{}}}\n", constraintMembersJson(list));
  requireReadableConstraints(json);
  return json;
}

}  // namespace holdfast

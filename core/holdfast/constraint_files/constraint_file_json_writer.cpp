#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Vector3& v)
{
  return {v.x(), v.y(), v.z()};
}

Json toJson(const SurfaceLocation& location);
Json toJson(const Selection& selection);
Json toJson(const AxisAngle& turn);

template <class Range>
Json listOf(const Range& range)
{
  Json list = Json::array();
  for (const auto& element : range) list.push_back(toJson(element));
  return list;
}

struct LocationJson {
  Json operator()(const AtVertex& at) const { return {{"vertex", at.vertex}}; }
  Json operator()(const AtEdge& at) const { return {{"edge", {at.i, at.j}}, {"t", at.t}}; }
  Json operator()(const AtFace& at) const { return {{"face", at.face}, {"weights", at.weights}}; }
  Json operator()(const AtNear& at) const { return {{"near", toJson(at.place)}}; }
};

Json toJson(const SurfaceLocation& location)
{
  return std::visit(LocationJson{}, location);
}

struct SelectionJson {
  Json operator()(const VertexIds& vertices) const { return {{"vertices", vertices.ids}}; }
  Json operator()(const InBox& box) const { return {{"box", {{"min", toJson(box.min)}, {"max", toJson(box.max)}}}}; }
  Json operator()(const InSphere& sphere) const
  {
    return {{"sphere", {{"center", toJson(sphere.center)}, {"radius", sphere.radius}}}};
  }
  Json operator()(const InHalfSpace& half) const
  {
    return {{"halfspace", {{"point", toJson(half.point)}, {"normal", toJson(half.normal)}}}};
  }
  Json operator()(const InComponent& part) const { return {{"component", part.component}}; }
  Json operator()(const InsideCurve& curve) const
  {
    return {{"curve",
             {{"through", listOf(curve.through)}, {"side", curve.side == CurveSide::Smaller ? "smaller" : "larger"}}}};
  }
  Json operator()(const AllOf& all) const { return {{"all", listOf(all.parts)}}; }
  Json operator()(const AnyOf& any) const { return {{"any", listOf(any.parts)}}; }
  Json operator()(const NotIn& none) const { return {{"not", toJson(*none.part)}}; }
};

Json toJson(const Selection& selection)
{
  return std::visit(SelectionJson{}, selection.what);
}

Json toJson(const Frame& frame)
{
  Json json = Json::object();
  if (frame.origin) json["origin"] = toJson(*frame.origin);
  json["x"] = toJson(frame.x);
  json["y"] = toJson(frame.y);
  return json;
}

Json toJson(const AxisAngle& turn)
{
  return {{"axis", toJson(turn.axis)}, {"degrees", turn.degrees}};
}

struct OwnKeys {
  Json& json;

  void operator()(const FixedConstraint& fixed) const { json["select"] = toJson(fixed.select); }
  void operator()(const RigidConstraint& rigid) const { json["select"] = toJson(rigid.select); }
  void operator()(const HandleConstraint& handle) const
  {
    json["select"] = toJson(handle.select);
    std::visit(*this, handle.motion);
    json["translate"] = toJson(handle.translate);
    if (!handle.rotations.empty()) json["rotations"] = listOf(handle.rotations);
  }
  void operator()(const PointConstraint& point) const
  {
    json["at"] = toJson(point.at);
    std::visit(*this, point.to);
  }
  void operator()(const RelativeConstraint& relative) const
  {
    json["from"] = toJson(relative.from);
    json["to"] = toJson(relative.to);
    if (relative.offset) json["offset"] = toJson(*relative.offset);
  }

  void operator()(const Target& target) const { json["target"] = toJson(target.place); }
  void operator()(const Move& move) const { json["move"] = toJson(move.shift); }

  void operator()(std::monostate) const {}
  void operator()(const AxisRotation& turn) const
  {
    json["rotate"] = toJson(AxisAngle{turn.axis, turn.degrees});
    if (turn.center) json["rotate"]["center"] = toJson(*turn.center);
  }
  void operator()(const RotationAboutFixed& turn) const
  {
    json["turn"] = "about-fixed";
    if (turn.near) json["turn_near"] = toJson(*turn.near);
  }
  void operator()(const FrameMotion& motion) const
  {
    json["frame"] = {{"from", toJson(motion.from)}, {"to", toJson(motion.to)}};
    if (motion.turns != 0) json["frame"]["turns"] = motion.turns;
  }
  void operator()(const VertexTargets& targets) const { json["targets"] = listOf(targets.places); }
};

std::string constraintJson(const Constraint& constraint)
{
  Json json{{"type", typeName(constraint)}, {"name", constraint.name}};
  if (!constraint.isEnabled) json["enabled"] = false;
  std::visit(OwnKeys{json}, constraint.what);
  const std::string text = jsonText(json);
  return "{ " + text.substr(1, text.size() - 2) + " }";
}

std::string constraintArrayJson(const std::vector<Constraint>& constraints)
{
  std::string json;
  for (const Constraint& constraint : constraints)
    json += (json.empty() ? "\n    " : ",\n    ") + constraintJson(constraint);
  return json.empty() ? "[]" : fmt::format("[{}\n  ]", json);
}

std::string quoted(const std::string& text)
{
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      json += {'\\', c};
    else if (c >= 0 && c < ' ')
      json += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      json += c;
  }
  return json + '"';
}

std::string numberJson(double value)
{
  if (!std::isfinite(value)) return "null";
  // An integer zero has no sign.
  if (value == 0 && std::signbit(value)) return "-0.0";
  return std::string(NumberText(value).view());
}

}  // namespace

std::string jsonText(const nlohmann::ordered_json& json)
{
  if (json.is_string()) return quoted(json.get_ref<const std::string&>());
  if (json.is_number_float()) return numberJson(json.get<double>());
  if (!json.is_structured()) return json.dump();
  std::string members;
  for (auto member = json.begin(); member != json.end(); ++member) {
    if (!members.empty()) members += ", ";
    if (json.is_object()) members += quoted(member.key()) + ": ";
    members += jsonText(*member);
  }
  return json.is_object() ? '{' + members + '}' : '[' + members + ']';
}

std::string constraintMembersJson(const ConstraintList& list)
{
  const std::string units = list.units.empty() ? "" : fmt::format("\n  \"units\": {},", jsonText(list.units));
  return fmt::format(
      "\n  \"format\": \"holdfast-constraints\",\n  \"version\": 1,{}\n"
      "  \"constraints\": {}\n",
      units, constraintArrayJson(list.constraints));
}

std::string constraintsToJson(const ConstraintList& list)
{
  std::string json = fmt::format("{{{}}}\n", constraintMembersJson(list));
  requireReadable("constraint file", [&] { return parseConstraintsJson(json, ""); });
  return json;
}

}  // namespace holdfast

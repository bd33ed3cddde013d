#include <cmath>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {

using Json = nlohmann::ordered_json;

// Found by the library where it writes values and lists of them.
static void to_json(Json& json, const SurfaceLocation& location);
static void to_json(Json& json, const Selection& selection);
static void to_json(Json& json, const AxisAngle& turn);
static void to_json(Json& json, const Frame& frame);

namespace {

struct LocationJson {
  Json operator()(const AtVertex& at) const { return {{"vertex", at.vertex}}; }
  Json operator()(const AtEdge& at) const { return {{"edge", {at.i, at.j}}, {"t", at.t}}; }
  Json operator()(const AtFace& at) const { return {{"face", at.face}, {"weights", at.weights}}; }
  Json operator()(const AtNear& at) const { return {{"near", at.place}}; }
};

struct SelectionJson {
  Json operator()(const VertexIds& vertices) const { return {{"vertices", vertices.ids}}; }
  Json operator()(const InBox& box) const { return {{"box", {{"min", box.min}, {"max", box.max}}}}; }
  Json operator()(const InSphere& sphere) const
  {
    return {{"sphere", {{"center", sphere.center}, {"radius", sphere.radius}}}};
  }
  Json operator()(const InHalfSpace& half) const
  {
    return {{"halfspace", {{"point", half.point}, {"normal", half.normal}}}};
  }
  Json operator()(const InComponent& part) const { return {{"component", part.component}}; }
  Json operator()(const InsideCurve& curve) const
  {
    const char* const side = curve.side == CurveSide::Smaller ? "smaller" : "larger";
    return {{"curve", {{"through", curve.through}, {"side", side}}}};
  }
  Json operator()(const AllOf& all) const { return {{"all", all.parts}}; }
  Json operator()(const AnyOf& any) const { return {{"any", any.parts}}; }
  Json operator()(const NotIn& none) const { return {{"not", *none.part}}; }
};

struct OwnKeys {
  Json& json;

  void operator()(const FixedConstraint& fixed) const { json["select"] = fixed.select; }
  void operator()(const RigidConstraint& rigid) const { json["select"] = rigid.select; }
  void operator()(const HandleConstraint& handle) const
  {
    json["select"] = handle.select;
    std::visit(*this, handle.motion);
    json["translate"] = handle.translate;
    if (!handle.rotations.empty()) json["rotations"] = handle.rotations;
  }
  void operator()(const PointConstraint& point) const
  {
    json["at"] = point.at;
    std::visit(*this, point.to);
  }
  void operator()(const RelativeConstraint& relative) const
  {
    json["from"] = relative.from;
    json["to"] = relative.to;
    if (relative.offset) json["offset"] = *relative.offset;
  }

  void operator()(const Target& target) const { json["target"] = target.place; }
  void operator()(const Move& move) const { json["move"] = move.shift; }

  void operator()(std::monostate) const {}
  void operator()(const AxisRotation& turn) const
  {
    json["rotate"] = AxisAngle{turn.axis, turn.degrees};
    if (turn.center) json["rotate"]["center"] = *turn.center;
  }
  void operator()(const RotationAboutFixed& turn) const
  {
    json["turn"] = "about-fixed";
    if (turn.near) json["turn_near"] = *turn.near;
  }
  void operator()(const FrameMotion& motion) const
  {
    json["frame"] = {{"from", motion.from}, {"to", motion.to}};
    if (motion.turns != 0) json["frame"]["turns"] = motion.turns;
  }
  void operator()(const VertexTargets& targets) const { json["targets"] = targets.places; }
};

std::string constraintJson(const Constraint& constraint)
{
  Json json{{"type", typeName(constraint)}, {"name", constraint.name}};
  if (!constraint.isEnabled) json["enabled"] = false;
  std::visit(OwnKeys{json}, constraint.what);
  for (const auto& [title, extra] : constraint.extra) json["extra"][title] = extra;
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

void to_json(Json& json, const SurfaceLocation& location)
{
  json = std::visit(LocationJson{}, location);
}

void to_json(Json& json, const Selection& selection)
{
  json = std::visit(SelectionJson{}, selection.what);
}

void to_json(Json& json, const AxisAngle& turn)
{
  json = {{"axis", turn.axis}, {"degrees", turn.degrees}};
}

void to_json(Json& json, const Frame& frame)
{
  if (frame.origin) json["origin"] = *frame.origin;
  json["x"] = frame.x;
  json["y"] = frame.y;
}

JsonValue locationJson(const SurfaceLocation& location)
{
  return location;
}

JsonValue selectionJson(const Selection& selection)
{
  return selection;
}

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

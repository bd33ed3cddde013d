#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/constraints/handle_motion.h>
#include <holdfast/numbers/same_bits.h>

namespace holdfast {

// Found by the library where it writes values and lists of them.
static void to_json(JsonValue& json, const AxisAngle& turn);
static void to_json(JsonValue& json, const Frame& frame);

namespace {

using Motion = decltype(HandleConstraint::motion);

constexpr std::array<std::string_view, 4> kMotions{"rotate", "turn", "frame", "targets"};
constexpr std::array<std::string_view, 7> kNeeded{"rotate",    "turn",      "frame", "targets",
                                                  "translate", "rotations", "scale"};
constexpr std::array<std::string_view, 1> kTurns{"about-fixed"};

bool hasAnyOf(const JsonReader& json, std::span<const std::string_view> keys)
{
  return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return json.has(key); });
}

AxisRotation readAxisRotation(const JsonReader& json)
{
  json.requireKeys({"axis", "degrees", "center"});
  AxisRotation turn{json["axis"].direction(), json["degrees"].number(), std::nullopt};
  if (json.has("center")) turn.center = json["center"].vector();
  return turn;
}

AxisAngle readAxisAngle(const JsonReader& json)
{
  json.requireKeys({"axis", "degrees"});
  return {json["axis"].direction(), json["degrees"].number()};
}

RotationAboutFixed readRotationAboutFixed(const JsonReader& handle)
{
  const JsonReader json = handle["turn"];
  static_cast<void>(json.choice(kTurns, "unknown way to turn {}"));
  if (!handle.has("translate"))
    json.fail(R"(how far the handle turns follows from "translate", which is missing; add "translate")");
  if (!handle.has("turn_near")) return {};
  return {readAxisAngle(handle["turn_near"])};
}

Frame readFrame(const JsonReader& json)
{
  json.requireKeys({"origin", "x", "y"});
  Frame frame;
  if (json.has("origin")) frame.origin = json["origin"].vector();
  if (json.has("x")) frame.x = json["x"].direction();
  if (json.has("y")) frame.y = json["y"].direction();
  return frame;
}

FrameMotion readFrameMotion(const JsonReader& json)
{
  json.requireKeys({"from", "to", "turns"});
  FrameMotion motion;
  if (json.has("from")) motion.from = readFrame(json["from"]);
  motion.to = readFrame(json["to"]);
  if (json.has("turns")) motion.turns = json["turns"].integer();
  return motion;
}

Motion readMotion(const JsonReader& json)
{
  if (json.has("turn_near") && !json.has("turn"))
    json.failBelow(".turn_near", R"(it says which "turn" is meant, and there is no "turn"; add "turn": "about-fixed")");
  if (!hasAnyOf(json, kMotions)) return std::monostate{};
  const std::string_view kind = json.oneKeyOf(kMotions);
  if (kind == "rotate") return readAxisRotation(json[kind]);
  if (kind == "turn") return readRotationAboutFixed(json);
  if (kind == "frame") return readFrameMotion(json[kind]);
  return VertexTargets{json[kind].listAboveZero(&JsonReader::vector)};
}

/// One factor, or one along each axis.
Vector3 readScale(const JsonReader& json)
{
  return json.isList() ? json.vector() : Vector3(Vector3::Constant(json.number()));
}

/// The selection with the rings around it.
Selection readWithRings(const JsonReader& json)
{
  Selection selection = readSelection(json["select"]);
  if (!json.has("rings") || json["rings"].id() == 0) return selection;
  return {Grown{std::make_shared<const Selection>(std::move(selection)), json["rings"].id()}};
}

void writeWithRings(JsonValue& json, const Selection& selection)
{
  const auto* grown = std::get_if<Grown>(&selection.what);
  json["select"] = grown == nullptr ? selection : *grown->part;
  if (grown != nullptr) json["rings"] = grown->rings;
}

HandleConstraint readHandle(const JsonReader& json)
{
  HandleConstraint handle{readWithRings(json), {}, Vector3::Zero(), {}};
  if (!hasAnyOf(json, kNeeded))
    json.fail(R"(a handle needs "rotate", "translate" or both, or another way to go: "turn", "frame", "targets", )"
              R"("rotations", "scale"; "fixed" is the type for vertices that stay in their places)");
  handle.motion = readMotion(json);
  if (json.has("translate")) handle.translate = json["translate"].vector();
  if (json.has("rotations")) handle.rotations = json["rotations"].listAboveZero(readAxisAngle);
  if (json.has("scale")) handle.scale = readScale(json["scale"]);
  if (const std::optional<HandleError> error = validateHandle(handle)) json.failBelow(error->key, error->reason);
  return handle;
}

using Keys = std::span<const std::string_view>;
using What = decltype(Constraint::what);

struct Type {
  std::string_view name;
  Keys keys;
  What (*read)(const JsonReader&);
};

constexpr std::array<std::string_view, 6> kFixedKeys{"type", "name", "enabled", "extra", "select", "rings"};
constexpr std::array<std::string_view, 5> kRegionKeys{"type", "name", "enabled", "extra", "select"};
constexpr std::array<std::string_view, 14> kHandleKeys{"type",      "name",      "enabled",   "extra", "select",
                                                       "rings",     "rotate",    "turn",      "frame", "targets",
                                                       "translate", "turn_near", "rotations", "scale"};
constexpr std::array<std::string_view, 10> kPointKeys{"type",   "name", "enabled", "extra",  "at",
                                                      "target", "move", "on",      "within", "weight"};
constexpr std::array<std::string_view, 8> kMirrorKeys{"type",  "name",      "enabled", "extra",
                                                      "plane", "tolerance", "select",  "pairs"};
constexpr std::array<std::string_view, 9> kSlideKeys{"type", "name",     "enabled", "extra", "select",
                                                     "on",   "together", "within",  "weight"};
constexpr std::array<std::string_view, 6> kCoincidentKeys{"type", "name", "enabled", "extra", "from", "to"};
constexpr std::array<std::string_view, 7> kRelativeKeys{"type", "name", "enabled", "extra", "from", "to", "offset"};
constexpr std::array<std::string_view, 3> kDestinations{"target", "move", "on"};
constexpr std::array<std::string_view, 3> kGuides{"plane", "line", "mesh"};
constexpr std::array<std::string_view, 1> kFits{"fit"};

What readFixed(const JsonReader& json)
{
  return FixedConstraint{readWithRings(json)};
}

What readRigid(const JsonReader& json)
{
  return RigidConstraint{readSelection(json["select"])};
}

using Goal = decltype(PointConstraint::to);

Goal readTarget(const JsonReader& json)
{
  const std::array<std::optional<double>, 3> values = json.coordinates();
  if (values[0] && values[1] && values[2]) return Target{{*values[0], *values[1], *values[2]}};
  return Coordinates{values};
}

OnPlane readPlane(const JsonReader& json)
{
  json.requireKeys({"point", "normal", "offset"});
  OnPlane plane{std::nullopt, json["normal"].direction(), 0};
  if (json.has("point")) plane.point = json["point"].vector();
  if (json.has("offset")) plane.offset = json["offset"].number();
  return plane;
}

OnLine readLine(const JsonReader& json)
{
  json.requireKeys({"point", "direction"});
  OnLine line{std::nullopt, json["direction"].direction()};
  if (json.has("point")) line.point = json["point"].vector();
  return line;
}

OnMesh readGuideMesh(const JsonReader& json)
{
  if (json.text().empty()) json.fail("the path is empty; give that of a mesh file");
  return {json.text()};
}

Goal readGuide(const JsonReader& json)
{
  json.requireKeys(kGuides);
  const std::string_view key = json.oneKeyOf(kGuides);
  if (key == "plane") return readPlane(json[key]);
  if (key == "line") return readLine(json[key]);
  return readGuideMesh(json[key]);
}

Goal readGoal(const JsonReader& json)
{
  const std::string_view key = json.oneKeyOf(kDestinations);
  if (key == "target") return readTarget(json[key]);
  if (key == "on") return readGuide(json[key]);
  return Move{json[key].vector()};
}

constexpr std::array<std::string_view, 3> kTolerances{"ball", "box", "slab"};

/// A bound of a slab; null where there is none.
double readBound(const JsonReader& json, double none)
{
  return json.isNull() ? none : json.number();
}

PointTolerance readWithin(const JsonReader& json)
{
  json.requireKeys({"ball", "box", "slab", "normal"});
  const std::string_view kind = json.oneKeyOf(kTolerances);
  if (kind != "slab" && json.has("normal")) json["normal"].fail("only a slab has a normal; leave it out");
  if (kind == "ball") return WithinBall{json["ball"].number()};
  if (kind == "box") return WithinBox{json["box"].vector()};
  const JsonReader slab = json["slab"];
  slab.requireSize(2, "the bounds [low, high], of which one may be null");
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  WithinSlab within{readBound(slab.element(0), -kUnbounded), readBound(slab.element(1), kUnbounded), std::nullopt};
  if (json.has("normal")) within.normal = json["normal"].direction();
  return within;
}

/// The tolerance of a point or a slide that holds in these `directions`.
PointTolerance readTolerance(const JsonReader& json, const RowDirections& directions)
{
  if (json.has("within") && json.has("weight"))
    json["weight"].fail(R"("within" says already how near the point comes; leave one of both out)");
  PointTolerance tolerance;
  if (json.has("within")) tolerance = readWithin(json["within"]);
  if (json.has("weight")) tolerance = Weighted{json["weight"].number()};
  if (const std::optional<ToleranceError> error = validateTolerance(tolerance, directions))
    json.failBelow(error->key, error->reason);
  return tolerance;
}

What readPoint(const JsonReader& json)
{
  PointConstraint point{readLocation(json["at"]), readGoal(json), {}};
  point.within = readTolerance(json, point.directions());
  return point;
}

decltype(SlideConstraint::on) readSlideGuide(const JsonReader& json)
{
  json.requireKeys(kGuides);
  const std::string_view key = json.oneKeyOf(kGuides);
  const bool isPlane = key == "plane";
  const JsonReader guide = json[key];
  if (key == "mesh") return readGuideMesh(guide);
  if (!guide.isText() && isPlane) return readPlane(guide);
  if (!guide.isText()) return readLine(guide);
  static_cast<void>(guide.choice(kFits, "unknown way to find it {}"));
  if (isPlane) return FittedPlane{};
  return FittedLine{};
}

What readSlide(const JsonReader& json)
{
  SlideConstraint slide{readSelection(json["select"]), readSlideGuide(json["on"]),
                        json.has("together") && json["together"].boolean()};
  slide.within = readTolerance(json, slide.directions());
  if (!slide.together) return slide;
  if (json["on"].has("mesh")) json["together"].fail("only a plane or a line may shift; leave this out");
  if (!std::holds_alternative<Exactly>(slide.within))
    json["together"].fail("vertices that shift together have no tolerance; leave one of both out");
  return slide;
}

What readCoincident(const JsonReader& json)
{
  return CoincidentConstraint{readLocation(json["from"]), readLocation(json["to"])};
}

What readMirror(const JsonReader& json)
{
  const JsonReader plane = json["plane"];
  plane.requireKeys({"point", "normal"});
  MirrorConstraint mirror{plane["point"].vector(), plane["normal"].direction(), {}, {AllOf{}}, {}};
  if (json.has("tolerance")) mirror.tolerance = json["tolerance"].number();
  if (mirror.tolerance && *mirror.tolerance < 0)
    json["tolerance"].fail("a distance cannot be below 0, this is {}", *mirror.tolerance);
  if (json.has("pairs"))
    mirror.pairs = json["pairs"].listAboveZero([](const JsonReader& pair) {
      pair.requireSize(2, "the two vertices [i, j]");
      return std::array<Index, 2>{pair.element(0).id(), pair.element(1).id()};
    });
  if (!json.has("select")) return mirror;
  if (!mirror.pairs.empty())
    json.failBelow(".pairs", R"("select" says that they are to be found; leave one of both out)");
  mirror.select = readSelection(json["select"]);
  return mirror;
}

What readRelative(const JsonReader& json)
{
  RelativeConstraint relative{readLocation(json["from"]), readLocation(json["to"]), std::nullopt};
  if (json.has("offset")) relative.offset = json["offset"].vector();
  return relative;
}

constexpr std::array<Type, std::variant_size_v<What>> kTypes{
    {{FixedConstraint::kType, kFixedKeys, readFixed},
     {HandleConstraint::kType, kHandleKeys, [](const JsonReader& json) { return What(readHandle(json)); }},
     {PointConstraint::kType, kPointKeys, readPoint},
     {RigidConstraint::kType, kRegionKeys, readRigid},
     {RelativeConstraint::kType, kRelativeKeys, readRelative},
     {SlideConstraint::kType, kSlideKeys, readSlide},
     {CoincidentConstraint::kType, kCoincidentKeys, readCoincident},
     {MirrorConstraint::kType, kMirrorKeys, readMirror}}};

Type readType(const JsonReader& json)
{
  std::array<std::string_view, kTypes.size()> names;
  std::ranges::transform(kTypes, names.begin(), &Type::name);
  return kTypes[json.choice(names, "unknown type {}")];
}

/// The name, or the default for the constraint at `place`, counted from 1.
std::string readName(const JsonReader& json, std::string_view type, std::size_t place)
{
  if (!json.has("name")) return fmt::format("{} {}", type, place);
  const JsonReader name = json["name"];
  if (name.text().empty()) name.fail("the name is empty; leave the key out for the default name");
  return name.text();
}

std::vector<ExtraText> readExtra(const JsonReader& json)
{
  std::vector<ExtraText> extra;
  for (const std::string_view title : json.keys()) {
    if (title.empty()) json.fail("a title is empty; give each text one");
    extra.push_back({std::string(title), json[title].text()});
  }
  return extra;
}

/// A coordinate that may be null elsewhere: what is not finite becomes a text, which readers refuse with its path.
JsonValue coordinateJson(double coordinate)
{
  return std::isfinite(coordinate) ? JsonValue(coordinate) : JsonValue("not finite");
}

struct OwnKeys {
  JsonValue& json;

  void operator()(const FixedConstraint& fixed) const { writeWithRings(json, fixed.select); }
  void operator()(const RigidConstraint& rigid) const { json["select"] = rigid.select; }
  void operator()(const HandleConstraint& handle) const
  {
    writeWithRings(json, handle.select);
    std::visit(*this, handle.motion);
    json["translate"] = handle.translate;
    if (!handle.rotations.empty()) json["rotations"] = handle.rotations;
    if (handle.scale == Vector3::Ones()) return;
    json["scale"] = isUniform(handle.scale) ? JsonValue(handle.scale.x()) : JsonValue(handle.scale);
  }
  void operator()(const PointConstraint& point) const
  {
    json["at"] = point.at;
    std::visit(*this, point.to);
    std::visit(*this, point.within);
  }
  void operator()(const Exactly& /*exactly*/) const {}
  void operator()(const WithinBall& ball) const { json["within"]["ball"] = ball.radius; }
  void operator()(const WithinBox& box) const { json["within"]["box"] = box.half; }
  void operator()(const WithinSlab& slab) const
  {
    for (const double bound : {slab.low, slab.high})
      json["within"]["slab"].push_back(std::isinf(bound) ? JsonValue(nullptr) : JsonValue(bound));
    if (slab.normal) json["within"]["normal"] = *slab.normal;
  }
  void operator()(const Weighted& weighted) const { json["weight"] = weighted.weight; }
  void operator()(const RelativeConstraint& relative) const
  {
    json["from"] = relative.from;
    json["to"] = relative.to;
    if (relative.offset) json["offset"] = *relative.offset;
  }

  void operator()(const SlideConstraint& slide) const
  {
    json["select"] = slide.select;
    std::visit(*this, slide.on);
    if (slide.together) json["together"] = true;
    std::visit(*this, slide.within);
  }
  void operator()(const MirrorConstraint& mirror) const
  {
    json["plane"] = {{"point", mirror.point}, {"normal", mirror.normal}};
    if (mirror.tolerance) json["tolerance"] = *mirror.tolerance;
    if (mirror.select != Selection{AllOf{}}) json["select"] = mirror.select;
    if (!mirror.pairs.empty()) json["pairs"] = mirror.pairs;
  }
  void operator()(const CoincidentConstraint& coincident) const
  {
    json["from"] = coincident.from;
    json["to"] = coincident.to;
  }
  void operator()(const FittedPlane& /*plane*/) const { json["on"]["plane"] = "fit"; }
  void operator()(const FittedLine& /*line*/) const { json["on"]["line"] = "fit"; }

  void operator()(const Target& target) const
  {
    for (const double coordinate : target.place) json["target"].push_back(coordinateJson(coordinate));
  }
  void operator()(const Move& move) const { json["move"] = move.shift; }
  void operator()(const Coordinates& coordinates) const
  {
    for (const std::optional<double>& value : coordinates.values)
      json["target"].push_back(value ? coordinateJson(*value) : JsonValue(nullptr));
  }
  void operator()(const OnPlane& on) const
  {
    JsonValue& plane = json["on"]["plane"];
    if (on.point) plane["point"] = *on.point;
    plane["normal"] = on.normal;
    if (!hasSameBits(on.offset, 0)) plane["offset"] = on.offset;
  }
  void operator()(const OnLine& on) const
  {
    JsonValue& line = json["on"]["line"];
    if (on.point) line["point"] = *on.point;
    line["direction"] = on.direction;
  }

  void operator()(const OnMesh& on) const { json["on"]["mesh"] = on.path; }

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

}  // namespace

void to_json(JsonValue& json, const AxisAngle& turn)
{
  json = {{"axis", turn.axis}, {"degrees", turn.degrees}};
}

void to_json(JsonValue& json, const Frame& frame)
{
  if (frame.origin) json["origin"] = *frame.origin;
  json["x"] = frame.x;
  json["y"] = frame.y;
}

Constraint readConstraint(const JsonReader& json, std::size_t place)
{
  const Type type = readType(json["type"]);
  json.requireKeys(type.keys);
  const bool isEnabled = !json.has("enabled") || json["enabled"].boolean();
  return {readName(json, type.name, place), isEnabled, type.read(json),
          json.has("extra") ? readExtra(json["extra"]) : std::vector<ExtraText>{}};
}

std::string constraintJson(const Constraint& constraint)
{
  JsonValue json{{"type", typeName(constraint)}, {"name", constraint.name}};
  if (!constraint.isEnabled) json["enabled"] = false;
  std::visit(OwnKeys{json}, constraint.what);
  for (const auto& [title, extra] : constraint.extra) json["extra"][title] = extra;
  const std::string text = jsonText(json);
  return "{ " + text.substr(1, text.size() - 2) + " }";
}

}  // namespace holdfast

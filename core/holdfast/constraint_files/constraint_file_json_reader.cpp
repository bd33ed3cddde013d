#include <cmath>
#include <map>
#include <memory>
#include <numeric>

#include <holdfast/base/lower_case.h>
#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/constraints/handle_motion.h>
#include <holdfast/io/files/file_bytes.h>

namespace holdfast {
namespace {

constexpr std::array<std::string_view, 9> kSelections{"vertices", "box", "sphere", "halfspace", "component",
                                                      "curve",    "all", "any",    "not"};
// Fewer would lead there and back.
constexpr std::size_t kLeastPlacesOfCurve = 3;
constexpr std::array<std::string_view, 4> kLocations{"vertex", "edge", "face", "near"};
constexpr std::array<std::string_view, 2> kSides{"smaller", "larger"};

AtEdge readEdge(const JsonReader& json)
{
  json.requireKeys({"edge", "t"});
  const JsonReader ends = json["edge"];
  ends.requireSize(2, "the two vertices [i, j]");
  const AtEdge edge{ends.element(0).id(), ends.element(1).id(), json["t"].number()};
  if (edge.i == edge.j) ends.fail("both ends are vertex {}; name two vertices", edge.i);
  if (edge.t < 0 || edge.t > 1)
    json["t"].fail("{} is outside [0, 1]; 1 is the first vertex of the edge, 0 the second", edge.t);
  return edge;
}

AtFace readFace(const JsonReader& json)
{
  json.requireKeys({"face", "weights"});
  const JsonReader weights = json["weights"];
  AtFace face{json["face"].id(), weights.list([](const JsonReader& weight) {
                if (weight.number() < 0)
                  weight.fail("the weight {} is negative; the point would lie outside the face", weight.number());
                return weight.number();
              })};
  if (face.weights.size() < 3)
    weights.fail("a face has at least 3 corners and a weight for each; this list has {}", face.weights.size());
  const double sum = std::accumulate(face.weights.begin(), face.weights.end(), 0.0);
  if (std::abs(sum - 1) <= kWeightSumTolerance) return face;
  const char* remedy = sum > 0 ? "divide each by that sum, with all digits" : "give weights above 0";
  weights.fail("the weights sum to {}, not to 1; {}", sum, remedy);
}

InBox readBox(const JsonReader& json)
{
  json.requireKeys({"min", "max"});
  const InBox box{json["min"].vector(), json["max"].vector()};
  for (int axis = 0; axis < 3; ++axis)
    if (box.min[axis] > box.max[axis])
      json.fail("the box is turned inside out: min {} is larger than max {} in {}; exchange them", box.min[axis],
                box.max[axis], "xyz"[axis]);
  return box;
}

InSphere readSphere(const JsonReader& json)
{
  json.requireKeys({"center", "radius"});
  const InSphere sphere{json["center"].vector(), json["radius"].number()};
  if (sphere.radius <= 0) json["radius"].fail("the radius must be above 0, this is {}", sphere.radius);
  return sphere;
}

InHalfSpace readHalfSpace(const JsonReader& json)
{
  json.requireKeys({"point", "normal"});
  return {json["point"].vector(), json["normal"].direction()};
}

InsideCurve readCurve(const JsonReader& json)
{
  json.requireKeys({"through", "side"});
  const JsonReader through = json["through"];
  if (through.size() < kLeastPlacesOfCurve)
    through.fail("a closed curve goes through at least {} places, this list has {}; add places along it",
                 kLeastPlacesOfCurve, through.size());
  InsideCurve curve{through.list(readLocation), CurveSide::Smaller};
  if (json.has("side")) curve.side = static_cast<CurveSide>(json["side"].choice(kSides, "unknown side {}"));
  return curve;
}

/// `depth` counts the selections around this one and itself.
Selection readSelection(const JsonReader& json, int depth)
{
  if (depth > kMaximumSelectionDepth)
    json.fail("selections are nested deeper than {}; take levels out", kMaximumSelectionDepth);
  json.requireKeys(kSelections);
  const std::string_view kind = json.oneKeyOf(kSelections);
  const JsonReader group = json[kind];
  const auto readPart = [&](const JsonReader& part) { return readSelection(part, depth + 1); };
  if (kind == "vertices") return {VertexIds{group.listAboveZero(&JsonReader::id)}};
  if (kind == "box") return {readBox(group)};
  if (kind == "sphere") return {readSphere(group)};
  if (kind == "halfspace") return {readHalfSpace(group)};
  if (kind == "component") return {InComponent{group.id()}};
  if (kind == "curve") return {readCurve(group)};
  if (kind == "all") return {AllOf{group.listAboveZero(readPart)}};
  if (kind == "any") return {AnyOf{group.listAboveZero(readPart)}};
  return {NotIn{std::make_shared<const Selection>(readPart(group))}};
}

using Motion = decltype(HandleConstraint::motion);

constexpr std::array<std::string_view, 4> kMotions{"rotate", "turn", "frame", "targets"};
constexpr std::array<std::string_view, 6> kNeeded{"rotate", "turn", "frame", "targets", "translate", "rotations"};
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
    json.fail(R"(the handle turns as "translate" moves it about the fixed vertices; add "translate")");
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
    json.failBelow(".turn_near", R"(says which "turn" is meant, and there is none; add "turn": "about-fixed")");
  if (!hasAnyOf(json, kMotions)) return std::monostate{};
  const std::string_view kind = json.oneKeyOf(kMotions);
  if (kind == "rotate") return readAxisRotation(json[kind]);
  if (kind == "turn") return readRotationAboutFixed(json);
  if (kind == "frame") return readFrameMotion(json[kind]);
  return VertexTargets{json[kind].listAboveZero(&JsonReader::vector)};
}

HandleConstraint readHandle(const JsonReader& json)
{
  HandleConstraint handle{readSelection(json["select"]), {}, Vector3::Zero(), {}};
  if (!hasAnyOf(json, kNeeded))
    json.fail(R"(a handle needs "rotate", "translate" or both, or another way to go: "turn", "frame", "targets", )"
              R"("rotations"; "fixed" is the type of what stays where it is)");
  handle.motion = readMotion(json);
  if (json.has("translate")) handle.translate = json["translate"].vector();
  if (json.has("rotations")) handle.rotations = json["rotations"].listAboveZero(readAxisAngle);
  if (const std::optional<HandleError> error = validateHandle(handle)) json.failBelow(error->key, error->reason);
  return handle;
}

using Keys = std::span<const std::string_view>;
using What = decltype(Constraint::what);

constexpr std::string_view kFormat = "holdfast-constraints";
constexpr Index kVersion = 1;
constexpr std::array<std::string_view, 4> kListKeys{"format", "version", "units", "constraints"};

struct Type {
  std::string_view name;
  Keys keys;
  What (*read)(const JsonReader&);
};

constexpr std::array<std::string_view, 5> kRegionKeys{"type", "name", "enabled", "extra", "select"};
constexpr std::array<std::string_view, 12> kHandleKeys{"type",    "name",      "enabled",   "extra",
                                                       "select",  "rotate",    "turn",      "frame",
                                                       "targets", "translate", "turn_near", "rotations"};
constexpr std::array<std::string_view, 7> kPointKeys{"type", "name", "enabled", "extra", "at", "target", "move"};
constexpr std::array<std::string_view, 7> kRelativeKeys{"type", "name", "enabled", "extra", "from", "to", "offset"};
constexpr std::array<std::string_view, 2> kDestinations{"target", "move"};

/// A constraint that is its selection alone.
template <class Region>
What readRegion(const JsonReader& json)
{
  return Region{readSelection(json["select"])};
}

What readPoint(const JsonReader& json)
{
  PointConstraint point{readLocation(json["at"]), {}};
  if (json.oneKeyOf(kDestinations) == "target")
    point.to = Target{json["target"].vector()};
  else
    point.to = Move{json["move"].vector()};
  return point;
}

What readRelative(const JsonReader& json)
{
  RelativeConstraint relative{readLocation(json["from"]), readLocation(json["to"]), std::nullopt};
  if (json.has("offset")) relative.offset = json["offset"].vector();
  return relative;
}

constexpr std::array<Type, std::variant_size_v<What>> kTypes{
    {{FixedConstraint::kType, kRegionKeys, readRegion<FixedConstraint>},
     {HandleConstraint::kType, kHandleKeys, [](const JsonReader& json) { return What(readHandle(json)); }},
     {PointConstraint::kType, kPointKeys, readPoint},
     {RigidConstraint::kType, kRegionKeys, readRegion<RigidConstraint>},
     {RelativeConstraint::kType, kRelativeKeys, readRelative}}};

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

Constraint readConstraint(const JsonReader& json, std::size_t place)
{
  const Type type = readType(json["type"]);
  json.requireKeys(type.keys);
  const bool isEnabled = !json.has("enabled") || json["enabled"].boolean();
  return {readName(json, type.name, place), isEnabled, type.read(json),
          json.has("extra") ? readExtra(json["extra"]) : std::vector<ExtraText>{}};
}

void requireFormat(const JsonReader& document)
{
  if (document["format"].text() != kFormat)
    document["format"].fail("{} is expected here, this file says {}; is it a constraint file?", inQuotes(kFormat),
                            inQuotes(document["format"].text()));
  const Index version = document["version"].integer();
  if (version > kVersion)
    document["version"].fail(
        "version {} is newer than this program, which reads version {}; write the file as version {} or use a newer "
        "program",
        version, kVersion, kVersion);
  if (version < kVersion) document["version"].fail("there is no version {}; the version is {}", version, kVersion);
}

std::vector<Constraint> readConstraintArray(const JsonReader& json)
{
  std::vector<Constraint> constraints;
  std::map<std::string, std::string, std::less<>> pathOf;  // by name
  for (std::size_t i = 0; i < json.size(); ++i) {
    const JsonReader element = json.element(i);
    constraints.push_back(readConstraint(element, i + 1));
    const std::string& name = constraints.back().name;
    const auto [first, isNew] = pathOf.try_emplace(name, element.path());
    if (isNew) continue;
    if (!element.has("name"))
      element.fail("its default name {} is that of {}; give it a name", inQuotes(name), first->second);
    element["name"].fail("{} is the name of {} already; names are unique", inQuotes(name), first->second);
  }
  return constraints;
}

}  // namespace

SurfaceLocation readLocation(const JsonReader& json)
{
  json.requireKeys({"vertex", "edge", "t", "face", "weights", "near"});
  const std::string_view kind = json.oneKeyOf(kLocations);
  if (kind == "edge") return readEdge(json);
  if (kind == "face") return readFace(json);
  json.requireKeys({kind});
  if (kind == "vertex") return AtVertex{json[kind].id()};
  return AtNear{json[kind].vector()};
}

Selection readSelection(const JsonReader& json)
{
  return readSelection(json, 1);
}

ConstraintList readConstraintDocument(const JsonReader& document)
{
  requireFormat(document);
  std::vector<std::string_view> keys(kListKeys.begin(), kListKeys.end());
  keys.insert(keys.end(), kSessionKeys.begin(), kSessionKeys.end());
  document.requireKeys(keys);
  ConstraintList list;
  if (document.has("units")) list.units = document["units"].text();
  list.constraints = readConstraintArray(document["constraints"]);
  return list;
}

ConstraintList parseConstraintsJson(std::string_view text, const std::string& name)
{
  const JsonValue root = parseJson(text, name);
  return readConstraintDocument(JsonReader(root, name));
}

bool isPointList(const std::filesystem::path& path, std::string_view text)
{
  const std::string extension = lowerCase(path.extension().string());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string_view::npos && text[first] == '{';
  return extension == kPointListExtensions[0] || (std::ranges::count(kPointListExtensions, extension) != 0 && !isJson);
}

ConstraintList readConstraints(const std::filesystem::path& path)
{
  const std::string text = readTextFile(path);
  return isPointList(path, text) ? parsePointListCsv(text, path.string()) : parseConstraintsJson(text, path.string());
}

}  // namespace holdfast

#include <cmath>
#include <memory>
#include <numeric>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_internal.h>

namespace holdfast {
namespace {

constexpr std::array<std::string_view, 10> kSelections{"vertices", "box", "sphere", "halfspace", "component",
                                                       "curve",    "all", "any",    "not",       "grown"};
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
  InBox box{json["min"].vector(), json["max"].vector()};
  for (int axis = 0; axis < 3; ++axis)
    if (box.min[axis] > box.max[axis])
      json.fail("the box is turned inside out: min {} is larger than max {} in {}; exchange them", box.min[axis],
                box.max[axis], "xyz"[axis]);
  return box;
}

InSphere readSphere(const JsonReader& json)
{
  json.requireKeys({"center", "radius"});
  InSphere sphere{json["center"].vector(), json["radius"].number()};
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
  if (kind == "not") return {NotIn{std::make_shared<const Selection>(readPart(group))}};
  group.requireKeys({"select", "rings"});
  return {Grown{std::make_shared<const Selection>(readPart(group["select"])), group["rings"].id()}};
}

struct LocationJson {
  JsonValue operator()(const AtVertex& at) const { return {{"vertex", at.vertex}}; }
  JsonValue operator()(const AtEdge& at) const { return {{"edge", {at.i, at.j}}, {"t", at.t}}; }
  JsonValue operator()(const AtFace& at) const { return {{"face", at.face}, {"weights", at.weights}}; }
  JsonValue operator()(const AtNear& at) const { return {{"near", at.place}}; }
};

struct SelectionJson {
  JsonValue operator()(const VertexIds& vertices) const { return {{"vertices", vertices.ids}}; }
  JsonValue operator()(const InBox& box) const { return {{"box", {{"min", box.min}, {"max", box.max}}}}; }
  JsonValue operator()(const InSphere& sphere) const
  {
    return {{"sphere", {{"center", sphere.center}, {"radius", sphere.radius}}}};
  }
  JsonValue operator()(const InHalfSpace& half) const
  {
    return {{"halfspace", {{"point", half.point}, {"normal", half.normal}}}};
  }
  JsonValue operator()(const InComponent& part) const { return {{"component", part.component}}; }
  JsonValue operator()(const InsideCurve& curve) const
  {
    const char* const side = curve.side == CurveSide::Smaller ? "smaller" : "larger";
    return {{"curve", {{"through", curve.through}, {"side", side}}}};
  }
  JsonValue operator()(const AllOf& all) const { return {{"all", all.parts}}; }
  JsonValue operator()(const AnyOf& any) const { return {{"any", any.parts}}; }
  JsonValue operator()(const NotIn& none) const { return {{"not", *none.part}}; }
  JsonValue operator()(const Grown& grown) const
  {
    return {{"grown", {{"select", *grown.part}, {"rings", grown.rings}}}};
  }
};

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

void to_json(JsonValue& json, const SurfaceLocation& location)
{
  json = std::visit(LocationJson{}, location);
}

void to_json(JsonValue& json, const Selection& selection)
{
  json = std::visit(SelectionJson{}, selection.what);
}

}  // namespace holdfast

#include <array>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_json_internal.h>
#include <holdfast/constraint_files/constraint_file_text_internal.h>

namespace holdfast {
namespace {

constexpr std::array<std::string_view, 9> kSelections{"vertices", "box", "sphere", "halfspace", "component",
                                                      "curve",    "all", "any",    "not"};
// Fewer would lead there and back.
constexpr std::size_t kLeastPlacesOfCurve = 3;
constexpr std::array<std::string_view, 4> kLocations{"vertex", "edge", "face", "near"};
constexpr std::array<std::string_view, 2> kSides{"smaller", "larger"};

VertexIds readVertices(const JsonReader& json)
{
  VertexIds vertices;
  vertices.ids.resize(json.sizeAboveZero());
  for (std::size_t i = 0; i < vertices.ids.size(); ++i) vertices.ids[i] = json.element(i).id();
  return vertices;
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

CurveSide readSide(const JsonReader& json)
{
  const std::string& side = json.text();
  if (side == kSides[0]) return CurveSide::Smaller;
  if (side == kSides[1]) return CurveSide::Larger;
  json.fail("unknown side {}{}", inQuotes(side), spellingHint(side, kSides));
}

InsideCurve readCurve(const JsonReader& json)
{
  json.requireKeys({"through", "side"});
  const JsonReader through = json["through"];
  if (through.size() < kLeastPlacesOfCurve)
    through.fail("a closed curve goes through at least {} places, this list has {}; add places along it",
                 kLeastPlacesOfCurve, through.size());
  InsideCurve curve;
  for (std::size_t i = 0; i < through.size(); ++i) curve.through.push_back(readLocation(through.element(i)));
  if (json.has("side")) curve.side = readSide(json["side"]);
  return curve;
}

Selection readNested(const JsonReader& json, int depth);

std::vector<Selection> readParts(const JsonReader& json, int depth)
{
  std::vector<Selection> parts(json.sizeAboveZero());
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = readNested(json.element(i), depth);
  return parts;
}

/// `depth` counts the selections around this one and itself.
Selection readNested(const JsonReader& json, int depth)
{
  if (depth > kMaximumSelectionDepth)
    json.fail("selections are nested deeper than {}; take levels out", kMaximumSelectionDepth);
  json.requireKeys(kSelections);
  const std::string_view kind = json.oneKeyOf(kSelections);
  const JsonReader group = json[kind];
  if (kind == "vertices") return {readVertices(group)};
  if (kind == "box") return {readBox(group)};
  if (kind == "sphere") return {readSphere(group)};
  if (kind == "halfspace") return {readHalfSpace(group)};
  if (kind == "component") return {InComponent{group.id()}};
  if (kind == "curve") return {readCurve(group)};
  if (kind == "all") return {AllOf{readParts(group, depth + 1)}};
  if (kind == "any") return {AnyOf{readParts(group, depth + 1)}};
  return {NotIn{std::make_shared<const Selection>(readNested(group, depth + 1))}};
}

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

void requireWeights(const JsonReader& json, const std::vector<double>& weights)
{
  if (weights.size() < 3)
    json.fail("a face has at least 3 corners and a weight for each; this list has {}", weights.size());
  double sum = 0;
  for (const double weight : weights) sum += weight;
  if (std::abs(sum - 1) <= kWeightSumTolerance) return;
  const char* remedy = sum > 0 ? "divide each by that sum, with all digits" : "give weights above 0";
  json.fail("the weights sum to {}, not to 1; {}", sum, remedy);
}

AtFace readFace(const JsonReader& json)
{
  json.requireKeys({"face", "weights"});
  const JsonReader weights = json["weights"];
  AtFace face{json["face"].id(), std::vector<double>(weights.size())};
  for (std::size_t corner = 0; corner < face.weights.size(); ++corner) {
    const JsonReader weight = weights.element(corner);
    face.weights[corner] = weight.number();
    if (face.weights[corner] < 0)
      weight.fail("the weight {} is negative; the point would lie outside the face", face.weights[corner]);
  }
  requireWeights(weights, face.weights);
  return face;
}

}  // namespace

Selection readSelection(const JsonReader& json)
{
  return readNested(json, 1);
}

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

}  // namespace holdfast

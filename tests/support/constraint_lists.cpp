#include "support/constraint_lists.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace holdfast::test {
namespace {

double randomNumber(Random& random)
{
  constexpr std::array<double, 6> kSpecial{
      0.0, -0.0, 1e308, std::numeric_limits<double>::denorm_min(), 0.1, 9007199254740993.0};
  const long choice = random.integer(0, 11);
  if (choice < static_cast<long>(kSpecial.size())) return kSpecial[choice];
  return random.uniform(-1, 1) * std::pow(10.0, static_cast<double>(random.integer(-20, 20)));
}

Vector3 randomVector(Random& random)
{
  return {randomNumber(random), randomNumber(random), randomNumber(random)};
}

Vector3 randomDirection(Random& random)
{
  Vector3 direction = randomVector(random);
  direction[random.integer(0, 2)] = random.uniform(0.1, 2);
  return direction;
}

Index randomId(Random& random)
{
  return random.integer(0, 9) == 0 ? std::numeric_limits<Index>::max() : random.integer(0, 1000);
}

std::vector<Selection> randomParts(Random& random, int depth)
{
  std::vector<Selection> parts;
  for (long i = random.integer(1, 3); i > 0; --i) parts.push_back(randomSelection(random, depth));
  return parts;
}

InBox randomBox(Random& random)
{
  const Vector3 a = randomVector(random);
  const Vector3 b = randomVector(random);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

VertexIds randomVertices(Random& random)
{
  VertexIds vertices;
  for (long i = random.integer(1, 5); i > 0; --i) vertices.ids.push_back(randomId(random));
  return vertices;
}

AtFace randomFace(Random& random)
{
  AtFace face{randomId(random), std::vector<double>(random.integer(3, 6))};
  double sum = 0;
  for (double& weight : face.weights) sum += weight = random.uniform(0, 1);
  for (double& weight : face.weights) weight /= sum;
  return face;
}

SurfaceLocation randomLocation(Random& random)
{
  const Index id = random.integer(0, 1000);
  switch (random.integer(0, 3)) {
    case 0:
      return AtVertex{randomId(random)};
    case 1:
      return AtEdge{id, id + 1, random.uniform(0, 1)};
    case 2:
      return randomFace(random);
    default:
      return AtNear{randomVector(random)};
  }
}

InsideCurve randomCurve(Random& random)
{
  InsideCurve curve;
  for (long i = random.integer(3, 6); i > 0; --i) curve.through.push_back(randomLocation(random));
  if (random.integer(0, 1) == 0) curve.side = CurveSide::Larger;
  return curve;
}

Frame randomFrame(Random& random)
{
  Frame frame;
  if (random.integer(0, 1) == 0) frame.origin = randomVector(random);
  if (random.integer(0, 1) == 0) frame.x = Vector3(random.uniform(1, 2), random.uniform(-1, 1), random.uniform(-1, 1));
  if (random.integer(0, 1) == 0) frame.y = Vector3(random.uniform(-1, 0), random.uniform(2, 3), random.uniform(0, 1));
  return frame;
}

decltype(HandleConstraint::motion) randomMotion(Random& random)
{
  switch (random.integer(0, 5)) {
    case 0:
      return AxisRotation{randomDirection(random), randomNumber(random), std::nullopt};
    case 1:
      return AxisRotation{randomDirection(random), randomNumber(random), randomVector(random)};
    case 2:
      return RotationAboutFixed{};
    case 4:
      return RotationAboutFixed{AxisAngle{randomDirection(random), randomNumber(random)}};
    case 3: {
      Frame to = randomFrame(random);
      to.x.z() += 1;
      return FrameMotion{randomFrame(random), to, random.integer(-2, 2)};
    }
    default:
      return std::monostate{};
  }
}

/// Returns `count` different ids, ascending or descending.
VertexIds distinctVertices(Random& random, long count)
{
  VertexIds vertices;
  const Index first = random.integer(0, 1000);
  const Index step = random.integer(0, 1) == 0 ? 7 : -3;
  for (long k = 0; k < count; ++k) vertices.ids.push_back(1000 + first + k * step);
  return vertices;
}

HandleConstraint randomHandle(Random& random)
{
  const long count = random.integer(3, 6);
  HandleConstraint handle{{distinctVertices(random, count)}, randomMotion(random), randomVector(random), {}};
  const long choice = random.integer(0, 5);
  if (choice == 0) {
    VertexTargets targets;
    for (long k = 0; k < count; ++k) targets.places.push_back(randomVector(random));
    handle.motion = std::move(targets);
  }
  if (choice > 3) handle.scale = Vector3(random.uniform(0.1, 2), 1, choice > 4 ? 0.5 : 7);
  if (choice == 3) handle.scale.setConstant(0.25);
  if (choice > 1)
    handle.select = randomSelection(random, 2);
  else if (random.integer(0, 1) == 0)
    for (long k = 0; k < count; ++k) handle.rotations.push_back({randomDirection(random), randomNumber(random)});
  return handle;
}

/// One or two coordinates.
Coordinates randomCoordinates(Random& random)
{
  Coordinates result;
  for (std::optional<double>& value : result.values) value = randomNumber(random);
  result.values[static_cast<std::size_t>(random.integer(0, 2))] = std::nullopt;
  if (random.integer(0, 1) == 0) result.values[static_cast<std::size_t>(random.integer(0, 2))] = std::nullopt;
  if (!result.values[0] && !result.values[1] && !result.values[2]) result.values[0] = randomNumber(random);
  return result;
}

decltype(PointConstraint::to) randomGoal(Random& random)
{
  const std::optional<Vector3> point = random.integer(0, 1) == 0 ? std::nullopt : std::optional(randomVector(random));
  switch (random.integer(0, 4)) {
    case 0:
      return Target{randomVector(random)};
    case 1:
      return Move{randomVector(random)};
    case 2:
      return randomCoordinates(random);
    case 3:
      return OnPlane{point, randomDirection(random), random.integer(0, 1) == 0 ? 0 : randomNumber(random)};
    default:
      return OnLine{point, randomDirection(random)};
  }
}

PointTolerance randomTolerance(Random& random, const RowDirections& directions)
{
  const double size = random.uniform(0.1, 2);
  const bool isOnLine = !directions.areAll() && !directions.areAlongAxis();
  switch (random.integer(0, 5)) {
    case 0:
      return WithinBall{size};
    case 1:
      if (!directions.areAll()) return Exactly{};
      return WithinBox{{size, 1e-300, 3}};
    case 2: {
      if (isOnLine) return Exactly{};
      WithinSlab slab{-size, randomNumber(random) > 0 ? size : std::numeric_limits<double>::infinity(), {}};
      if (directions.areAll()) slab.normal = randomDirection(random);
      return slab;
    }
    case 3:
      return Weighted{size};
    default:
      return Exactly{};
  }
}

/// A plane or a line, given or to be fitted.
SlideConstraint randomSlide(Random& random)
{
  const std::optional<Vector3> point = random.integer(0, 1) == 0 ? std::nullopt : std::optional(randomVector(random));
  const std::array<decltype(SlideConstraint::on), 4> guides{OnPlane{point, randomDirection(random), 0.25},
                                                            OnLine{point, randomDirection(random)}, FittedPlane{},
                                                            FittedLine{}};
  SlideConstraint slide{randomSelection(random, 2), guides[random.integer(0, 3)], random.integer(0, 1) == 0};
  if (!slide.together) slide.within = randomTolerance(random, slide.directions());
  return slide;
}

/// With partners that are found, among all or some, or listed.
MirrorConstraint randomMirror(Random& random)
{
  MirrorConstraint mirror{randomVector(random), randomDirection(random), {}, {AllOf{}}, {}};
  if (random.integer(0, 1) == 0) mirror.tolerance = random.uniform(0, 1);
  const long way = random.integer(0, 2);
  if (way == 0) mirror.select = randomSelection(random, 2);
  if (way == 1) mirror.pairs = {{randomId(random), randomId(random)}, {3, 3}};
  return mirror;
}

decltype(Constraint::what) randomWhat(Random& random)
{
  switch (random.integer(0, 7)) {
    case 0:
      return FixedConstraint{randomSelection(random, 3)};
    case 1:
      return randomHandle(random);
    case 2: {
      PointConstraint point{randomLocation(random), randomGoal(random)};
      point.within = randomTolerance(random, point.directions());
      return point;
    }
    case 3:
      return RigidConstraint{randomSelection(random, 3)};
    case 4:
      return randomSlide(random);
    case 5:
      return CoincidentConstraint{randomLocation(random), randomLocation(random)};
    case 6:
      return randomMirror(random);
    default:
      break;
  }
  RelativeConstraint relative{randomLocation(random), randomLocation(random), std::nullopt};
  if (random.integer(0, 1) == 0) relative.offset = randomVector(random);
  return relative;
}

/// Overloads, one for each type that a list is made of.
struct Same {
  bool operator()(double a, double b) const
  {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  }
  bool operator()(Index a, Index b) const { return a == b; }
  bool operator()(const Vector3& a, const Vector3& b) const
  {
    return (*this)(a.x(), b.x()) && (*this)(a.y(), b.y()) && (*this)(a.z(), b.z());
  }
  template <class T>
  bool operator()(const std::optional<T>& a, const std::optional<T>& b) const
  {
    return a.has_value() == b.has_value() && (!a || (*this)(*a, *b));
  }
  template <class T>
  bool operator()(const std::vector<T>& a, const std::vector<T>& b) const
  {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), *this);
  }
  template <class... T>
  bool operator()(const std::variant<T...>& a, const std::variant<T...>& b) const
  {
    const auto sameKind = [&](const auto& x) { return (*this)(x, std::get<std::decay_t<decltype(x)>>(b)); };
    return a.index() == b.index() && std::visit(sameKind, a);
  }

  bool operator()(const VertexIds& a, const VertexIds& b) const { return (*this)(a.ids, b.ids); }
  bool operator()(const InBox& a, const InBox& b) const { return (*this)(a.min, b.min) && (*this)(a.max, b.max); }
  bool operator()(const InSphere& a, const InSphere& b) const
  {
    return (*this)(a.center, b.center) && (*this)(a.radius, b.radius);
  }
  bool operator()(const InHalfSpace& a, const InHalfSpace& b) const
  {
    return (*this)(a.point, b.point) && (*this)(a.normal, b.normal);
  }
  bool operator()(const InComponent& a, const InComponent& b) const { return a.component == b.component; }
  bool operator()(const InsideCurve& a, const InsideCurve& b) const
  {
    return (*this)(a.through, b.through) && a.side == b.side;
  }
  bool operator()(const AllOf& a, const AllOf& b) const { return (*this)(a.parts, b.parts); }
  bool operator()(const AnyOf& a, const AnyOf& b) const { return (*this)(a.parts, b.parts); }
  bool operator()(const NotIn& a, const NotIn& b) const { return (*this)(*a.part, *b.part); }
  bool operator()(const Grown& a, const Grown& b) const { return (*this)(*a.part, *b.part) && a.rings == b.rings; }
  bool operator()(const Selection& a, const Selection& b) const { return (*this)(a.what, b.what); }

  bool operator()(const AtVertex& a, const AtVertex& b) const { return a.vertex == b.vertex; }
  bool operator()(const AtEdge& a, const AtEdge& b) const { return a.i == b.i && a.j == b.j && (*this)(a.t, b.t); }
  bool operator()(const AtFace& a, const AtFace& b) const { return a.face == b.face && (*this)(a.weights, b.weights); }
  bool operator()(const AtNear& a, const AtNear& b) const { return (*this)(a.place, b.place); }

  bool operator()(const FixedConstraint& a, const FixedConstraint& b) const { return (*this)(a.select, b.select); }
  bool operator()(const RigidConstraint& a, const RigidConstraint& b) const { return (*this)(a.select, b.select); }
  bool operator()(const AxisRotation& a, const AxisRotation& b) const
  {
    return (*this)(a.axis, b.axis) && (*this)(a.degrees, b.degrees) && (*this)(a.center, b.center);
  }
  bool operator()(std::monostate /*a*/, std::monostate /*b*/) const { return true; }
  bool operator()(const RotationAboutFixed& a, const RotationAboutFixed& b) const { return (*this)(a.near, b.near); }
  bool operator()(const Frame& a, const Frame& b) const
  {
    return (*this)(a.origin, b.origin) && (*this)(a.x, b.x) && (*this)(a.y, b.y);
  }
  bool operator()(const FrameMotion& a, const FrameMotion& b) const
  {
    return (*this)(a.from, b.from) && (*this)(a.to, b.to) && a.turns == b.turns;
  }
  bool operator()(const VertexTargets& a, const VertexTargets& b) const { return (*this)(a.places, b.places); }
  bool operator()(const AxisAngle& a, const AxisAngle& b) const
  {
    return (*this)(a.axis, b.axis) && (*this)(a.degrees, b.degrees);
  }
  bool operator()(const HandleConstraint& a, const HandleConstraint& b) const
  {
    return (*this)(a.select, b.select) && (*this)(a.motion, b.motion) && (*this)(a.translate, b.translate) &&
           (*this)(a.rotations, b.rotations) && (*this)(a.scale, b.scale);
  }
  bool operator()(const Target& a, const Target& b) const { return (*this)(a.place, b.place); }
  bool operator()(const Move& a, const Move& b) const { return (*this)(a.shift, b.shift); }
  bool operator()(const Coordinates& a, const Coordinates& b) const
  {
    return std::ranges::equal(a.values, b.values, *this);
  }
  bool operator()(const OnPlane& a, const OnPlane& b) const
  {
    return (*this)(a.point, b.point) && (*this)(a.normal, b.normal) && (*this)(a.offset, b.offset);
  }
  bool operator()(const OnLine& a, const OnLine& b) const
  {
    return (*this)(a.point, b.point) && (*this)(a.direction, b.direction);
  }
  bool operator()(const OnMesh& a, const OnMesh& b) const { return a.path == b.path; }
  bool operator()(const PointConstraint& a, const PointConstraint& b) const
  {
    return (*this)(a.at, b.at) && (*this)(a.to, b.to) && (*this)(a.within, b.within);
  }
  bool operator()(const Exactly& /*a*/, const Exactly& /*b*/) const { return true; }
  bool operator()(const WithinBall& a, const WithinBall& b) const { return (*this)(a.radius, b.radius); }
  bool operator()(const WithinBox& a, const WithinBox& b) const { return (*this)(a.half, b.half); }
  bool operator()(const WithinSlab& a, const WithinSlab& b) const
  {
    return (*this)(a.low, b.low) && (*this)(a.high, b.high) && (*this)(a.normal, b.normal);
  }
  bool operator()(const Weighted& a, const Weighted& b) const { return (*this)(a.weight, b.weight); }
  bool operator()(const FittedPlane& /*a*/, const FittedPlane& /*b*/) const { return true; }
  bool operator()(const FittedLine& /*a*/, const FittedLine& /*b*/) const { return true; }
  bool operator()(const SlideConstraint& a, const SlideConstraint& b) const
  {
    return (*this)(a.select, b.select) && (*this)(a.on, b.on) && a.together == b.together &&
           (*this)(a.within, b.within);
  }
  bool operator()(const CoincidentConstraint& a, const CoincidentConstraint& b) const
  {
    return (*this)(a.from, b.from) && (*this)(a.to, b.to);
  }
  bool operator()(const MirrorConstraint& a, const MirrorConstraint& b) const
  {
    return (*this)(a.point, b.point) && (*this)(a.normal, b.normal) && (*this)(a.tolerance, b.tolerance) &&
           (*this)(a.select, b.select) && a.pairs == b.pairs;
  }
  bool operator()(const RelativeConstraint& a, const RelativeConstraint& b) const
  {
    return (*this)(a.from, b.from) && (*this)(a.to, b.to) && (*this)(a.offset, b.offset);
  }
};

}  // namespace

Selection randomSelection(Random& random, int depth)
{
  switch (random.integer(0, depth > 0 ? 9 : 5)) {
    case 0:
      return {randomVertices(random)};
    case 1:
      return {randomBox(random)};
    case 2:
      return {InSphere{randomVector(random), random.uniform(0.1, 2)}};
    case 3:
      return {InHalfSpace{randomVector(random), randomDirection(random)}};
    case 4:
      return {InComponent{randomId(random)}};
    case 5:
      return {randomCurve(random)};
    case 6:
      return {AllOf{randomParts(random, depth - 1)}};
    case 7:
      return {AnyOf{randomParts(random, depth - 1)}};
    case 8:
      return {Grown{std::make_shared<const Selection>(randomSelection(random, depth - 1)), random.integer(1, 4)}};
    default:
      return {NotIn{std::make_shared<const Selection>(randomSelection(random, depth - 1))}};
  }
}

ConstraintList randomConstraintList(Random& random, int count)
{
  ConstraintList list{random.integer(0, 1) == 0 ? "mm" : "", {}};
  const std::array<std::string, 5> stems{"P", "hole \"A\"", "tab\tand\nline", "Bohrung \xC3\xA4\xE2\x82\xAC",
                                         "back\\slash"};
  for (int i = 0; i < count; ++i) {
    list.constraints.push_back(
        {stems[random.integer(0, 4)] + " " + std::to_string(i), random.integer(0, 3) > 0, randomWhat(random)});
    if (i % 3 == 1) list.constraints.back().extra = {{stems[i % 5], "read by " + stems[i % 4]}, {"note", ""}};
  }
  return list;
}

testing::AssertionResult areSame(const ConstraintList& a, const ConstraintList& b)
{
  if (a.units != b.units) return testing::AssertionFailure() << "units " << a.units << " and " << b.units;
  if (a.constraints.size() != b.constraints.size())
    return testing::AssertionFailure() << a.constraints.size() << " and " << b.constraints.size() << " constraints";
  for (std::size_t i = 0; i < a.constraints.size(); ++i) {
    const Constraint& left = a.constraints[i];
    const Constraint& right = b.constraints[i];
    if (left.name != right.name || left.isEnabled != right.isEnabled || left.extra != right.extra ||
        !Same{}(left.what, right.what))
      return testing::AssertionFailure() << "constraint " << i << " (" << left.name << ") differs";
  }
  return testing::AssertionSuccess();
}

}  // namespace holdfast::test

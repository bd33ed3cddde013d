#include "support/residual_verifier.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "support/plain_constraints.h"
#include "support/plain_motion.h"
#include "support/plain_selection.h"

namespace holdfast::test {
namespace {

using Json = nlohmann::json;
using Real = long double;
using Place = PlainPlace;
using Terms = std::vector<std::pair<long, Real>>;

Place placeOf(const PlainMesh& mesh, const Terms& terms)
{
  Place place{};
  for (const auto& [vertex, weight] : terms)
    for (std::size_t k = 0; k < 3; ++k) place[k] += weight * mesh.positions.at(vertex)[k];
  return place;
}

double distance(const Place& a, const Place& b)
{
  return static_cast<double>(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
}

using Arm = Eigen::Matrix<Real, 3, 1>;

Arm armOf(const Place& place)
{
  return {place[0], place[1], place[2]};
}

/// The part of `arm` across a unit vector.
Arm partAcross(const Arm& arm, const Arm& axis)
{
  return arm - axis.dot(arm) * axis;
}

/// How far a place is from a plane or a line of a file that leads through `through` unless it says otherwise.
double distanceFrom(const Json& on, const Place& through, const Place& place)
{
  const Json& guide = on.begin().value();
  const Arm arm = armOf(place) - armOf(guide.contains("point") ? guide.at("point").get<Place>() : through);
  const auto direction = [&](const char* key) { return armOf(guide.at(key).get<Place>()).normalized(); };
  if (on.contains("line")) return static_cast<double>(partAcross(arm, direction("direction")).norm());
  const Real offset = guide.value("offset", 0.0);
  return static_cast<double>(std::abs(direction("normal").dot(arm) - offset));
}

/// The longest of the arms from the first place, across a unit vector or 0.
Arm longestArm(const std::vector<Place>& places, const Arm& axis)
{
  Arm longest = Arm::Zero();
  for (const Place& place : places)
    if (const Arm arm = partAcross(armOf(place) - armOf(places.front()), axis); arm.norm() > longest.norm())
      longest = arm;
  return longest;
}

/// The plane or the line, as in a file, that three or two of the places lie on and the others ought to.
Json guideThrough(const std::vector<Place>& places, bool isPlane)
{
  const auto json = [](const Arm& arm) { return Place{arm[0], arm[1], arm[2]}; };
  const Arm axis = longestArm(places, Arm::Zero()).normalized();
  if (!isPlane) return {{"line", {{"point", places.front()}, {"direction", json(axis)}}}};
  const Arm normal = axis.cross(longestArm(places, axis).normalized());
  return {{"plane", {{"point", places.front()}, {"normal", json(normal)}}}};
}

/// One run of `verify`.
class Verifier {
 public:
  /// `fixed` are the vertices that handles may turn about. Paths of other meshes begin in `folder`.
  Verifier(const PlainMesh& rest, const PlainMesh& written, std::vector<long> fixed, std::filesystem::path folder)
      : rest_(rest), written_(written), fixed_(std::move(fixed)), folder_(std::move(folder))
  {
  }

  void add(const Json& constraint)
  {
    name_ = constraint.at("name");
    const std::string type = constraint.at("type");
    if (type == "fixed")
      for (const long v : verticesOfPlain(constraint, rest_)) measurePin(v, rest_.positions[v]);
    else if (type == "handle")
      addHandle(constraint);
    else if (type == "point")
      addPoint(constraint);
    else if (type == "rigid")
      addRigid(selectPlain(constraint.at("select"), rest_));
    else if (type == "relative")
      addRelative(constraint);
    else if (type == "coincident")
      measure(differenceOf(constraint), {});
    else if (type == "slide")
      addSlide(constraint);
    else if (type == "mirror")
      addMirror(constraint);
    else
      throw std::runtime_error("not to be verified: constraints of type " + type);
  }

  [[nodiscard]] const Verification& result() const { return result_; }

 private:
  void addHandle(const Json& handle)
  {
    for (const auto& [vertex, place] : placesOfHandle(handle, fixed_, rest_))
      if (isTurned(handle)) {
        measure({{vertex, 1}}, place);
        pinned_.insert(vertex);
      } else {
        measurePin(vertex,
                   {static_cast<double>(place[0]), static_cast<double>(place[1]), static_cast<double>(place[2])});
      }
  }

  void addRigid(const std::vector<long>& vertices)
  {
    for (const long v : vertices)
      for (const long w : vertices)
        if (v < w) measureLength({{v, 1}, {w, -1}});
  }

  [[nodiscard]] Terms differenceOf(const Json& ends) const
  {
    Terms terms = termsOf(ends.at("from"));
    for (const auto& [vertex, weight] : termsOf(ends.at("to"))) terms.emplace_back(vertex, -weight);
    return terms;
  }

  void addSlide(const Json& slide)
  {
    const std::vector<long> vertices = selectPlain(slide.at("select"), rest_);
    std::vector<Place> places;
    for (const long v : vertices) places.push_back(placeOf(written_, {{v, 1}}));
    const Json& on = slide.at("on");
    if (on.begin().value() == "fit") {
      const Json found = guideThrough(places, on.contains("plane"));
      for (const Place& place : places) note(distanceFrom(found, {}, place));
      return;
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!slide.value("together", false)) {
        note(missedOn(slide, placeOf(rest_, {{vertices[k], 1}}), places[k]));
        continue;
      }
      // Of a plane or a line that may shift: as far from where the first vertex went as they are at rest, or not at
      // all.
      Json shifted = on;
      Json& guide = shifted.begin().value();
      guide.erase("offset");
      Place through = places.front();
      if (!guide.contains("point")) {
        const Arm arm = armOf(placeOf(rest_, {{vertices[k], 1}})) - armOf(placeOf(rest_, {{vertices.front(), 1}}));
        for (std::size_t i = 0; i < 3; ++i) through[i] += arm[i];
      }
      guide["point"] = through;
      note(distanceFrom(shifted, {}, places[k]));
    }
  }

  /// Every pair of vertices of which each is nearest to the image of the other at rest: as far apart as they are, where
  /// they went, from being images of one another.
  void addMirror(const Json& mirror)
  {
    const Arm normal = armOf(mirror.at("plane").at("normal").get<Place>()).normalized();
    const Arm point = armOf(mirror.at("plane").at("point").get<Place>());
    const auto image = [&](const Arm& place) -> Arm { return place - 2 * normal.dot(place - point) * normal; };
    const auto noteMissed = [&](long v, long w) {
      note(
          static_cast<double>((image(armOf(placeOf(written_, {{v, 1}}))) - armOf(placeOf(written_, {{w, 1}}))).norm()));
    };
    if (mirror.contains("pairs")) {
      for (const Json& pair : mirror.at("pairs")) noteMissed(pair.at(0).get<long>(), pair.at(1).get<long>());
      return;
    }
    const double tolerance = mirror.value("tolerance", 1e-6 * diagonalOf(rest_));
    const auto partnerOf = [&](long v) {
      const Arm wanted = image(armOf(placeOf(rest_, {{v, 1}})));
      long nearest = -1;
      Real least = tolerance;
      for (long w = 0; w < static_cast<long>(rest_.positions.size()); ++w)
        if (const Real distance = (armOf(placeOf(rest_, {{w, 1}})) - wanted).norm(); distance <= least) {
          nearest = distance < least || nearest < 0 ? w : nearest;
          least = distance;
        }
      return nearest;
    };
    const Json everything{{"halfspace", {{"point", {0, 0, 0}}, {"normal", {0, 0, 0}}}}};
    for (const long v : selectPlain(mirror.value("select", everything), rest_)) {
      const long partner = partnerOf(v);
      if (partner >= 0 && partnerOf(partner) == v) noteMissed(v, partner);
    }
  }

  void addRelative(const Json& relative)
  {
    const Terms terms = differenceOf(relative);
    if (relative.contains("offset"))
      measure(terms, relative.at("offset").get<Place>());
    else
      measureLength(terms);
  }

  void addPoint(const Json& point)
  {
    const Terms terms = termsOf(point.at("at"));
    if (point.contains("on")) return note(missedOn(point, placeOf(rest_, terms), placeOf(written_, terms)));
    if (point.contains("within")) return note(beyond(point.at("within"), offsetOf(point, terms)));
    if (point.contains("weight")) return note(0);
    if (hasFreeCoordinates(point)) return measureCoordinates(terms, point.at("target"));
    if (terms.size() == 1) return measurePin(terms[0].first, pinTarget(point, rest_.positions.at(terms[0].first)));
    if (point.contains("target")) return measure(terms, point.at("target").get<Place>());
    Place target = placeOf(rest_, terms);
    const Place move = point.at("move").get<Place>();
    for (std::size_t k = 0; k < 3; ++k) target[k] += move[k];
    measure(terms, target);
  }

  /// How far `place` is from what a constraint is on, or farther than within the ball of its tolerance.
  [[nodiscard]] double missedOn(const Json& constraint, const Place& rest, const Place& place)
  {
    if (constraint.contains("weight")) return 0;
    const Json& on = constraint.at("on");
    const double distance =
        on.contains("mesh") ? distanceFromMesh(on.at("mesh"), place) : distanceFrom(on, rest, place);
    if (!constraint.contains("within")) return distance;
    return std::max(0.0, distance - constraint.at("within").at("ball").get<double>());
  }

  [[nodiscard]] double distanceFromMesh(const std::string& path, const Place& place)
  {
    if (!meshes_.contains(path)) meshes_.emplace(path, readPlainMesh(folder_ / path));
    const PlainMesh& mesh = meshes_.at(path);
    const auto [corners, weights] = nearestPlain(
        mesh, {static_cast<double>(place[0]), static_cast<double>(place[1]), static_cast<double>(place[2])});
    return distance(place,
                    placeOf(mesh, {{corners[0], weights[0]}, {corners[1], weights[1]}, {corners[2], weights[2]}}));
  }

  /// From its target to where a point went.
  [[nodiscard]] Arm offsetOf(const Json& point, const Terms& terms) const
  {
    const Arm went = armOf(placeOf(written_, terms));
    if (point.contains("target")) return went - armOf(point.at("target").get<Place>());
    return went - armOf(placeOf(rest_, terms)) - armOf(point.at("move").get<Place>());
  }

  /// How far an offset is from what a tolerance allows.
  static double beyond(const Json& within, const Arm& offset)
  {
    const auto above = [](Real value, const Json& most) -> Real {
      return most.is_null() ? 0 : std::max<Real>(0, value - most.get<double>());
    };
    if (within.contains("ball")) return static_cast<double>(above(offset.norm(), within.at("ball")));
    Real most = 0;
    if (within.contains("box"))
      for (int k = 0; k < 3; ++k) most = std::max(most, above(std::abs(offset[k]), within.at("box").at(k)));
    if (within.contains("slab")) {
      const Real along = armOf(within.at("normal").get<Place>()).normalized().dot(offset);
      const Json& low = within.at("slab").at(0);
      most = above(along, within.at("slab").at(1));
      if (!low.is_null()) most = std::max<Real>(most, low.get<double>() - along);
    }
    return static_cast<double>(most);
  }

  static bool hasFreeCoordinates(const Json& point)
  {
    return point.contains("target") &&
           std::ranges::any_of(point.at("target"), [](const Json& c) { return c.is_null(); });
  }

  /// Those of a vertex are copied bit for bit.
  void measureCoordinates(const Terms& terms, const Json& target)
  {
    const Place place = placeOf(written_, terms);
    for (std::size_t k = 0; k < 3; ++k) {
      if (target.at(k).is_null()) continue;
      const auto asked = target.at(k).get<double>();
      note(static_cast<double>(std::abs(place[k] - asked)));
      if (terms.size() == 1 && written_.positions.at(terms[0].first)[k] != asked) result_.inexact.insert(name_);
    }
  }

  static PlainPoint pinTarget(const Json& point, PlainPoint place)
  {
    if (point.contains("target")) return point.at("target").get<PlainPoint>();
    for (std::size_t k = 0; k < 3; ++k) place[k] += point.at("move").at(k).get<double>();
    return place;
  }

  [[nodiscard]] Terms termsOf(const Json& at) const
  {
    if (at.contains("vertex")) return {{at.at("vertex").get<long>(), 1}};
    if (at.contains("edge")) {
      const Real t = at.at("t").get<double>();
      return {{at.at("edge").at(0).get<long>(), t}, {at.at("edge").at(1).get<long>(), 1 - t}};
    }
    if (at.contains("near")) {
      const auto [corners, weights] = nearestPlain(rest_, at.at("near").get<PlainPoint>());
      return {{corners[0], weights[0]}, {corners[1], weights[1]}, {corners[2], weights[2]}};
    }
    Terms terms;
    const std::vector<long>& corners = rest_.faces.at(at.at("face").get<std::size_t>());
    for (std::size_t k = 0; k < corners.size(); ++k)
      terms.emplace_back(corners[k], at.at("weights").at(k).get<double>());
    return terms;
  }

  /// A pin whose target is one of doubles: the earliest of each vertex is copied bit for bit.
  void measurePin(long vertex, const PlainPoint& target)
  {
    measure({{vertex, 1}}, {target[0], target[1], target[2]});
    if (pinned_.insert(vertex).second && written_.positions.at(vertex) != target) result_.inexact.insert(name_);
  }

  void measure(const Terms& terms, const Place& target) { note(distance(placeOf(written_, terms), target)); }

  /// Of a vector that may turn.
  void measureLength(const Terms& terms)
  {
    note(std::abs(distance(placeOf(written_, terms), {}) - distance(placeOf(rest_, terms), {})));
  }

  void note(double residual)
  {
    ++result_.points;
    if (residual <= result_.largest || std::isnan(result_.largest)) return;
    result_.largest = residual;
    result_.worst = name_;
  }

  const PlainMesh& rest_;
  const PlainMesh& written_;
  std::vector<long> fixed_;
  std::filesystem::path folder_;
  std::map<std::string, PlainMesh> meshes_;
  std::string name_;
  std::set<long> pinned_;
  Verification result_;
};

std::vector<long> fixedVertices(const Json& constraints, const PlainMesh& rest)
{
  std::set<long> fixed;
  for (const Json& constraint : constraints)
    if (constraint.value("enabled", true) && constraint.at("type") == "fixed")
      for (const long v : verticesOfPlain(constraint, rest)) fixed.insert(v);
  return {fixed.begin(), fixed.end()};
}

}  // namespace

Verification verify(const PlainMesh& rest, const PlainMesh& written, const std::filesystem::path& constraints,
                    const std::set<std::string>& leftOut)
{
  const Json list = readPlainConstraints(constraints);
  Verifier verifier(rest, written, fixedVertices(list, rest), constraints.parent_path());
  for (const Json& constraint : list)
    if (constraint.value("enabled", true) && !leftOut.contains(constraint.at("name"))) verifier.add(constraint);
  return verifier.result();
}

testing::AssertionResult meetsConstraints(const std::filesystem::path& rest, const std::filesystem::path& written,
                                          const std::filesystem::path& constraints,
                                          const std::set<std::string>& leftOut)
{
  const PlainMesh restMesh = readPlainMesh(rest);
  const PlainMesh writtenMesh = readPlainMesh(written);
  if (restMesh.positions.size() != writtenMesh.positions.size() || restMesh.faces != writtenMesh.faces)
    return testing::AssertionFailure() << written << " has other vertices or faces than " << rest;
  const Verification found = verify(restMesh, writtenMesh, constraints, leftOut);
  const double relative = found.largest / diagonalOf(restMesh);
  const auto measured = testing::Message() << found.points << " points, \"" << found.worst << "\" is missed by "
                                           << relative << " of the diagonal";
  if (!(relative <= kPromisedResidual)) return testing::AssertionFailure() << measured;
  if (!found.inexact.empty())
    return testing::AssertionFailure() << measured << "; not copied: \"" << *found.inexact.begin() << '"';
  if (found.points == 0) return testing::AssertionFailure() << "nothing was measured";
  return testing::AssertionSuccess() << measured;
}

}  // namespace holdfast::test

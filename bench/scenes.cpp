#include "bench/scenes.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <holdfast/geometry/bounding_box.h>

#include "bench/random.h"

namespace holdfast::bench {
namespace {

constexpr double kEnd = 0.05;    // of the length
constexpr double kShift = 0.01;  // of the length

Selection beyond(double x, double normal)
{
  return {InHalfSpace{Vector3(x, 0, 0), Vector3(normal, 0, 0)}};
}

ConstraintList ends(const Mesh& mesh)
{
  const Eigen::AlignedBox3d box = boundingBox(mesh.positions);
  const double length = box.sizes().x();
  ConstraintList list;
  list.constraints.push_back({"fixed end", true, FixedConstraint{beyond(box.min().x() + kEnd * length, -1)}});
  const HandleConstraint handle{
      beyond(box.max().x() - kEnd * length, 1), AxisRotation{Vector3(1, 2, 3), 1, {}}, Vector3(0, 0.2 * length, 0), {}};
  list.constraints.push_back({"handle", true, handle});
  return list;
}

Constraint point(Index number, SurfaceLocation at, const Vector3& shift)
{
  PointConstraint point;
  point.at = std::move(at);
  point.to = Move{shift};
  Constraint result;
  result.name = "P" + std::to_string(number);
  result.what = std::move(point);
  return result;
}

/// Tells whether each vertex lies at an end, or as near to one as no point may.
std::vector<bool> nearEnds(const Mesh& mesh)
{
  const Eigen::AlignedBox3d box = boundingBox(mesh.positions);
  const double margin = 2 * kEnd * box.sizes().x();
  std::vector<bool> isNear(static_cast<std::size_t>(mesh.vertexCount()));
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    isNear[v] = mesh.positions(v, 0) < box.min().x() + margin || mesh.positions(v, 0) > box.max().x() - margin;
  return isNear;
}

/// `count` faces in random order that share no vertex with one another or with an end.
std::vector<Index> isolatedFaces(const Mesh& mesh, Index count, Random& random)
{
  std::vector<bool> isTaken = nearEnds(mesh);
  std::vector<Index> chosen;
  for (const Index face : random.permutation(mesh.faces.size())) {
    if (static_cast<Index>(chosen.size()) == count) return chosen;
    const auto corners = mesh.faces[face];
    if (std::any_of(corners.begin(), corners.end(), [&](Index v) { return isTaken[v]; })) continue;
    for (const Index v : corners) isTaken[v] = true;
    chosen.push_back(face);
  }
  throw std::runtime_error("no room for " + std::to_string(count) + " isolated points on this mesh");
}

AtFace insideFace(Index face, Random& random)
{
  const double a = random.uniform(0.1, 0.45);
  const double b = random.uniform(0.1, 0.45);
  return {face, {a, b, 1 - a - b}};
}

/// The ends, and isolated points: `location` makes them of the place in the list and of a face.
template <class Location>
ConstraintList isolatedPoints(const Mesh& mesh, Index count, Random random, const Location& location)
{
  ConstraintList list = ends(mesh);
  const double shift = kShift * boundingBox(mesh.positions).sizes().x();
  const auto component = [&] { return shift * random.uniform(-1, 1); };
  for (const Index face : isolatedFaces(mesh, count, random)) {
    const Index number = static_cast<Index>(list.constraints.size() - kEnds);
    SurfaceLocation at = location(number, face, random);
    list.constraints.push_back(point(number, std::move(at), {component(), component(), component()}));
  }
  return list;
}

/// The `count` faces, away from the ends, whose first corners are nearest to the place of the first of them.
std::vector<Index> patch(const Mesh& mesh, Index count)
{
  const std::vector<bool> isNearEnd = nearEnds(mesh);
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    if (std::ranges::none_of(mesh.faces[f], [&](Index v) { return isNearEnd[v]; })) faces.push_back(f);
  const Vector3 center = mesh.positions.row(mesh.faces[faces.front()][0]);
  std::stable_sort(faces.begin(), faces.end(), [&](Index f, Index g) {
    const auto distance = [&](Index face) {
      return (mesh.positions.row(mesh.faces[face][0]).transpose() - center).squaredNorm();
    };
    return distance(f) < distance(g);
  });
  faces.resize(std::min(faces.size(), static_cast<std::size_t>(count)));
  return faces;
}

}  // namespace

ConstraintList scene(const Mesh& mesh, std::uint32_t set)
{
  const Index each = std::min<Index>(300, mesh.vertexCount() / 100);
  return isolatedPoints(mesh, 3 * each, Random(2 + set), [&](Index number, Index face, Random& random) {
    const auto corners = mesh.faces[face];
    if (number < each) return SurfaceLocation(AtVertex{corners[0]});
    if (number < 2 * each) return SurfaceLocation(AtEdge{corners[0], corners[1], random.uniform(0.1, 0.9)});
    return SurfaceLocation(insideFace(face, random));
  });
}

ConstraintList isolatedFacePoints(const Mesh& mesh, Index count)
{
  return isolatedPoints(mesh, count, Random(2),
                        [](Index, Index face, Random& random) { return insideFace(face, random); });
}

ConstraintList overlappingFacePoints(const Mesh& mesh, Index count, Index among)
{
  Random random(2);
  ConstraintList list = ends(mesh);
  const std::vector<Index> faces = patch(mesh, among);
  const std::vector<Index> order = random.permutation(static_cast<Index>(faces.size()));
  // A shift that all share: they do not contradict one another where some depend on others.
  const Vector3 shift = kShift * boundingBox(mesh.positions).sizes().x() * Vector3::UnitY();
  for (Index k = 0; k < count; ++k)
    list.constraints.push_back(point(k, insideFace(faces.at(order.at(k)), random), shift));
  return list;
}

void turnHandle(ConstraintList& list, double degrees)
{
  std::get<HandleConstraint>(list.constraints[1].what).motion = AxisRotation{Vector3(1, 2, 3), degrees, {}};
}

void moveHandle(ConstraintList& list, double by)
{
  std::get<HandleConstraint>(list.constraints[1].what).translate.x() += by;
}

}  // namespace holdfast::bench

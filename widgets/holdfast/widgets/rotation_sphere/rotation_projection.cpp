#include "holdfast/widgets/rotation_sphere/rotation_projection.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>

#include <Eigen/Eigenvalues>

#include <holdfast/deform/deform_details.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

// A label names so many constraints and counts the others.
constexpr std::size_t kNamesInLabel = 3;

// Among directions that say equally little, those of coordinate axes, z before y before x, are not shown.
constexpr double kPreference = 1e-9;

// The frame stays as long as it hides no more than this share beyond what the best one hides.
constexpr double kHiddenShare = 0.02;

// The sine of the angle between two axes: about rounding.
constexpr double kSameAxis = 1e-9;

constexpr double kArcStep = 2 * std::numbers::pi / 180;

/// The shadow of a unit quaternion.
Vector3 shadow(const SphereFrame& frame, const Eigen::Quaterniond& rotation)
{
  return {rotation.vec().dot(frame.axes.col(0)), rotation.vec().dot(frame.axes.col(1)), rotation.w()};
}

std::string labelOf(const std::vector<std::string>& names)
{
  std::string label;
  for (std::size_t k = 0; k < std::min(names.size(), kNamesInLabel); ++k) label += (k == 0 ? "" : ", ") + names[k];
  if (names.size() > kNamesInLabel) label += " +" + std::to_string(names.size() - kNamesInLabel);
  return label;
}

int arcSteps(double halfAngle)
{
  return std::max(1, static_cast<int>(std::ceil(halfAngle / kArcStep)));
}

/// The right-handed frame that does not show `hidden`; x of the picture is the coordinate axis that it shows best.
SphereFrame frameWithout(const Vector3& hidden)
{
  Index shown = 0;
  hidden.cwiseAbs().minCoeff(&shown);
  SphereFrame frame;
  const Vector3 x = (Vector3::Unit(shown) - hidden[shown] * hidden).normalized();
  frame.axes << x, hidden.cross(x), hidden;
  return frame;
}

std::uint64_t cellOf(const Vector3& place, double side)
{
  constexpr double kMiddle = 1 << 20;
  std::uint64_t cell = 0;
  for (const double coordinate : place)
    cell = cell << 21U |
           static_cast<std::uint64_t>(std::clamp(std::floor(coordinate / side) + kMiddle, 1.0, 2 * kMiddle - 1));
  return cell;
}

std::vector<Index> firstOfCells(const std::vector<Vector3>& places, const std::vector<Index>& among, double side)
{
  std::vector<std::pair<std::uint64_t, Index>> cells;
  cells.reserve(among.size());
  for (const Index place : among) cells.emplace_back(cellOf(places[place], side), place);
  std::sort(cells.begin(), cells.end());
  const auto isSame = [](const auto& a, const auto& b) { return a.first == b.first; };
  cells.erase(std::unique(cells.begin(), cells.end(), isSame), cells.end());
  std::vector<Index> first;
  first.reserve(cells.size());
  for (const auto& [cell, place] : cells) first.push_back(place);
  std::sort(first.begin(), first.end());
  return first;
}

// In radii: points that are nearer to one another than a pixel of a sphere that is shown several times as large as the
// panel hide one another.
constexpr double kFinestCell = 1.0 / 4096;

}  // namespace

std::vector<BoundaryRotation> boundaryRotations(const DeformResult& deformation)
{
  std::vector<BoundaryRotation> boundary;
  std::vector<std::vector<std::string>> names;
  std::map<std::array<double, 3>, std::size_t> placeOf;
  std::set<Index> named;
  for (const GivenRotation& given : deformation.details->system.rotations) {
    const auto [found, isNew] = placeOf.try_emplace({given.q.x(), given.q.y(), given.q.z()}, boundary.size());
    if (isNew) {
      boundary.push_back({given.q, ""});
      names.emplace_back();
    }
    if (named.insert(given.constraint).second)
      names[found->second].push_back(deformation.report.constraints[given.constraint].name);
  }
  for (std::size_t k = 0; k < boundary.size(); ++k) boundary[k].label = labelOf(names[k]);
  return boundary;
}

bool hasRotation(const std::vector<BoundaryRotation>& boundary)
{
  return std::any_of(boundary.begin(), boundary.end(),
                     [](const BoundaryRotation& value) { return !value.q.isZero(0); });
}

SphereFrame sphereFrame(const std::vector<BoundaryRotation>& boundary, const SphereFrame& before)
{
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const BoundaryRotation& value : boundary) spread += value.q * value.q.transpose();
  const double whole = spread.trace();
  if (whole == 0) return before;
  spread += kPreference * whole * Vector3(3, 2, 1).asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> ascending(spread);
  const Vector3 hiddenBefore = before.axes.col(2);
  if (hiddenBefore.dot(spread * hiddenBefore) <= ascending.eigenvalues()[0] + kHiddenShare * whole) return before;
  Vector3 hidden = ascending.eigenvectors().col(0);
  Index largest = 0;
  hidden.cwiseAbs().maxCoeff(&largest);
  // Seen from where the hidden axis points to the eye, as coordinate planes are drawn.
  if (hidden[largest] < 0) hidden = -hidden;
  return frameWithout(hidden);
}

Vector3 spherePlace(const SphereFrame& frame, const Vector3& q)
{
  const double lift = 1 + kTurnRise * std::max(0.0, q.norm() / std::numbers::pi - 1);
  return lift * shadow(frame, rotationExp(q));
}

std::vector<Vector3> sphereArc(const SphereFrame& frame, const Vector3& from, const Vector3& to)
{
  std::vector<Vector3> places;
  const bool areAlongOneAxis = from.cross(to).norm() <= kSameAxis * from.norm() * to.norm();
  if (areAlongOneAxis || std::max(from.norm(), to.norm()) > std::numbers::pi) {
    const int steps = arcSteps((to - from).norm());
    for (int k = 0; k <= steps; ++k) places.push_back(spherePlace(frame, from + k / double(steps) * (to - from)));
    return places;
  }
  const Eigen::Vector4d a = rotationExp(from).coeffs();
  const Eigen::Vector4d b = rotationExp(to).coeffs();
  const double angle = 2 * std::atan2((b - a).norm(), (b + a).norm());
  const int steps = arcSteps(angle);
  for (int k = 0; k <= steps; ++k) {
    const double t = k / double(steps);
    const Eigen::Vector4d blend = std::sin((1 - t) * angle) * a + std::sin(t * angle) * b;
    places.push_back(shadow(frame, Eigen::Quaterniond(Eigen::Vector4d(blend.normalized()))));
  }
  return places;
}

std::vector<Index> thinnedPlaces(const std::vector<Vector3>& places, Index most, double finest)
{
  std::vector<Index> chosen(places.size());
  std::iota(chosen.begin(), chosen.end(), Index{0});
  for (double side = finest; static_cast<Index>(chosen.size()) > most; side *= 2)
    chosen = firstOfCells(places, chosen, side);
  return chosen;
}

SphereVertices sphereVertices(const Model& model)
{
  const SolverMesh& mesh = model.solverMesh;
  SphereVertices vertices;
  std::vector<Index> pointOfUnknown(mesh.unknownCount(), -1);
  for (Index u = 0; u < mesh.unknownCount(); ++u) {
    if (mesh.componentOf[u] < 0) continue;
    pointOfUnknown[u] = static_cast<Index>(vertices.vertexOf.size());
    vertices.vertexOf.push_back(mesh.weld.firstVertexOf[u]);
    vertices.unknownOf.push_back(u);
  }
  for (Index v = 0; v < model.mesh.vertexCount(); ++v)
    vertices.pointOf.push_back(pointOfUnknown[mesh.weld.unknownOf[v]]);
  return vertices;
}

std::shared_ptr<const PlacedRotations> placeRotations(const Model& model, const DeformResult& deformation,
                                                      const std::shared_ptr<const PlacedRotations>& before)
{
  auto placed = std::make_shared<PlacedRotations>();
  placed->vertices = before ? before->vertices : std::make_shared<const SphereVertices>(sphereVertices(model));
  placed->boundary = boundaryRotations(deformation);
  placed->frame = sphereFrame(placed->boundary, before ? before->frame : SphereFrame{});
  for (const Index unknown : placed->vertices->unknownOf)
    placed->places.push_back(spherePlace(placed->frame, deformation.rotations.row(unknown).transpose()));
  placed->drawn = thinnedPlaces(placed->places, kMostSpherePoints, kFinestCell);
  return placed;
}

}  // namespace holdfast

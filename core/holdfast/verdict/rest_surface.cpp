#include "holdfast/verdict/rest_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <holdfast/check/mesh_check.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/mesh/edges.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// Six times a volume, in cubes of diagonals: parts that enclose less are flat within rounding.
constexpr double kNoVolume = 1e-12;

float inverseOf(double square)
{
  return square < kNoLength * kNoLength ? 0.0F : static_cast<float>(1 / square);
}

/// An angle below a degree: which side it shows is decided by less than can be seen.
bool isNeedleShape(const TriangleShape& shape)
{
  std::array<double, 3> squares{};
  for (int k = 0; k < 3; ++k) squares[k] = shape.sides[k].squaredNorm();
  std::sort(squares.begin(), squares.end());
  if (squares[0] < kNoLength * kNoLength) return true;
  return shape.area.norm() < std::sin(kNeedleDegrees * kDegree) * std::sqrt(squares[1] * squares[2]);
}

/// The cosine of normals above which a hinge that is bent by `restDegrees` at rest is certainly not folded.
float flatCosineFor(double restDegrees)
{
  const double degrees = kFoldDegrees - std::abs(restDegrees);
  return degrees <= 0 ? 2.0F : static_cast<float>(std::cos(degrees * kDegree));
}

/// The side of `triangle` that it shares with `other`.
int sharedSide(const Triangle& triangle, const Triangle& other)
{
  const auto isIn = [&](int vertex) { return std::ranges::find(other, vertex) != other.end(); };
  int side = 0;
  while (side < 2 && !(isIn(triangle[side]) && isIn(triangle[side + 1]))) ++side;
  return side;
}

}  // namespace

double bendDegrees(const RestSurface& surface, const Hinge& hinge, const Positions& positions)
{
  const Triangle& first = surface.triangles[hinge.first];
  const Triangle& second = surface.triangles[hinge.second];
  const TriangleShape a = shapeOf(first, positions, surface.perUnit);
  const TriangleShape b = shapeOf(second, positions, surface.perUnit);
  const Vector3 edge = a.sides[sharedSide(first, second)];
  const double sine = edge.dot(a.area.cross(b.area));
  return std::atan2(hinge.side * sine, hinge.side * edge.norm() * a.area.dot(b.area)) / kDegree;
}

RestSurface::RestSurface(const SolverMesh& mesh) : triangles(mesh.triangles), perUnit(1 / mesh.diagonal)
{
  center = (mesh.rest.colwise().minCoeff() / 2 + mesh.rest.colwise().maxCoeff() / 2).transpose();
  partOf.reserve(triangles.size());
  for (const Triangle& triangle : triangles) partOf.push_back(mesh.componentOf[triangle[0]]);
  const std::vector<bool> isNeedle = measureTriangles(mesh.rest);
  const std::vector<bool> isOpen = findHinges(static_cast<std::size_t>(mesh.componentCount));
  measureHinges(mesh.rest, isNeedle);
  measureVolumes(mesh.rest, isOpen);
  for (Triangle& triangle : triangles)
    for (int& corner : triangle) corner = mesh.weld.firstVertexOf[corner];
  vertexOfPart.resize(volumes.size());
  for (std::size_t t = triangles.size(); t-- > 0;) vertexOfPart[partOf[t]] = triangles[t][0];
}

/// Returns which of them are needles.
std::vector<bool> RestSurface::measureTriangles(const Positions& rest)
{
  std::vector<bool> isNeedle;
  for (const Triangle& triangle : triangles) {
    const TriangleShape shape = shapeOf(triangle, rest, perUnit);
    isNeedle.push_back(isNeedleShape(shape));
    inverseSquares.push_back({inverseOf(shape.sides[0].squaredNorm()), inverseOf(shape.sides[1].squaredNorm()),
                              inverseOf(shape.sides[2].squaredNorm()),
                              isNeedle.back() ? 0.0F : static_cast<float>(1 / shape.area.squaredNorm())});
  }
  return isNeedle;
}

/// Returns which parts are open, or have no inside because their triangles disagree on which side is out.
std::vector<bool> RestSurface::findHinges(std::size_t parts)
{
  std::vector<bool> isOpen(parts, false);
  ownSides.assign(triangles.size(), 0);
  forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> edge) {
    const bool isPair = edge.size() == 2;
    const bool doAgree = isPair && edge[0].isForward != edge[1].isForward;
    ownSides[edge[0].triangle] |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(edge[0].side));
    if (isPair) hinges.push_back({edge[0].triangle, edge[1].triangle, doAgree ? 1.0F : -1.0F, 0, -2});
    if (!doAgree) isOpen[partOf[edge[0].triangle]] = true;
  });
  return isOpen;
}

void RestSurface::measureHinges(const Positions& rest, const std::vector<bool>& isNeedle)
{
  parallelBlocks(static_cast<Index>(hinges.size()), [&](Index h) {
    Hinge& hinge = hinges[h];
    if (isNeedle[hinge.first] || isNeedle[hinge.second]) return;
    hinge.restDegrees = static_cast<float>(bendDegrees(*this, hinge, rest));
    hinge.flatCosine = flatCosineFor(hinge.restDegrees);
  });
}

void RestSurface::measureVolumes(const Positions& rest, const std::vector<bool>& isOpen)
{
  volumes.assign(isOpen.size(), 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vector3 corner = perUnit * (rest.row(triangles[t][0]).transpose() - center);
    volumes[partOf[t]] += corner.dot(shapeOf(triangles[t], rest, perUnit).area);
  }
  for (std::size_t part = 0; part < volumes.size(); ++part)
    if (isOpen[part] || std::abs(volumes[part]) < kNoVolume) volumes[part] = 0;
}

}  // namespace holdfast

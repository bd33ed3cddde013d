#include "holdfast/check/mesh_check.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <holdfast/mesh/edges.h>
#include <holdfast/mesh/near_pairs.h>
#include <holdfast/mesh/stated_places.h>
#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// A share of the diagonal: far below any detail of a part, and above what writing with six digits loses.
constexpr double kNearlyCoincident = 1e-6;

// A share of the largest coordinate: two places of single precision, which a corner may be off by each.
constexpr double kRoundedToFloats = 0x1p-22;

/// Adds a finding, unless it is about nothing.
void add(Findings& findings, const char* kind, const char* idsOf, std::vector<Index> ids, const CountedWords& words)
{
  if (!ids.empty()) findings.push_back(makeFinding(kind, idsOf, std::move(ids), words));
}

std::vector<Index> fileVertices(const SolverMesh& mesh, const std::vector<Index>& unknowns)
{
  std::vector<Index> result;
  result.reserve(unknowns.size());
  for (const Index u : unknowns) result.push_back(mesh.weld.firstVertexOf[u]);
  return result;
}

void addComponents(Findings& findings, const SolverMesh& mesh)
{
  if (mesh.componentCount < 2) return;
  std::vector<Index> first(static_cast<std::size_t>(mesh.componentCount), -1);
  for (Index u = 0; u < mesh.unknownCount(); ++u)
    if (const Index c = mesh.componentOf[u]; c >= 0 && first[c] < 0) first[c] = u;
  add(findings, "components", "vertex", fileVertices(mesh, first),
      {{}, "connected parts (a vertex of each is named); a part without a constraint stays at rest"});
}

bool isWithoutPlace(const SolverMesh& mesh, Index vertex)
{
  return std::ranges::binary_search(mesh.withoutPlace, vertex);
}

/// Faces and vertices of the file that are no part of the surface.
void addStated(Findings& findings, const Mesh& mesh, const SolverMesh& solverMesh)
{
  add(findings, "faces_of_few_corners", "face", facesWithoutSurface(mesh.faces),
      {"face has fewer than three corners; it stays in the file and holds nothing together",
       "faces have fewer than three corners; they stay in the file and hold nothing together"});
  add(findings, "non_finite_unused_vertices", "vertex", solverMesh.withoutPlace,
      {"vertex that no face uses has a coordinate that is not a finite number; it stays as the file has it, and no "
       "constraint can hold it",
       "vertices that no face uses have a coordinate that is not a finite number; they stay as the file has them, and "
       "no constraint can hold them"});
}

void addUnreferenced(Findings& findings, const SolverMesh& mesh)
{
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < mesh.weld.unknownOf.size(); ++v)
    if (mesh.componentOf[mesh.weld.unknownOf[v]] < 0 && !isWithoutPlace(mesh, static_cast<Index>(v)))
      vertices.push_back(static_cast<Index>(v));
  add(findings, "unreferenced_vertices", "vertex", std::move(vertices),
      {"vertex that no face uses; it stays where it is unless pinned",
       "vertices that no face uses; they stay where they are unless pinned"});
}

/// Vertices that lie on others, apart by whether the solver ties them.
void addCoincident(Findings& findings, const Mesh& mesh, const SolverMesh& solverMesh)
{
  const std::vector<int> firstAt = firstAtPlaces(mesh.positions);
  std::vector<Index> tied;
  std::vector<Index> tiedNear;
  std::vector<Index> apart;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (const Index first = solverMesh.weld.firstVertexOf[solverMesh.weld.unknownOf[v]]; first != v)
      (firstAt[v] == firstAt[first] ? tied : tiedNear).push_back(v);
    else if (firstAt[v] != v && !isWithoutPlace(solverMesh, v))
      apart.push_back(v);
  add(findings, "welded_vertices", "vertex", std::move(tied),
      {"vertex repeats another one exactly along an open edge; they are deformed as one and written apart",
       "vertices repeat another one exactly along open edges; they are deformed as one and written apart"});
  add(findings, "welded_near_vertices", "vertex", std::move(tiedNear),
      {"vertex lies within the tolerance of another one along an open edge; they are deformed as one and written apart",
       "vertices lie within the tolerance of others along open edges; they are deformed as one and written apart"});
  add(findings, "coincident_vertices", "vertex", std::move(apart),
      {"vertex lies exactly on another one without an open edge in common; they may move apart",
       "vertices lie exactly on another one without an open edge in common; they may move apart"});
}

/// Vertices of open edges that all but lie on others of which the surface is torn off.
void addNearlyCoincident(Findings& findings, const SolverMesh& mesh, const std::vector<HalfEdge>& halfEdges)
{
  std::vector<int> ends;
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) ends.insert(ends.end(), {static_cast<int>(edge[0].a), static_cast<int>(edge[0].b)});
  });
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const double distance = std::max(kNearlyCoincident * mesh.diagonal, kRoundedToFloats * mesh.largestCoordinate);
  const auto isEdge = [&](Index a, Index b) {
    const auto endsOf = [](const HalfEdge& half) { return std::pair<Index, Index>(half.a, half.b); };
    return std::ranges::binary_search(halfEdges, std::pair(a, b), {}, endsOf);
  };
  std::vector<Index> near;
  double widest = 0;
  for (const auto& [a, b] : nearPairs(mesh.rest, ends, distance)) {
    if (isEdge(a, b)) continue;
    near.push_back(b);
    widest = std::max(widest, (mesh.rest.row(a) - mesh.rest.row(b)).stableNorm());
  }
  const std::string rest = fmt::format(
      " up to {:.2g} away, and may move apart: the surface may tear there; weld with a larger tolerance if they should "
      "be one",
      widest);
  add(findings, "nearly_coincident_vertices", "vertex", fileVertices(mesh, near),
      {"vertex at an open edge nearly coincides with another," + rest,
       "vertices at open edges nearly coincide with others," + rest});
}

double smallestAngleDegrees(const Positions& positions, const Triangle& triangle)
{
  Vector3 ab = positions.row(triangle[1]) - positions.row(triangle[0]);
  Vector3 ac = positions.row(triangle[2]) - positions.row(triangle[0]);
  const double size = std::max(ab.stableNorm(), ac.stableNorm());
  if (size == 0) return 0;
  ab /= size;
  ac /= size;
  std::array<double, 3> edges{ab.norm(), ac.norm(), (ac - ab).norm()};
  std::sort(edges.begin(), edges.end());
  const double sine = ab.cross(ac).norm() / (edges[1] * edges[2]);
  return std::asin(std::min(1.0, sine)) * 180 / std::numbers::pi;
}

/// A quick look that passes most triangles: whether the smallest angle is certainly above 1.8 degrees.
bool isFarFromANeedle(const Positions& positions, const Triangle& triangle)
{
  constexpr double kSquaredSine = 1e-3;
  const Vector3 ab = positions.row(triangle[1]) - positions.row(triangle[0]);
  const Vector3 ac = positions.row(triangle[2]) - positions.row(triangle[0]);
  const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  return std::isfinite(longest * longest) && ab.cross(ac).squaredNorm() > kSquaredSine * longest * longest;
}

void addBadTriangles(Findings& findings, const Mesh& mesh, const Triangulation& triangulation)
{
  // An angle of this size is rounding of the coordinates.
  const double noArea = 64 * std::numeric_limits<double>::epsilon();
  std::vector<Index> repeated;
  std::vector<Index> flat;
  std::vector<Index> needles;
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    const Triangle& triangle = triangulation.triangles[t];
    if (isFarFromANeedle(mesh.positions, triangle)) continue;
    const double angle = smallestAngleDegrees(mesh.positions, triangle);
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      repeated.push_back(triangulation.faceOf[t]);
    else if (angle <= noArea)
      flat.push_back(triangulation.faceOf[t]);
    else if (angle < kNeedleDegrees)
      needles.push_back(triangulation.faceOf[t]);
  }
  add(findings, "repeated_corner_faces", "face", std::move(repeated),
      {"face names a vertex twice; the solver leaves the part without area out",
       "faces name a vertex twice; the solver leaves the part without area out"});
  add(findings, "zero_area_faces", "face", std::move(flat),
      {"face has no area; its cotangents are capped so that it holds together",
       "faces have no area; their cotangents are capped so that they hold together"});
  add(findings, "needle_faces", "face", std::move(needles),
      {"face has an angle below 1 degree; its cotangents are capped",
       "faces have an angle below 1 degree; their cotangents are capped"});
}

/// The unknowns at which corners of triangles do not all hang together across edges.
std::vector<Index> unknownsOfSeveralFans(const SolverMesh& mesh, const std::vector<HalfEdge>& halfEdges)
{
  DisjointSets fans(3 * static_cast<Index>(mesh.triangles.size()));  // of corners
  const auto cornerAt = [&](const HalfEdge& half, Index v) {
    const int k = mesh.triangles[half.triangle][half.side] == v ? half.side : (half.side + 1) % 3;
    return 3 * half.triangle + k;
  };
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    for (const HalfEdge& half : edge.subspan(1)) {
      fans.unite(cornerAt(edge[0], half.a), cornerAt(half, half.a));
      fans.unite(cornerAt(edge[0], half.b), cornerAt(half, half.b));
    }
  });
  std::vector<Index> result;
  std::vector<Index> fanOf(static_cast<std::size_t>(mesh.unknownCount()), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index fan = fans.find(static_cast<Index>(3 * t) + k);
      Index& known = fanOf[mesh.triangles[t][k]];
      if (known < 0) known = fan;
      if (known != fan) result.push_back(mesh.triangles[t][k]);
    }
  return result;
}

void addFans(Findings& findings, const SolverMesh& mesh, const std::vector<HalfEdge>& halfEdges)
{
  add(findings, "non_manifold_vertices", "vertex", fileVertices(mesh, unknownsOfSeveralFans(mesh, halfEdges)),
      {"vertex joins fans of faces that share no edge; the fans stay joined there",
       "vertices join fans of faces that share no edge; the fans stay joined there"});
}

void addNonManifoldEdges(Findings& findings, const SolverMesh& mesh, const std::vector<HalfEdge>& halfEdges)
{
  std::vector<Index> faces;
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() > 2)
      for (const HalfEdge& half : edge) faces.push_back(mesh.faceOf[half.triangle]);
  });
  add(findings, "non_manifold_edges", "face", std::move(faces),
      {"face meets itself and others at an edge of more than two faces; all of them pull on it",
       "faces meet at edges of more than two faces; all of them pull on such an edge"});
}

void addFlippedNeighbours(Findings& findings, const SolverMesh& mesh, const std::vector<HalfEdge>& halfEdges)
{
  std::vector<Index> faces;
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 2 && edge[0].isForward == edge[1].isForward)
      for (const HalfEdge& half : edge) faces.push_back(mesh.faceOf[half.triangle]);
  });
  add(findings, "flipped_neighbours", "face", std::move(faces),
      {"face disagrees with itself on which side is out; the shape is kept all the same, normals are not",
       "faces disagree with a neighbour on which side is out; the shape is kept all the same, normals are not"});
}

void addBoundaries(Findings& findings, const SolverMesh& mesh, const std::vector<HalfEdge>& halfEdges)
{
  DisjointSets boundaries(mesh.unknownCount());
  std::vector<bool> isBoundary(static_cast<std::size_t>(mesh.unknownCount()), false);
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() > 1) return;
    boundaries.unite(edge[0].a, edge[0].b);
    isBoundary[edge[0].a] = true;
  });
  std::vector<Index> first;
  for (Index u = 0; u < mesh.unknownCount(); ++u)
    if (isBoundary[u] && boundaries.find(u) == u) first.push_back(u);
  add(findings, "boundary_loops", "vertex", fileVertices(mesh, first),
      {"boundary (a vertex of it is named); the surface is open there",
       "boundaries (a vertex of each is named); the surface is open there"});
}

}  // namespace

std::vector<Finding> findNonFinite(const Mesh& mesh)
{
  Findings findings;
  add(findings, "non_finite_coordinates", "vertex", nonFiniteVertices(mesh).ofSurface,
      {"vertex has a coordinate that is not a finite number; repair it, nothing can be solved",
       "vertices have a coordinate that is not a finite number; repair them, nothing can be solved"});
  return findings;
}

std::vector<Finding> checkMesh(const Mesh& mesh, const Triangulation& triangulation, const SolverMesh& solverMesh)
{
  const std::vector<HalfEdge> halfEdges = sortedHalfEdges(solverMesh.triangles);
  std::array<Findings, 9> parts;
  parallelFor(9, [&](Index part) {
    if (part == 0) addFans(parts[5], solverMesh, halfEdges);  // takes the longest
    if (part == 1) addCoincident(parts[2], mesh, solverMesh);
    if (part == 2) addBoundaries(parts[7], solverMesh, halfEdges);
    if (part == 3) addNonManifoldEdges(parts[4], solverMesh, halfEdges);
    if (part == 4) addFlippedNeighbours(parts[6], solverMesh, halfEdges);
    if (part == 5) addBadTriangles(parts[3], mesh, triangulation);
    if (part == 6) addUnreferenced(parts[1], solverMesh);
    if (part == 7) addComponents(parts[0], solverMesh);
    if (part == 8) addNearlyCoincident(parts[8], solverMesh, halfEdges);
  });
  Findings findings;
  addStated(findings, mesh, solverMesh);
  for (Findings& part : parts) std::ranges::move(part, std::back_inserter(findings));
  return findings;
}

std::vector<Finding> guardFindings(const Operators& operators, const SolverMesh& solverMesh)
{
  Findings findings;
  add(findings, "capped_cotangents", "vertex", fileVertices(solverMesh, operators.clampedCotangents),
      {"vertex of triangles whose cotangents were capped: very small or very large angles",
       "vertices of triangles whose cotangents were capped: very small or very large angles"});
  add(findings, "floored_areas", "vertex", fileVertices(solverMesh, operators.flooredAreas),
      {"vertex whose area was raised to a thousandth of the mean",
       "vertices whose area was raised to a thousandth of the mean"});
  return findings;
}

std::vector<Finding> guardFindings(const RotationWeights& weights, const SolverMesh& solverMesh)
{
  Findings findings;
  add(findings, "capped_rotation_weights", "vertex", fileVertices(solverMesh, weights.capped),
      {"vertex of triangles whose cotangents were capped for the rotations: very small or very large angles",
       "vertices of triangles whose cotangents were capped for the rotations: very small or very large angles"});
  add(findings, "floored_rotation_weights", "vertex", fileVertices(solverMesh, weights.floored),
      {"vertex of edges that hardly pass rotations on: negative sums of cotangents were raised to a millionth",
       "vertices of edges that hardly pass rotations on: negative sums of cotangents were raised to a millionth"});
  return findings;
}

bool isSolid(const SolverMesh& mesh)
{
  bool isClosed = true;
  forEachEdge(sortedHalfEdges(mesh.triangles), [&](std::span<const HalfEdge> edge) {
    isClosed = isClosed && edge.size() == 2 && edge[0].isForward != edge[1].isForward;
  });
  const Positions rest = restInDiagonals(mesh);
  const auto at = [&](Index unknown) -> Vector3 { return rest.row(unknown).transpose(); };
  std::vector<double> volumes(static_cast<std::size_t>(mesh.componentCount), 0.0);  // times six, in cubes of diagonals
  for (const auto& [a, b, c] : mesh.triangles) volumes[mesh.componentOf[a]] += at(a).dot(at(b).cross(at(c)));
  return isClosed && std::ranges::all_of(volumes, [](double volume) { return volume > 0; });
}

}  // namespace holdfast

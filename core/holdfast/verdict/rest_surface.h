#pragma once
/// The surface at rest, measured once for a mesh. A deformed surface is compared with it.

#include <array>
#include <cstdint>
#include <vector>

#include <holdfast/mesh/solver_mesh.h>

namespace holdfast {

/// The two triangles of an edge that no other triangle has.
struct Hinge {
  int first = 0;
  int second = 0;
  float side = 1;         ///< -1 where the two disagree on which side is out
  float restDegrees = 0;  ///< how far they are bent at rest, see `bendDegrees`
  float flatCosine = -2;  ///< above this cosine of their normals they are not folded; -2 for needles, which never are
};

/// Two neighbours fold where the angle between them changes by more than this. It is two thirds of the way to lying
/// back on back. A surface that bends by more from one triangle to the next has lost its shape there, however coarse it
/// is.
inline constexpr double kFoldDegrees = 120;

/// The ends of edges shorter than this share of the diagonal are at the same place. Triangles of such edges have no
/// area.
inline constexpr double kNoLength = 1e-7;

/// The measured surface. All lengths are in diagonals. It takes 60 bytes a triangle.
struct RestSurface {
  /// Measures the mesh at rest. O(T log T).
  explicit RestSurface(const SolverMesh& mesh);

  std::vector<Triangle> triangles;  ///< vertices of the file, one for each unknown
  /// One over the squares of the three sides (0-1, 1-2, 2-0) and of twice the area. 0 where these are nothing.
  std::vector<std::array<float, 4>> inverseSquares;
  std::vector<std::uint8_t> ownSides;  ///< bit k: side k of the triangle counts for its edge, which others share
  std::vector<int> partOf;             ///< of each triangle
  std::vector<Hinge> hinges;
  std::vector<double> volumes;  ///< six times what each part encloses; 0 where it is open or encloses nothing
  std::vector<int> vertexOfPart;
  Vector3 center;      ///< about which volumes are measured, model units
  double perUnit = 1;  ///< diagonals for each model unit

 private:
  std::vector<bool> measureTriangles(const Positions& rest);
  std::vector<bool> findHinges(std::size_t parts);
  void measureHinges(const Positions& rest, const std::vector<bool>& isNeedle);
  void measureVolumes(const Positions& rest, const std::vector<bool>& isOpen);
};

/// The sides of a triangle at `positions`, as `RestSurface` has them, and twice its area as a vector along its normal.
struct TriangleShape {
  std::array<Vector3, 3> sides;
  Vector3 area;
};
[[nodiscard]] inline TriangleShape shapeOf(const Triangle& triangle, const Positions& positions, double perUnit)
{
  const Vector3 ab = perUnit * (positions.row(triangle[1]) - positions.row(triangle[0])).transpose();
  const Vector3 ac = perUnit * (positions.row(triangle[2]) - positions.row(triangle[0])).transpose();
  return {{ab, ac - ab, -ac},
          {ab.y() * ac.z() - ab.z() * ac.y(), ab.z() * ac.x() - ab.x() * ac.z(), ab.x() * ac.y() - ab.y() * ac.x()}};
}

/// Returns how far the two triangles of a hinge are bent about its edge, from -180 to 180 degrees. 0 where one has no
/// area.
[[nodiscard]] double bendDegrees(const RestSurface& surface, const Hinge& hinge, const Positions& positions);

}  // namespace holdfast

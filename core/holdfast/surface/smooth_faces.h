#pragma once
/// \file
/// Faces that hang together without a sharp bend between them, as the sides of a machine part do.

#include <array>
#include <vector>

#include <holdfast/mesh/solver_mesh.h>

namespace holdfast {

/// Finds smooth patches of one mesh, at rest.
class SmoothFaces {
 public:
  /// `mesh` is that of which `solverMesh` was made. O(T log T).
  SmoothFaces(const Mesh& mesh, const SolverMesh& solverMesh);

  /// `face` and all faces to which edges lead from it that bend the surface by at most `degrees`, in ascending order.
  /// What counts is the angle between the best-fitting planes of the two faces at the edge, so that 0 keeps to a plane
  /// and 180 to nothing. Edges of three or more triangles are never crossed; a face without an area bends as the one
  /// does from which it is reached; faces that disagree on which side is out are compared as if they agreed. O(k log k)
  /// for k triangles reached, and O(T) for memory to remember them.
  [[nodiscard]] std::vector<Index> around(Index face, double degrees) const;

 private:
  /// What lies beyond one side of a triangle.
  struct Beyond {
    Index triangle = -1;     // -1 for a border, and where more than one triangle is there
    bool isFlipped = false;  // its other side is out
  };

  [[nodiscard]] std::vector<Index> trianglesOf(Index face) const;

  const SolverMesh& mesh_;
  std::vector<std::array<Beyond, 3>> beyond_;  // of each triangle
  Positions normals_;                          // of each face, unit length or zero
};

}  // namespace holdfast

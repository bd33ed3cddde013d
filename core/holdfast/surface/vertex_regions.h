#pragma once
/// Sets of vertices grow and shrink over the surface, as a user selects them.

#include <array>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/surface/edge_graph.h>

namespace holdfast {

/// `BendFrom` says with which face the direction of another one is compared.
enum class BendFrom {
  Neighbour,  ///< the one from which it is reached: a side that bends gently belongs to it as a whole
  FirstFace   ///< the first one: what looks in one direction
};

/// `SmoothFaces` finds smooth patches of one mesh, at rest.
class SmoothFaces {
 public:
  /// `solverMesh` must be made of `mesh`. O(T log T).
  SmoothFaces(const Mesh& mesh, const SolverMesh& solverMesh);

  /// Returns `face` and all faces to which edges lead from it through faces that bend by at most `degrees`, ascending.
  /// A face bends from the one that `from` names, by the angle between the best-fitting planes of the two. Edges of
  /// three or more triangles are never crossed. A face without an area bends as the one does from which it is reached.
  /// Faces that disagree on which side is out are compared as if they agreed. O(k log k) for k triangles reached, and
  /// O(T) for memory.
  [[nodiscard]] std::vector<Index> around(Index face, double degrees, BendFrom from = BendFrom::Neighbour) const;

  /// Returns the share of the edges between two triangles that do not bend the surface. It is 0 where there are none.
  /// O(T).
  [[nodiscard]] double flatShare() const;

 private:
  /// `Beyond` says what lies beyond one side of a triangle.
  struct Beyond {
    Index triangle = -1;     // -1 for a border, and where more than one triangle is there
    bool isFlipped = false;  // its other side is out
  };

  [[nodiscard]] std::vector<Index> trianglesOf(Index face) const;

  const SolverMesh& mesh_;
  std::vector<std::array<Beyond, 3>> beyond_;  // of each triangle
  Positions normals_;                          // of each face, unit length or zero
};

/// `VertexRegions` makes sets of vertices of one mesh, those of the file. Results ascend. Vertices that are one unknown
/// go together: a set with one of them counts as holding all, and results hold all. Each call is O(N).
class VertexRegions {
 public:
  /// `solverMesh` must be made of `mesh`. Both must stay alive as long as this. O(T log T).
  VertexRegions(const Mesh& mesh, const SolverMesh& solverMesh)
      : mesh_(mesh), solverMesh_(solverMesh), graph_(solverMesh), smoothFaces_(mesh, solverMesh)
  {
  }

  [[nodiscard]] const EdgeGraph& graph() const noexcept { return graph_; }

  /// Returns `vertices` and all vertices of the connected parts that they lie in.
  [[nodiscard]] std::vector<Index> connected(std::span<const Index> vertices) const;

  /// Returns the vertices of the faces that `SmoothFaces::around` reaches.
  [[nodiscard]] std::vector<Index> smooth(Index face, double degrees, BendFrom from = BendFrom::Neighbour) const;

  [[nodiscard]] double flatShare() const { return smoothFaces_.flatShare(); }

  /// Returns `vertices` and all that an edge joins to one of them.
  [[nodiscard]] std::vector<Index> grown(std::span<const Index> vertices) const;

  /// Returns `vertices` without those that an edge joins to one that is not among them. Borders of the mesh stay.
  [[nodiscard]] std::vector<Index> shrunk(std::span<const Index> vertices) const;

  /// Returns the vertices that faces use and that are not among `vertices`.
  [[nodiscard]] std::vector<Index> inverted(std::span<const Index> vertices) const;

  /// Returns a dab of a brush at `place`, a point of `face`, with the vertices at `positions`. It has those within
  /// `radius` to which edges lead inside that ball from a corner of the face. The other side of a thin wall is not
  /// reached.
  [[nodiscard]] std::vector<Index> within(double radius, const Vector3& place, Index face,
                                          const Positions& positions) const;

 private:
  [[nodiscard]] std::vector<bool> unknownsOf(std::span<const Index> vertices) const;
  [[nodiscard]] std::vector<Index> verticesWhere(const std::vector<bool>& isChosen) const;

  const Mesh& mesh_;
  const SolverMesh& solverMesh_;
  EdgeGraph graph_;
  SmoothFaces smoothFaces_;
};

/// A region size says what a set of vertices covers.
struct RegionSize {
  Index triangles = 0;  ///< all of whose corners are in the set
  double area = 0;      ///< of these
  Eigen::AlignedBox3d box;
};

/// Returns the size of a region with vertices at `positions`. O(T).
[[nodiscard]] RegionSize sizeOfRegion(std::span<const Index> vertices, const std::vector<Triangle>& triangles,
                                      const Positions& positions);

}  // namespace holdfast

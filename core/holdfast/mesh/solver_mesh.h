#pragma once
/// The solver sees a mesh as triangles over unknowns, in place of polygons over file vertices.

#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// A weld says which file vertices are one unknown: `unknownOf[v]` is the unknown of file vertex v. Unknowns are
/// numbered by their first vertex.
struct Weld {
  std::vector<int> unknownOf;
  Index unknownCount = 0;
  std::vector<int> firstVertexOf;  ///< the file vertex of smallest id of each unknown
  bool joinsApart = false;         ///< whether vertices at different places are one unknown
};

/// Ties the ends of open edges (edges of one triangle only) that lie exactly on one another. So an unwelded file
/// deforms as the one surface that it shows. Closed parts that merely touch stay apart. Ends within `tolerance`, in
/// model units, count as one place, as do ends that others between them join. O(T log T).
[[nodiscard]] Weld weldOpenEdges(const Positions& positions, const std::vector<Triangle>& triangles,
                                 double tolerance = 0);

/// Returns for each vertex the vertex of smallest id at its place, where -0 is 0. Positions must be finite. O(N).
[[nodiscard]] std::vector<int> firstAtPlaces(const Positions& positions);

/// A mesh over unknowns.
struct SolverMesh {
  Positions rest;                   ///< n x 3, the position of each unknown at rest, model units
  std::vector<Triangle> triangles;  ///< unknown ids; no triangle names an unknown twice
  std::vector<int> faceOf;          ///< the file face of each triangle
  std::vector<int> componentOf;     ///< the connected part of each unknown; -1 where no triangle uses it
  Index componentCount = 0;         ///< parts are numbered by their smallest unknown
  Weld weld;                        ///< which file vertices are one unknown
  double diagonal = 0;              ///< of the bounding box, model units
  double largestCoordinate = 0;     ///< of `rest`, by size
  /// The vertices of the file, ascending, that no face uses and whose coordinates there are not finite. `rest` has a
  /// place for them that means nothing. Nothing may be asked of them.
  std::vector<Index> withoutPlace;

  [[nodiscard]] Index unknownCount() const noexcept { return rest.rows(); }
};

/// Welds open edges that coincide, exactly or within `weldTolerance` (model units), and finds the connected parts.
/// Vertices that no face uses are unknowns too, in no part: they can be pinned. Positions must be finite, those of the
/// vertices `withoutPlace` too. O(T log T).
[[nodiscard]] SolverMesh makeSolverMesh(const Mesh& mesh, const Triangulation& triangulation, double weldTolerance = 0,
                                        std::vector<Index> withoutPlace = {});

/// Returns where the unknown of each file vertex is at rest, N x 3, in model units.
[[nodiscard]] Positions restOfVertices(const SolverMesh& mesh);

/// Returns the positions at rest about the first unknown, n x 3, in diagonals. Their squares stay in the range of
/// doubles.
[[nodiscard]] Positions restInDiagonals(const SolverMesh& mesh);

/// Returns the connected part of each file vertex, -1 where no face uses it.
[[nodiscard]] std::vector<int> componentOfVertices(const SolverMesh& solverMesh);

}  // namespace holdfast

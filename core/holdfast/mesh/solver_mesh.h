#pragma once
/// The mesh as the solver sees it: triangles over unknowns, in place of polygons over file vertices.

#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// unknownOf[v] is the unknown of file vertex v; unknowns are numbered by their first vertex.
struct Weld {
  std::vector<int> unknownOf;
  Index unknownCount = 0;
  std::vector<int> firstVertexOf;  ///< one file vertex of each unknown, the one of smallest id
  bool joinsApart = false;         ///< whether vertices at different places are one unknown
};

/// Ties the ends of open edges (edges of one triangle only) that lie exactly on one another, so that an unwelded file
/// deforms as the one surface that it shows. Closed parts that merely touch stay apart. With a `tolerance`, a length,
/// ends within it count as one place, as do those that others between them join. O(T log T).
[[nodiscard]] Weld weldOpenEdges(const Positions& positions, const std::vector<Triangle>& triangles,
                                 double tolerance = 0);

/// For each vertex the one of smallest id at its place (-0 is 0). Positions must be finite. O(N).
[[nodiscard]] std::vector<int> firstAtPlaces(const Positions& positions);

struct SolverMesh {
  Positions rest;                   ///< n x 3, position of each unknown at rest, model units
  std::vector<Triangle> triangles;  ///< unknown ids; none names an unknown twice
  std::vector<int> faceOf;          ///< file face of each triangle
  std::vector<int> componentOf;     ///< connected part of each unknown; -1 where no triangle uses it
  Index componentCount = 0;         ///< parts are numbered by their smallest unknown
  Weld weld;                        ///< file vertices to unknowns
  double diagonal = 0;              ///< of the bounding box, model units
  double largestCoordinate = 0;     ///< of `rest`, by size
  /// Vertices of the file, ascending, that no face uses and whose coordinates there are not finite. `rest` has a place
  /// for them that means nothing: nothing may be asked of them.
  std::vector<Index> withoutPlace;

  [[nodiscard]] Index unknownCount() const noexcept { return rest.rows(); }
};

/// Welds open edges that coincide, exactly or within `weldTolerance`, and finds the connected parts. Vertices that no
/// face uses are unknowns too (they can be pinned), in no part. Positions must be finite, those of vertices
/// `withoutPlace` too. O(T log T).
[[nodiscard]] SolverMesh makeSolverMesh(const Mesh& mesh, const Triangulation& triangulation, double weldTolerance = 0,
                                        std::vector<Index> withoutPlace = {});

/// Where the unknown of each file vertex is at rest, model units.
[[nodiscard]] Positions restOfVertices(const SolverMesh& mesh);

/// The rest positions about the first unknown, in units of the diagonal, whose squares stay in the range of doubles.
[[nodiscard]] Positions restInDiagonals(const SolverMesh& mesh);

/// The connected part of each file vertex, -1 where no face uses it.
[[nodiscard]] std::vector<int> componentOfVertices(const SolverMesh& solverMesh);

}  // namespace holdfast

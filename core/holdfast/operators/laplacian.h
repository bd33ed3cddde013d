#pragma once
/// These functions make Laplacians of a mesh from weights on its edges, equations (1) to (3).

#include <vector>

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/operators/cotangents.h>

namespace holdfast {

/// An edge weight is on the edge between two unknowns. Each edge has one, with i < j.
struct EdgeWeight {
  int i = 0;
  int j = 0;
  double weight = 0;
};

/// Returns weight 1 on every edge, sorted by (i, j).
[[nodiscard]] std::vector<EdgeWeight> unitEdgeWeights(const std::vector<Triangle>& triangles);

/// Returns cot alpha + cot beta on every edge, sorted by (i, j). The angles are those across the edge in the triangles
/// on it. There is one at a boundary, and there are more than two where the mesh is not a manifold. `cotangents` holds
/// those of each triangle.
[[nodiscard]] std::vector<EdgeWeight> cotangentEdgeWeights(const std::vector<Triangle>& triangles,
                                                           const std::vector<CornerCotangents>& cotangents);

/// Returns S, n x n and symmetric, with rows of sum zero: S_ij = -w_ij, S_ii = sum over j of w_ij. The weights are
/// sorted by (i, j).
[[nodiscard]] SparseMatrix stiffness(Index n, const std::vector<EdgeWeight>& weights);

}  // namespace holdfast

#pragma once
/// Laplacians of a mesh from weights on its edges, equations (1) to (3).

#include <vector>

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/operators/cotangents.h>

namespace holdfast {

/// A weight on the edge between two unknowns; each edge once, i < j.
struct EdgeWeight {
  int i = 0;
  int j = 0;
  double weight = 0;
};

/// Weight 1 on every edge, sorted by (i, j).
[[nodiscard]] std::vector<EdgeWeight> unitEdgeWeights(const std::vector<Triangle>& triangles);

/// cot alpha + cot beta on every edge, of the angles across it in the triangles on it (one at a boundary, more where
/// the mesh is not a manifold), sorted by (i, j). `cotangents` holds those of each triangle.
[[nodiscard]] std::vector<EdgeWeight> cotangentEdgeWeights(const std::vector<Triangle>& triangles,
                                                           const std::vector<CornerCotangents>& cotangents);

/// n x n, symmetric, rows of sum zero: S_ij = -w_ij, S_ii = sum over j of w_ij. The weights are sorted by (i, j).
[[nodiscard]] SparseMatrix stiffness(Index n, const std::vector<EdgeWeight>& weights);

}  // namespace holdfast

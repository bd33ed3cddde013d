#pragma once
/// \file
/// Lengths of shortest paths along edges, without the code under test.

#include <Eigen/Core>

#include <holdfast/mesh/mesh.h>

namespace holdfast::test {

/// Between all pairs of vertices of a mesh of triangles, by the algorithm of Floyd and Warshall; infinite where no path
/// is. O(N^3).
[[nodiscard]] Eigen::MatrixXd pathLengths(const Mesh& mesh);

}  // namespace holdfast::test

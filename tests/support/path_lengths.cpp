#include "support/path_lengths.h"

#include <limits>

namespace holdfast::test {

Eigen::MatrixXd pathLengths(const Mesh& mesh)
{
  const Index n = mesh.vertexCount();
  Eigen::MatrixXd lengths = Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::infinity());
  lengths.diagonal().setZero();
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const Index a : mesh.faces[f])
      for (const Index b : mesh.faces[f]) lengths(a, b) = (mesh.positions.row(a) - mesh.positions.row(b)).norm();
  for (Index via = 0; via < n; ++via)
    for (Index a = 0; a < n; ++a)
      for (Index b = 0; b < n; ++b) lengths(a, b) = std::min(lengths(a, b), lengths(a, via) + lengths(via, b));
  return lengths;
}

}  // namespace holdfast::test

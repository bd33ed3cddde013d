// LU by Eigen.

#include <memory>

#include <Eigen/SparseLU>

#include <holdfast/solve/sparse_lu.h>

namespace holdfast {

std::optional<SparseLu> luByEigen(const SparseMatrix& K)
{
  const auto lu = std::make_shared<const Eigen::SparseLU<Eigen::SparseMatrix<double>>>(K);
  if (lu->info() != Eigen::Success) return std::nullopt;
  return SparseLu{[lu](const Columns3& right) { return Eigen::MatrixX3d(lu->solve(Eigen::MatrixX3d(right))); },
                  lu->nnzL() + lu->nnzU()};
}

}  // namespace holdfast

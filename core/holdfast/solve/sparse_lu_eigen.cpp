// LU by Eigen.

#include <Eigen/SparseLU>

#include <holdfast/solve/sparse_lu.h>

namespace holdfast {
namespace {

class LuByEigen final : public SparseLu {
 public:
  explicit LuByEigen(const SparseMatrix& K) : lu_(K) {}

  [[nodiscard]] bool isRegular() const { return lu_.info() == Eigen::Success; }
  [[nodiscard]] Columns3 solve(const Columns3& rightSides) const override
  {
    return Eigen::MatrixX3d(lu_.solve(Eigen::MatrixX3d(rightSides)));
  }
  [[nodiscard]] Index nonzeros() const override { return lu_.nnzL() + lu_.nnzU(); }

 private:
  Eigen::SparseLU<SparseMatrix> lu_;
};

}  // namespace

std::unique_ptr<const SparseLu> luByEigen(const SparseMatrix& K)
{
  auto lu = std::make_unique<LuByEigen>(K);
  return lu->isRegular() ? std::move(lu) : nullptr;
}

}  // namespace holdfast

// LU by UMFPACK, through Eigen's wrapper.

#include <memory>

#include <Eigen/UmfPackSupport>

#include <holdfast/solve/sparse_lu.h>
#include <holdfast/threads/one_thread_internal.h>

namespace holdfast {
namespace {

/// Eigen keeps UMFPACK's object to itself.
class Umfpack : public Eigen::UmfPackLU<Eigen::SparseMatrix<double>> {
 public:
  explicit Umfpack(const SparseMatrix& K) : K_(K) { compute(K_); }

  [[nodiscard]] Index nonzeros() const
  {
    int lower = 0;
    int upper = 0;
    int rows = 0;
    int columns = 0;
    int diagonal = 0;
    umfpack_di_get_lunz(&lower, &upper, &rows, &columns, &diagonal, m_numeric);
    return static_cast<Index>(lower) + upper;
  }

 private:
  SparseMatrix K_;
};

}  // namespace

std::optional<SparseLu> luBySuiteSparse(const SparseMatrix& K)
{
  const OneThread libraries;
  const auto lu = std::make_shared<const Umfpack>(K);
  if (lu->info() != Eigen::Success) return std::nullopt;
  return SparseLu{[lu](const Columns3& right) {
                    const OneThread whileSolving;
                    return Eigen::MatrixX3d(lu->solve(Eigen::MatrixX3d(right)));
                  },
                  lu->nonzeros()};
}

}  // namespace holdfast

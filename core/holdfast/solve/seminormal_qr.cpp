// The least-squares factor of last resort: R of a sparse QR of C, which never squares the condition number.

#include <algorithm>

#include <fmt/format.h>

#include <holdfast/elimination/sparse_qr.h>
#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {
namespace {

/// The rows that are not empty (Eigen's QR does not take those), longest first: reflections keep the digits of short
/// rows only after the long ones. Source: A. J. Cox, N. J. Higham, "Stability of Householder QR factorization for
/// weighted least squares problems", 1998.
SparseMatrix longestRowsFirst(const SparseRows& byRows)
{
  Eigen::VectorXd lengths(byRows.rows());
  for (Index r = 0; r < byRows.rows(); ++r) lengths[r] = byRows.row(r).norm();
  std::vector<Index> kept;
  for (Index r = 0; r < byRows.rows(); ++r)
    if (byRows.outerIndexPtr()[r + 1] > byRows.outerIndexPtr()[r]) kept.push_back(r);
  std::ranges::stable_sort(kept, std::ranges::greater{}, [&](Index r) { return lengths[r]; });
  SparseRows result(static_cast<Index>(kept.size()), byRows.cols());
  result.reserve(byRows.nonZeros());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    result.startVec(static_cast<Index>(k));
    for (SparseRows::InnerIterator entry(byRows, kept[k]); entry; ++entry)
      result.insertBack(static_cast<Index>(k), entry.col()) = entry.value();
  }
  result.finalize();
  return result;
}

class SeminormalQr final : public LeastSquaresFactor {
 public:
  SeminormalQr(SparseQrResult qr, Backend backend) : qr_(std::move(qr)), backend_(backend) {}

  [[nodiscard]] Columns3 solve(const Columns3& g) const override { return qr_.solveSeminormal(g); }
  [[nodiscard]] Index nonzeros() const override { return qr_.R.nonZeros(); }
  [[nodiscard]] std::string_view method() const override
  {
    return backend_ != Backend::Eigen && isBuilt(Backend::Cholmod) ? "R of a sparse QR (SPQR)"
                                                                   : "R of a sparse QR (Eigen)";
  }

 private:
  SparseQrResult qr_;
  Backend backend_;
};

SparseQrResult qrBy(Backend backend, const SparseMatrix& M)
{
  constexpr double kAcceptAll = -1;
#ifdef HOLDFAST_WITH_CHOLMOD
  if (backend != Backend::Eigen) return sparseQrSuiteSparse(M, kAcceptAll, WantQ::No);
#endif
  static_cast<void>(backend);
  return sparseQrEigen(M, kAcceptAll, WantQ::No);
}

bool hasRegularDiagonal(const SparseMatrix& R)
{
  for (Index k = 0; k < R.cols(); ++k)
    if (R.coeff(k, k) == 0) return false;
  return true;
}

}  // namespace

FactorResult seminormalQr(const LinearMap& map, Backend backend)
{
  const std::shared_ptr<const TwoWayMatrix> C = map.matrix();
  const Index unknowns = C->columns().cols();
  SparseQrResult qr = qrBy(backend, longestRowsFirst(C->rows()));
  if (qr.rank < unknowns || qr.R.rows() < unknowns || !hasRegularDiagonal(qr.R))
    return {nullptr, fmt::format("sparse QR finds rank {} for {} unknowns", qr.rank, unknowns)};
  return {std::make_unique<SeminormalQr>(std::move(qr), backend)};
}

}  // namespace holdfast

#pragma once
/// A factorisation of a sparse least-squares problem: of the normal equations, by our own method, CHOLMOD or Eigen, or
/// the R of a sparse QR.

#include <memory>
#include <string_view>

#include <holdfast/base/result.h>
#include <holdfast/factor/packed_factor.h>
#include <holdfast/solve/linear_map.h>
#include <holdfast/solve/solver_options.h>

namespace holdfast {

/// A factorised problem: minimise |C z - f| for any f. The last rows of C may be kept: they hold exactly, C z = 0
/// there, and have a multiplier each. It does not need C any more. Not for concurrent calls.
class LeastSquaresFactor {
 public:
  virtual ~LeastSquaresFactor() = default;

  /// z for g = C^T f (k x 3), without any correction: see `correctedSolve`. With kept rows K: z and below it the
  /// multipliers l, for any g with C^T C z + K^T l = g, K z = what is below g. O(nonzeros()).
  [[nodiscard]] virtual Columns3 solve(const Columns3& g) const = 0;

  /// Our own factor of C^T C or of the system with kept rows, where it is one.
  [[nodiscard]] virtual const PackedFactor* packed() const { return nullptr; }

  /// Stored entries of the factor.
  [[nodiscard]] virtual Index nonzeros() const = 0;

  /// How it was made, in a user's words: "Cholesky factor of the normal equations (CHOLMOD)".
  [[nodiscard]] virtual std::string_view method() const = 0;

 protected:
  LeastSquaresFactor() = default;
  LeastSquaresFactor(const LeastSquaresFactor&) = default;
  LeastSquaresFactor& operator=(const LeastSquaresFactor&) = default;
};

/// In which order a factorisation eliminates unknowns.
enum class EliminationOrder {
  ToBeFound,
  OfColumns  ///< that of the columns of C, which keeps the factor small
};

using FactorResult = Result<std::unique_ptr<const LeastSquaresFactor>>;

/// Each takes C (m x k) with columns of unit length, of which `kept` are the last rows. Those of SuiteSparse are
/// defined where that is built.
[[nodiscard]] FactorResult choleskyMultifrontal(const LinearMap& C,
                                                EliminationOrder order = EliminationOrder::ToBeFound,
                                                const SparseMatrix& kept = {});
[[nodiscard]] FactorResult choleskyBySuiteSparse(const LinearMap& C);
[[nodiscard]] FactorResult choleskyByEigen(const LinearMap& C);
/// R of a sparse QR of C, Q not kept: R^T R z = C^T f (semi-normal equations; Björck, 1987).
[[nodiscard]] FactorResult seminormalQr(const LinearMap& C, Backend backend);

/// A factor that solves with the digits of a double after corrections: Cholesky of the normal equations, and where that
/// meets a bad pivot or contracts too slowly, sparse QR of C. `probe` (k x 3) is any typical solution, by which
/// factors are measured. A failure names both reasons. Other backends than our own find an order themselves.
[[nodiscard]] FactorResult factorize(const LinearMap& C, Backend backend, const Columns3& probe,
                                     EliminationOrder order = EliminationOrder::ToBeFound);

/// Our own factor of a problem with the last rows `kept`, if corrections reach the digits of a double with it.
[[nodiscard]] FactorResult factorizeKept(const LinearMap& C, const SparseMatrix& kept, const Columns3& probe,
                                         EliminationOrder order);

}  // namespace holdfast

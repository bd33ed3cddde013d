#pragma once
/// A factorisation of a sparse least-squares problem. It is one of the normal equations, by our own method, CHOLMOD or
/// Eigen, or it is the R of a sparse QR.

#include <memory>
#include <string_view>

#include <holdfast/factor/packed_factor.h>
#include <holdfast/solve/linear_map.h>
#include <holdfast/solve/solver_options.h>
#include <holdfast/words/result.h>

namespace holdfast {

/// A factorised problem: minimise |C z - f| for any f. The last rows of C may be kept. These hold exactly, C z = 0
/// there, and have a multiplier each. The factor does not need C any more. One thread at a time may call it.
class LeastSquaresFactor {
 public:
  virtual ~LeastSquaresFactor() = default;

  /// Returns z for g = C^T f (k x 3), without any correction: see `correctedSolve`. With kept rows K it returns z and
  /// below it the multipliers l. These satisfy C^T C z + K^T l = g and K z = what is below g, for any g. O(nonzeros()).
  [[nodiscard]] virtual Columns3 solve(const Columns3& g) const = 0;

  /// Returns our own factor of C^T C or of the system with kept rows, and null where this is another one.
  [[nodiscard]] virtual const PackedFactor* packed() const { return nullptr; }

  /// Returns how many entries the factor stores.
  [[nodiscard]] virtual Index nonzeros() const = 0;

  /// Returns how the factor was made, in a user's words: "Cholesky factor of the normal equations (CHOLMOD)".
  [[nodiscard]] virtual std::string_view method() const = 0;

 protected:
  LeastSquaresFactor() = default;
  LeastSquaresFactor(const LeastSquaresFactor&) = default;
  LeastSquaresFactor& operator=(const LeastSquaresFactor&) = default;
};

/// A factorisation eliminates unknowns in one of these orders.
enum class EliminationOrder {
  ToBeFound,
  OfColumns  ///< the order of the columns of C, which keeps the factor small
};

using FactorResult = Result<std::unique_ptr<const LeastSquaresFactor>>;

/// Each of these factorises C (m x k), which has columns of unit length. `kept` are the last rows of C. The functions
/// of SuiteSparse are defined only where that is built.
[[nodiscard]] FactorResult choleskyMultifrontal(const LinearMap& C,
                                                EliminationOrder order = EliminationOrder::ToBeFound,
                                                const SparseMatrix& kept = {});
[[nodiscard]] FactorResult choleskyBySuiteSparse(const LinearMap& C);
[[nodiscard]] FactorResult choleskyByEigen(const LinearMap& C);
/// Makes R of a sparse QR of C and does not keep Q. It solves R^T R z = C^T f (semi-normal equations; Björck, 1987).
[[nodiscard]] FactorResult seminormalQr(const LinearMap& C, Backend backend);

/// Makes a factor that solves with the digits of a double after corrections. It tries Cholesky of the normal equations.
/// Where that meets a bad pivot or contracts too slowly, it takes sparse QR of C. `probe` (k x 3) is any typical
/// solution, by which factors are measured. A failure names both reasons. Other backends than our own find an order
/// themselves.
[[nodiscard]] FactorResult factorize(const LinearMap& C, Backend backend, const Columns3& probe,
                                     EliminationOrder order = EliminationOrder::ToBeFound);

/// Makes our own factor of a problem with the last rows `kept`. Fails where corrections do not reach the digits of a
/// double with it.
[[nodiscard]] FactorResult factorizeKept(const LinearMap& C, const SparseMatrix& kept, const Columns3& probe,
                                         EliminationOrder order);

}  // namespace holdfast

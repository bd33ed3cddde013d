#pragma once
/// Rows whose offsets are bounded along one axis, any number of them.

#include <functional>
#include <memory>
#include <vector>

#include <holdfast/elimination/diagnosis.h>
#include <holdfast/factor/packed_factor.h>
#include <holdfast/operators/energy_matrix.h>
#include <holdfast/solve/reduced_matrix.h>
#include <holdfast/words/result.h>

namespace holdfast {

/// The offset r of a row from its target keeps low <= r <= high, and adds weight r^2 / 2 to the energy. Bounds may be
/// infinite, and low is less than high.
struct RowBound {
  double low = 0;
  double high = 0;
  double weight = 0;
};

/// `BoundedRows::offsetsOf` begins with this, along one axis.
struct BoundedStart {
  Eigen::VectorXd u;        ///< n: meets the exact rows, and all bounds with room
  Eigen::VectorXd f;        ///< what A u is to be near
  Eigen::VectorXd targets;  ///< of the bounded rows: what they ask of u where their offset is 0
  double work = 0;          ///< a size of the energy: what all pulls could do within the bounds
};

struct BoundedOffsets {
  Eigen::VectorXd offsets;      ///< of the bounded rows, within their bounds to the last bit
  std::vector<char> isAtBound;  ///< 1 where a bound keeps a row from going farther
};

/// Minimises |A u - f|^2 / 2 and what offsets cost, under exact rows and bounds: a primal-dual interior-point method
/// with Mehrotra's corrections (Nocedal and Wright, Numerical Optimization, 16.6). Each of its 10 to 25 steps
/// factorises the normal equations of one axis once more, always with the same structure.
class BoundedRows {
 public:
  /// The rows `bounded` (places in `eliminated`, ascending) are bounded, and all others are exact. No dependency may
  /// have a bounded row.
  BoundedRows(std::shared_ptr<const EnergyMatrix> A, const EliminatedConstraints& eliminated,
              const std::vector<Index>& bounded);

  /// Returns the offsets of the least energy, and those of `start` where no row holds the surface. Calls `announce`
  /// with the number of each factorisation, from 1, before it. Throws what that throws. Fails where a factorisation
  /// does, and where rounding leaves more than 1e-7 of the work to be done.
  [[nodiscard]] Result<std::unique_ptr<const BoundedOffsets>> offsetsOf(const BoundedStart& start,
                                                                        const std::vector<RowBound>& bounds,
                                                                        const std::function<void(int)>& announce) const;

 private:
  [[nodiscard]] Result<std::unique_ptr<const PackedFactor>> factorOf(const Eigen::VectorXd& weights) const;
  /// Q2^T A^T (A u - f).
  [[nodiscard]] Eigen::VectorXd gradientAt(const Eigen::VectorXd& u, const Eigen::VectorXd& f) const;
  [[nodiscard]] Eigen::VectorXd solve(const PackedFactor& factor, const Eigen::VectorXd& g) const;

  std::shared_ptr<const EnergyMatrix> A_;
  SparseRows B_;
  std::size_t exactCount_;
  TwoWayMatrix Q2_;
  SparseRows reduced_;  // B Q2
  std::shared_ptr<const SymbolicFactor> symbolic_;
  SparseMatrix lower_;        // of Q2^T A^T A Q2 with the bounded rows below it, in the order of elimination
  std::vector<int> placeOf_;  // of each column in that order, and of each row behind them
};

}  // namespace holdfast

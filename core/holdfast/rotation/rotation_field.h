#pragma once
/// The rotation of every unknown from those that are given: a harmonic field of logarithms, section 3.3 of the paper.

#include <memory>
#include <vector>

#include <holdfast/operators/laplacian.h>
#include <holdfast/solve/column_scaling.h>
#include <holdfast/solve/corrected_solve.h>

namespace holdfast {

/// The field that minimises the sum of w_ij |q_i - q_j|^2. q is given at some unknowns and equal inside rigid regions.
struct RotationProblem {
  Index unknownCount = 0;
  std::vector<EdgeWeight> weights;               ///< each edge once
  std::vector<Index> prescribed;                 ///< unknowns whose q is given, in the order of precedence
  std::vector<std::vector<Index>> rigidRegions;  ///< unknowns of each rigid region; regions that overlap are one
  std::vector<int> ranks = {};                   ///< `eliminationRanks`; empty: the factorisation finds an order
};

/// Each unknown is one of three kinds: given (`givenOf`), free (`columnOf`), or out of reach of everything given
/// (neither).
struct RotationUnknowns {
  std::vector<Index> givenOf;      ///< of each unknown: place in `prescribed` of the value that it has; -1
  std::vector<Index> columnOf;     ///< of each unknown: its column, that of all free unknowns of one region; -1
  std::vector<Index> leaderOf;     ///< of each place in `prescribed`: the first place of the same region
  std::vector<Index> referenceOf;  ///< of each column: the first place in `prescribed` that edges and regions tie it to

  [[nodiscard]] Index columnCount() const noexcept { return static_cast<Index>(referenceOf.size()); }
};

/// A pull is what a given rotation asks of an equation: `weight` times its difference from another given rotation.
struct RotationPull {
  Index row = 0;
  double weight = 0;
  Index given = 0;      ///< place in `prescribed`
  Index reference = 0;  ///< place in `prescribed`
};

/// Two given rotations of one rigid region that differ.
struct RotationGap {
  Index given = 0;  ///< place in `RotationProblem::prescribed`
  Index first = 0;  ///< place of the first of the region
  Vector3 difference = Vector3::Zero();
};

/// A log for every unknown.
struct RotationField {
  Columns3 q;                     ///< n x 3, half angle times axis, radians
  double accuracy = 0;            ///< estimated relative error of its free part
  std::vector<RotationGap> gaps;  ///< ascending by `given`; none where the given rotations of each region agree
};

/// A solver holds one decomposition, for any number of values at the same unknowns. Other unknowns, regions or weights
/// make another solver.
class RotationFieldSolver {
 public:
  /// `factor` must be a factor of `scaled.C`.
  RotationFieldSolver(RotationUnknowns unknowns, std::vector<RotationPull> pulls, ScaledColumns scaled,
                      std::unique_ptr<const LeastSquaresFactor> factor);

  /// Returns the field for `values` (prescribed.size() x 3), the logs at `RotationProblem::prescribed`. They may have
  /// any number of turns and are copied bit for bit. Without negative weights every q is a mean of the given ones with
  /// non-negative weights, up to rounding. A part of the mesh may be tied to values that are all the same. Then q is
  /// exactly that there. Unknowns that are tied to no value have q = 0.
  ///
  /// O(factor). It is O(n) where up to four values differ and are equal at the same places as in the call before. One
  /// thread at a time may call it.
  [[nodiscard]] RotationField solve(const Columns3& values) const;

 private:
  /// Returns how far each unknown is from its base, n x 3. The pulls make this of three numbers that are given at each
  /// place in `prescribed`.
  [[nodiscard]] CorrectedSolution pulled(const Columns3& values) const;

  /// The last answer to distinct values. Each of its columns says how far one of them reaches.
  struct Response {
    std::vector<int> valueOf;  ///< of each place in `prescribed`
    CorrectedSolution reach;
  };

  RotationUnknowns unknowns_;
  std::vector<int> baseOf_;  // of each unknown: place in `prescribed` of its value, or of its reference; -1
  std::vector<RotationPull> pulls_;
  ScaledColumns scaled_;
  std::unique_ptr<const LeastSquaresFactor> factor_;
  mutable Response response_;
};

using RotationFieldResult = Result<std::unique_ptr<const RotationFieldSolver>>;

/// Makes a solver that minimises the Dirichlet energy by least squares over the edges. Where a weight is negative there
/// may be no minimum. Then it solves L q = 0, (25), at every free unknown, summed over each rigid region. Fails for
/// weights that are not finite, and for negative ones that leave the equations singular.
[[nodiscard]] RotationFieldResult makeRotationFieldSolver(const RotationProblem& problem, Backend backend);

}  // namespace holdfast

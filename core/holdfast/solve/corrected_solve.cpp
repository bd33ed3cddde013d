#include "holdfast/solve/corrected_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <holdfast/matrices/largest_size.h>

namespace holdfast {
namespace {

constexpr int kMaxCorrections = 20;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// A factor that leaves a share c of an error leaves c of the first correction, too: below this, c^2 is less than a
// double holds, and another correction would only exchange one rounding for another.
const double kLastCorrection = std::sqrt(kEpsilon);
// What another correction would take off is less than this share of the accuracy that is reached.
constexpr double kNegligible = 1.0 / 64;
// The size of the first correction estimates the error that the normal equations cause. Measured errors were up to 2.3
// times as large as the estimate that follows from it.
constexpr double kSampleFactor = 2.5;
// A correction larger than this share of the one before has met rounding, or a factor that does not contract.
constexpr double kStalled = 0.5;

/// The normal equations lose cond^2 epsilon = `first`; what their corrections reach is cond epsilon.
double reachedBy(double first)
{
  return std::sqrt(first * kEpsilon);
}

/// After one of that relative size.
bool isLastCorrection(double first, double change)
{
  return first * change <= kNegligible * reachedBy(first);
}

/// What changes a solution and its multipliers when this is left of their equations: of C z = f (`left`), and in its
/// last rows of K z = 0.
Columns3 solved(const LeastSquaresFactor& factor, const LinearMap& C, Columns3 left, const Columns3& multipliers)
{
  const Index kept = multipliers.rows();
  if (kept == 0) return factor.solve(C.transposeTimes(left));
  const Columns3 ofKept = left.bottomRows(kept);
  left.bottomRows(kept) -= multipliers;
  Columns3 g = C.transposeTimes(left);
  g.conservativeResize(g.rows() + kept, 3);
  g.bottomRows(kept) = ofKept;
  return factor.solve(g);
}

}  // namespace

CorrectedSolution correctedSolve(const LeastSquaresFactor& factor, const LinearMap& C,
                                 const Eigen::VectorXd& columnScale, const Columns3& f, Index kept,
                                 const KnownSolution& known)
{
  const Index unknowns = columnScale.size();
  const Columns3 none = Columns3::Zero(kept, 3);
  if (f.isZero(0)) return {Columns3::Zero(unknowns, 3), none, 0, 0, known.left};
  CorrectedSolution result{{}, known.multipliers.rows() == kept ? known.multipliers : none, 0, 0, known.left};
  auto& [z, multipliers, corrections, accuracy, first] = result;
  z = solved(factor, C, f, multipliers);
  multipliers += z.bottomRows(kept);
  z.conservativeResize(unknowns, 3);
  const double taken = largestSize(columnScale, z);
  if (known.isTelling()) first = std::max(first, taken / known.step);
  if (first > 0 && isLastCorrection(first, taken / known.size)) {
    accuracy = kSampleFactor * reachedBy(first);
    return result;
  }
  double last = std::numeric_limits<double>::infinity();
  while (corrections < kMaxCorrections) {
    const double size = std::max(known.size, largestSize(columnScale, z));
    if (size == 0) break;
    const Columns3 correction = solved(factor, C, C.residual(f, z), multipliers);
    const auto step = correction.topRows(unknowns);
    const double change = largestSize(columnScale, step) / size;
    if (!(change < last)) break;
    z += step;
    multipliers += correction.bottomRows(kept);
    if (corrections++ == 0 && first == 0) first = change;
    const bool isLast = change <= kLastCorrection || isLastCorrection(first, change);
    accuracy = isLast ? kSampleFactor * reachedBy(first) : change;
    if (isLast || change > kStalled * last) break;
    last = change;
  }
  return result;
}

double contraction(const LeastSquaresFactor& factor, const LinearMap& C, const Columns3& probe, Index kept)
{
  const Columns3 found = solved(factor, C, C.times(probe), Columns3::Zero(kept, 3)).topRows(probe.rows());
  return largestSize(probe) == 0 ? 0 : largestSize(found - probe) / largestSize(probe);
}

}  // namespace holdfast

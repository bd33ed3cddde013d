#include "holdfast/solve/corrected_solve.h"

#include <cmath>
#include <limits>

namespace holdfast {
namespace {

constexpr int kMaxCorrections = 20;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// A factor that leaves a share c of an error leaves c of the first correction, too: below this, c^2 is less than a
// double holds, and another correction would only exchange one rounding for another.
const double kLastCorrection = std::sqrt(kEpsilon);
// A correction larger than this share of the one before has met rounding, or a factor that does not contract.
constexpr double kStalled = 0.5;

template <class Matrix>
double largest(const Eigen::MatrixBase<Matrix>& x)
{
  return x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff();
}

}  // namespace

CorrectedSolution correctedSolve(const LeastSquaresFactor& factor, const TwoWayMatrix& C,
                                 const Eigen::VectorXd& columnScale, const Columns3& f)
{
  if (f.isZero(0)) return {Columns3::Zero(C.columns().cols(), 3), 0, 0};
  CorrectedSolution result{factor.solve(C.transposeTimes(f)), 0, 0};
  double first = 0;
  double last = std::numeric_limits<double>::infinity();
  while (result.corrections < kMaxCorrections) {
    const double size = largest(columnScale.asDiagonal() * result.z);
    if (size == 0) break;
    const Columns3 correction = factor.solve(C.transposeTimes(C.residual(f, result.z)));
    const double change = largest(columnScale.asDiagonal() * correction) / size;
    if (!(change < last)) break;
    result.z += correction;
    if (result.corrections++ == 0) first = change;
    // The normal equations lost cond^2 epsilon = first; what their corrections reach is cond epsilon.
    result.accuracy = change <= kLastCorrection ? std::sqrt(first * kEpsilon) : change;
    if (change <= kLastCorrection || change > kStalled * last) break;
    last = change;
  }
  return result;
}

double contraction(const LeastSquaresFactor& factor, const TwoWayMatrix& C, const Columns3& probe)
{
  const Columns3 found = factor.solve(C.transposeTimes(C.times(probe)));
  return largest(probe) == 0 ? 0 : largest(found - probe) / largest(probe);
}

}  // namespace holdfast

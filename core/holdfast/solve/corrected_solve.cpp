#include <limits>

#include <holdfast/solve/corrected_solve.h>

namespace holdfast {
namespace {

constexpr int kMaxCorrections = 20;
constexpr double kDone = 4 * std::numeric_limits<double>::epsilon();
// A correction larger than this share of the one before has met rounding, or a factor that does not contract.
constexpr double kStalled = 0.5;

double largest(const Columns3& x)
{
  return x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff();
}

}  // namespace

CorrectedSolution correctedSolve(const LeastSquaresFactor& factor, const SparseMatrix& C,
                                 const Eigen::VectorXd& columnScale, const Columns3& f)
{
  CorrectedSolution result{factor.solve(f), 0, 0};
  double last = std::numeric_limits<double>::infinity();
  while (result.corrections < kMaxCorrections) {
    const double size = largest(columnScale.asDiagonal() * result.z);
    if (size == 0) break;
    const Columns3 correction = factor.solve(f - C * result.z);
    const double change = largest(columnScale.asDiagonal() * correction) / size;
    if (!(change < last)) break;
    result.z += correction;
    result.accuracy = change;
    ++result.corrections;
    if (change <= kDone || change > kStalled * last) break;
    last = change;
  }
  return result;
}

double contraction(const LeastSquaresFactor& factor, const SparseMatrix& C, const Columns3& probe)
{
  const Columns3 found = factor.solve(C * probe);
  return largest(probe) == 0 ? 0 : largest(found - probe) / largest(probe);
}

}  // namespace holdfast

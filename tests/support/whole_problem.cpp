#include "support/whole_problem.h"

#include "support/lapack.h"

namespace holdfast::test {
namespace {

/// The directions in which a row holds, square to one another.
std::vector<Vector3> heldDirections(const RowDirections& directions)
{
  if (directions.areAll()) return {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  const Vector3& axis = directions.axis();
  if (directions.areAlongAxis()) return {axis};
  const Vector3 first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

}  // namespace

std::optional<Columns3> wholeSolution(const Eigen::MatrixXd& A, const Columns3& f, const ConstraintSystem& system)
{
  // All coordinates of all unknowns, x of all first.
  const Index n = A.cols();
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(3 * A.rows(), 3 * n);
  for (Index k = 0; k < 3; ++k) whole.block(k * A.rows(), k * n, A.rows(), n) = A;
  std::vector<Eigen::RowVectorXd> B;
  std::vector<double> d;
  for (const ConstraintRow& row : system.rows)
    for (const Vector3& direction : heldDirections(row.directions)) {
      Eigen::RowVectorXd& equation = B.emplace_back(Eigen::RowVectorXd::Zero(3 * n));
      for (Index k = 0; k < 3; ++k)
        for (const Term& term : row.terms) equation[k * n + term.index] = direction[k] * term.coefficient;
      d.push_back(direction.dot(row.shift));
    }
  Eigen::MatrixXd rows(static_cast<Index>(B.size()), 3 * n);
  for (std::size_t r = 0; r < B.size(); ++r) rows.row(static_cast<Index>(r)) = B[r];
  const Eigen::MatrixXd wanted = Eigen::MatrixXd(f).reshaped(3 * f.rows(), 1);
  const Eigen::MatrixXd asked = Eigen::Map<const Eigen::VectorXd>(d.data(), static_cast<Index>(d.size()));
  const std::optional<Eigen::MatrixXd> u = constrainedLeastSquaresByLapack(whole, rows, wanted, asked);
  if (!u) return std::nullopt;
  return Columns3(u->reshaped(n, 3));
}

}  // namespace holdfast::test

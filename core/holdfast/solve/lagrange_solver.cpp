// Constraints by Lagrange multipliers (end of section 3.2 of the paper), for comparison with elimination.

#include <fmt/format.h>

#include <holdfast/solve/constrained_solver.h>
#include <holdfast/solve/corrected_solve.h>
#include <holdfast/solve/sparse_lu.h>

namespace holdfast {
namespace {

/// [A^T A, B^T; B, 0].
SparseMatrix saddleMatrix(const SparseMatrix& A, const SparseMatrix& B)
{
  const SparseMatrix normal = A.transpose() * A;
  const SparseMatrix BT = B.transpose();
  const Index k = A.cols();
  return assembled<SparseMatrix>(k + B.rows(), k + B.rows(), [&](Index j, ColumnSum& sum) {
    if (j >= k) return sum.addColumn(BT, j - k);
    sum.addColumn(normal, j);
    sum.addColumn(B, j, k);
  });
}

class LagrangeSolver final : public ConstrainedSolver {
 public:
  LagrangeSolver(SparseMatrix spread, SparseMatrix A, SparseMatrix B, std::vector<Index> rows, SparseLu lu)
      : spread_(std::move(spread)), A_(std::move(A)), B_(std::move(B)), rows_(std::move(rows)), lu_(std::move(lu))
  {
  }

  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    Columns3 d(B_.rows(), 3);
    for (Index k = 0; k < d.rows(); ++k) d.row(k) = targets.shifts.row(rows_[k]);
    Columns3 rightSides(unknowns(), 3);
    rightSides << A_.transpose() * f, d;
    const Columns3 found = lu_.solve(rightSides);
    return {spread_ * found.topRows(A_.cols()), 0, accuracy(found, f, d)};
  }

  [[nodiscard]] Index unknowns() const override { return A_.cols() + static_cast<Index>(rows_.size()); }
  [[nodiscard]] Index factorNonzeros() const override { return lu_.nonzeros; }
  [[nodiscard]] std::string method() const override { return "LU of the system of Lagrange multipliers"; }

 private:
  /// The size of the step that would correct `found`, relative to the displacement. Of the residual A^T (f - A u) -
  /// B^T l, d - B u, computed through A itself: as `correctedSolve` does, which takes the step.
  [[nodiscard]] double accuracy(const Columns3& found, const Columns3& f, const Columns3& d) const
  {
    const auto u = found.topRows(A_.cols());
    const double size = u.size() == 0 ? 0 : u.cwiseAbs().maxCoeff();
    if (size == 0) return 0;
    Columns3 residual(found.rows(), 3);
    residual << A_.transpose() * (f - A_ * u) - B_.transpose() * found.bottomRows(B_.rows()), d - B_ * u;
    return lu_.solve(residual).topRows(A_.cols()).cwiseAbs().maxCoeff() / size;
  }

  SparseMatrix spread_;  // n x free unknowns, identity columns
  SparseMatrix A_;       // over free unknowns
  SparseMatrix B_;       // the independent rows, over free unknowns
  std::vector<Index> rows_;
  SparseLu lu_;
};

/// What a correction leaves of an error, by a known solution: as `contraction` of least-squares factors.
double contractionOf(const SparseLu& lu, const SparseMatrix& A, const SparseMatrix& B, const Columns3& probe)
{
  if (probe.isZero(0)) return 0;
  Columns3 rightSides(A.cols() + B.rows(), 3);
  rightSides << A.transpose() * (A * probe), B * probe;
  return (lu.solve(rightSides).topRows(A.cols()) - probe).cwiseAbs().maxCoeff() / probe.cwiseAbs().maxCoeff();
}

std::optional<SparseLu> factorLu(const SparseMatrix& K, Backend backend)
{
#ifdef HOLDFAST_WITH_CHOLMOD
  if (backend != Backend::Eigen) return luBySuiteSparse(K);
#endif
  static_cast<void>(backend);
  return luByEigen(K);
}

}  // namespace

SolverResult makeLagrangeSolver(const ConstrainedProblem& problem, Backend backend)
{
  const EliminatedConstraints& eliminated = *problem.eliminated;
  const SparseMatrix whole = problem.A->matrix();
  SparseMatrix spread = Elimination({}, {}, whole.cols(), eliminated.isHeld).Q2();
  std::vector<Index> rows = independentRows(eliminated.dependencies, eliminated.rows.size());
  std::vector<RowTerms> terms;
  terms.reserve(rows.size());
  for (const Index row : rows) terms.push_back(eliminated.rows[row]);
  SparseMatrix A = whole * spread;
  SparseMatrix B = constraintMatrix(terms, whole.cols()) * spread;
  std::optional<SparseLu> lu = factorLu(saddleMatrix(A, B), backend);
  if (!lu) return {nullptr, "the system of Lagrange multipliers is singular in doubles"};
  const double left = contractionOf(*lu, A, B, spread.transpose() * problem.rest);
  if (!(left <= kUsableContraction))
    return {nullptr, fmt::format("the system of Lagrange multipliers keeps no digits (a correction leaves {:.1g} of an "
                                 "error)",
                                 left)};
  return {
      std::make_unique<LagrangeSolver>(std::move(spread), std::move(A), std::move(B), std::move(rows), std::move(*lu))};
}

}  // namespace holdfast

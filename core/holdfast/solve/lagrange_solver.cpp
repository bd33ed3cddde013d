// Constraints by Lagrange multipliers (end of section 3.2 of the paper), for comparison with elimination.

#include <utility>
#include <vector>

#include <holdfast/elimination/find_dependencies.h>
#include <holdfast/solve/constraint_matrix.h>
#include <holdfast/solve/deformation_solver.h>
#include <holdfast/solve/sparse_lu.h>

namespace holdfast {
namespace {

/// [A^T A, B^T; B, 0].
SparseMatrix saddleMatrix(const SparseMatrix& A, const SparseMatrix& B)
{
  const SparseMatrix normal = A.transpose() * A;
  const int k = static_cast<int>(A.cols());
  std::vector<Eigen::Triplet<double, int>> entries;
  for (int j = 0; j < normal.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(normal, j); entry; ++entry)
      entries.emplace_back(static_cast<int>(entry.row()), j, entry.value());
  for (int j = 0; j < B.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(B, j); entry; ++entry) {
      entries.emplace_back(k + static_cast<int>(entry.row()), j, entry.value());
      entries.emplace_back(j, k + static_cast<int>(entry.row()), entry.value());
    }
  SparseMatrix K(k + B.rows(), k + B.rows());
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

class LagrangeSolver final : public DeformationSolver {
 public:
  LagrangeSolver(SparseMatrix spread, SparseMatrix A, std::vector<Index> rows, std::unique_ptr<const SparseLu> lu)
      : spread_(std::move(spread)), A_(std::move(A)), rows_(std::move(rows)), lu_(std::move(lu))
  {
  }

  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    Columns3 rightSides(unknowns(), 3);
    rightSides.topRows(A_.cols()) = A_.transpose() * f;
    for (std::size_t k = 0; k < rows_.size(); ++k) rightSides.row(A_.cols() + k) = targets.shifts.row(rows_[k]);
    return {spread_ * lu_->solve(rightSides).topRows(A_.cols()), 0, 0};
  }

  [[nodiscard]] Index unknowns() const override { return A_.cols() + static_cast<Index>(rows_.size()); }
  [[nodiscard]] Index factorNonzeros() const override { return lu_->nonzeros(); }
  [[nodiscard]] std::string method() const override { return "LU of the system of Lagrange multipliers"; }

 private:
  SparseMatrix spread_;  // n x free unknowns, identity columns
  SparseMatrix A_;       // over free unknowns
  std::vector<Index> rows_;
  std::unique_ptr<const SparseLu> lu_;
};

std::unique_ptr<const SparseLu> factorLu(const SparseMatrix& K, Backend backend)
{
#ifdef HOLDFAST_WITH_CHOLMOD
  if (backend == Backend::Cholmod) return luBySuiteSparse(K);
#endif
  static_cast<void>(backend);
  return luByEigen(K);
}

}  // namespace

DecompositionAttempt makeLagrangeSolver(DeformationProblem problem, Backend backend)
{
  const EliminatedConstraints& eliminated = problem.eliminated;
  const Index n = problem.A.cols();
  SparseMatrix spread = Elimination({}, {}, n, eliminated.isHeld).Q2();
  std::vector<Index> rows = independentRows(eliminated.dependencies, eliminated.rows.size());
  std::vector<RowTerms> terms;
  for (const Index row : rows) terms.push_back(eliminated.rows[row]);
  SparseMatrix A = problem.A * spread;
  auto lu = factorLu(saddleMatrix(A, constraintMatrix(terms, n) * spread), backend);
  if (lu == nullptr) return {nullptr, "the system of Lagrange multipliers is singular in doubles"};
  return {std::make_unique<LagrangeSolver>(std::move(spread), std::move(A), std::move(rows), std::move(lu)), {}};
}

}  // namespace holdfast

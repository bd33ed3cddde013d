#include "bench/paper/reference.h"

#include <array>

#include <holdfast/ordering/elimination_order.h>

#include "bench/random.h"

namespace holdfast::paper {
namespace {

__extension__ using Quad = __float128;  // ISO C++ has no name for it
using QuadRow = std::array<Quad, 3>;
using QuadColumns = std::vector<QuadRow>;

constexpr int kMostCorrections = 60;
constexpr double kEnough = 1e-26;
constexpr double kStalls = 0.9;

Columns3 rounded(const QuadColumns& x)
{
  Columns3 result(static_cast<Index>(x.size()), 3);
  for (Index i = 0; i < result.rows(); ++i)
    for (int c = 0; c < 3; ++c) result(i, c) = static_cast<double>(x[i][c]);
  return result;
}

void add(QuadColumns& x, const Columns3& step)
{
  for (Index i = 0; i < step.rows(); ++i)
    for (int c = 0; c < 3; ++c) x[i][c] += step(i, c);
}

QuadRow rowOf(const Columns3& x, Index i)
{
  return {x(i, 0), x(i, 1), x(i, 2)};
}

/// sum - (k-th row, or column of a matrix by columns, of M) x.
template <class Matrix>
QuadRow less(QuadRow sum, const Matrix& M, Index k, const QuadColumns& x)
{
  for (typename Matrix::InnerIterator entry(M, k); entry; ++entry)
    for (int c = 0; c < 3; ++c) sum[c] -= static_cast<Quad>(entry.value()) * x[entry.index()][c];
  return sum;
}

/// f - M x, by rows of M or columns of its transpose.
template <class Matrix>
QuadColumns residual(const Columns3& f, const Matrix& M, const QuadColumns& x)
{
  QuadColumns result(static_cast<std::size_t>(f.rows()));
  parallelBlocks(f.rows(), [&](Index k) { result[k] = less(rowOf(f, k), M, k, x); });
  return result;
}

/// y - M x.
template <class Matrix>
void subtract(QuadColumns& y, const Matrix& M, const QuadColumns& x)
{
  parallelBlocks(static_cast<Index>(y.size()), [&](Index k) { y[k] = less(y[k], M, k, x); });
}

double largest(const Columns3& x)
{
  return x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff();
}

/// Corrects by `step`, which returns how much it has changed, until that no longer shrinks.
template <class Step>
Reference corrected(QuadColumns& u, const Step& step)
{
  Reference result;
  for (int k = 0; k < kMostCorrections; ++k) {
    const double change = step() / largest(rounded(u));
    if (k > 2 && !(change < kStalls * result.lastCorrection)) break;
    result.lastCorrection = change;
    if (change <= kEnough) break;
  }
  result.u = rounded(u);
  return result;
}

}  // namespace

Result<ReducedProblem> reducedProblem(const BentMesh& bent, const BentProblem& problem, const Method& method)
{
  const ConstrainedProblem product = constrainedProblem(bent, problem);
  const Elimination& elimination = bent.eliminated->elimination;
  if (method.kind != SolverKind::Soft)
    return makeReducedProblem(problem.A, orderedColumns(elimination.wholeQ2(), bent.ranks), {}, RowsBelow::Kept,
                              product.rest, Backend::Holdfast, EliminationOrder::OfColumns);
  SparseMatrix Q2 = freeColumns(bent);
  SparseRows below = method.weight * SparseRows(problem.B * Q2);
  return makeReducedProblem(problem.A, std::move(Q2), std::move(below), RowsBelow::Equations, product.rest,
                            Backend::Holdfast, EliminationOrder::OfColumns);
}

Reference quadrupleSolution(const BentMesh& bent, const BentProblem& problem, const ReducedProblem& reduced,
                            const Method& method)
{
  const SparseMatrix BT = problem.B.transpose();
  const SparseMatrix Q2T = reduced.C->Q2()->rows().transpose();
  const TwoWayMatrix A(problem.A->matrix());
  const Columns3 none = Columns3::Zero(problem.A->cols(), 3);
  const Elimination& elimination = bent.eliminated->elimination;
  QuadColumns u(static_cast<std::size_t>(none.rows()), QuadRow{});
  QuadColumns multipliers(static_cast<std::size_t>(problem.d.rows()), QuadRow{});
  // A^T (A u - f): (M^T, -x) is subtracted from 0.
  const auto gradient = [&] { return residual(none, A.columns(), residual(problem.f, A.rows(), u)); };
  const auto reducedStep = [&](const QuadColumns& against) {
    const Columns3 step = reduced.C->spread(reduced.factor->solve(Q2T * rounded(against)));
    add(u, -step);
    return largest(step);
  };
  if (method.kind == SolverKind::Soft)
    return corrected(u, [&] {
      QuadColumns against = gradient();
      QuadColumns missed = residual(problem.d, problem.B, u);
      for (QuadRow& row : missed)
        for (Quad& value : row) value *= static_cast<Quad>(method.weight) * static_cast<Quad>(method.weight);
      subtract(against, SparseRows(BT), missed);
      return reducedStep(against);
    });
  // At the minimum the gradient is B^T l. What l explains of it is subtracted before Q2, which is orthogonal to B in
  // doubles only.
  return corrected(u, [&] {
    const Columns3 toRows = elimination.particular(rounded(residual(problem.d, problem.B, u)));
    add(u, toRows);
    QuadColumns against = gradient();
    subtract(against, SparseRows(BT), multipliers);
    const Columns3 more = elimination.multipliers(rounded(against));
    add(multipliers, more);
    QuadColumns moreInQuad(multipliers.size(), QuadRow{});
    add(moreInQuad, more);
    subtract(against, SparseRows(BT), moreInQuad);
    return std::max(largest(toRows), reducedStep(against));
  });
}

double conditionOf(const ReducedProblem& reduced)
{
  constexpr int kIterations = 30;
  const Index size = reduced.scale.size();
  bench::Random random(5);
  Columns3 start(size, 3);
  for (Index i = 0; i < size; ++i)
    for (int c = 0; c < 3; ++c) start(i, c) = random.uniform(-1, 1);
  const auto largestEigenvalue = [&](const auto& times) {
    Columns3 x = start;
    for (int k = 0; k < kIterations; ++k) x = times(Columns3(x.array().rowwise() / x.colwise().norm().array()));
    return x.colwise().norm().maxCoeff();
  };
  const double most = largestEigenvalue([&](const Columns3& x) -> Columns3 {
    const Columns3 scaled = reduced.scale.cwiseInverse().asDiagonal() * x;
    return reduced.scale.cwiseInverse().asDiagonal() * reduced.C->transposeTimes(reduced.C->times(scaled));
  });
  const double inverse = largestEigenvalue([&](const Columns3& x) -> Columns3 {
    return reduced.scale.asDiagonal() * reduced.factor->solve(reduced.scale.asDiagonal() * x);
  });
  return most * inverse;
}

}  // namespace holdfast::paper

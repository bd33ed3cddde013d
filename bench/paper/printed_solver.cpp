#include "bench/paper/printed_solver.h"

#include <optional>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <Eigen/UmfPackSupport>

#include <holdfast/base/one_thread_internal.h>
#include <holdfast/solve/elimination_order.h>

#include "bench/measure.h"

namespace holdfast::paper {
namespace {

template <class Scalar>
using Matrix = Eigen::SparseMatrix<Scalar, Eigen::ColMajor, int>;
template <class Scalar>
using Columns = Eigen::Matrix<Scalar, Eigen::Dynamic, 3>;

/// x of M^T M x = M^T b; nothing where the factorisation fails.
std::optional<Columns<double>> normalSolution(const Matrix<double>& M, const Columns<double>& b)
{
  const TwoWayMatrix C(M);
  const FactorResult factor = choleskyBySuiteSparse(C);
  if (!factor) return std::nullopt;
  return factor.value->solve(C.transposeTimes(b));
}

std::optional<Columns<float>> normalSolution(const Matrix<float>& M, const Columns<float>& b)
{
  const Matrix<float> N = M.transpose() * M;
  const Eigen::SimplicialLLT<Matrix<float>, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(N);
  if (factor.info() != Eigen::Success) return std::nullopt;
  return factor.solve(Columns<float>(M.transpose() * b));
}

std::optional<Columns<double>> luSolution(const Matrix<double>& K, const Columns<double>& b)
{
  const OneThread libraries;
  Eigen::UmfPackLU<Matrix<double>> factor;
  factor.umfpackControl()[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
  factor.umfpackControl()[UMFPACK_IRSTEP] = 0;
  factor.compute(K);
  if (factor.info() != Eigen::Success) return std::nullopt;
  return factor.solve(b);
}

std::optional<Columns<float>> luSolution(const Matrix<float>& K, const Columns<float>& b)
{
  const Eigen::SparseLU<Matrix<float>> factor(K);
  if (factor.info() != Eigen::Success) return std::nullopt;
  return factor.solve(b);
}

/// The rows of `below` under those of `above`.
template <class Scalar>
Matrix<Scalar> stacked(const Matrix<Scalar>& above, const Matrix<Scalar>& below)
{
  return assembled<Matrix<Scalar>>(above.rows() + below.rows(), above.cols(), [&](Index j, ColumnSum& sum) {
    sum.addColumn(above, j);
    sum.addColumn(below, j, above.rows());
  });
}

/// What is solved for positions p: minimise |A p - c| under B p = d.
template <class Scalar>
struct Printed {
  Matrix<Scalar> A;
  Columns<Scalar> c;
  Matrix<Scalar> B;
  Columns<Scalar> d;
  Columns<Scalar> rest;
};

template <class Scalar>
Printed<Scalar> printed(const BentMesh& bent, const BentProblem& problem)
{
  const Positions& rest = bent.model.solverMesh.rest;
  const Columns3 c = problem.A->times(rest) + problem.f;
  const Columns3 d = problem.B * rest + problem.d;
  return {problem.A->columns().cast<Scalar>(), c.cast<Scalar>(), SparseMatrix(problem.B).cast<Scalar>(),
          d.cast<Scalar>(), rest.cast<Scalar>()};
}

/// (7) and (8), soft constraints, over the free unknowns.
template <class Scalar>
std::optional<Columns<Scalar>> softPositions(const BentMesh& bent, const Printed<Scalar>& problem, double weight)
{
  const auto w = static_cast<Scalar>(weight);
  const Matrix<Scalar> S = freeColumns(bent).cast<Scalar>();
  const Matrix<Scalar> M = stacked<Scalar>(problem.A * S, w * (problem.B * S));
  Columns<Scalar> b(M.rows(), 3);
  b << problem.c, w * problem.d;
  const auto x = normalSolution(M, b);
  if (!x) return std::nullopt;
  return problem.rest + S * (*x - S.transpose() * problem.rest);
}

/// (11) to (21), hard constraints: those of B^T = Q R, (14), in double precision, rounded.
template <class Scalar>
std::optional<Columns<Scalar>> hardPositions(const BentMesh& bent, const Printed<Scalar>& problem)
{
  const Elimination& elimination = bent.eliminated->elimination;
  const Matrix<Scalar> Q2 = orderedColumns(elimination.wholeQ2(), bent.ranks).cast<Scalar>();
  const Columns<Scalar> particular = elimination.particular(problem.d.template cast<double>()).template cast<Scalar>();
  const Matrix<Scalar> M = problem.A * Q2;
  const auto z = normalSolution(M, Columns<Scalar>(problem.c - problem.A * particular));
  if (!z) return std::nullopt;
  const Matrix<Scalar> S = freeColumns(bent).cast<Scalar>();
  return problem.rest + S * (S.transpose() * Columns<Scalar>(particular + Q2 * *z - problem.rest));
}

/// [A^T A, B^T; B, 0] [p; l] = [A^T c; d], end of section 3.2, over the free unknowns.
template <class Scalar>
std::optional<Columns<Scalar>> lagrangePositions(const BentMesh& bent, const Printed<Scalar>& problem)
{
  const Matrix<Scalar> S = freeColumns(bent).cast<Scalar>();
  const Matrix<Scalar> A = problem.A * S;
  const Matrix<Scalar> B = problem.B * S;
  const Matrix<Scalar> N = A.transpose() * A;
  const Matrix<Scalar> BT = B.transpose();
  const Index k = A.cols();
  const auto K = assembled<Matrix<Scalar>>(k + B.rows(), k + B.rows(), [&](Index j, ColumnSum& sum) {
    if (j >= k) return sum.addColumn(BT, j - k);
    sum.addColumn(N, j);
    sum.addColumn(B, j, k);
  });
  Columns<Scalar> b(K.rows(), 3);
  b << A.transpose() * problem.c, problem.d;
  const auto x = luSolution(K, b);
  if (!x) return std::nullopt;
  return problem.rest + S * (x->topRows(k) - S.transpose() * problem.rest);
}

template <class Scalar>
Outcome solved(const BentMesh& bent, const BentProblem& problem, const Method& method, const Columns3& reference)
{
  const Printed<Scalar> asPrinted = printed<Scalar>(bent, problem);
  std::optional<Columns<Scalar>> p;
  const double seconds = bench::secondsOf([&] {
    if (method.kind == SolverKind::Soft) p = softPositions(bent, asPrinted, method.weight);
    if (method.kind == SolverKind::Hard) p = hardPositions(bent, asPrinted);
    if (method.kind == SolverKind::Lagrange) p = lagrangePositions(bent, asPrinted);
  });
  if (!p) return {"fails", 0, 0, seconds};
  return judged(problem, p->template cast<double>() - bent.model.solverMesh.rest, reference, seconds);
}

}  // namespace

Outcome judged(const BentProblem& problem, const Columns3& u, const Columns3& reference, double seconds)
{
  if (!u.allFinite()) return {"fails", 0, 0, seconds};
  return {"", (problem.B * u - problem.d).rowwise().norm().maxCoeff(), (u - reference).rowwise().norm().maxCoeff(),
          seconds};
}

Outcome solvedInDouble(const BentMesh& bent, const BentProblem& problem, const Method& method,
                       const Columns3& reference)
{
  return solved<double>(bent, problem, method, reference);
}

Outcome solvedInSingle(const BentMesh& bent, const BentProblem& problem, const Method& method,
                       const Columns3& reference)
{
  const Index unknowns = problem.A->columns().cols();
  if (method.kind == SolverKind::Lagrange && unknowns > kMostForSingleLu) return {kNotRun};
  return solved<float>(bent, problem, method, reference);
}

Outcome solvedByProduct(const BentMesh& bent, const BentProblem& problem, const Method& method,
                        const Columns3& reference)
{
  SolverOptions options;
  options.kind = method.kind;
  options.softWeight = method.weight;
  std::string failure;
  Columns3 u;
  const double seconds = bench::secondsOf([&] {
    const SolverResult solver = makeSolver(constrainedProblem(bent, problem), options);
    failure = solver.failure;
    if (solver) u = solver.value->solve({problem.d, {}}, problem.f).u;
  });
  if (!failure.empty()) return {failure, 0, 0, seconds};
  return judged(problem, u, reference, seconds);
}

}  // namespace holdfast::paper

#include "bench/paper/printed_solver.h"

#include <cstddef>
#include <span>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <Eigen/UmfPackSupport>
#include <sys/resource.h>

#include <holdfast/ordering/elimination_order.h>
#include <holdfast/threads/one_thread_internal.h>

namespace holdfast::paper {
namespace {

template <class Scalar>
using Matrix = Eigen::SparseMatrix<Scalar, Eigen::ColMajor, int>;
template <class Scalar>
using Columns = Eigen::Matrix<Scalar, Eigen::Dynamic, 3>;

/// Seconds that this process and the ended ones that it started have computed, on all cores.
double processorSeconds()
{
  double sum = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      sum += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return sum;
}

/// Runs `work` once; returns its processor time.
template <class Work>
double processorSecondsOf(const Work& work)
{
  const double start = processorSeconds();
  work();
  return processorSeconds() - start;
}

bool isFinite(const BentProblem& problem)
{
  return problem.A->matrix().coeffs().isFinite().all();
}

/// Of a solution.
template <class Scalar>
using Attempt = Result<Columns<Scalar>>;

constexpr const char* kFails = "fails";

/// x of M^T M x = M^T b.
Attempt<double> normalSolution(const Matrix<double>& M, const Columns<double>& b)
{
  const TwoWayMatrix C(M);
  const FactorResult factor = choleskyBySuiteSparse(C);
  if (!factor) return {{}, kFails};
  return {factor.value->solve(C.transposeTimes(b))};
}

Attempt<float> normalSolution(const Matrix<float>& M, const Columns<float>& b)
{
  const Matrix<float> N = M.transpose() * M;
  const Eigen::SimplicialLLT<Matrix<float>, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(N);
  if (factor.info() != Eigen::Success) return {{}, kFails};
  return {factor.solve(Columns<float>(M.transpose() * b))};
}

/// UMFPACK without its scaling and its refinement.
struct PlainLu : Eigen::UmfPackLU<Matrix<double>> {
  PlainLu()
  {
    umfpackControl()[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
    umfpackControl()[UMFPACK_IRSTEP] = 0;
  }
  [[nodiscard]] bool lacksMemory() const { return m_fact_errorCode == UMFPACK_ERROR_out_of_memory; }
};

Ending solveByLu(const Matrix<double>& K, const Columns<double>& b, Eigen::Ref<Columns<double>> x)
{
  const OneThread libraries;
  PlainLu factor;
  factor.compute(K);
  if (factor.lacksMemory()) return Ending::LacksMemory;
  if (factor.info() != Eigen::Success) return Ending::Failed;
  x = factor.solve(b);
  return Ending::Done;
}

Ending solveByLu(const Matrix<float>& K, const Columns<float>& b, Eigen::Ref<Columns<float>> x)
{
  Eigen::SparseLU<Matrix<float>> factor(K);
  if (factor.lastErrorMessage().find("MEMORY") != std::string::npos) return Ending::LacksMemory;
  if (factor.info() != Eigen::Success) return Ending::Failed;
  x = factor.solve(b);
  return Ending::Done;
}

/// x of K x = b within `kLuLimits`.
template <class Scalar>
Attempt<Scalar> luSolution(const Matrix<Scalar>& K, const Columns<Scalar>& b)
{
  Attempt<Scalar> attempt{Columns<Scalar>(K.rows(), 3)};
  const std::span<Scalar> numbers(attempt.value.data(), attempt.value.size());
  attempt.failure = limited(kLuLimits, std::as_writable_bytes(numbers), [&](std::span<std::byte> shared) {
    return solveByLu(K, b, Eigen::Map<Columns<Scalar>>(reinterpret_cast<Scalar*>(shared.data()), K.rows(), 3));
  });
  return attempt;
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
  return {problem.A->matrix().cast<Scalar>(), c.cast<Scalar>(), SparseMatrix(problem.B).cast<Scalar>(),
          d.cast<Scalar>(), rest.cast<Scalar>()};
}

/// (7) and (8), soft constraints, over the free unknowns.
template <class Scalar>
Attempt<Scalar> softPositions(const BentMesh& bent, const Printed<Scalar>& problem, double weight)
{
  const auto w = static_cast<Scalar>(weight);
  const Matrix<Scalar> S = freeColumns(bent).cast<Scalar>();
  const Matrix<Scalar> M = stacked<Scalar>(problem.A * S, w * (problem.B * S));
  Columns<Scalar> b(M.rows(), 3);
  b << problem.c, w * problem.d;
  auto x = normalSolution(M, b);
  if (!x) return x;
  return {problem.rest + S * (x.value - S.transpose() * problem.rest)};
}

/// (11) to (21), hard constraints: those of B^T = Q R, (14), in double precision, rounded.
template <class Scalar>
Attempt<Scalar> hardPositions(const BentMesh& bent, const Printed<Scalar>& problem)
{
  const Elimination& elimination = bent.eliminated->elimination;
  const Matrix<Scalar> Q2 = orderedColumns(elimination.wholeQ2(), bent.ranks).cast<Scalar>();
  const Columns<Scalar> particular = elimination.particular(problem.d.template cast<double>()).template cast<Scalar>();
  const Matrix<Scalar> M = problem.A * Q2;
  auto z = normalSolution(M, Columns<Scalar>(problem.c - problem.A * particular));
  if (!z) return z;
  const Matrix<Scalar> S = freeColumns(bent).cast<Scalar>();
  return {problem.rest + S * (S.transpose() * Columns<Scalar>(particular + Q2 * z.value - problem.rest))};
}

/// [A^T A, B^T; B, 0] [p; l] = [A^T c; d], end of section 3.2, over the free unknowns.
template <class Scalar>
Attempt<Scalar> lagrangePositions(const BentMesh& bent, const Printed<Scalar>& problem)
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
  auto x = luSolution(K, b);
  if (!x) return x;
  return {problem.rest + S * (x.value.topRows(k) - S.transpose() * problem.rest)};
}

template <class Scalar>
Outcome solved(const BentMesh& bent, const BentProblem& problem, const Method& method, const Columns3& reference)
{
  if (!isFinite(problem)) return {kNotFinite};
  const Printed<Scalar> asPrinted = printed<Scalar>(bent, problem);
  Attempt<Scalar> p;
  const double seconds = processorSecondsOf([&] {
    if (method.kind == SolverKind::Soft) p = softPositions(bent, asPrinted, method.weight);
    if (method.kind == SolverKind::Hard) p = hardPositions(bent, asPrinted);
    if (method.kind == SolverKind::Lagrange) p = lagrangePositions(bent, asPrinted);
  });
  if (!p) return {p.failure, 0, 0, seconds};
  return judged(problem, p.value.template cast<double>() - bent.model.solverMesh.rest, reference, seconds);
}

}  // namespace

Outcome judged(const BentProblem& problem, const Columns3& u, const Columns3& reference, double seconds)
{
  if (!u.allFinite()) return {kFails, 0, 0, seconds};
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
  return solved<float>(bent, problem, method, reference);
}

Outcome solvedByProduct(const BentMesh& bent, const BentProblem& problem, const Method& method,
                        const Columns3& reference)
{
  if (!isFinite(problem)) return {kNotFinite};
  SolverOptions options;
  options.kind = method.kind;
  options.softWeight = method.weight;
  bool isSolved = false;
  Columns3 u;
  const double seconds = processorSecondsOf([&] {
    const SolverResult solver = makeSolver(constrainedProblem(bent, problem), options);
    isSolved = static_cast<bool>(solver);
    if (solver) u = solver.value->solve({problem.d, {}}, problem.f).u;
  });
  if (!isSolved) return {kFails, 0, 0, seconds};
  return judged(problem, u, reference, seconds);
}

}  // namespace holdfast::paper

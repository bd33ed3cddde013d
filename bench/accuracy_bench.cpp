// How far solutions are from those of the same equations in quadruple precision.

#include <stdexcept>
#include <string>

#include "bench/benchmarks.h"
#include "bench/paper/reference.h"
#include "bench/samples.h"

namespace holdfast::bench {
namespace {

/// The largest error of a displacement as a share of the diagonal, which is 1, and the estimate of it.
void addErrors(Samples& samples, const paper::BentMesh& bent, const paper::BentProblem& problem,
               const paper::Reference& reference, const std::string& weights)
{
  for (const Backend backend : {Backend::Holdfast, Backend::Cholmod}) {
    SolverOptions options;
    options.backend = backend;
    const SolverResult solver = makeSolver(paper::constrainedProblem(bent, problem), options);
    if (!solver) throw std::runtime_error(solver.failure);
    const Displacement displacement = solver.value->solve({problem.d, {}}, problem.f);
    const std::string row = weights + ", " + std::string(name(backend));
    samples.add(row, "error", (displacement.u - reference.u).rowwise().norm().maxCoeff());
    samples.add(row, "estimate", displacement.accuracy * displacement.u.rowwise().norm().maxCoeff());
    samples.add(row, "residual", (problem.B * displacement.u - problem.d).rowwise().norm().maxCoeff());
    samples.add(row, "of reference", reference.lastCorrection);
  }
}

}  // namespace

void accuracy(benchmark::State& state, const Mesh& mesh)
{
  const paper::BentMesh bent = paper::bentMesh(mesh);
  Samples samples;
  for ([[maybe_unused]] auto turn : state)
    for (const Weights weights : {Weights::Uniform, Weights::Cotangent}) {
      const paper::BentProblem problem = paper::bentProblem(bent, weights);
      const Result<ReducedProblem> reduced = paper::reducedProblem(bent, problem, {});
      if (!reduced) throw std::runtime_error(reduced.failure);
      addErrors(samples, bent, problem, paper::quadrupleSolution(bent, problem, reduced.value, {}),
                std::string(name(weights)));
    }
  samples.report(state);
}

}  // namespace holdfast::bench

// Fig. 12 of the paper: what set-up, decomposition and solution cost with hard and with soft constraints.

#include <memory>
#include <string>

#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"
#include "bench/steps.h"

namespace holdfast::bench {
namespace {

void takeTurn(Samples& samples, const Model& model, const ConstraintList& constraints, SolverKind kind)
{
  const std::string column = "s " + std::string(name(kind));
  std::unique_ptr<const SetUp> made;
  const double setUpSeconds = secondsOf([&] { made = std::make_unique<SetUp>(setUp(model, constraints)); });
  std::unique_ptr<const EliminatedConstraints> eliminated;
  const double elimination = secondsOf(
      [&] { eliminated = std::make_unique<EliminatedConstraints>(eliminate(made->system, model.solverMesh)); });
  std::unique_ptr<const ConstrainedSolver> solver;
  const double factorization = secondsOf([&] { solver = factorized(model, *made, *eliminated, kind); });
  // Soft constraints need no elimination: it is charged to hard ones alone.
  const double decomposition = factorization + (kind == SolverKind::Hard ? elimination : 0);
  samples.add("set-up", column, setUpSeconds);
  samples.add("decomposition", column, decomposition);
  samples.add("set-up and decomposition", column, setUpSeconds + decomposition);
  samples.add("solution", column, shortest(5, [&] { solution(*made, *solver); }));
  samples.add("factor", "MiB " + std::string(name(kind)), factorMiB(*solver));
}

}  // namespace

void hardAgainstSoft(benchmark::State& state, const Mesh& mesh)
{
  const Model model = makeModel(mesh);
  const ConstraintList constraints = scene(mesh);
  Samples notCounted;
  takeTurn(notCounted, model, constraints, SolverKind::Hard);  // takes the memory that all others use again
  Samples samples;
  for ([[maybe_unused]] auto turn : state)
    for (const SolverKind kind : {SolverKind::Hard, SolverKind::Soft}) takeTurn(samples, model, constraints, kind);
  for (const char* row : {"set-up and decomposition", "solution"})
    samples.addRatios("= hard/soft", {row, "s hard"}, {row, "s soft"});
  samples.addRatios("= hard/soft", {"factor", "MiB hard"}, {"factor", "MiB soft"});
  samples.report(state);
}

}  // namespace holdfast::bench

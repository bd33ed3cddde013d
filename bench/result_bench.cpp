// What it costs to look at a result: in a frame of a drag, and when the drag rests.

#include <memory>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/verdict/result_check.h>

#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {
namespace {

constexpr int kRuns = 5;

}  // namespace

void resultChecks(benchmark::State& state, const Mesh& mesh)
{
  const auto model = std::make_shared<const Model>(makeModel(mesh));
  Deformer deformer(model);
  ConstraintList list = scene(mesh);
  turnHandle(list, 20);
  const DeformResult result = deformer.deform(list);
  ResultCheck check(model->solverMesh, model->mesh.positions);
  const ConstraintSystem& system = result.details->system;
  Samples samples;
  double degrees = 20;
  for ([[maybe_unused]] auto turn : state) {
    samples.add("frame", "ms", 1000 * shortest(kRuns, [&] {
                                 turnHandle(list, ++degrees);
                                 benchmark::DoNotOptimize(deformer.deform(list));
                               }));
    samples.add("its check", "ms",
                1000 * shortest(kRuns, [&] { benchmark::DoNotOptimize(check.ofFrame(result.positions, system)); }));
    ResultVerdict verdict = check.ofFrame(result.positions, system).verdict;
    samples.add("check at rest", "ms",
                1000 * secondsOf([&] {
                  benchmark::DoNotOptimize(check.addRest(verdict, result.positions, system, RotationSource::Given));
                }));
  }
  samples.addRatios("= of a frame", {"its check", "ms"}, {"frame", "ms"});
  samples.report(state);
}

}  // namespace holdfast::bench

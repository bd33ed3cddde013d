// This benchmark tells whether results have the same bits on one core and on all, and how much faster all of them are.

#include <memory>
#include <string>

#include "bench/benchmarks.h"
#include "bench/dragged_mesh.h"
#include "bench/samples.h"
#include "bench/scenes.h"
#include "support/one_core.h"

namespace holdfast::bench {
namespace {

/// The positions of the last frame.
Positions takeTurn(Samples& samples, const std::string& column, const std::shared_ptr<const Model>& model)
{
  const ConstraintList list = scene(model->mesh);
  DraggedMesh dragged(model);
  dragged.deform(list);
  samples.add("decomposition", column, dragged.report().seconds.factorization);
  samples.add("frame", column, dragged.frame(list));
  return dragged.positions();
}

}  // namespace

void oneCoreAgainstAll(benchmark::State& state, const Mesh& mesh)
{
  const auto model = std::make_shared<const Model>(makeModel(mesh));
  Samples before;
  const Positions first = takeTurn(before, "s all", model);
  Samples samples;
  const auto compare = [&](const std::string& column, const Positions& positions) {
    samples.add("numbers that differ", column, static_cast<double>((positions.array() != first.array()).count()));
  };
  for ([[maybe_unused]] auto turn : state) {
    compare("s all", takeTurn(samples, "s all", model));
    const test::OneCore here;
    compare("s one", takeTurn(samples, "s one", model));
  }
  for (const char* row : {"decomposition", "frame"}) samples.addRatios("= one/all", {row, "s one"}, {row, "s all"});
  samples.report(state);
}

}  // namespace holdfast::bench

// What a hand waits for: the first deformation, the frames of a drag, and another set of constraints.

#include <chrono>
#include <string>
#include <variant>
#include <vector>

#include <holdfast/deform/deformer.h>

#include "bench/bench_meshes.h"
#include "bench/benchmarks.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {
namespace {

constexpr int kFrames = 10;

HandleConstraint& handle(ConstraintList& list)
{
  return std::get<HandleConstraint>(list.constraints[1].what);
}

void takeTurn(Samples& samples, const Model& model, Backend backend)
{
  const std::string column = "s " + std::string(name(backend));
  ConstraintList list = scene(model.mesh, {});
  handle(list).motion = AxisRotation{Vector3(1, 2, 3), 1, {}};
  Deformer deformer(model, {Weights::Cotangent, {SolverKind::Hard, backend, 0}});
  const auto deformed = [&] {
    const auto start = std::chrono::steady_clock::now();
    static_cast<void>(deformer.deform(list));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  samples.add("first", column, deformed());
  std::vector<double> frames;
  for (int k = 1; k <= kFrames; ++k) {
    handle(list).motion = AxisRotation{Vector3(1, 2, 3), 1.0 + k, {}};
    frames.push_back(deformed());
  }
  samples.add("frame", column, median(frames));
  list.constraints.push_back({"pin", true, PointConstraint{AtVertex{model.mesh.faces[0][0]}, Move{Vector3::Zero()}}});
  samples.add("one pin more", column, deformed());
}

void frames(benchmark::State& state, const BenchMesh& mesh)
{
  const Model model = mesh.load();
  Samples samples;
  for ([[maybe_unused]] auto turn : state)
    for (const Backend backend : {Backend::Holdfast, Backend::Cholmod})
      if (isBuilt(backend)) takeTurn(samples, model, backend);
  if (isBuilt(Backend::Cholmod))
    for (const char* row : {"first", "frame", "one pin more"})
      samples.addRatios(row, "= holdfast/cholmod", "s holdfast", "s cholmod");
  samples.report(state);
}

}  // namespace

void registerFrames()
{
  for (const BenchMesh& mesh : benchMeshes())
    benchmark::RegisterBenchmark(("frames/" + mesh.name).c_str(), frames, mesh)
        ->Iterations(3)
        ->Unit(benchmark::kSecond);
}

}  // namespace holdfast::bench

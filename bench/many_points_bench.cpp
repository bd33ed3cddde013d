// What many points cost: isolated ones, ones that overlap, and ones at random.

#include <memory>
#include <string>

#include "bench/benchmarks.h"
#include "bench/dragged_mesh.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {
namespace {

/// Decomposition and frames of one list, as one row of the table.
void takeTurn(Samples& samples, const std::string& row, const std::shared_ptr<const Model>& model,
              const ConstraintList& list)
{
  const double before = startPeak();
  DraggedMesh dragged(model);
  dragged.deform(list);
  samples.add(row, "MiB peak", peakMiB() - before);
  samples.add(row, "s decomposition", dragged.report().seconds.factorization);
  samples.add(row, "ms frame", 1000 * dragged.frame(list));
  samples.add(row, "residual", dragged.report().maxResidualRelative);
  samples.add(row, "points", static_cast<double>(list.constraints.size() - kEnds));
}

void addRatios(Samples& samples, const std::string& row, const std::string& base)
{
  for (const char* column : {"MiB peak", "s decomposition", "ms frame"})
    samples.addRatios("= " + std::string(column), {row, column}, {base, column});
}

}  // namespace

void manyPoints(benchmark::State& state, const Mesh& mesh)
{
  const auto model = std::make_shared<const Model>(makeModel(mesh));
  const Index count = mesh.vertexCount() / 10;
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    takeTurn(samples, "none", model, isolatedFacePoints(mesh, 0));
    takeTurn(samples, "isolated", model, isolatedFacePoints(mesh, count));
    takeTurn(samples, "overlapping", model, overlappingFacePoints(mesh, count, 3 * count));
  }
  addRatios(samples, "isolated", "none");
  addRatios(samples, "overlapping", "none");
  samples.report(state);
}

void randomPoints(benchmark::State& state, const Mesh& mesh)
{
  const auto model = std::make_shared<const Model>(makeModel(mesh));
  const Index many = mesh.vertexCount() * 100 / 156;
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    takeTurn(samples, "some", model, overlappingFacePoints(mesh, many / 10, mesh.faces.size()));
    takeTurn(samples, "ten times as many", model, overlappingFacePoints(mesh, many, mesh.faces.size()));
  }
  addRatios(samples, "ten times as many", "some");
  samples.report(state);
}

}  // namespace holdfast::bench

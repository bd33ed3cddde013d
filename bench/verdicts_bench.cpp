// How long it takes to find the constraints that follow from others, without solving anything.

#include <string>

#include <holdfast/elimination/elimination.h>
#include <holdfast/elimination/find_dependencies.h>
#include <holdfast/elimination/row_components.h>

#include "bench/bench_meshes.h"
#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"
#include "bench/steps.h"

namespace holdfast::bench {
namespace {

constexpr std::size_t kRepeats = 37;

/// The rows of the largest component of `count` overlapping points of faces; 37 of the points are said twice.
std::vector<RowTerms> overlappingRows(const Model& model, Index count)
{
  ConstraintList list = overlappingScene(model.mesh, count);
  const std::size_t first = list.constraints.size() - static_cast<std::size_t>(count);
  for (std::size_t k = 0; k < kRepeats; ++k) {
    Constraint repeat = list.constraints[first + k * (static_cast<std::size_t>(count) / kRepeats)];
    repeat.name += " again";
    list.constraints.insert(list.constraints.begin(), std::move(repeat));
  }
  const SetUp made = setUp(model, list);
  std::vector<RowTerms> rows;
  for (const ConstraintRow& row : made.system.rows) rows.push_back(row.terms);
  RowComponent largest;
  for (RowComponent& component : connectedRows(rows, model.solverMesh.unknownCount()))
    if (component.rows.size() > largest.rows.size()) largest = std::move(component);
  std::vector<RowTerms> result;
  for (const Index row : largest.rows) result.push_back(rows[row]);
  return result;
}

void takeTurn(Samples& samples, const std::string& row, const std::vector<RowTerms>& rows, Index unknownCount)
{
  const auto found = measure([&] { return findDependencies(rows, unknownCount); });
  samples.add(row, "ms verdict", 1000 * found.cost.seconds);
  const std::vector<bool> isHeld(static_cast<std::size_t>(unknownCount), false);
  const auto eliminated =
      measure([&] { return Elimination(rows, independentRows(found.result, rows.size()), unknownCount, isHeld); });
  samples.add(row, "ms eliminate", 1000 * eliminated.cost.seconds);
  samples.add(row, "rows", static_cast<double>(rows.size()));
  samples.add(row, "dependent", static_cast<double>(found.result.size()));
}

void verdicts(benchmark::State& state)
{
  const Model model = benchMeshes()[2].load();
  const std::vector<RowTerms> few = overlappingRows(model, 1100);
  const std::vector<RowTerms> many = overlappingRows(model, 106000);
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    takeTurn(samples, "some 1,000 points of faces", few, model.solverMesh.unknownCount());
    takeTurn(samples, "some 100,000 points of faces", many, model.solverMesh.unknownCount());
  }
  samples.report(state);
}

}  // namespace

void registerVerdicts()
{
  benchmark::RegisterBenchmark("verdicts/one component", verdicts)->Iterations(5)->Unit(benchmark::kSecond);
}

}  // namespace holdfast::bench

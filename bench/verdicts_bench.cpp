// How long it takes to find the constraints that follow from others, without solving anything.

#include <algorithm>
#include <string>
#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/model.h>
#include <holdfast/elimination/elimination.h>
#include <holdfast/elimination/find_dependencies.h>
#include <holdfast/elimination/row_components.h>

#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {
namespace {

/// The rows of the largest component of `count` overlapping points in so many faces; some of the points are said twice.
std::vector<RowTerms> overlappingRows(const Model& model, Index count, Index faces)
{
  constexpr std::size_t kRepeats = 37;
  ConstraintList list = overlappingFacePoints(model.mesh, count, faces);
  for (std::size_t k = 0; k < std::min(kRepeats, static_cast<std::size_t>(count)); ++k) {
    Constraint repeat = list.constraints[list.constraints.size() - 1 - 2 * k];
    repeat.name += " again";
    list.constraints.insert(list.constraints.begin(), std::move(repeat));
  }
  const ConstraintSystem system =
      makeConstraintSystem(list, model.mesh, model.solverMesh, model.locator(), "benchmark");
  std::vector<RowTerms> rows;
  for (const ConstraintRow& row : system.rows) rows.push_back(row.terms);
  const std::vector<RowComponent> components = connectedRows(rows, model.solverMesh.unknownCount());
  std::vector<RowTerms> result;
  for (const Index row : std::ranges::max(components, {}, [](const RowComponent& c) { return c.rows.size(); }).rows)
    result.push_back(rows[row]);
  return result;
}

void takeTurn(Samples& samples, const std::string& row, const std::vector<RowTerms>& rows, Index unknownCount)
{
  std::vector<Dependency> found;
  samples.add(row, "ms verdict", 1000 * secondsOf([&] { found = findDependencies(rows, unknownCount); }));
  const std::vector<bool> isHeld(static_cast<std::size_t>(unknownCount), false);
  samples.add(row, "ms eliminate",
              1000 * secondsOf([&] { Elimination(rows, independentRows(found, rows.size()), unknownCount, isHeld); }));
  samples.add(row, "rows", static_cast<double>(rows.size()));
  samples.add(row, "dependent", static_cast<double>(found.size()));
}

}  // namespace

void verdicts(benchmark::State& state, const Mesh& mesh)
{
  const Model model = makeModel(mesh);
  const Index many = mesh.vertexCount() * 10 / 41;
  const std::vector<RowTerms> fewRows = overlappingRows(model, many / 100, 3 * (many / 100));
  const std::vector<RowTerms> manyRows = overlappingRows(model, many, 3 * many);
  // 1.1 for each vertex: a tenth and more of them follow from others.
  const std::vector<RowTerms> crowdedRows = overlappingRows(model, many, 20 * many / 11);
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    takeTurn(samples, "some", fewRows, model.solverMesh.unknownCount());
    takeTurn(samples, "a hundred times as many", manyRows, model.solverMesh.unknownCount());
    takeTurn(samples, "as many, 1.1 a vertex", crowdedRows, model.solverMesh.unknownCount());
  }
  samples.report(state);
}

}  // namespace holdfast::bench

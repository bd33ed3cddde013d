// What many constraints cost: isolated ones of each kind, and points that overlap in one component.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <holdfast/elimination/row_components.h>
#include <holdfast/geometry/bounding_box.h>

#include "bench/bench_meshes.h"
#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"
#include "bench/steps.h"

namespace holdfast::bench {
namespace {

constexpr Index kIsolated = 10000;
constexpr Index kOverlapping = 5000;

/// Elimination, factorisation and solution of one list, as one row of the table.
void takeTurn(Samples& samples, const std::string& row, const Model& model, const SetUp& made)
{
  const auto [eliminated, elimination] = measure([&] { return eliminate(made.system, model.solverMesh); });
  samples.add(row, "s eliminate", elimination.seconds);
  const auto [solver, factorization] = measure([&] { return factorized(model, made, eliminated, {}); });
  samples.add(row, "s factorise", factorization.seconds);
  samples.add(row, "s solve", measure([&] { return solution(made, *solver); }).cost.seconds);
  samples.add(row, "unknowns", static_cast<double>(solver->unknowns()));
  samples.add(row, "MiB factor", factorMiB(*solver));
  samples.add(row, "MiB peak", std::max(elimination.peakMiB, factorization.peakMiB));
}

/// The ends, and a rigid region of about `kIsolated` vertices in the middle.
ConstraintList rigidScene(const Mesh& mesh)
{
  ConstraintList list = scene(mesh, {0, 0, 0});
  const Eigen::AlignedBox3d box = boundingBox(mesh.positions);
  std::vector<Index> ids(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(ids.begin(), ids.end(), Index{0});
  const auto distance = [&](Index v) { return std::abs(mesh.positions(v, 0) - box.center().x()); };
  std::nth_element(ids.begin(), ids.begin() + kIsolated, ids.end(),
                   [&](Index v, Index w) { return distance(v) < distance(w); });
  ids.resize(kIsolated);
  list.constraints.push_back({"rigid", true, RigidConstraint{{VertexIds{std::move(ids)}}}});
  return list;
}

void isolatedPoints(benchmark::State& state)
{
  const Model model = middleModel();
  const SetUp none = setUp(model, scene(model.mesh, {0, 0, 0}));
  const SetUp pins = setUp(model, scene(model.mesh, {kIsolated, 0, 0}));
  const SetUp edges = setUp(model, scene(model.mesh, {0, kIsolated, 0}));
  const SetUp faces = setUp(model, scene(model.mesh, {0, 0, kIsolated}));
  const SetUp rigid = setUp(model, rigidScene(model.mesh));
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    takeTurn(samples, "0 points", model, none);
    takeTurn(samples, "rigid region of 10,000", model, rigid);
    takeTurn(samples, "10,000 vertices", model, pins);
    takeTurn(samples, "10,000 points of edges", model, edges);
    takeTurn(samples, "10,000 points of faces", model, faces);
  }
  samples.report(state);
}

Index largestComponent(const EliminatedConstraints& eliminated)
{
  std::size_t largest = 0;
  for (const RowComponent& component : connectedRows(eliminated.rows, eliminated.elimination.Q2().rows()))
    largest = std::max(largest, component.rows.size());
  return static_cast<Index>(largest);
}

void overlappingPoints(benchmark::State& state)
{
  const Model model = middleModel();
  const SetUp made = setUp(model, overlappingScene(model.mesh, kOverlapping));
  const EliminatedConstraints eliminated = eliminate(made.system, model.solverMesh);
  const std::string row = "5,000 points of faces";
  Samples samples;
  samples.add(row, "largest part", static_cast<double>(largestComponent(eliminated)));
  samples.add(row, "dependent", static_cast<double>(eliminated.dependencies.size()));
  for ([[maybe_unused]] auto turn : state) takeTurn(samples, row, model, made);
  samples.report(state);
}

}  // namespace

void registerConstraintCounts()
{
  benchmark::RegisterBenchmark("isolated constraints/bumpy 173k", isolatedPoints)
      ->Iterations(5)
      ->Unit(benchmark::kSecond);
}

void registerOverlappingPoints()
{
  benchmark::RegisterBenchmark("overlapping constraints/bumpy 173k", overlappingPoints)
      ->Iterations(5)
      ->Unit(benchmark::kSecond);
}

}  // namespace holdfast::bench

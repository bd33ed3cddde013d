// Finding the points of a surface that are closest to places near it.

#include <vector>

#include <holdfast/mesh/triangulation.h>
#include <holdfast/surface/surface_locator.h>

#include "bench/benchmarks.h"
#include "bench/bumpy_mesh.h"
#include "bench/measure.h"
#include "bench/random.h"
#include "bench/samples.h"

namespace holdfast::bench {
namespace {

constexpr Index kMillionTriangles = 289;  // divisions
constexpr Index kQueries = 100000;

/// Places off vertices, by up to a hundredth of the size.
std::vector<Vector3> placesNear(const Mesh& mesh)
{
  Random random(3);
  std::vector<Vector3> places;
  for (Index k = 0; k < kQueries; ++k) {
    const Vector3 off(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01));
    places.emplace_back(mesh.positions.row(random.below(mesh.vertexCount())).transpose() + off);
  }
  return places;
}

void closestPoints(benchmark::State& state)
{
  const Mesh mesh = bumpyMesh(kMillionTriangles);
  const Triangulation triangulation = triangulate(mesh);
  const std::vector<Vector3> places = placesNear(mesh);
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    const auto [search, built] = measure([&] { return ClosestPointSearch(mesh.positions, triangulation.triangles); });
    const auto [sum, asked] = measure([&] {
      double distances = 0;
      for (const Vector3& place : places) distances += search.find(place).distance;
      return distances;
    });
    benchmark::DoNotOptimize(sum);
    samples.add("building the tree", "s", built.seconds);
    samples.add("building the tree", "MiB peak", built.peakMiB);
    samples.add("100,000 places", "s", asked.seconds);
  }
  samples.report(state);
}

}  // namespace

void registerClosestPoints()
{
  benchmark::RegisterBenchmark("closest points/1M triangles", closestPoints)->Iterations(3)->Unit(benchmark::kSecond);
}

}  // namespace holdfast::bench

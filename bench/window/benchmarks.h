#pragma once
/// \file
/// The benchmarks of the window: each measures one mesh. docs/performance.md says what for.

#include <benchmark/benchmark.h>

#include <holdfast/mesh/mesh.h>

namespace holdfast::bench {

void dragInTheWindow(benchmark::State& state, const Mesh& mesh);

}  // namespace holdfast::bench

#pragma once
/// \file
/// The benchmarks: each measures one mesh. docs/performance.md says what for.

#include <benchmark/benchmark.h>

#include <holdfast/mesh/mesh.h>

namespace holdfast::bench {

void hardAgainstSoft(benchmark::State& state, const Mesh& mesh);
void againstCholmod(benchmark::State& state, const Mesh& mesh);
void editsOfConstraints(benchmark::State& state, const Mesh& mesh);
void manyPoints(benchmark::State& state, const Mesh& mesh);
void randomPoints(benchmark::State& state, const Mesh& mesh);
void verdicts(benchmark::State& state, const Mesh& mesh);
void resultChecks(benchmark::State& state, const Mesh& mesh);
void freedom(benchmark::State& state, const Mesh& mesh);
void manyBoxes(benchmark::State& state, const Mesh& mesh);
void heldOutNoise(benchmark::State& state, const Mesh& mesh);
void oneCoreAgainstAll(benchmark::State& state, const Mesh& mesh);
void batchProgram(benchmark::State& state, const Mesh& mesh);
void accuracy(benchmark::State& state, const Mesh& mesh);

}  // namespace holdfast::bench

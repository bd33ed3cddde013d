#pragma once
/// \file
/// What the programs of benchmarks have in common: meshes and options of their command lines, and tables.

#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <holdfast/mesh/mesh.h>

namespace holdfast::bench {

struct Benchmark {
  const char* name;
  void (*measure)(benchmark::State& state, const Mesh& mesh);
  std::vector<std::string> meshes;  ///< where the command line names none: files, or thousands of vertices
};

/// Runs those that the options name, and prints tables. Returns the exit code; throws what a benchmark throws.
int runBenchmarks(const std::vector<Benchmark>& all, int argc, char** argv);

}  // namespace holdfast::bench

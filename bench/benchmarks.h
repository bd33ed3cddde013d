#pragma once
/// \file
/// The groups of benchmarks. Each function registers one with Google Benchmark; docs/benchmarks.md says what they
/// measure.

namespace holdfast::bench {

void registerHardAgainstSoft();
void registerBackends();
void registerFrames();
void registerConstraintCounts();
void registerOverlappingPoints();
void registerVerdicts();
void registerClosestPoints();
#ifdef HOLDFAST_WITH_CHOLMOD
void registerOrderings();
#endif

}  // namespace holdfast::bench

#pragma once
/// \file
/// Every mesh or problem, weighting and backend on which a law of the solve is tried.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/deform/deform.h>
#include <holdfast/geometry/bounding_box.h>

#include "support/law_meshes.h"

namespace holdfast::test {

/// The backends that are built.
[[nodiscard]] inline std::vector<Backend> backends()
{
#ifdef HOLDFAST_WITH_CHOLMOD
  return {Backend::Holdfast, Backend::Cholmod, Backend::Eigen};
#else
  return {Backend::Holdfast, Backend::Eigen};
#endif
}

[[nodiscard]] inline std::vector<Weights> allWeights()
{
  return {Weights::Cotangent, Weights::CotangentPaper, Weights::Uniform};
}

/// Calls `check(mesh, options)` for every mesh of `lawMeshes()`, weighting and backend, the hard solver set.
template <class Check>
void forEachSolveCase(Check&& check)
{
  for (const NamedMesh& named : lawMeshes())
    for (const Weights weights : allWeights())
      for (const Backend backend : backends()) {
        SCOPED_TRACE(named.name + ", " + std::string(name(weights)) + ", " + std::string(name(backend)));
        check(named.mesh, DeformOptions{weights, {SolverKind::Hard, backend, 5}});
      }
}

/// A mesh and what is asked of it.
struct Problem {
  Mesh mesh;
  ConstraintList list;
};

/// Calls `check(problem, options)` for `makeProblem(seed)` of every seed below `seeds`, every weighting and backend.
template <class MakeProblem, class Check>
void forEachProblem(std::uint32_t seeds, SolverKind kind, MakeProblem&& makeProblem, Check&& check)
{
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    const Problem problem = makeProblem(seed);
    for (const Weights weights : allWeights())
      for (const Backend backend : backends()) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << name(weights) << ", " << name(backend));
        check(problem, DeformOptions{weights, {kind, backend, 5}});
      }
  }
}

[[nodiscard]] inline DeformResult deformed(const Mesh& mesh, const ConstraintList& list, const DeformOptions& options)
{
  NoProgress progress;
  return deform(makeModel(mesh, "mesh"), list, "constraints", options, progress);
}

/// The finding of that kind; null where there is none.
[[nodiscard]] inline const Finding* findingOf(const Report& report, const std::string& kind)
{
  const std::vector<Finding>& findings = report.mesh.findings;
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& finding) { return finding.kind == kind; });
  return found == findings.end() ? nullptr : &*found;
}

/// The largest coordinate of a difference, as a share of the diagonal of `b`'s bounding box.
[[nodiscard]] inline double distance(const Positions& a, const Positions& b)
{
  return (a - b).cwiseAbs().maxCoeff() / boundingBoxDiagonal(b);
}

}  // namespace holdfast::test

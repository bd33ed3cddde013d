#pragma once
/// \file
/// Every mesh, weighting and backend on which a law of the solve is tried.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/deform/deform.h>
#include <holdfast/mesh/bounding_box.h>

#include "support/law_meshes.h"

namespace holdfast::test {

/// The backends that are built.
[[nodiscard]] inline std::vector<Backend> backends()
{
#ifdef HOLDFAST_WITH_CHOLMOD
  return {Backend::Cholmod, Backend::Eigen};
#else
  return {Backend::Eigen};
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

[[nodiscard]] inline Deformation deformed(const Mesh& mesh, const ConstraintList& list, const DeformOptions& options)
{
  NoProgress progress;
  return deform(makeModel(mesh, "mesh"), list, "constraints", options, progress);
}

/// The largest coordinate of a difference, as a share of the diagonal of `b`'s bounding box.
[[nodiscard]] inline double distance(const Positions& a, const Positions& b)
{
  return (a - b).cwiseAbs().maxCoeff() / boundingBoxDiagonal(b);
}

}  // namespace holdfast::test

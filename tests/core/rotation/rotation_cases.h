#pragma once
/// \file
/// Meshes, problems and solutions for tests of the rotation field, in few words.

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/rotation/edge_weights.h>
#include <holdfast/rotation/rotation_field.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast::test {

/// Every triangle split at a point beside the middle of a side: caps with an angle of nearly 180 degrees.
[[nodiscard]] inline Mesh withCaps(const Mesh& mesh, double height)
{
  Mesh result{mesh.positions, {}};
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Index a = mesh.faces[f][0];
    const Index b = mesh.faces[f][1];
    const Index c = mesh.faces[f][2];
    const Vector3 side = (mesh.positions.row(a) + mesh.positions.row(b)) / 2;
    const Index middle = result.vertexCount();
    result = withVertex(std::move(result), side + height * (Vector3(mesh.positions.row(c)) - side));
    result.faces.add({a, middle, c});
    result.faces.add({middle, b, c});
    result.faces.add({a, b, middle});
  }
  return result;
}

/// Meshes of needles, caps, obtuse triangles, and one with triangles without area.
[[nodiscard]] inline std::vector<NamedMesh> badMeshes()
{
  Eigen::Affine3d shear = Eigen::Affine3d::Identity();
  shear.linear()(0, 1) = 5;
  return {{"needles", transformed(plate(7, 5), Eigen::Affine3d(Eigen::Scaling(1.0, 1e-5, 1.0)))},
          {"obtuse", transformed(grid(6, 5), shear)},
          {"caps", withCaps(plate(4, 3), 1e-6)},
          {"without area", withCaps(grid(3, 3), 0)}};
}

[[nodiscard]] inline std::vector<NamedMesh> allMeshes()
{
  std::vector<NamedMesh> meshes = lawMeshes();
  for (NamedMesh& bad : badMeshes()) meshes.push_back(std::move(bad));
  return meshes;
}

/// Weights that are never negative.
[[nodiscard]] inline std::vector<Weights> guardedWeights()
{
  return {Weights::Cotangent, Weights::Uniform};
}

/// Calls `check(mesh, weights, backend)` for every mesh, guarded weighting and backend.
template <class Check>
void forEachGuardedCase(Check&& check)
{
  for (const NamedMesh& named : allMeshes())
    for (const Weights weights : guardedWeights())
      for (const Backend backend : backends()) {
        SCOPED_TRACE(named.name + ", " + std::string(name(weights)) + ", " + std::string(name(backend)));
        check(solverMeshOf(named.mesh), weights, backend);
      }
}

[[nodiscard]] inline RotationProblem problemOf(const SolverMesh& mesh, Weights weights, std::vector<Index> prescribed,
                                               std::vector<std::vector<Index>> rigidRegions = {})
{
  return {mesh.unknownCount(), rotationEdgeWeights(makeOperators(mesh, weights)).edges, std::move(prescribed),
          std::move(rigidRegions)};
}

/// `count` different unknowns in random order.
[[nodiscard]] inline std::vector<Index> someUnknowns(Random& random, const SolverMesh& mesh, std::size_t count)
{
  std::vector<Index> all;
  for (Index i = 0; i < mesh.unknownCount(); ++i) all.push_back(i);
  for (std::size_t k = 0; k < count; ++k)
    std::swap(all[k], all[random.integer(static_cast<long>(k), static_cast<long>(all.size()) - 1)]);
  all.resize(count);
  return all;
}

/// A row for each value.
[[nodiscard]] inline Columns3 rows(const std::vector<Vector3>& values)
{
  Columns3 result(static_cast<Index>(values.size()), 3);
  for (std::size_t k = 0; k < values.size(); ++k) result.row(static_cast<Index>(k)) = values[k];
  return result;
}

/// The field, or one of no rows after a failure of the running test.
[[nodiscard]] inline RotationField solved(const RotationProblem& problem, Backend backend, const Columns3& values)
{
  const RotationFieldResult result = makeRotationFieldSolver(problem, backend);
  EXPECT_NE(result.value, nullptr) << result.failure;
  return result.value == nullptr ? RotationField{} : result.value->solve(values);
}

}  // namespace holdfast::test

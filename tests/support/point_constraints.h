#pragma once
/// \file
/// Lists of constraints on points and vertices of a mesh, in few words.

#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/mesh/mesh.h>

#include "support/random.h"

namespace holdfast::test {

[[nodiscard]] Constraint moveBy(SurfaceLocation at, const Vector3& shift);
[[nodiscard]] Constraint moveTo(SurfaceLocation at, const Vector3& target);
[[nodiscard]] Constraint hold(std::vector<Index> vertices);
[[nodiscard]] Constraint rigid(std::vector<Index> vertices);
[[nodiscard]] Constraint handle(std::vector<Index> vertices, decltype(HandleConstraint::motion) motion,
                                const Vector3& translate);

/// The constraints in order, named "P0", "P1", ...
[[nodiscard]] ConstraintList listOf(std::vector<Constraint> constraints);

/// A vertex, a point of an edge or a point of a face, of the faces of `mesh`. Weights are multiples of 1/16, so that
/// sums of them are exact; with that, points that depend on one another do so exactly.
[[nodiscard]] SurfaceLocation randomPlace(Random& random, const Mesh& mesh);

/// `count` random places, each moved by a random shift of up to `size` along each axis.
[[nodiscard]] ConstraintList randomMoves(Random& random, const Mesh& mesh, int count, double size);

[[nodiscard]] Vector3 randomVector(Random& random, double size);

}  // namespace holdfast::test

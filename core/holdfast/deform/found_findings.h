#pragma once
/// What is doubtful about rotations that were found: turns that were lost, shapes that would give way, rotations that
/// points overrule.

#include <functional>
#include <optional>

#include <holdfast/check/finding.h>
#include <holdfast/constraints/constraint_system.h>
#include <holdfast/rotation/rotation_energy.h>

namespace holdfast {

/// Names constraints whose rotations the found ones `q` (n x 3, logs) lead to with other whole turns than were stated,
/// from the first that is given in a part of the mesh on, along its edges. O(T) where rotations that are given differ
/// by more than a quarter turn; else O(n).
[[nodiscard]] std::optional<Finding> lostTurns(const ConstraintSystem& system, const SolverMesh& mesh,
                                               const Columns3& q);

/// Names constraints that give a rotation within a rigid region which turns by another, because points decide it.
[[nodiscard]] std::optional<Finding> overruledRotations(const ConstraintSystem& system, const Columns3& q);

/// A displacement, and what follows it in the search.
struct SaddleTest {
  const RotationEnergy& energy;
  const SolverMesh& mesh;
  const Columns3& u;                                ///< n x 3, model units: what was found
  double flat = 0;                                  ///< of thinner parts, as a share of `energy.size()`
  std::function<Columns3(const Columns3& u)> next;  ///< the displacement of the next iteration
};

/// Warns where a part lies in a plane only because nothing says to which side it could give way: some displacement
/// across the plane grows from iteration to iteration. Up to `kMostSaddleSteps` iterations where a part is flat.
[[nodiscard]] std::optional<Finding> flatSaddle(const SaddleTest& test);

inline constexpr int kMostSaddleSteps = 24;

}  // namespace holdfast

#pragma once
/// These findings say what is doubtful about rotations that were found. Turns may be lost, flat parts may bend to
/// either side, and points may overrule rotations.

#include <functional>
#include <optional>

#include <holdfast/check/finding.h>
#include <holdfast/constraints/constraint_system.h>
#include <holdfast/rotation/rotation_energy.h>

namespace holdfast {

/// Names constraints that stated other whole turns than the found rotations `q` (n x 3, logs) lead to. It follows `q`
/// along the edges of each part of the mesh, from the first rotation given there. O(T) where given rotations differ by
/// more than a quarter turn, else O(n).
[[nodiscard]] std::optional<Finding> lostTurns(const ConstraintSystem& system, const SolverMesh& mesh,
                                               const Columns3& q);

/// Names constraints that give a rotation within a rigid region which turns by another rotation, because points decide
/// it.
[[nodiscard]] std::optional<Finding> overruledRotations(const ConstraintSystem& system, const Columns3& q);

/// A displacement, and what follows it in the search.
struct SaddleTest {
  const RotationEnergy& energy;
  const SolverMesh& mesh;
  const Columns3& u;                                ///< n x 3, model units: what was found
  double flat = 0;                                  ///< parts thinner than this share of `energy.size()` are flat
  std::function<Columns3(const Columns3& u)> next;  ///< the displacement of the next iteration
};

/// Warns where a part lies in a plane only because nothing says to which side it would bend. Then some displacement
/// across the plane grows from iteration to iteration. Takes up to `kMostSaddleSteps` iterations where a part is flat.
[[nodiscard]] std::optional<Finding> flatSaddle(const SaddleTest& test);

inline constexpr int kMostSaddleSteps = 24;

}  // namespace holdfast

#pragma once
/// The second of the three calls of section 6: all that the structure of a set of constraints costs, for any targets.

#include <memory>
#include <vector>

#include <holdfast/base/long_step.h>
#include <holdfast/deform/deform.h>
#include <holdfast/deform/rotation_factorization.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast {

/// The elimination of a set of constraints and, once they are asked for, the factors of positions and rotations. It
/// serves every set with the same rows, whatever these ask for; another structure makes another object.
class ConstraintFactorization {
 public:
  /// Eliminates. `model` stays alive as long as this; a factorisation that is left behind (`LongStep`) does not need
  /// it. O(see `findDependencies` and `Elimination`).
  ConstraintFactorization(const Model& model, std::shared_ptr<const Operators> operators,
                          const ConstraintSystem& system, const DeformOptions& options);
  ConstraintFactorization(const ConstraintFactorization&) = delete;
  ConstraintFactorization& operator=(const ConstraintFactorization&) = delete;

  /// Whether `system` has the rows, given rotations and rigid regions that this was made of. O(terms).
  [[nodiscard]] bool serves(const ConstraintSystem& system) const;

  [[nodiscard]] const EliminatedConstraints& eliminated() const noexcept { return *eliminated_; }
  [[nodiscard]] const std::vector<double>& sensitivities() const noexcept { return sensitivities_; }

  /// Whether rotations have been asked for and are factorised, or cannot be.
  [[nodiscard]] bool hasRotationFactor() const { return rotations_.isReady(); }

  /// The rotations that `system` asks for. Factorises when the first are asked for; `progress` may throw then, and the
  /// next call goes on where that is.
  [[nodiscard]] Rotations rotations(const ConstraintSystem& system, Progress& progress);

  /// The factorised problem of positions, or the reason why there is none. Factorises at the first call; `progress`
  /// may throw then, and the next call goes on where that is.
  [[nodiscard]] const SolverResult& positions(Progress& progress);

 private:
  ConstraintSystem system_;
  std::shared_ptr<const EliminatedConstraints> eliminated_;
  std::vector<double> sensitivities_;
  RotationFactorization rotations_;
  LongStep<SolverResult> positions_;
};

}  // namespace holdfast

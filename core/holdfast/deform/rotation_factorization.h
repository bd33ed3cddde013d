#pragma once
/// The rotation field of a set of constraints, and what it does to the problem of positions: sections 3.3 and 4.

#include <algorithm>
#include <bitset>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/report.h>
#include <holdfast/operators/operators.h>
#include <holdfast/rotation/rotation_field.h>
#include <holdfast/threads/long_step.h>

namespace holdfast {

/// The rotations of all unknowns, or the reason why there are none.
struct Rotations {
  Columns3 q;                                 ///< n x 3, logs; zero everywhere where no rotation is asked for
  std::optional<double> accuracy;             ///< see `RotationField`; none where no rotation is asked for
  std::optional<double> disagreementDegrees;  ///< largest difference of those given in one rigid region; likewise
  std::vector<Finding> findings;              ///< what is doubtful about the field, ids in the file and in the list
  std::string failure;
};

/// Given rotations of a rigid region are a finding where they differ by more than this. It is in half angles, in
/// radians: what the promised residual is for a length.
inline constexpr double kAgreeingRotations = 1e-12;

/// Tells whether constraints give a rotation other than none.
[[nodiscard]] bool asksForRotation(const ConstraintSystem& system);

/// Finds rotations for constraints of one structure. Nothing is factorised before a rotation is asked for.
class RotationFactorization {
 public:
  /// `mesh` must stay alive as long as this. The `operators` are those of the mesh, or none where no rotation will be
  /// asked for. `ranks` may be empty, see `RotationProblem`.
  RotationFactorization(const SolverMesh& mesh, std::shared_ptr<const Operators> operators, Backend backend,
                        std::vector<int> ranks = {})
      : mesh_(mesh), operators_(std::move(operators)), backend_(backend), ranks_(std::move(ranks))
  {
  }

  /// Returns the field for the rotations of `system`. The prescribed unknowns, rigid regions and flat unknowns must be
  /// the same at every call. At flat unknowns the field is 0 across the normal, so that each axis of a frame of their
  /// normals is a problem of its own. Those whose normals are at odds with most others' are free. The first rotations
  /// that are asked for start the factorisation. `progress` may throw then, and the next call goes on.
  [[nodiscard]] Rotations solve(const ConstraintSystem& system, Progress& progress);

  /// Tells whether nothing is left to factorise.
  [[nodiscard]] bool isReady() const
  {
    return !fields_.empty() && std::ranges::all_of(fields_, [](const AxisField& some) { return some.field->isDone(); });
  }

 private:
  /// The coordinates of the field along some axes of the frame, where flat unknowns are 0 across their normals.
  struct AxisField {
    std::bitset<3> axes;
    Index flat = 0;  ///< how many such unknowns are prescribed behind the given ones
    std::unique_ptr<LongStep<RotationFieldResult>> field;
  };

  void prepare(const ConstraintSystem& system);

  const SolverMesh& mesh_;
  std::shared_ptr<const Operators> operators_;
  Backend backend_;
  std::vector<int> ranks_;
  std::vector<AxisField> fields_;  // empty until a rotation is asked for
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
  std::vector<Finding> guards_;
};

/// Enters in `report` the figures and findings of the rotations.
void takeOver(const Rotations& rotations, Report& report);

/// Returns `delta` rotated by exp(q_i), less `delta`: n x 3.
[[nodiscard]] Columns3 rotationOfDelta(const Columns3& delta, const Columns3& q);

}  // namespace holdfast

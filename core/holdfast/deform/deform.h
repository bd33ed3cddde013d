#pragma once
/// The whole way from a mesh and its constraints to deformed positions: set-up, decomposition, solution (section 6).

#include <memory>
#include <string>

#include <holdfast/base/progress.h>
#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/model.h>
#include <holdfast/deform/report.h>

namespace holdfast {

struct DeformDetails;

/// `near` places farther from the surface than this share of the diagonal are warned of: parts as measured are seldom
/// off by more, and places in another unit or coordinate system are.
inline constexpr double kNearLimit = 0.01;

struct DeformOptions {
  Weights weights = Weights::Cotangent;
  SolverOptions solver;
  RotationOptions rotations = {};
  double nearLimit = kNearLimit;  ///< share of the diagonal
  double weldTolerance = 0;       ///< for `makeModel`, model units: a model that is there already was welded

  friend bool operator==(const DeformOptions&, const DeformOptions&) = default;
};

/// A deformed mesh, or (status `Failed`) the mesh at rest with the reason in the report.
struct DeformResult {
  Positions positions;  ///< of the file's vertices
  Columns3 rotations;   ///< q of every unknown, n x 3, logs
  Report report;
  std::shared_ptr<const DeformDetails> details;  ///< what fields, multipliers and marks of constraints are made of

  /// Those of the constraints, summed up at the unknowns that they name, n x 3; 0 at all others. No rows but for hard
  /// constraints that were solved. Made when they are first asked for.
  [[nodiscard]] const Columns3& multipliers() const;
};

/// Deforms `model` under `constraints`; `source` names the list in messages. Throws `InputError` for constraints that
/// do not fit the mesh, and what `progress` throws. Everything else is in the report. The model is not changed.
[[nodiscard]] DeformResult deform(const Model& model, const ConstraintList& constraints,
                                  const std::string& source = "constraints", const DeformOptions& options = {},
                                  Progress& progress = noProgress());

/// The report without positions: what repeats, what conflicts, which parts would stay at rest. Residuals are not set.
/// Rotations are solved for, with the weights and the backend of `options`, where any are asked for: what rigid regions
/// and kept distances ask for turns with them. The status is `Failed` where the rotations cannot be found; what is said
/// of constraints then holds without them.
[[nodiscard]] Report diagnoseConstraints(const Model& model, const ConstraintList& constraints,
                                         const std::string& source = "constraints", const DeformOptions& options = {});

/// The part of the report that speaks of the mesh alone.
[[nodiscard]] MeshReport describeMesh(const Model& model);

}  // namespace holdfast

#pragma once
/// `deform` goes the whole way from a mesh and its constraints to deformed positions: set-up, decomposition and
/// solution (section 6).

#include <memory>
#include <string>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/model.h>
#include <holdfast/deform/report.h>
#include <holdfast/threads/progress.h>

namespace holdfast {

struct DeformDetails;

/// The report warns of `near` places farther from the surface than this share of the diagonal. Parts as measured are
/// seldom off by more. Places in another unit or coordinate system are.
inline constexpr double kNearLimit = 0.01;

/// These options say how to deform, whatever the constraints are.
struct DeformOptions {
  Weights weights = Weights::Cotangent;
  SolverOptions solver;
  RotationOptions rotations = {};
  double nearLimit = kNearLimit;  ///< as a share of the diagonal
  double weldTolerance = 0;       ///< for `makeModel`, in model units; `deform` ignores it: its model was welded before

  friend bool operator==(const DeformOptions&, const DeformOptions&) = default;
};

/// A deformed mesh. Where the status is `Failed` it is the mesh at rest, and the report has the reason.
struct DeformResult {
  Positions positions;  ///< N x 3, of the file's vertices, model units
  Columns3 rotations;   ///< n x 3, the log q of every unknown
  Report report;
  std::shared_ptr<const DeformDetails> details;  ///< fields, multipliers and marks of constraints are made of these

  /// Returns the Lagrange multipliers of the constraints, n x 3. Each row is their sum at an unknown that constraints
  /// name, and 0 at all others. There are no rows unless hard constraints were solved. The first call makes them.
  [[nodiscard]] const Columns3& multipliers() const;
};

/// Deforms `model` under `constraints`. Messages call the list `source`. The model is not changed. Any thread may call
/// this. Several may do so at once with one model, and each gets the bits that it would get alone.
///
/// Throws `InputError` for constraints that do not fit the mesh, `std::bad_alloc` where memory does not suffice, and
/// what `progress` throws. The report has everything else. Without a usable solution the status is `Failed`.
///
/// A surface of n vertices takes O(n^1.5) operations and O(n log n) memory, at n = 400,000 some 2 KB a vertex. Nearly
/// all of both is for the factor. A `Deformer` keeps it for other targets.
///
///     const Model model = makeModel(readMesh("bracket.obj").mesh, "bracket.obj");
///     DeformOptions options;
///     options.rotations.source = RotationSource::Found;
///     const DeformResult result = deform(model, readConstraints("points.csv"), "points.csv", options);
///     if (result.report.solve.status == SolveStatus::Failed) std::cerr << result.report.solve.message << '\n';
[[nodiscard]] DeformResult deform(const Model& model, const ConstraintList& constraints,
                                  const std::string& source = "constraints", const DeformOptions& options = {},
                                  Progress& progress = noProgress());

/// Makes the report without positions. It says which constraints repeat others, which conflict, and which parts would
/// stay at rest. Residuals are not set. Where constraints ask for rotations, these are solved for with the weights and
/// the backend of `options`. What rigid regions and kept vectors ask for turns with them. Where the rotations cannot be
/// found, the status is `Failed`. What the report says of constraints then holds without rotations. Throws `InputError`
/// for constraints that do not fit the mesh.
[[nodiscard]] Report diagnoseConstraints(const Model& model, const ConstraintList& constraints,
                                         const std::string& source = "constraints", const DeformOptions& options = {});

/// Makes the part of the report that speaks of the mesh alone.
[[nodiscard]] MeshReport describeMesh(const Model& model);

}  // namespace holdfast

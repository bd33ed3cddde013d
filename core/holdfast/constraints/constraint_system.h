#pragma once
/// \file
/// Constraints as the solver sees them: the rows of B and d, in the user's order, over unknowns.

#include <string>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

/// One row of B x = d. It holds for x, y and z alike.
struct ConstraintRow {
  std::vector<PointTerm> terms;  ///< unknowns, ascending, with their coefficients; a pin is one term of weight 1
  Vector3 target;                ///< d, model units
  Vector3 shift;                 ///< d - B p at rest: what the row asks of the displacement
  Index constraint = 0;          ///< place in the list of the constraint that it came from

  [[nodiscard]] bool isPin() const noexcept { return terms.size() == 1; }
};

/// All rows of the enabled constraints, in the user's order; what is behind this door may rely on unknowns in range,
/// canonical terms and finite numbers.
struct ConstraintSystem {
  std::vector<ConstraintRow> rows;
  std::vector<SurfacePoint> points;      ///< of each constraint of type point: where it lies, in file vertices
  std::vector<double> surfaceDistances;  ///< of each constraint: how far its `near` place lay from the surface; else 0
};

/// Makes rows of a list of constraints on a mesh whose positions are finite. `source` names the list in messages.
/// Throws `InputError` with the place in the list: ids out of range, edges that are not in the mesh, as many weights as
/// a face has no corners, selections without a vertex. O(N) per selection, O(log T) per `near` point after O(T log T).
[[nodiscard]] ConstraintSystem makeConstraintSystem(const ConstraintList& list, const Mesh& mesh,
                                                    const Triangulation& triangulation, const SolverMesh& solverMesh,
                                                    const std::string& source);

}  // namespace holdfast

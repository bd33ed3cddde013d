#pragma once
/// \file
/// These details are what a deformation was computed from. Its report is made of them when somebody looks at it.

#include <future>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/operators/operators.h>

namespace holdfast {

/// A label is what a report says of a constraint in any case.
struct ConstraintLabel {
  std::string name;
  std::string_view type;
  bool isEnabled = true;
  bool hasTarget = false;  ///< it has its own target, which can be another one: points and offsets
};

using ConstraintLabels = std::vector<ConstraintLabel>;

/// Lagrange multipliers of hard constraints. All lengths are in diagonals.
struct Multipliers {
  Columns3 ofRows;
  Columns3 atUnknowns;  ///< n x 3: summed up at the unknowns that constraints name; 0 at all others
};

struct DeformDetails {
  ConstraintSystem system;  ///< the rows that were asked for, rotated by the rotations
  Diagnosis diagnosis;
  std::shared_ptr<const Operators> operators;                ///< without L after `deform`
  std::shared_ptr<const ConstraintLabels> labels;            ///< of the constraints in the list
  std::shared_ptr<const std::vector<double>> sensitivities;  ///< of rows, see `Elimination::sensitivities`
  std::vector<double> residuals;                             ///< of rows at the positions of the result, model units
  bool isSolved = false;                                     ///< the positions are a solution, and not those at rest
  std::shared_future<Multipliers> multipliers;               ///< made on demand; none but for hard constraints
};

}  // namespace holdfast

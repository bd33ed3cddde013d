#pragma once
/// \file
/// What a deformation was computed from: the rows of its constraints, the verdict on them, and the operators.

#include <memory>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/operators/operators.h>

namespace holdfast {

struct DeformDetails {
  ConstraintSystem system;  ///< the rows that were asked for, rotated by the rotations
  Diagnosis diagnosis;
  std::shared_ptr<const Operators> operators;  ///< without L after `deform`
};

}  // namespace holdfast

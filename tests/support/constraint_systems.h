#pragma once
/// \file
/// The rows of a list of constraints on a mesh, in few words.

#include <holdfast/constraints/constraint_system.h>

namespace holdfast::test {

[[nodiscard]] ConstraintSystem systemOf(const Mesh& mesh, const ConstraintList& list);

}  // namespace holdfast::test

#pragma once
/// \file
/// Lists of constraints made at random, compared member by member, and as text.

#include <string>

#include <holdfast/constraints/constraint.h>

#include "support/random.h"

namespace holdfast::test {

/// The first line of a point list as text.
inline const std::string kPointListHeader = "name,x,y,z,target_x,target_y,target_z\n";

/// A selection of every kind and up to `depth` levels, as a constraint file can say it.
[[nodiscard]] Selection randomSelection(Random& random, int depth);

/// A list of `count` constraints of every type, as a constraint file can say it: numbers of all magnitudes and with all
/// digits, names with quotes, line ends and letters beyond ASCII.
[[nodiscard]] ConstraintList randomConstraintList(Random& random, int count);

/// The same in every member, numbers bit for bit, but for the form of `NotIn`, which is compared by value.
[[nodiscard]] testing::AssertionResult areSame(const ConstraintList& a, const ConstraintList& b);

}  // namespace holdfast::test

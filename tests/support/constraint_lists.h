#pragma once
/// \file
/// Lists of constraints made at random, and compared member by member.

#include <holdfast/constraints/constraint.h>

#include "support/random.h"

namespace holdfast::test {

/// A selection of every kind and up to `depth` levels, as a constraint file can say it.
[[nodiscard]] Selection randomSelection(Random& random, int depth);

/// A list of `count` constraints of every type, as a constraint file can say it: numbers of all magnitudes and with all
/// digits, names with quotes, line ends and letters beyond ASCII.
[[nodiscard]] ConstraintList randomConstraintList(Random& random, int count);

/// The same in every member, numbers bit for bit, but for the form of `NotIn`, which is compared by value.
[[nodiscard]] testing::AssertionResult areSame(const ConstraintList& a, const ConstraintList& b);

}  // namespace holdfast::test

#pragma once
/// One term of a linear combination.

#include <compare>

#include <holdfast/base/types.h>

namespace holdfast {

/// `coefficient` times what `index` names: a vertex of a surface point, an unknown of a row, a row of a dependency.
struct Term {
  Index index = 0;
  double coefficient = 0;

  friend bool operator==(const Term&, const Term&) = default;
  friend auto operator<=>(const Term&, const Term&) = default;
};

}  // namespace holdfast

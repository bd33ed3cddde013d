#pragma once
/// A row of a point list that was left out.

#include <string>

#include <holdfast/base/types.h>

namespace holdfast {

struct SkippedRow {
  Index line = 0;  ///< of the file, from 1
  std::string name;
  std::string fault;  ///< where in the row and what is wrong: "column z: "two" is not a number"
};

}  // namespace holdfast

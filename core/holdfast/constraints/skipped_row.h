#pragma once
/// Rows of a point list may be left out.

#include <string>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// This row of a point list could not be read and was left out.
struct SkippedRow {
  Index line = 0;  ///< its line in the file, from 1
  std::string name;
  std::string fault;  ///< where in the row the fault is, and what is wrong: "column z: "two" is not a number"
};

}  // namespace holdfast

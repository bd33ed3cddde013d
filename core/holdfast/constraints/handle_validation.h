#pragma once
/// What a handle may not say, whatever the mesh is.

#include <optional>
#include <string>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// What cannot be in a handle: the key at fault below that of the constraint (".frame.to.y"), why, and what to do.
struct HandleError {
  std::string key;
  std::string reason;
};

/// The first thing in the handle that contradicts what its type demands: entries for each vertex of what is no list of
/// distinct vertices, or not as many; too few targets; frames of zero or parallel axes; whole turns about no axis.
[[nodiscard]] std::optional<HandleError> validateHandle(const HandleConstraint& handle);

}  // namespace holdfast

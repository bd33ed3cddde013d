#pragma once
/// The result of a step that can fail.

#include <string>

namespace holdfast {

/// A value, or the reason why there is none. In the latter case `failure` is not empty and `value` means nothing.
template <class T>
struct Result {
  T value{};
  std::string failure = {};

  [[nodiscard]] explicit operator bool() const noexcept { return failure.empty(); }
};

}  // namespace holdfast

#pragma once
/// What a step that can fail gives back.

#include <string>

namespace holdfast {

/// A value, or the reason why there is none: then `failure` is not empty and `value` means nothing.
template <class T>
struct Result {
  T value{};
  std::string failure = {};

  [[nodiscard]] explicit operator bool() const noexcept { return failure.empty(); }
};

}  // namespace holdfast

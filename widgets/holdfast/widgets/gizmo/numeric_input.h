#pragma once
/// \file
/// A number that is typed key by key while a gesture goes on.

#include <string>
#include <string_view>

namespace holdfast {

/// Digits and one point or comma, in the order of the keys. Minus turns the sign at any time. No locale has a say.
class NumericInput {
 public:
  static constexpr std::string_view kKeys = "0123456789.,-";

  /// Whether a number can begin with the key.
  [[nodiscard]] static bool isBegunBy(char key);

  /// False, and nothing changes, where the number cannot go on with the key.
  bool add(char key);
  /// Takes back the last key's digit, point or sign.
  void chop();
  void clear() { text_.clear(); }

  [[nodiscard]] bool isEmpty() const noexcept { return text_.empty(); }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  /// The nearest double; 0 before the first digit.
  [[nodiscard]] double value() const;

 private:
  std::string text_;
};

}  // namespace holdfast

#pragma once
/// \file
/// A length or an angle that is typed while the mouse is busy.

#include <QString>

class QKeyEvent;

namespace holdfast {

/// Digits and one point or comma, in the order of the keys. Minus turns the sign at any time. No locale has a say.
class TypedAmount {
 public:
  /// Whether the key can begin a number: held together with nothing but Shift or the number pad.
  [[nodiscard]] static bool isBegunBy(const QKeyEvent& event);

  /// False, and nothing changes, where the number cannot go on with the key.
  bool add(const QKeyEvent& event);
  /// Takes back the last key's digit, point or sign.
  void chop();
  void clear();

  [[nodiscard]] bool isEmpty() const noexcept { return text_.isEmpty(); }
  [[nodiscard]] const QString& text() const noexcept { return text_; }
  /// The nearest double; 0 before the first digit.
  [[nodiscard]] double value() const;

 private:
  QString text_;
};

}  // namespace holdfast

#pragma once
/// Offers lines into which a user types numbers, with all their digits.

#include <QLineEdit>
#include <array>
#include <optional>

#include <holdfast/window/text/number_text.h>

namespace holdfast {

/// The line shows a number as its shortest exact text. Enter, or leaving the line, enters another number. Escape
/// restores the last one.
class NumberEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberEdit(QWidget* parent = nullptr);

  /// Shows a number, or "mixed" if there are several. It does not disturb a user who is typing.
  void setNumber(std::optional<double> number);
  [[nodiscard]] std::optional<double> typed() const { return typedNumber(text()); }
  /// Replaces what the user has typed by a number.
  void replaceTyped(std::optional<double> number);

  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void entered(double number);
  /// The text is no number. The line shows it as long as it has the focus.
  void refused(const QString& reason);
  /// The user types a number, or the line has its last one again. What was refused is not there any more.
  void righted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  void finish();

  std::optional<double> number_;
  bool isRefused_ = false;  // what was typed last
};

class VectorEdit : public QWidget {
  Q_OBJECT

 public:
  using Numbers = std::array<std::optional<double>, 3>;

  /// Makes three lines. They are called `name` + "X", ... for scripts, and `title` + " x", ... for screen readers.
  VectorEdit(const QString& name, const QString& title, QWidget* parent = nullptr);

  void setNumbers(const Numbers& numbers)
  {
    for (std::size_t axis = 0; axis < 3; ++axis) lines_[axis]->setNumber(numbers[axis]);
  }
  [[nodiscard]] Numbers typed() const { return {lines_[0]->typed(), lines_[1]->typed(), lines_[2]->typed()}; }
  [[nodiscard]] NumberEdit& line(int axis) { return *lines_[static_cast<std::size_t>(axis)]; }

 Q_SIGNALS:
  void entered(int axis, double number);
  void refused(const QString& reason);
  void righted();

 private:
  std::array<NumberEdit*, 3> lines_{};
};

}  // namespace holdfast

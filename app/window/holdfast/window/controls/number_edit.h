#pragma once
/// \file
/// Lines to type numbers into, with all their digits.

#include <QLineEdit>
#include <array>
#include <optional>

namespace holdfast {

/// A number with its shortest exact text. What the user typed is told of when he leaves the line or presses Enter,
/// once, and only where it is another number; Escape brings back the number that was there.
class NumberEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberEdit(QWidget* parent = nullptr);

  /// Shows a number, or that there are several. Does not disturb the user while he types.
  void setNumber(std::optional<double> number);
  /// The number that is typed at the moment; nothing where that is none.
  [[nodiscard]] std::optional<double> typed() const;
  /// The same, and gives up what the user typed.
  void replaceTyped(std::optional<double> number);

  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void entered(double number);
  /// What was typed is no number; the line shows it as long as it has the focus.
  void refused(const QString& reason);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void finish();

  std::optional<double> number_;
};

/// Three lines side by side, x, y and z.
class VectorEdit : public QWidget {
  Q_OBJECT

 public:
  using Numbers = std::array<std::optional<double>, 3>;

  /// Lines are called `name` + "X", ... for scripts, and `title` + " x", ... for people who hear what they cannot see.
  VectorEdit(const QString& name, const QString& title, QWidget* parent = nullptr);

  void setNumbers(const Numbers& numbers);
  /// What the lines say at the moment; nothing where that is no number.
  [[nodiscard]] Numbers typed() const;
  [[nodiscard]] NumberEdit& line(int axis) { return *lines_[static_cast<std::size_t>(axis)]; }

 Q_SIGNALS:
  void entered(int axis, double number);
  void refused(const QString& reason);

 private:
  std::array<NumberEdit*, 3> lines_{};
};

}  // namespace holdfast

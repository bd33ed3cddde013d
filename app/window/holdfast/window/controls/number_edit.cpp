#include "holdfast/window/controls/number_edit.h"

#include <QKeyEvent>
#include <utility>

#include <holdfast/numbers/same_bits.h>
#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {
namespace {

bool isSame(const std::optional<double>& a, const std::optional<double>& b)
{
  return a.has_value() == b.has_value() && (!a || hasSameBits(*a, *b));
}

constexpr int kVisibleDigits = 9;

}  // namespace

NumberEdit::NumberEdit(QWidget* parent) : QLineEdit(parent)
{
  setPlaceholderText(tr("mixed"));
  connect(this, &QLineEdit::editingFinished, this, &NumberEdit::finish);
  connect(this, &QLineEdit::textEdited, this, [this] {
    if (typed()) Q_EMIT righted();
  });
}

void NumberEdit::setNumber(std::optional<double> number)
{
  if (isModified() && hasFocus() && isSame(number, number_)) return;
  replaceTyped(number);
}

void NumberEdit::replaceTyped(std::optional<double> number)
{
  number_ = number;
  // No sum is -0.
  const QString exact = number ? exactText(*number + 0.0) : QString();
  if (text() != exact) setText(exact);
  setModified(false);
  setToolTip(exact);
  if (!hasFocus()) setCursorPosition(0);
}

QSize NumberEdit::sizeHint() const
{
  const QSize usual = QLineEdit::sizeHint();
  return {fontMetrics().horizontalAdvance('0') * kVisibleDigits + usual.height(), usual.height()};
}

void NumberEdit::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Escape && isModified()) {
    replaceTyped(number_);
    event->accept();
    Q_EMIT righted();
    return;
  }
  QLineEdit::keyPressEvent(event);
}

void NumberEdit::focusInEvent(QFocusEvent* event)
{
  QLineEdit::focusInEvent(event);
  // What was refused when the user left was replaced then.
  if (std::exchange(isRefused_, false)) Q_EMIT righted();
}

void NumberEdit::finish()
{
  if (!isModified()) return;
  const QString shown = text();
  const std::optional<double> number = typed();
  if (!number) {
    if (!hasFocus()) replaceTyped(number_);
    isRefused_ = !shown.trimmed().isEmpty() || number_;
    if (isRefused_) Q_EMIT refused(notANumber(shown));
    return;
  }
  const bool isOther = !isSame(number, number_);
  replaceTyped(number);
  if (isOther) Q_EMIT entered(*number);
}

VectorEdit::VectorEdit(const QString& name, const QString& title, QWidget* parent) : QWidget(parent)
{
  auto* layout = newLayout<QHBoxLayout>(this, 0, 4);
  const QString axes = QStringLiteral("xyz");
  for (int axis = 0; axis < 3; ++axis) {
    NumberEdit* line = named(new NumberEdit(this), name + axes[axis].toUpper(), title + ' ' + axes[axis]);
    connect(line, &NumberEdit::entered, this, [this, axis](double number) { Q_EMIT entered(axis, number); });
    connect(line, &NumberEdit::refused, this, &VectorEdit::refused);
    connect(line, &NumberEdit::righted, this, &VectorEdit::righted);
    layout->addWidget(line, 1);
    lines_[static_cast<std::size_t>(axis)] = line;
  }
  setFocusProxy(lines_.front());
}

}  // namespace holdfast

#include "holdfast/widgets/tools/typed_amount.h"

#include <QKeyEvent>

#include <holdfast/widgets/number_words.h>

namespace holdfast {
namespace {

// What a double can tell apart, and room for zeros around it.
constexpr int kMostCharacters = 24;

/// A digit, '.' or '-'; nothing where the key stands for none of them.
QChar characterOf(const QKeyEvent& event)
{
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return {};
  if (event.text().size() != 1) return {};
  const QChar character = event.text().front();
  if (character == ',') return '.';
  const bool isDigit = character >= '0' && character <= '9';
  return isDigit || character == '.' || character == '-' ? character : QChar();
}

}  // namespace

bool TypedAmount::isBegunBy(const QKeyEvent& event)
{
  return !characterOf(event).isNull();
}

bool TypedAmount::add(const QKeyEvent& event)
{
  const QChar character = characterOf(event);
  if (character.isNull()) return false;
  if (character == '-') {
    text_ = text_.startsWith('-') ? text_.mid(1) : '-' + text_;
    return true;
  }
  if (text_.size() >= kMostCharacters || (character == '.' && text_.contains('.'))) return false;
  text_ += character;
  return true;
}

void TypedAmount::chop()
{
  text_.chop(1);
}

void TypedAmount::clear()
{
  text_.clear();
}

double TypedAmount::value() const
{
  return typedNumber(text_).value_or(0);
}

}  // namespace holdfast

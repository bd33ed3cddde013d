#include "holdfast/widgets/gizmo/numeric_input.h"

#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

// What a double can tell apart, and room for zeros around it.
constexpr std::size_t kMostCharacters = 24;

}  // namespace

bool NumericInput::isBegunBy(char key)
{
  return kKeys.find(key) != std::string_view::npos;
}

bool NumericInput::add(char key)
{
  if (!isBegunBy(key)) return false;
  if (key == '-') {
    text_ = text_.starts_with('-') ? text_.substr(1) : '-' + text_;
    return true;
  }
  const char character = key == ',' ? '.' : key;
  if (text_.size() >= kMostCharacters || (character == '.' && text_.find('.') != std::string::npos)) return false;
  text_ += character;
  return true;
}

void NumericInput::chop()
{
  if (!text_.empty()) text_.pop_back();
}

double NumericInput::value() const
{
  const ParsedNumber<double> number = parseDouble(text_);
  return number.fault == NumberFault::None ? number.value : 0;
}

}  // namespace holdfast

#include "holdfast/io/text/text_cursor.h"

#include <algorithm>

#include <holdfast/base/printable.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

template <class Number>
Number parsed(const TextCursor& cursor, std::string_view token, std::string_view what, const char* tooLarge,
              const char* other)
{
  const auto [value, fault] = parseNumber<Number>(token);
  if (fault == NumberFault::None) return value;
  if (token.empty()) cursor.fail("{} is missing: complete the line", what);
  cursor.fail("{} is {}, {}", what, quotedToken(token), fault == NumberFault::OutOfRange ? tooLarge : other);
}

}  // namespace

TextCursor::TextCursor(std::string_view text, std::string file, TextDialect dialect)
    : text_(text), file_(std::move(file)), dialect_(dialect)
{
  if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  for (const char c :
       {' ', '\t', '\r', '\v', '\f', '\n', dialect_.comment.value_or('\n'), dialect_.continuation.value_or('\n')})
    mayEnd_[static_cast<unsigned char>(c)] = true;
}

std::string_view TextCursor::token()
{
  skipBlanks();
  const std::size_t first = at_;
  while (at_ < text_.size() && !(mayEndAt(at_) && (dialect_.continuation != text_[at_] || continued(at_)))) ++at_;
  return text_.substr(first, at_ - first);
}

bool TextCursor::findToken()
{
  for (;;) {
    skipBlanks();
    if (at_ == text_.size()) return false;
    if (text_[at_] != '\n') return true;
    ++at_;
    ++line_;
  }
}

void TextCursor::skipLine()
{
  while (at_ < text_.size()) {
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) {
      at_ = text_.size();
      return;
    }
    const std::size_t last = end > at_ && text_[end - 1] == '\r' ? end - 1 : end;
    const bool isContinued = last > at_ && continued(last - 1).has_value();
    at_ = end + 1;
    ++line_;
    if (!isContinued) return;
  }
}

double TextCursor::numberOf(std::string_view token, std::string_view what) const
{
  return parsed<double>(*this, token, what,
                        "which no double can hold (4.9e-324 to 1.8e308 in magnitude): scale the model, or write 0 "
                        "where that is meant",
                        "which is not a number: write digits, as in -1.5e3");
}

Index TextCursor::integerOf(std::string_view token, std::string_view what) const
{
  return parsed<Index>(*this, token, what, "far beyond any count or index: correct it",
                       "which is not a whole number: write digits only");
}

Index TextCursor::skipNumbers(std::string_view what)
{
  Index count = 0;
  for (std::string_view next = token(); !next.empty(); next = token(), ++count) static_cast<void>(numberOf(next, what));
  return count;
}

void TextCursor::expectLineEnd(std::string_view remedy)
{
  const std::string_view extra = token();
  if (!extra.empty()) fail("{} is too much here: {}", quotedToken(extra), remedy);
}

Index TextCursor::line() const
{
  const bool isPastLastLine = at_ == text_.size() && at_ > 0 && text_[at_ - 1] == '\n';
  return isPastLastLine ? std::max<Index>(line_ - 1, 1) : line_;
}

void TextCursor::skipBlanks()
{
  while (at_ < text_.size() && mayEndAt(at_)) {
    if (isBlank(text_[at_])) {
      ++at_;
    } else if (const std::optional<std::size_t> next = continued(at_)) {
      at_ = *next;
      ++line_;
    } else {
      if (dialect_.comment == text_[at_]) at_ = std::min(text_.find('\n', at_), text_.size());
      return;
    }
  }
}

std::optional<std::size_t> TextCursor::continued(std::size_t at) const
{
  if (dialect_.continuation != text_[at]) return std::nullopt;
  std::size_t next = at + 1;
  if (next < text_.size() && text_[next] == '\r') ++next;
  if (next < text_.size() && text_[next] == '\n') return next + 1;
  return std::nullopt;
}

std::string quotedToken(std::string_view token)
{
  constexpr std::size_t kLongest = 40;
  return '\'' + printable(token, kLongest) + '\'';
}

}  // namespace holdfast

#include "holdfast/io/text/text_cursor.h"

#include <algorithm>

#include <holdfast/io/text/loose_number.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool isLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

/// Tells whether the first line ends in CR alone.
bool endsInReturnAlone(std::string_view text)
{
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos || text[end] == '\n') return false;
  const std::size_t next = text.find_first_not_of('\r', end);
  return next == std::string_view::npos || text[next] != '\n';
}

constexpr const char* kNotANumber = "which is not a number: write digits, as in -1.5e3";
constexpr const char* kTooLarge =
    "which no double can hold (up to 1.8e308 in magnitude): scale the model, or write 0 where that is meant";

template <class Number>
Number valueOf(const TextCursor& cursor, const ParsedNumber<Number>& parsed, std::string_view token,
               std::string_view what, const char* tooLarge, const char* other)
{
  if (parsed.fault == NumberFault::None) return parsed.value;
  if (token.empty()) cursor.fail("{} is missing: complete the line", what);
  cursor.fail("{} is {}, {}", what, quotedToken(token), parsed.fault == NumberFault::OutOfRange ? tooLarge : other);
}

}  // namespace

TextCursor::TextCursor(std::string_view text, std::string file, TextDialect dialect)
    : text_(text), file_(std::move(file)), dialect_(dialect), hasLoneReturns_(endsInReturnAlone(text))
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
  while (at_ < text_.size() && !(mayEndAt(at_) && endsAt(at_))) ++at_;
  return text_.substr(first, at_ - first);
}

bool TextCursor::endsAt(std::size_t at) const
{
  if (dialect_.continuation == text_[at]) return continued(at).has_value();
  return dialect_.comment != text_[at] || !hasSpecialAt(text_, at);
}

bool TextCursor::findToken()
{
  for (;;) {
    skipBlanks();
    if (at_ == text_.size()) return false;
    if (const std::optional<std::size_t> next = behindLineEnd(at_)) {
      at_ = *next;
      ++line_;
    } else if (text_.substr(at_).starts_with(kByteOrderMark)) {
      at_ += kByteOrderMark.size();
    } else {
      return true;
    }
  }
}

void TextCursor::skipLine(GluedBackslash glued)
{
  const auto mayContinue = [&](std::size_t at) {
    return glued == GluedBackslash::Continues || at == 0 || isBlank(text_[at - 1]);
  };
  while (at_ < text_.size()) {
    if (const std::optional<std::size_t> next = behindLineEnd(at_)) {
      at_ = *next;
      ++line_;
      return;
    }
    if (dialect_.comment == text_[at_]) {
      skipComment();
      continue;
    }
    const std::optional<std::size_t> next = mayContinue(at_) ? continued(at_) : std::nullopt;
    line_ += next ? 1 : 0;
    at_ = next.value_or(at_ + 1);
  }
}

double TextCursor::numberOf(std::string_view token, std::string_view what) const
{
  return valueOf(*this, parseLooseNumber(token), token, what, kTooLarge, kNotANumber);
}

Index TextCursor::integerOf(std::string_view token, std::string_view what) const
{
  return valueOf(*this, parseNumber<Index>(token), token, what, "far beyond any count or index: correct it",
                 "which is not a whole number: write digits only");
}

void TextCursor::expectNumber(std::string_view token, std::string_view what) const
{
  if (parseLooseNumber(token).fault == NumberFault::NotANumber) static_cast<void>(numberOf(token, what));
}

Index TextCursor::skipNumbers(std::string_view what)
{
  Index count = 0;
  for (std::string_view next = token(); !next.empty(); next = token(), ++count) expectNumber(next, what);
  return count;
}

void TextCursor::expectLineEnd(std::string_view remedy)
{
  const std::string_view extra = token();
  if (!extra.empty()) fail("{} is too much here: {}", quotedToken(extra), remedy);
}

Index TextCursor::line() const
{
  const bool isPastLastLine = at_ == text_.size() && at_ > 0 && isLineEnd(text_[at_ - 1]);
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
      if (dialect_.comment == text_[at_]) skipComment();
      return;
    }
  }
}

void TextCursor::skipComment()
{
  while (at_ < text_.size() && !isLineEnd(text_[at_])) ++at_;
}

std::optional<std::size_t> TextCursor::continued(std::size_t at) const
{
  if (dialect_.continuation != text_[at]) return std::nullopt;
  std::size_t next = at + 1;
  while (next < text_.size() && isBlank(text_[next])) ++next;
  return next == text_.size() ? next : behindLineEnd(next);
}

std::optional<std::size_t> TextCursor::behindLineEnd(std::size_t at) const
{
  if (text_[at] == '\n') return at + 1;
  if (text_[at] != '\r') return std::nullopt;
  if (hasLoneReturns_) return at + 1;
  // Text mode on Windows makes CR CR LF of CR LF.
  const std::size_t next = std::min(text_.find_first_not_of('\r', at), text_.size());
  return next < text_.size() && text_[next] == '\n' ? next + 1 : at + 1;
}

std::string_view withoutPadding(std::string_view bytes)
{
  while (bytes.ends_with('\0') || bytes.ends_with('\x1A')) bytes.remove_suffix(1);
  return bytes;
}

std::string quotedToken(std::string_view token)
{
  constexpr std::size_t kLongest = 40;
  return '\'' + printable(token, kLongest) + '\'';
}

}  // namespace holdfast

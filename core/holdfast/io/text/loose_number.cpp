#include "holdfast/io/text/loose_number.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace holdfast {
namespace {

struct Special {
  std::string_view word;
  double value;
};

// Zeros may follow, for as many places as were asked for.
constexpr std::array<Special, 4> kSpecials{{{"1.#QNAN", std::numeric_limits<double>::quiet_NaN()},
                                            {"1.#SNAN", std::numeric_limits<double>::quiet_NaN()},
                                            {"1.#IND", std::numeric_limits<double>::quiet_NaN()},
                                            {"1.#INF", std::numeric_limits<double>::infinity()}}};

bool isSigned(std::string_view token)
{
  return token.starts_with('-') || token.starts_with('+');
}

ParsedNumber<double> special(std::string_view token)
{
  const double sign = token.starts_with('-') ? -1 : 1;
  if (isSigned(token)) token.remove_prefix(1);
  while (token.ends_with('0')) token.remove_suffix(1);
  const auto* const found = std::ranges::find(kSpecials, token, &Special::word);
  if (found == kSpecials.end()) return {0, NumberFault::NotANumber};
  return {sign * found->value, NumberFault::None};
}

/// Tells whether the first digit that is not 0 stands behind the point, exponent included: of numbers that no double
/// can hold, those are too small.
bool isTooSmall(std::string_view token)
{
  const std::size_t end = std::min(token.find_first_of("eE"), token.size());
  const std::size_t point = std::min(token.find('.'), end);
  const std::size_t first = token.find_first_of("123456789");
  const auto places = static_cast<Index>(point) - static_cast<Index>(first);
  const bool isExponentNegative = end + 1 < token.size() && token[end + 1] == '-';
  if (end == token.size()) return places <= 0;
  const auto [exponent, fault] = parseNumber<Index>(token.substr(end + 1));
  return fault == NumberFault::OutOfRange ? isExponentNegative : exponent + places <= 0;
}

}  // namespace

bool hasSpecialAt(std::string_view text, std::size_t hash)
{
  constexpr std::size_t kBefore = 2;  // "1."
  if (hash < kBefore) return false;
  const std::string_view from = text.substr(hash - kBefore);
  return std::ranges::any_of(kSpecials, [&](const Special& special) { return from.starts_with(special.word); });
}

ParsedNumber<double> parseLooseNumber(std::string_view token)
{
  const ParsedNumber<double> parsed = parseNumber<double>(token);
  if (parsed.fault == NumberFault::None) return parsed;
  if (parsed.fault == NumberFault::OutOfRange)
    return isTooSmall(token) ? ParsedNumber<double>{token.starts_with('-') ? -0.0 : 0.0} : parsed;
  if (token.find('#') != std::string_view::npos) return special(token);
  const std::size_t exponent = token.find_first_of("dD");
  if (exponent == std::string_view::npos) return parsed;
  std::string usual(token);
  usual[exponent] = 'e';
  return usual.find_first_of("dD") == std::string::npos ? parseLooseNumber(usual) : parsed;
}

}  // namespace holdfast

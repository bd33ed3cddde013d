#include "holdfast/io/text/number_text.h"

#include <system_error>

namespace holdfast {
namespace {

template <class Number>
ParsedNumber<Number> parse(std::string_view token)
{
  // std::from_chars knows no '+'; "+-1" must not slip through.
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  ParsedNumber<Number> parsed;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, parsed.value);
  if (stop != end || token.empty() || error == std::errc::invalid_argument)
    parsed.fault = NumberFault::NotANumber;
  else if (error != std::errc{})
    parsed.fault = NumberFault::OutOfRange;
  return parsed;
}

}  // namespace

ParsedNumber<double> parseDouble(std::string_view token)
{
  return parse<double>(token);
}

ParsedNumber<Index> parseInteger(std::string_view token)
{
  return parse<Index>(token);
}

}  // namespace holdfast

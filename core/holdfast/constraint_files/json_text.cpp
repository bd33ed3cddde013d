#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include <holdfast/constraint_files/json_text_internal.h>

namespace holdfast {

std::string textJson(std::string_view text)
{
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      json += {'\\', c};
    else if (c >= 0 && c < ' ')
      json += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      json += c;
  }
  return json + '"';
}

std::string numberJson(double value)
{
  // JSON cannot say "not finite"; null is refused when the text is read again, with its path.
  if (!std::isfinite(value)) return "null";
  // An integer zero has no sign.
  if (value == 0 && std::signbit(value)) return "-0.0";
  std::array<char, 32> digits{};
  const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end.ptr};
}

std::string numberJson(Index value)
{
  return std::to_string(value);
}

std::string vectorJson(const Vector3& v)
{
  return fmt::format("[{}, {}, {}]", numberJson(v.x()), numberJson(v.y()), numberJson(v.z()));
}

}  // namespace holdfast

#include <cmath>

#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

std::string quoted(const std::string& text)
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
  if (!std::isfinite(value)) return "null";
  // An integer zero has no sign.
  if (value == 0 && std::signbit(value)) return "-0.0";
  return std::string(NumberText(value).view());
}

}  // namespace

std::string jsonText(const JsonValue& json)
{
  if (json.is_string()) return quoted(json.get_ref<const std::string&>());
  if (json.is_number_float()) return numberJson(json.get<double>());
  if (!json.is_structured()) return json.dump();
  std::string members;
  for (auto member = json.begin(); member != json.end(); ++member) {
    if (!members.empty()) members += ", ";
    if (json.is_object()) members += quoted(member.key()) + ": ";
    members += jsonText(*member);
  }
  return json.is_object() ? '{' + members + '}' : '[' + members + ']';
}

}  // namespace holdfast

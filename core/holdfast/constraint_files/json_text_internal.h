#pragma once
/// JSON as text that reads back as the same values.

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace holdfast {

/// The text of `json` in one line: [1, 2], {"key": "text"}. Doubles have their shortest exact form, -0.0 included; what
/// is not finite becomes null, which JSON readers refuse with its path. Strings are UTF-8.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace holdfast

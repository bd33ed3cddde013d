#pragma once
/// The part of a JSON document that states constraints: all of a constraint file, or some of a session.

#include <array>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include <holdfast/constraint_files/json_reader_internal.h>
#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// Keys that only sessions have. A session is a constraint file as well, whose readers skip them.
inline constexpr std::array<std::string_view, 4> kSessionKeys{"mesh", "options", "view", "original"};

/// The constraints of a document whose format, version and keys are those of a constraint file or a session. Throws
/// `InputError`.
[[nodiscard]] ConstraintList readConstraintDocument(const JsonReader& document);

/// What an object states: {"vertices": [...]}, {"edge": [1, 2], "t": 0.5}, a whole handle. Throws `InputError`.
[[nodiscard]] Selection readSelection(const JsonReader& json);
[[nodiscard]] SurfaceLocation readLocation(const JsonReader& json);
[[nodiscard]] HandleConstraint readHandle(const JsonReader& json);

/// The members of a constraint file, in lines of their own, without the braces around them.
[[nodiscard]] std::string constraintMembersJson(const ConstraintList& list);

/// The text of `json` in one line: [1, 2], {"key": "text"}. Doubles have their shortest exact form, -0.0 included; what
/// is not finite becomes null, which JSON readers refuse with its path. Strings are UTF-8.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace holdfast

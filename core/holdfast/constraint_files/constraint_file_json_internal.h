#pragma once
/// The part of a JSON document that states constraints: all of a constraint file, or some of a session.

#include <array>
#include <string>
#include <string_view>

#include <holdfast/constraint_files/json_reader_internal.h>
#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// Keys that only sessions have. A session is a constraint file as well, whose readers skip them.
inline constexpr std::array<std::string_view, 4> kSessionKeys{"mesh", "options", "view", "original"};

/// The constraints of a document whose format, version and keys are those of a constraint file or a session. Throws
/// `InputError`.
[[nodiscard]] ConstraintList readConstraintDocument(const JsonReader& document);

/// The members of a constraint file, in lines of their own, without the braces around them.
[[nodiscard]] std::string constraintMembersJson(const ConstraintList& list);

}  // namespace holdfast

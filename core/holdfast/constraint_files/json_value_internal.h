#pragma once
/// \file
/// A JSON text as a tree that forgets nothing: 64-bit integers apart from doubles, keys in file order, repeated keys.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace holdfast {

struct JsonValue;
struct JsonMember;

using JsonArray = std::vector<JsonValue>;
using JsonObject = std::vector<JsonMember>;

/// Integers that fit are `std::int64_t` when negative and `std::uint64_t` otherwise; every other number is a double.
struct JsonValue {
  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, JsonArray, JsonObject> what;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

/// Lists and objects inside one another at most: more than a constraint file can need, and little enough to recurse.
inline constexpr std::size_t kMaximumJsonDepth = 300;

/// The tree of a JSON text. Throws `InputError` in `file`: with line and column where the text is not JSON, not UTF-8,
/// or holds a number too large for a double; with the path of a number too small for one and of what is nested deeper
/// than `kMaximumJsonDepth`.
/// O(size of the text) in time and memory.
[[nodiscard]] JsonValue parseJson(std::string_view text, std::string_view file);

/// "a number", "a list", ...: what a message calls the value.
[[nodiscard]] std::string_view kindOf(const JsonValue& value);

/// The path as messages show it: "top level" where it is empty.
[[nodiscard]] std::string namedPath(const std::string& path);

/// Path of the member `key` of the object at `path`: `path.key`, or `path["key"]` where the key is not a plain word.
[[nodiscard]] std::string memberPath(const std::string& path, std::string_view key);

/// Path of an element of the list at `path`: `path[2]`.
[[nodiscard]] std::string elementPath(const std::string& path, std::size_t place);

}  // namespace holdfast

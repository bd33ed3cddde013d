#pragma once
/// A typed view of a JSON value that knows its path and refuses, with that path, whatever is not as it should be.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <holdfast/base/types.h>

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

/// The tree of a JSON text. Throws `InputError` for what is not JSON, not UTF-8, nested deeper than
/// `kMaximumJsonDepth`, or holds a number that is no double. O(size of the text) in time and memory.
[[nodiscard]] JsonValue parseJson(std::string_view text, std::string_view file);

/// "a number", "a list", ...: what a message calls the value.
[[nodiscard]] std::string_view kindOf(const JsonValue& value);

/// The path as messages show it: "top level" where it is empty.
[[nodiscard]] std::string namedPath(const std::string& path);

/// Path of the member `key` of the object at `path`: `path.key`, or `path["key"]` where the key is not a plain word.
[[nodiscard]] std::string memberPath(const std::string& path, std::string_view key);

/// Path of an element of the list at `path`: `path[2]`.
[[nodiscard]] std::string elementPath(const std::string& path, std::size_t place);

/// A value in a JSON text. Every member function throws `InputError` with file and path where the value is not what it
/// asks for. Refers to the tree and to the file's name, which must outlive it.
class JsonReader {
 public:
  JsonReader(const JsonValue& root, std::string_view file) : JsonReader(root, file, std::string()) {}

  /// This is an object whose keys are all among `known` and do not repeat.
  void requireKeys(std::span<const std::string_view> known) const;
  void requireKeys(std::initializer_list<std::string_view> known) const { requireKeys(std::span(known)); }

  [[nodiscard]] bool has(std::string_view key) const;

  /// The one of `choices` that this object has; both none and several are refused.
  [[nodiscard]] std::string_view oneKeyOf(std::span<const std::string_view> choices) const;

  /// The value of a key, which must be there.
  [[nodiscard]] JsonReader operator[](std::string_view key) const;

  [[nodiscard]] std::size_t size() const { return array().size(); }
  /// The length of a list that is not empty.
  [[nodiscard]] std::size_t sizeAboveZero() const;
  /// This is a list of `count`, which `meaning` names: "[x, y, z]".
  void requireSize(std::size_t count, std::string_view meaning) const;
  [[nodiscard]] JsonReader element(std::size_t place) const;

  [[nodiscard]] bool boolean() const { return as<bool>("true or false"); }
  [[nodiscard]] double number() const;
  /// An integer, written without point and exponent, that fits into 64 bits.
  [[nodiscard]] Index integer() const;
  /// An integer from 0.
  [[nodiscard]] Index id() const;
  [[nodiscard]] const std::string& text() const { return as<std::string>("text in double quotes"); }
  [[nodiscard]] Vector3 vector() const;
  /// [x, y, z], not all zero.
  [[nodiscard]] Vector3 direction() const;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }

  /// Throws `InputError` with this value's file and path.
  [[noreturn]] void fail(const std::string& reason) const;
  template <class Arg, class... Args>
  [[noreturn]] void fail(fmt::format_string<Arg, Args...> reason, Arg&& arg, Args&&... args) const
  {
    fail(fmt::format(reason, std::forward<Arg>(arg), std::forward<Args>(args)...));
  }
  /// The same with this value's path followed by `key`: ".vertices[3]".
  [[noreturn]] void failBelow(const std::string& key, const std::string& reason) const;

 private:
  JsonReader(const JsonValue& value, std::string_view file, std::string path)
      : value_(&value), file_(file), path_(std::move(path))
  {
  }

  template <class Kind>
  [[nodiscard]] const Kind& as(std::string_view expected) const
  {
    if (const auto* value = std::get_if<Kind>(&value_->what)) return *value;
    failKind(expected);
  }
  [[nodiscard]] const JsonObject& object() const { return as<JsonObject>("an object in braces"); }
  [[nodiscard]] const JsonArray& array() const { return as<JsonArray>("a list"); }
  [[noreturn]] void failKind(std::string_view expected) const;

  const JsonValue* value_;
  std::string_view file_;
  std::string path_;
};

}  // namespace holdfast

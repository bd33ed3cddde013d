#pragma once
/// Readers and writers of constraint files and sessions share these. They are texts, JSON values that know their path,
/// and the part of a document that states constraints.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <holdfast/constraints/constraint.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {

/// Returns `text` without a byte order mark. Throws `InputError` with the line of the first byte that is not UTF-8.
[[nodiscard]] std::string_view requireUtf8(std::string_view text, std::string_view file);

[[nodiscard]] std::string listInQuotes(std::span<const std::string_view> words);

/// Returns the end of a message about an unknown word: `; did you mean "center"? Known here: "axis", "center"`.
[[nodiscard]] std::string spellingHint(std::string_view word, std::span<const std::string_view> known);

/// Numbers are integers where they are written so and fit, else doubles. Negative integers are `std::int64_t`, others
/// `std::uint64_t`. An object holds its members in the order of the text, and as often as they stand there.
using JsonValue = nlohmann::ordered_json;

/// Returns the tree of a JSON text. Throws `InputError` for a text that is not JSON, is not UTF-8, or holds a number
/// that is no double. Throws it too for one that is nested deeper than a constraint file can need. O(size of the text)
/// in time and memory.
[[nodiscard]] JsonValue parseJson(std::string_view text, std::string_view file);

/// A reader reads a value in a JSON text. Every member function throws `InputError` with file and path where the value
/// is not what it asks for. The reader refers to the tree and to the file's name, which must outlive it.
class JsonReader {
 public:
  /// `path` is the place of `value` in the text.
  JsonReader(const JsonValue& value, std::string_view file, std::string path = {})
      : value_(&value), file_(file), path_(std::move(path))
  {
  }

  /// Throws unless this is an object whose keys are all among `known` and do not repeat.
  void requireKeys(std::span<const std::string_view> known) const;
  void requireKeys(std::initializer_list<std::string_view> known) const { requireKeys(std::span(known)); }

  [[nodiscard]] bool has(std::string_view key) const;
  /// Returns the keys of this object. They may be any, and must not repeat.
  [[nodiscard]] std::vector<std::string_view> keys() const;

  /// Returns the one of `choices` that this object has. Both none and several are refused.
  [[nodiscard]] std::string_view oneKeyOf(std::span<const std::string_view> choices) const;

  /// Returns the value of a key, which must be there.
  [[nodiscard]] JsonReader operator[](std::string_view key) const;

  [[nodiscard]] std::size_t size() const { return array().size(); }
  /// Throws unless this is a list of `count`, which `meaning` names: "[x, y, z]".
  void requireSize(std::size_t count, std::string_view meaning) const;
  [[nodiscard]] JsonReader element(std::size_t place) const;
  /// Returns the elements of a list, each as `read(element)` returns it.
  template <class Read>
  [[nodiscard]] auto list(Read&& read) const
  {
    std::vector<std::decay_t<std::invoke_result_t<Read, JsonReader>>> values;
    values.reserve(size());
    for (std::size_t k = 0; k < size(); ++k) values.push_back(std::invoke(read, element(k)));
    return values;
  }
  /// Does the same for a list that must not be empty.
  template <class Read>
  [[nodiscard]] auto listAboveZero(Read&& read) const
  {
    if (size() == 0) fail("the list is empty; give at least one element");
    return list(read);
  }

  [[nodiscard]] bool isText() const noexcept { return value_->is_string(); }
  [[nodiscard]] bool isList() const noexcept { return value_->is_array(); }
  [[nodiscard]] bool isNull() const noexcept { return value_->is_null(); }
  [[nodiscard]] bool boolean() const { return as<bool>("true or false"); }
  [[nodiscard]] double number() const;
  /// Returns an integer that fits into 64 bits. It must be written without point and exponent.
  [[nodiscard]] Index integer() const;
  /// Returns an integer that is 0 or more.
  [[nodiscard]] Index id() const;
  [[nodiscard]] const std::string& text() const { return as<std::string>("text in double quotes"); }
  /// Returns the place of this text in `names`. Where it has none, `unknown` says so in the error: "unknown side {}".
  [[nodiscard]] std::size_t choice(std::span<const std::string_view> names, fmt::string_view unknown) const;
  [[nodiscard]] Vector3 vector() const;
  /// Returns [x, y, z], in which each may be null. Not all may.
  [[nodiscard]] std::array<std::optional<double>, 3> coordinates() const;
  /// Returns [x, y, z], which must not be all zero.
  [[nodiscard]] Vector3 direction() const;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> reason, Args&&... args) const
  {
    failBelow("", fmt::format(reason, std::forward<Args>(args)...));
  }
  /// Fails in the same way, with this value's path followed by `key`: ".vertices[3]".
  [[noreturn]] void failBelow(const std::string& key, const std::string& reason) const;

 private:
  template <class Kind>
  [[nodiscard]] const Kind& as(std::string_view expected) const
  {
    if (const auto* value = value_->get_ptr<const Kind*>()) return *value;
    failKind(expected);
  }
  [[nodiscard]] const JsonValue::object_t& object() const { return as<JsonValue::object_t>("an object in braces"); }
  [[nodiscard]] const JsonValue::array_t& array() const { return as<JsonValue::array_t>("a list"); }
  [[noreturn]] void failKind(std::string_view expected) const;

  const JsonValue* value_;
  std::string_view file_;
  std::string path_;
};

/// Only sessions have these keys. A session is a constraint file as well, and readers of constraint files skip them.
inline constexpr std::array<std::string_view, 6> kSessionKeys{"mesh",         "options", "selections",
                                                              "measurements", "view",    "original"};

/// Returns the constraints of a document that is a constraint file or a session. Throws `InputError`.
[[nodiscard]] ConstraintList readConstraintDocument(const JsonReader& document);

/// These read and write a point of the surface, and a set of vertices, as constraints name them. The readers throw
/// `InputError`.
[[nodiscard]] SurfaceLocation readLocation(const JsonReader& json);
[[nodiscard]] Selection readSelection(const JsonReader& json);
void to_json(JsonValue& json, const SurfaceLocation& location);
void to_json(JsonValue& json, const Selection& selection);

/// Reads the constraint at `place` of a list, counted from 1. Throws `InputError`.
[[nodiscard]] Constraint readConstraint(const JsonReader& json, std::size_t place);
/// Returns the constraint as it stands in a file, in one line.
[[nodiscard]] std::string constraintJson(const Constraint& constraint);

/// Returns the members of a constraint file, in lines of their own, without the braces around them.
[[nodiscard]] std::string constraintMembersJson(const ConstraintList& list);

/// Throws `OutputError` for `what` if `read` throws `InputError`. `read` reads what is to be written.
template <class Read>
void requireReadable(const char* what, const Read& read)
{
  try {
    static_cast<void>(read());
  } catch (const InputError& error) {
    throw OutputError(what, std::string("it cannot be written so that it can be read; ") + error.what());
  }
}

/// Returns the text of `json` in one line: [1, 2], {"key": "text"}. Doubles have their shortest exact form, -0.0
/// included. What is not finite becomes null, which JSON readers refuse with its path. Strings are UTF-8.
[[nodiscard]] std::string jsonText(const JsonValue& json);

}  // namespace holdfast

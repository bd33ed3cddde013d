#pragma once
/// What readers and writers of constraint files and sessions share: texts, JSON values that know their path, and the
/// part of a document that states constraints.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <holdfast/base/error.h>
#include <holdfast/base/printable.h>
#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// `text` without a byte order mark. Throws `InputError` with the line of the first byte that is not UTF-8.
[[nodiscard]] std::string_view requireUtf8(std::string_view text, std::string_view file);

[[nodiscard]] std::string listInQuotes(std::span<const std::string_view> words);

/// `; did you mean "center"? Known here: "axis", "center"`, the end of a message about an unknown word.
[[nodiscard]] std::string spellingHint(std::string_view word, std::span<const std::string_view> known);

/// Numbers are integers where they are written so and fit, negative ones `std::int64_t`, others `std::uint64_t`; else
/// doubles. An object holds its members in the order of the text, and as often as they stand there.
using JsonValue = nlohmann::ordered_json;

/// The tree of a JSON text. Throws `InputError` for what is not JSON, not UTF-8, nested deeper than a constraint file
/// can need, or holds a number that is no double. O(size of the text) in time and memory.
[[nodiscard]] JsonValue parseJson(std::string_view text, std::string_view file);

/// A value in a JSON text. Every member function throws `InputError` with file and path where the value is not what it
/// asks for. Refers to the tree and to the file's name, which must outlive it.
class JsonReader {
 public:
  /// `path` is the place of `value` in the text.
  JsonReader(const JsonValue& value, std::string_view file, std::string path = {})
      : value_(&value), file_(file), path_(std::move(path))
  {
  }

  /// This is an object whose keys are all among `known` and do not repeat.
  void requireKeys(std::span<const std::string_view> known) const;
  void requireKeys(std::initializer_list<std::string_view> known) const { requireKeys(std::span(known)); }

  [[nodiscard]] bool has(std::string_view key) const;
  /// The keys of this object, which do not repeat and may be any.
  [[nodiscard]] std::vector<std::string_view> keys() const;

  /// The one of `choices` that this object has; both none and several are refused.
  [[nodiscard]] std::string_view oneKeyOf(std::span<const std::string_view> choices) const;

  /// The value of a key, which must be there.
  [[nodiscard]] JsonReader operator[](std::string_view key) const;

  [[nodiscard]] std::size_t size() const { return array().size(); }
  /// This is a list of `count`, which `meaning` names: "[x, y, z]".
  void requireSize(std::size_t count, std::string_view meaning) const;
  [[nodiscard]] JsonReader element(std::size_t place) const;
  /// The elements of a list, each as `read(element)` has it.
  template <class Read>
  [[nodiscard]] auto list(Read&& read) const
  {
    std::vector<std::decay_t<std::invoke_result_t<Read, JsonReader>>> values;
    values.reserve(size());
    for (std::size_t k = 0; k < size(); ++k) values.push_back(std::invoke(read, element(k)));
    return values;
  }
  /// The same of a list that must not be empty.
  template <class Read>
  [[nodiscard]] auto listAboveZero(Read&& read) const
  {
    if (size() == 0) fail("the list is empty; give at least one element");
    return list(read);
  }

  [[nodiscard]] bool boolean() const { return as<bool>("true or false"); }
  [[nodiscard]] double number() const;
  /// An integer, written without point and exponent, that fits into 64 bits.
  [[nodiscard]] Index integer() const;
  /// An integer from 0.
  [[nodiscard]] Index id() const;
  [[nodiscard]] const std::string& text() const { return as<std::string>("text in double quotes"); }
  /// The place of this text in `names`; where it has none, `unknown` says so: "unknown side {}".
  [[nodiscard]] std::size_t choice(std::span<const std::string_view> names, fmt::string_view unknown) const;
  [[nodiscard]] Vector3 vector() const;
  /// [x, y, z], not all zero.
  [[nodiscard]] Vector3 direction() const;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> reason, Args&&... args) const
  {
    failBelow("", fmt::format(reason, std::forward<Args>(args)...));
  }
  /// The same with this value's path followed by `key`: ".vertices[3]".
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

/// Keys that only sessions have. A session is a constraint file as well, whose readers skip them.
inline constexpr std::array<std::string_view, 6> kSessionKeys{"mesh",         "options", "selections",
                                                              "measurements", "view",    "original"};

/// The constraints of a document that is a constraint file or a session. Throws `InputError`.
[[nodiscard]] ConstraintList readConstraintDocument(const JsonReader& document);

/// A point of the surface, and a set of vertices, as constraints name them. They throw `InputError`.
[[nodiscard]] SurfaceLocation readLocation(const JsonReader& json);
[[nodiscard]] Selection readSelection(const JsonReader& json);
[[nodiscard]] JsonValue locationJson(const SurfaceLocation& location);
[[nodiscard]] JsonValue selectionJson(const Selection& selection);

/// The members of a constraint file, in lines of their own, without the braces around them.
[[nodiscard]] std::string constraintMembersJson(const ConstraintList& list);

/// Throws `OutputError` for `what` if `read`, which reads what is to be written, throws `InputError`.
template <class Read>
void requireReadable(const char* what, const Read& read)
{
  try {
    static_cast<void>(read());
  } catch (const InputError& error) {
    throw OutputError(what, std::string("it cannot be written so that it can be read; ") + error.what());
  }
}

/// The text of `json` in one line: [1, 2], {"key": "text"}. Doubles have their shortest exact form, -0.0 included; what
/// is not finite becomes null, which JSON readers refuse with its path. Strings are UTF-8.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace holdfast

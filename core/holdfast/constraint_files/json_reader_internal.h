#pragma once
/// \file
/// A typed view of a JSON value that knows its path and refuses, with that path, whatever is not as it should be.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/base/types.h>
#include <holdfast/constraint_files/json_value_internal.h>

namespace holdfast {

/// A value in a JSON text. Every member function throws `InputError` with file and path where the value is not what it
/// asks for. Refers to the tree and to the file's name, which must outlive it.
class JsonReader {
 public:
  JsonReader(const JsonValue& root, std::string_view file) : JsonReader(root, file, std::string()) {}

  /// This is an object whose keys are all among `known` and do not repeat. O(k log k) for k keys.
  void requireKeys(std::span<const std::string_view> known) const;

  /// This object has the key.
  [[nodiscard]] bool has(std::string_view key) const;

  /// The one of `choices` that this object has; both none and several are refused.
  [[nodiscard]] std::string_view oneKeyOf(std::span<const std::string_view> choices) const;

  /// The value of a key, which must be there.
  [[nodiscard]] JsonReader operator[](std::string_view key) const;

  /// The length of a list.
  [[nodiscard]] std::size_t size() const;
  /// The length of a list that is not empty.
  [[nodiscard]] std::size_t sizeAboveZero() const;
  /// This is a list of `count`, which `meaning` names: "[x, y, z]".
  void requireSize(std::size_t count, std::string_view meaning) const;
  /// The element at `place` of a list, from 0, below its length.
  [[nodiscard]] JsonReader element(std::size_t place) const;

  [[nodiscard]] bool boolean() const;
  [[nodiscard]] double number() const;
  /// An integer, written without point and exponent, that fits into 64 bits.
  [[nodiscard]] Index integer() const;
  /// An integer from 0.
  [[nodiscard]] Index id() const;
  [[nodiscard]] const std::string& text() const;
  /// [x, y, z].
  [[nodiscard]] Vector3 vector() const;
  /// [x, y, z], not all zero: a direction.
  [[nodiscard]] Vector3 direction() const;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }

  /// Throws `InputError` with this value's file and path.
  [[noreturn]] void fail(const std::string& reason) const;
  /// The same with this value's path followed by `key`: ".vertices[3]".
  [[noreturn]] void failBelow(const std::string& key, const std::string& reason) const;

 private:
  JsonReader(const JsonValue& value, std::string_view file, std::string path)
      : value_(&value), file_(file), path_(std::move(path))
  {
  }

  [[nodiscard]] const JsonObject& object() const;
  [[nodiscard]] const JsonArray& array() const;
  [[noreturn]] void failKind(std::string_view expected) const;

  const JsonValue* value_;
  std::string_view file_;
  std::string path_;
};

}  // namespace holdfast

#pragma once
/// \file
/// Small XML texts as trees.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace holdfast {

/// An element with all that is in it. References to entities are resolved.
struct XmlElement {
  std::string name;
  std::size_t place = 0;  ///< byte of the text where it begins
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text;  ///< between its tags, without that of its children
  std::vector<XmlElement> children;

  /// The value of an attribute, or nothing where there is none of that name.
  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view wanted) const;
  /// The first child of that name, or null.
  [[nodiscard]] const XmlElement* child(std::string_view wanted) const;
};

/// The root of `text`. Throws `InputError` about `file` where it is no XML, and where elements are nested more than 32
/// deep. O(text).
[[nodiscard]] XmlElement parseXml(const std::string& text, const std::string& file);

}  // namespace holdfast

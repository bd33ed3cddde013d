#pragma once
/// An XML file is a tree of elements. Each of them knows the bytes of the file at which it stands, so that parts of it
/// can be replaced.

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/io/formats/text_edit.h>

namespace holdfast {

/// A run of text stands between tags. Comments and references divide it.
struct XmlText {
  std::size_t place = 0;  ///< the byte of the file at which it begins
  std::size_t size = 0;   ///< how many bytes of the file it takes
  std::string resolved;   ///< what a reference stands for; empty where the bytes are the text

  [[nodiscard]] std::string_view in(std::string_view bytes) const
  {
    return resolved.empty() ? bytes.substr(place, size) : resolved;
  }
};

/// An element holds all that is in it. References are resolved.
struct XmlElement {
  std::string name;
  std::size_t place = 0;                                       ///< the byte of the file at which its first tag begins
  std::size_t tagSize = 0;                                     ///< how many bytes this tag takes
  std::map<std::string, std::string, std::less<>> attributes;  ///< those that the tag states
  std::vector<XmlText> texts;                                  ///< the text that is not in a child
  std::vector<XmlElement> children;

  /// Returns the value of the attribute of that name. There is none where the element lacks it.
  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view wanted) const;
  /// Returns the first child of that name, or null.
  [[nodiscard]] const XmlElement* child(std::string_view wanted) const;
  /// Returns its text in the file `bytes`, without that of its children.
  [[nodiscard]] std::string text(std::string_view bytes) const;
};

/// Parses `bytes` and returns the root. Where the root has a child called `last`, nothing behind the first tag of this
/// child is read, and it need not be XML. Throws `InputError` about `file`, with the line, for bytes that are no XML.
/// It does the same where elements are nested more than 32 deep, and where entities make the text longer than the file.
/// The tree takes no text of the file a second time. O(bytes).
[[nodiscard]] XmlElement parseXml(std::string_view bytes, const std::string& file, std::string_view last);

/// Returns the edit of the file `bytes` that gives an attribute, which the tag states, another value. The value has no
/// letters that XML would have to write as references.
[[nodiscard]] TextEdit attributeEdit(const XmlElement& element, std::string_view bytes, std::string_view name,
                                     std::string value);

/// Returns `text` with the letters that mean something to XML as references.
[[nodiscard]] std::string toXml(std::string_view text);

}  // namespace holdfast

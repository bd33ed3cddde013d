#pragma once
/// \file
/// The tags of an XML text one after another, without building a tree.

#include <optional>
#include <string_view>

#include <holdfast/base/types.h>

namespace holdfast {

/// One start tag of an XML text, `<name attribute="value" ...>`. Views into the text.
struct XmlTag {
  std::string_view name;
  std::string_view attributes;
  std::size_t end = 0;  ///< the place in the text that follows the tag

  /// The value of an attribute as it is written, or nothing where the tag has none of that name.
  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view name) const;
};

/// The first start tag of `text` at or after `from`; end tags, comments and declarations are passed over.
[[nodiscard]] std::optional<XmlTag> nextTag(std::string_view text, std::size_t from);

}  // namespace holdfast

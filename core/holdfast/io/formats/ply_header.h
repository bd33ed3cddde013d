#pragma once
/// The header of a PLY file says what elements follow, and what each of them is made of.

#include <string_view>

#include <holdfast/io/formats/formats.h>

namespace holdfast {

struct PlyProperty {
  std::string name;
  NumberType type = NumberType::Float;  ///< of a list: of its items
  std::optional<NumberType> countType;  ///< set for a list
  std::size_t typeOffset = 0;           ///< where the header names `type`

  [[nodiscard]] bool isList() const noexcept { return countType.has_value(); }
};

struct PlyElement {
  std::string name;
  Index count = 0;
  Index line = 0;  ///< in the header
  std::vector<PlyProperty> properties;

  /// Returns the place of a property, or -1 where there is none.
  [[nodiscard]] Index find(std::string_view wanted) const;
  /// Tells whether the rows are strips of triangles. Stanford's scans have such rows.
  [[nodiscard]] bool hasStrips() const { return name == "tristrips"; }
};

struct PlyHeader {
  std::optional<std::endian> byteOrder;  ///< none in a text
  std::vector<PlyElement> elements;
  std::size_t bodyOffset = 0;
  Index bodyLine = 1;

  [[nodiscard]] const PlyElement* find(std::string_view wanted) const;
  /// Returns `tristrips` where there is no `face` or none of its rows, else `face`. Returns null where there is
  /// neither.
  [[nodiscard]] const PlyElement* surface() const;
};

/// Reads the first word of a PLY file. Throws `InputError` where it is another word.
void requirePlyMagic(TextCursor cursor);

/// Reads the header at the beginning of `bytes`. `file` names the file in errors. Counts are as the file claims, and
/// not negative. Throws `InputError` with the line.
[[nodiscard]] PlyHeader parsePlyHeader(std::string_view bytes, const std::string& file);

}  // namespace holdfast

#pragma once
/// The header of a PLY file: what elements follow, and what each of them is made of.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/io/formats/splice_source.h>

namespace holdfast {

struct PlyProperty {
  std::string name;
  NumberType type = NumberType::kFloat;  ///< of a list: of its items
  std::optional<NumberType> countType;   ///< set for a list
  std::size_t typeOffset = 0;            ///< where the header names `type`

  [[nodiscard]] bool isList() const noexcept { return countType.has_value(); }
};

struct PlyElement {
  std::string name;
  Index count = 0;
  Index line = 0;  ///< in the header
  std::vector<PlyProperty> properties;

  /// Place of the property called `wanted`; -1 where there is none.
  [[nodiscard]] Index find(std::string_view wanted) const;
  /// Whether the rows are strips of triangles, as Stanford's scans have them.
  [[nodiscard]] bool hasStrips() const { return name == "tristrips"; }
};

struct PlyHeader {
  Encoding encoding = Encoding::kText;
  std::vector<PlyElement> elements;
  std::size_t bodyOffset = 0;
  Index bodyLine = 1;

  /// The element called `wanted`, or null.
  [[nodiscard]] const PlyElement* find(std::string_view wanted) const;
  /// The element whose rows are the surface: `tristrips` where there is no `face` or none of its rows, else `face`.
  /// Null where there is neither.
  [[nodiscard]] const PlyElement* surface() const;
};

/// Reads the header at the beginning of `bytes`; `file` names it in errors. Throws `InputError` with the line. Counts
/// are not negative, and otherwise as the file claims.
[[nodiscard]] PlyHeader parsePlyHeader(std::string_view bytes, const std::string& file);

}  // namespace holdfast

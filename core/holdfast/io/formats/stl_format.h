#pragma once
/// \file
/// The layout of binary STL: 80 bytes of header, a count, and 50 bytes a facet; numbers little-endian.

#include <cstdint>
#include <string>
#include <string_view>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

inline constexpr std::size_t kStlHeaderBytes = 80;   ///< then the count of facets, 32 bits unsigned
inline constexpr std::size_t kStlFacetsOffset = 84;  ///< first facet
inline constexpr std::size_t kStlFacetBytes = 50;    ///< normal, three corners, 16 bits of attributes
inline constexpr std::size_t kStlVectorBytes = 12;   ///< three floats
inline constexpr std::size_t kStlAttributesOffset = 4 * kStlVectorBytes;  ///< in a facet

/// Three floats at `offset` of `bytes`.
[[nodiscard]] Vector3 stlVector(std::string_view bytes, std::size_t offset);

/// The twelve bytes of `vector`, rounded to single precision.
[[nodiscard]] std::string stlBytes(const Vector3& vector);

/// How much single precision loses.
struct StlRounding {
  Index count = 0;     ///< coordinates that a float cannot hold
  double largest = 0;  ///< largest |x - float(x)|, in model units

  /// A note for the user; empty where nothing is lost.
  [[nodiscard]] std::string note() const;
};

/// What rounding all of `positions` loses. Throws `OutputError` where a coordinate is too large for a float.
[[nodiscard]] StlRounding stlRounding(const Positions& positions);

}  // namespace holdfast

#pragma once
/// Lower triangles, or their first columns, are stored in strips. A strip is so many columns. It is stored column by
/// column as a matrix from the row of the first of them down. Strips are half as large as a square, and dense kernels
/// take them as they are.

#include <cstdint>

namespace holdfast {

/// This width is fixed: which sums are formed must not depend on the number of threads.
inline constexpr int kStripWidth = 192;

/// Returns the first column of the strip that a column is in. It is also the strip's first row.
inline int stripOf(int column)
{
  return column / kStripWidth * kStripWidth;
}

/// Returns where the number of a row and a column lies in a triangle of `size` rows. In a strip, columns are `size`
/// less its first row apart.
inline std::int64_t placeInStrips(std::int64_t row, int column, std::int64_t size)
{
  const std::int64_t first = stripOf(column);
  return first * size - first * (first - kStripWidth) / 2 + (column - first) * (size - first) + row - first;
}

/// Returns how many numbers the first `columns` columns of such a triangle take.
inline std::int64_t numbersInStrips(int columns, std::int64_t size)
{
  return placeInStrips(stripOf(columns), columns, size);
}

}  // namespace holdfast

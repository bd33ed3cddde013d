#include "holdfast/io/formats/stl_format.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/io/text/byte_order.h>

namespace holdfast {

Vector3 stlVector(std::string_view bytes, std::size_t offset)
{
  Vector3 vector;
  for (Index k = 0; k < 3; ++k)
    vector[k] = static_cast<double>(fromBytes<float>(bytes.substr(offset + 4 * k, 4), ByteOrder::kLittle));
  return vector;
}

std::string stlBytes(const Vector3& vector)
{
  std::string bytes;
  for (const double value : vector) bytes += toBytes(static_cast<float>(value), ByteOrder::kLittle).view();
  return bytes;
}

std::string StlRounding::note() const
{
  if (count == 0) return {};
  return fmt::format(
      "STL stores single precision: {} coordinate{} rounded, off by at most {:.3g}; write PLY, OBJ or OFF "
      "to keep every digit",
      count, count == 1 ? "" : "s", largest);
}

StlRounding stlRounding(const Positions& positions)
{
  constexpr double kLargestFloat = std::numeric_limits<float>::max();
  StlRounding rounding;
  for (const double x : positions.reshaped()) {
    if (!std::isfinite(x)) continue;
    if (std::abs(x) > kLargestFloat)
      throw OutputError(".stl", fmt::format("the coordinate {} is too large for single precision, which is all that "
                                            "binary STL holds: write PLY, OBJ or OFF instead",
                                            x));
    const double error = std::abs(x - static_cast<double>(static_cast<float>(x)));
    if (error > 0) ++rounding.count;
    rounding.largest = std::max(rounding.largest, error);
  }
  return rounding;
}

}  // namespace holdfast

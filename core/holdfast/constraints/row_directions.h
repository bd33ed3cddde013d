#pragma once
/// The directions in which a row of B x = d holds.

#include <bitset>
#include <cmath>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// A row holds in all directions, along one direction or across one. A point that is placed is a row of the first sort,
/// one that stays in a plane of the second, and one that stays on a line of the third.
///
///     const RowDirections inPlane = RowDirections::along({0, 0, 1});
///     inPlane.held({1, 2, 3});  // (0, 0, 3): x and y are free
class RowDirections {
 public:
  /// All three.
  RowDirections() = default;

  /// Returns the direction of a plane's `normal`, of any length but 0. The row is n . B x = n . d.
  [[nodiscard]] static RowDirections along(const Vector3& normal) { return {Sort::Along, normal.stableNormalized()}; }

  /// Returns the two directions across a line with this `direction`, of any length but 0.
  [[nodiscard]] static RowDirections across(const Vector3& direction)
  {
    return {Sort::Across, direction.stableNormalized()};
  }

  [[nodiscard]] bool areAll() const noexcept { return sort_ == Sort::All; }

  /// Returns the normal or the line's direction, of length 1. The row must not hold in all directions.
  [[nodiscard]] const Vector3& axis() const noexcept { return axis_; }

  /// Tells whether the row holds along `axis()`, and not across it.
  [[nodiscard]] bool areAlongAxis() const noexcept { return sort_ == Sort::Along; }

  /// Returns the coordinates that the row holds by themselves: all, or those along or across a coordinate axis.
  [[nodiscard]] std::bitset<3> coordinates() const noexcept
  {
    if (areAll()) return 0b111;
    std::bitset<3> along;
    for (int k = 0; k < 3; ++k) along[static_cast<std::size_t>(k)] = std::abs(axis_[k]) == 1;
    return along.none() || areAlongAxis() ? along : ~along;
  }

  /// Returns the part of `v` that the row says something about.
  [[nodiscard]] Vector3 held(const Vector3& v) const
  {
    if (areAll()) return v;
    const Vector3 along = axis_.dot(v) * axis_;
    return areAlongAxis() ? along : v - along;
  }

  bool operator==(const RowDirections&) const = default;

 private:
  enum class Sort : unsigned char { All, Along, Across };
  RowDirections(Sort sort, const Vector3& axis) : axis_(axis), sort_(sort) {}

  Vector3 axis_ = Vector3::Zero();
  Sort sort_ = Sort::All;
};

}  // namespace holdfast

#pragma once
/// A polygon mesh as a file holds it: positions and faces, nothing derived.

#include <cassert>
#include <initializer_list>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// F x 3, the vertices of each triangle.
using Triangles = Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Faces of any number of corners, in file order. Face f has the vertices `polygons[f]`, in the file's order.
class Polygons {
 public:
  Polygons() = default;
  /// A triangle for each row of `triangles`, F x 3.
  explicit Polygons(const Eigen::Ref<const Triangles>& triangles)
  {
    reserve(triangles.rows(), triangles.size());
    for (Index f = 0; f < triangles.rows(); ++f) add({triangles(f, 0), triangles(f, 1), triangles(f, 2)});
  }

  [[nodiscard]] Index size() const noexcept { return static_cast<Index>(starts_.size()) - 1; }
  [[nodiscard]] bool isEmpty() const noexcept { return size() == 0; }
  /// Corners of all faces together.
  [[nodiscard]] Index cornerCount() const noexcept { return static_cast<Index>(corners_.size()); }

  [[nodiscard]] std::span<const int> operator[](Index face) const
  {
    assert(face >= 0 && face < size());
    const auto first = corners_.begin() + starts_[face];
    return {first, corners_.begin() + starts_[face + 1]};
  }

  /// Whether `face` has three corners or more.
  [[nodiscard]] bool isSurface(Index face) const { return (*this)[face].size() >= 3; }

  /// Where the corners of each face begin among `corners()`, and where those of the last one end.
  [[nodiscard]] std::span<const int> starts() const noexcept { return starts_; }
  /// Of all faces, one face after the other.
  [[nodiscard]] std::span<const int> corners() const noexcept { return corners_; }

  void reserve(Index faces, Index corners)
  {
    starts_.reserve(faces + 1);
    corners_.reserve(corners);
  }

  /// Throws `std::length_error` for an id, or a number of corners, of more than 32 bits.
  template <std::ranges::sized_range Range>
  void add(const Range& vertices)
  {
    for (const Index vertex : vertices) corners_.push_back(narrowed(vertex));
    starts_.push_back(narrowed(cornerCount()));
  }

  void add(std::initializer_list<Index> vertices) { add(std::span<const Index>(vertices.begin(), vertices.size())); }

  friend bool operator==(const Polygons&, const Polygons&) = default;

 private:
  static int narrowed(Index number)
  {
    if (number != static_cast<int>(number))
      throw std::length_error(std::to_string(number) + ": vertices and corners of a mesh are numbered in 32 bits");
    return static_cast<int>(number);
  }

  std::vector<int> starts_{0};
  std::vector<int> corners_;
};

/// Positions and faces as in the file. Every corner is a valid vertex id (readers guarantee it, `makeModel` refuses
/// others); nothing else is promised. Faces of fewer than three corners keep their number and are no surface.
struct Mesh {
  Positions positions;
  Polygons faces;

  [[nodiscard]] Index vertexCount() const noexcept { return positions.rows(); }
};

}  // namespace holdfast

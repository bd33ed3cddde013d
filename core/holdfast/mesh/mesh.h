#pragma once
/// A polygon mesh is positions and faces as a file holds them. Nothing in it is derived.

#include <cassert>
#include <initializer_list>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// F x 3: each row has the vertices of a triangle.
using Triangles = Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Faces with any number of corners, in file order. Face f has the vertices `polygons[f]`, in the file's order.
class Polygons {
 public:
  Polygons() = default;
  /// Makes a triangle of each row of `triangles`, F x 3. Throws `std::length_error` as `add` does.
  explicit Polygons(const Eigen::Ref<const Triangles>& triangles)
  {
    reserve(triangles.rows(), triangles.size());
    for (Index f = 0; f < triangles.rows(); ++f) add({triangles(f, 0), triangles(f, 1), triangles(f, 2)});
  }

  [[nodiscard]] Index size() const noexcept { return static_cast<Index>(starts_.size()) - 1; }
  [[nodiscard]] bool isEmpty() const noexcept { return size() == 0; }
  /// Returns how many corners all faces have together.
  [[nodiscard]] Index cornerCount() const noexcept { return static_cast<Index>(corners_.size()); }

  /// Returns the vertices of `face`, which is at least 0 and less than `size()`.
  [[nodiscard]] std::span<const int> operator[](Index face) const
  {
    assert(face >= 0 && face < size());
    const auto first = corners_.begin() + starts_[face];
    return {first, corners_.begin() + starts_[face + 1]};
  }

  /// Tells whether `face` has three corners or more.
  [[nodiscard]] bool isSurface(Index face) const { return (*this)[face].size() >= 3; }

  /// Returns the places in `corners()` where the corners of each face begin, and the place where those of the last end.
  [[nodiscard]] std::span<const int> starts() const noexcept { return starts_; }
  /// Returns the corners of all faces, one face after the other.
  [[nodiscard]] std::span<const int> corners() const noexcept { return corners_; }

  /// Takes memory for so many faces with so many corners in all.
  void reserve(Index faces, Index corners)
  {
    starts_.reserve(faces + 1);
    corners_.reserve(corners);
  }

  /// Adds a face with these vertices. Throws `std::length_error` for an id, or a number of corners, of more than 32
  /// bits.
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

/// Labels are the numbers that a file gives its vertices and faces, such as those of nodes and elements. Each list has
/// one for each vertex or face, or is empty. Constraints name vertices and faces by their places, not by labels.
struct Labels {
  std::vector<Index> vertices = {};
  std::vector<Index> faces = {};
};

/// Positions and faces as in the file. Every corner is a valid vertex id: readers guarantee it, and `makeModel` refuses
/// others. Nothing else is promised. Faces with fewer than three corners keep their number and are no surface.
///
///     Mesh square;
///     square.positions.resize(4, 3);
///     square.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
///     square.faces.add({0, 1, 2, 3});
///     const Model model = makeModel(square, "square");
struct Mesh {
  Positions positions;
  Polygons faces;
  Labels labels = {};  ///< for messages and for readers of tables; nothing is computed from them

  [[nodiscard]] Index vertexCount() const noexcept { return positions.rows(); }
};

}  // namespace holdfast

#include "support/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace holdfast::test {
namespace {

/// Collects vertices by key, so that parts made apart share them.
template <class Key>
class Builder {
 public:
  Index vertex(const Key& key, const Vector3& position)
  {
    const auto [entry, isNew] = ids_.try_emplace(key, static_cast<Index>(positions_.size()));
    if (isNew) positions_.push_back(position);
    return entry->second;
  }

  Mesh finish(Polygons faces) const
  {
    Mesh mesh{Positions(static_cast<Index>(positions_.size()), 3), std::move(faces)};
    for (Index v = 0; v < mesh.vertexCount(); ++v) mesh.positions.row(v) = positions_[v];
    return mesh;
  }

  [[nodiscard]] const Vector3& position(Index v) const { return positions_[v]; }

 private:
  std::map<Key, Index> ids_;
  std::vector<Vector3> positions_;
};

}  // namespace

Mesh grid(Index columns, Index rows)
{
  Mesh mesh{Positions((columns + 1) * (rows + 1), 3), {}};
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i)
      mesh.positions.row(j * (columns + 1) + i) = Vector3(static_cast<double>(i), static_cast<double>(j), 0);
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i;
      mesh.faces.add({a, a + 1, a + columns + 2});
      mesh.faces.add({a, a + columns + 2, a + columns + 1});
    }
  return mesh;
}

Mesh box(const Vector3& size, Index divisions)
{
  Builder<std::array<Index, 3>> builder;
  Polygons faces;
  const auto corner = [&](int axis, Index side, Index u, Index v) {
    std::array<Index, 3> key{};
    key[axis] = side * divisions;
    key[(axis + 1) % 3] = u;
    key[(axis + 2) % 3] = v;
    const Vector3 unit =
        Vector3(static_cast<double>(key[0]), static_cast<double>(key[1]), static_cast<double>(key[2])) /
        static_cast<double>(divisions);
    return builder.vertex(key, unit.cwiseProduct(size));
  };
  for (int axis = 0; axis < 3; ++axis)
    for (Index side = 0; side < 2; ++side)
      for (Index u = 0; u < divisions; ++u)
        for (Index v = 0; v < divisions; ++v) {
          const Index a = corner(axis, side, u, v);
          const Index b = corner(axis, side, u + 1, v);
          const Index c = corner(axis, side, u + 1, v + 1);
          const Index d = corner(axis, side, u, v + 1);
          if (side == 1) {
            faces.add({a, b, c});
            faces.add({a, c, d});
          } else {
            faces.add({a, c, b});
            faces.add({a, d, c});
          }
        }
  return builder.finish(std::move(faces));
}

Mesh icosphere(int levels)
{
  const double golden = (1 + std::sqrt(5.0)) / 2;
  Builder<std::pair<Index, Index>> builder;
  const std::array<Vector3, 12> corners{Vector3(-1, golden, 0),  Vector3(1, golden, 0),   Vector3(-1, -golden, 0),
                                        Vector3(1, -golden, 0),  Vector3(0, -1, golden),  Vector3(0, 1, golden),
                                        Vector3(0, -1, -golden), Vector3(0, 1, -golden),  Vector3(golden, 0, -1),
                                        Vector3(golden, 0, 1),   Vector3(-golden, 0, -1), Vector3(-golden, 0, 1)};
  for (Index v = 0; v < 12; ++v) builder.vertex({v, v}, corners[v].normalized());
  std::vector<std::array<Index, 3>> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                              {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                              {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                              {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  const auto middle = [&](Index a, Index b) {
    const Vector3 position = (builder.position(a) + builder.position(b)).normalized();
    return builder.vertex({std::min(a, b), std::max(a, b)}, position);
  };
  for (int level = 0; level < levels; ++level) {
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  Polygons faces;
  for (const auto& [a, b, c] : triangles) faces.add({a, b, c});
  return builder.finish(std::move(faces));
}

Mesh tetrahedron()
{
  Mesh mesh{Positions(4, 3), {}};
  mesh.positions << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  mesh.faces.add({0, 1, 2});
  mesh.faces.add({0, 3, 1});
  mesh.faces.add({0, 2, 3});
  mesh.faces.add({1, 3, 2});
  return mesh;
}

Mesh merged(const Mesh& a, const Mesh& b)
{
  Mesh mesh{Positions(a.vertexCount() + b.vertexCount(), 3), a.faces};
  mesh.positions << a.positions, b.positions;
  for (Index f = 0; f < b.faces.size(); ++f) {
    std::vector<Index> corners(b.faces[f].begin(), b.faces[f].end());
    for (Index& corner : corners) corner += a.vertexCount();
    mesh.faces.add(corners);
  }
  return mesh;
}

}  // namespace holdfast::test

#include "bench/bumpy_mesh.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "bench/random.h"

namespace holdfast::bench {
namespace {

using Node = std::array<Index, 3>;  // of the cube's grid, each from 0 to the number of divisions

/// The vertices of the cube's surface, numbered as they are first asked for.
class CubeSurface {
 public:
  explicit CubeSurface(Index divisions) : divisions_(divisions) {}

  /// The node (u, v) of the side where coordinate `axis` is 0 or the number of divisions.
  Index vertex(int axis, Index side, Index u, Index v)
  {
    Node node{};
    node[axis] = side * divisions_;
    node[(axis + 1) % 3] = u;
    node[(axis + 2) % 3] = v;
    const auto [entry, isNew] = ids_.try_emplace(node, static_cast<Index>(nodes_.size()));
    if (isNew) nodes_.push_back(node);
    return entry->second;
  }

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

 private:
  Index divisions_;
  std::map<Node, Index> ids_;
  std::vector<Node> nodes_;
};

/// Splits every square of one side along a random diagonal, facing outwards.
void addSide(Polygons& faces, CubeSurface& cube, Random& random, Index divisions, int axis, Index side)
{
  for (Index u = 0; u < divisions; ++u)
    for (Index v = 0; v < divisions; ++v) {
      std::array<Index, 4> square{cube.vertex(axis, side, u, v), cube.vertex(axis, side, u + 1, v),
                                  cube.vertex(axis, side, u + 1, v + 1), cube.vertex(axis, side, u, v + 1)};
      if (side == 0) std::swap(square[1], square[3]);
      const auto first = static_cast<std::size_t>(random.below(2));
      faces.add({square[first], square[first + 1], square[first + 2]});
      faces.add({square[first], square[first + 2], square[(first + 3) % 4]});
    }
}

/// Returns the place of a node on the unit sphere, shaken by up to a third of the distance to its neighbours.
Vector3 direction(const Node& node, Index divisions, Random& random)
{
  Vector3 place;
  for (int k = 0; k < 3; ++k)
    place[k] = (2 * static_cast<double>(node[k]) + random.uniform(-0.6, 0.6)) / static_cast<double>(divisions) - 1;
  return place.normalized();
}

Vector3 onBumpySurface(const Vector3& direction)
{
  const double bumps = std::sin(9 * direction.x() + 1) * std::sin(8 * direction.y()) * std::cos(7 * direction.z());
  return (1 + 0.15 * bumps) * direction.cwiseProduct(Vector3(1, 0.6, 0.4));
}

}  // namespace

Mesh bumpyMesh(Index vertices)
{
  const auto divisions = static_cast<Index>(std::lround(std::sqrt(static_cast<double>(vertices) / 6)));
  Random random(1);
  CubeSurface cube(divisions);
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (Index side = 0; side < 2; ++side) addSide(mesh.faces, cube, random, divisions, axis, side);
  mesh.positions.resize(static_cast<Index>(cube.nodes().size()), 3);
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    mesh.positions.row(v) = onBumpySurface(direction(cube.nodes()[v], divisions, random));
  return mesh;
}

}  // namespace holdfast::bench

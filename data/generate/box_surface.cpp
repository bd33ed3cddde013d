#include "box_surface.h"

#include <map>

namespace holdfast::generate {
namespace {

using Node = std::array<Index, 3>;

class BoxBuilder {
 public:
  BoxBuilder(const Vector3& low, double step, const Node& cells) : low_(low), step_(step), cells_(cells) {}

  GroupedMesh build()
  {
    constexpr std::array kNames{"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};
    for (Index side = 0; side < 6; ++side) {
      mesh_.groups.push_back({kNames[side], static_cast<Index>(mesh_.triangles.size())});
      addSide(side / 2, side % 2 == 0 ? 0 : cells_[side / 2]);
    }
    return mesh_;
  }

 private:
  void addSide(Index axis, Index level)
  {
    const Index u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (Index j = 0; j < cells_[v]; ++j) {
      for (Index i = 0; i < cells_[u]; ++i) {
        Node node{};
        node[axis] = level;
        node[u] = i;
        node[v] = j;
        addSquare(node, level == 0 ? v : u, level == 0 ? u : v, (i + j) % 2);
      }
    }
  }

  // first x second points outward.
  void addSquare(Node node, Index first, Index second, Index parity)
  {
    std::array<Index, 4> corners{};
    corners[0] = vertex(node);
    ++node[first];
    corners[1] = vertex(node);
    ++node[second];
    corners[2] = vertex(node);
    --node[first];
    corners[3] = vertex(node);
    const auto corner = [&](Index k) { return corners[(k + parity) % 4]; };
    mesh_.triangles.push_back({corner(0), corner(1), corner(2)});
    mesh_.triangles.push_back({corner(0), corner(2), corner(3)});
  }

  Index vertex(const Node& node)
  {
    const auto [entry, isNew] = vertexOf_.try_emplace(node, static_cast<Index>(mesh_.points.size()));
    if (isNew) {
      const Vector3 steps(static_cast<double>(node[0]), static_cast<double>(node[1]), static_cast<double>(node[2]));
      mesh_.points.push_back(low_ + step_ * steps);
    }
    return entry->second;
  }

  Vector3 low_;
  double step_;
  Node cells_;
  GroupedMesh mesh_;
  std::map<Node, Index> vertexOf_;
};

}  // namespace

GroupedMesh boxSurface(const Vector3& low, double step, const std::array<Index, 3>& cells)
{
  return BoxBuilder(low, step, cells).build();
}

}  // namespace holdfast::generate

#include "contour.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace holdfast::generate {
namespace {

/// Values at the nodes of a grid. Nodes are numbered, x fastest.
class Grid {
 public:
  Grid(const DistanceFunction& distance, const Eigen::AlignedBox3d& box, double step) : origin_(box.min()), step_(step)
  {
    for (Index axis = 0; axis < 3; ++axis) size_[axis] = static_cast<Index>(std::ceil(box.sizes()[axis] / step)) + 1;
    for (Index node = 0; node < size_[0] * size_[1] * size_[2]; ++node) values_.push_back(distance(place(node)));
  }

  [[nodiscard]] double value(Index node) const { return values_[node]; }
  [[nodiscard]] bool isInside(Index node) const { return values_[node] < 0; }
  [[nodiscard]] Index stride(Index axis) const { return axis == 0 ? 1 : axis == 1 ? size_[0] : size_[0] * size_[1]; }

  [[nodiscard]] Vector3 place(Index node) const
  {
    const Vector3 steps(static_cast<double>(node % size_[0]), static_cast<double>(node / size_[0] % size_[1]),
                        static_cast<double>(node / (size_[0] * size_[1])));
    return origin_ + step_ * steps;
  }

  /// The lowest node of each cell.
  [[nodiscard]] std::vector<Index> cells() const
  {
    std::vector<Index> result;
    for (Index k = 0; k + 1 < size_[2]; ++k) {
      for (Index j = 0; j + 1 < size_[1]; ++j) {
        for (Index i = 0; i + 1 < size_[0]; ++i) result.push_back(i * stride(0) + j * stride(1) + k * stride(2));
      }
    }
    return result;
  }

 private:
  Vector3 origin_;
  double step_;
  std::array<Index, 3> size_{};
  std::vector<double> values_;
};

class Cutter {
 public:
  explicit Cutter(const Grid& grid) : grid_(grid) {}

  // The six tetrahedra of a cell: one for each way from its lowest corner to its highest along three edges.
  GroupedMesh run()
  {
    constexpr std::array<std::array<Index, 2>, 6> kWays{{{0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}}};
    const Index diagonal = grid_.stride(0) + grid_.stride(1) + grid_.stride(2);
    for (const Index low : grid_.cells()) {
      for (const auto& [first, second] : kWays) {
        const Index next = low + grid_.stride(first);
        cut({low, next, next + grid_.stride(second), low + diagonal});
      }
    }
    return mesh_;
  }

 private:
  void cut(const std::array<Index, 4>& tetrahedron)
  {
    std::vector<Index> in, out;
    for (const Index node : tetrahedron) (grid_.isInside(node) ? in : out).push_back(node);
    if (in.size() == 1) add(in[0], vertex(in[0], out[0]), vertex(in[0], out[1]), vertex(in[0], out[2]));
    if (in.size() == 3) add(in[0], vertex(in[0], out[0]), vertex(in[1], out[0]), vertex(in[2], out[0]));
    if (in.size() == 2) {
      const Index a = vertex(in[0], out[0]), c = vertex(in[1], out[1]);
      add(in[0], a, vertex(in[0], out[1]), c);
      add(in[1], a, c, vertex(in[1], out[0]));
    }
  }

  // The triangle, turned so that the node inside is behind it.
  void add(Index inside, Index a, Index b, Index c)
  {
    const Vector3 &p = mesh_.points[a], &q = mesh_.points[b], &r = mesh_.points[c];
    const bool isBehind = (q - p).cross(r - p).dot(grid_.place(inside) - p) < 0;
    mesh_.triangles.push_back(isBehind ? Triangle{a, b, c} : Triangle{a, c, b});
  }

  Index vertex(Index inside, Index outside)
  {
    constexpr double kMargin = 0.15;  // of the edge, kept free at both nodes
    const auto [entry, isNew] = vertexOf_.try_emplace({inside, outside}, static_cast<Index>(mesh_.points.size()));
    if (isNew) {
      const double t = grid_.value(inside) / (grid_.value(inside) - grid_.value(outside));
      const double kept = std::clamp(t, kMargin, 1 - kMargin);
      mesh_.points.push_back((1 - kept) * grid_.place(inside) + kept * grid_.place(outside));
    }
    return entry->second;
  }

  const Grid& grid_;
  GroupedMesh mesh_;
  std::map<std::pair<Index, Index>, Index> vertexOf_;
};

}  // namespace

GroupedMesh contour(const DistanceFunction& distance, const Eigen::AlignedBox3d& box, double step)
{
  const Grid grid(distance, box, step);
  return Cutter(grid).run();
}

}  // namespace holdfast::generate

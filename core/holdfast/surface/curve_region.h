#pragma once
/// Closed curves along the edges of a surface, and the regions that they enclose.

#include <span>
#include <vector>

#include <holdfast/mesh/edge_graph.h>

namespace holdfast {

/// The vertices of the closed curve through `places`, in their order: shortest paths along edges from each to the next
/// and from the last to the first, each vertex once a passage. There is at least one place, and all are in one
/// connected part. O(N log N) for each place at the most, far less for places near one another.
[[nodiscard]] std::vector<Index> closedCurve(const EdgeGraph& graph, std::span<const Index> places);

/// How a curve divides the vertices of the connected part that it lies on. Ids ascend.
struct CurveRegion {
  std::vector<Index> curve;
  std::vector<Index> inside;   ///< empty where the curve leaves the part in one piece
  std::vector<Index> outside;  ///< the largest of the pieces; of equally large ones that whose smallest id is largest
};

/// Floods what is left of the part when the vertices of `curve` are taken out. A curve that crosses itself may leave
/// more than two pieces: all but the largest are inside. O(N).
[[nodiscard]] CurveRegion regionOfCurve(const EdgeGraph& graph, const std::vector<Index>& curve);

}  // namespace holdfast

#pragma once
/// \file
/// Closed curves along the edges of the surface as lines for drawing.

#include <span>

#include <holdfast/mesh/edge_graph.h>

namespace holdfast {

/// The places, one a row, of the closed curve through `vertices` of the file (see `closedCurve`), the first once more
/// at the end; of one vertex, that place alone twice. No rows where there is no vertex, where no face uses one of them,
/// or where they lie on different connected parts. `graph` is that of `mesh`; `positions` has one row for each vertex
/// of the file. Costs what `closedCurve` does.
[[nodiscard]] Positions curveThrough(std::span<const Index> vertices, const EdgeGraph& graph, const SolverMesh& mesh,
                                     const Positions& positions);

}  // namespace holdfast

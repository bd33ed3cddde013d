#include "holdfast/ordering/nested_dissection.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>

#include <holdfast/ordering/bisection.h>
#include <holdfast/ordering/minimum_degree.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

constexpr int kPiece = 200;  // vertices that are not cut any more
constexpr Index kPiecesAtOnce = 16;

/// Vertices that come one after the other, with the edges among them and to the vertices around them.
struct Domain {
  std::vector<int> vertices;  // in the whole graph; behind the first `size` those around them, which weigh 0
  int size = 0;
  int firstPlace = 0;
  Graph graph;
};

/// The subgraph of some vertices and their neighbours: `vertices` gets the latter behind them. `placeOf` has -1 for
/// each vertex of `graph`, before and afterwards.
Graph withNeighbours(const Graph& graph, std::vector<int>& vertices, std::vector<int>& placeOf)
{
  Graph part;
  const int size = static_cast<int>(vertices.size());
  const auto endList = [&] {
    part.degree.push_back(static_cast<int>(part.neighbour.size()) - part.start.back());
    part.start.push_back(static_cast<int>(part.neighbour.size()));
  };
  for (int k = 0; k < size; ++k) placeOf[vertices[k]] = k;
  for (int k = 0; k < size; ++k) {
    graph.forEachEdge(vertices[k], [&](int u, int /*weight*/) {
      if (placeOf[u] < 0) {
        placeOf[u] = static_cast<int>(vertices.size());
        vertices.push_back(u);
      }
      part.neighbour.push_back(placeOf[u]);
    });
    endList();
  }
  for (std::size_t k = static_cast<std::size_t>(size); k < vertices.size(); ++k) {
    graph.forEachEdge(vertices[k], [&](int u, int /*weight*/) {
      if (placeOf[u] >= 0 && placeOf[u] < size) part.neighbour.push_back(placeOf[u]);
    });
    endList();
  }
  for (const int vertex : vertices) placeOf[vertex] = -1;
  part.edgeWeight.assign(part.neighbour.size(), 1);
  part.weight.assign(static_cast<std::size_t>(size), 1);
  part.weight.resize(vertices.size(), 0);
  return part;
}

/// Ranks the vertices along the cut; the domains that it leaves.
std::array<Domain, 2> cutInTwo(const Domain& domain, std::vector<int>& ranks)
{
  const Bisection parts = bisect(domain.graph);
  std::array<std::vector<int>, 2> left;
  int end = domain.firstPlace + domain.size;
  for (int v = domain.size - 1; v >= 0; --v) {
    if (parts.external[v] > 0)
      ranks[domain.vertices[v]] = --end;
    else
      left[parts.side[v]].push_back(v);
  }
  std::array<Domain, 2> result;
  std::vector<int> placeOf(domain.vertices.size(), -1);
  int firstPlace = domain.firstPlace;
  for (int side = 0; side < 2; ++side) {
    std::vector<int>& its = left[side];
    std::ranges::reverse(its);
    const int size = static_cast<int>(its.size());
    Graph graph = withNeighbours(domain.graph, its, placeOf);
    for (int& v : its) v = domain.vertices[v];
    result[side] = {std::move(its), size, firstPlace, std::move(graph)};
    firstPlace += size;
  }
  return result;
}

void rankPieces(const Graph& graph, const std::vector<Domain>& pieces, std::vector<int>& ranks)
{
  std::vector<std::unique_ptr<PieceOrder>> orders(static_cast<std::size_t>(threadCount()));
  const auto count = static_cast<Index>(pieces.size());
  parallelFor((count + kPiecesAtOnce - 1) / kPiecesAtOnce, [&](Index block, Index thread) {
    if (orders[thread] == nullptr) orders[thread] = std::make_unique<PieceOrder>(graph);
    for (Index k = block * kPiecesAtOnce; k < std::min(count, (block + 1) * kPiecesAtOnce); ++k) {
      int place = pieces[k].firstPlace;
      for (const int vertex : (*orders[thread])({pieces[k].vertices.data(), static_cast<std::size_t>(pieces[k].size)}))
        ranks[vertex] = place++;
    }
  });
}

}  // namespace

std::vector<int> nestedDissection(const Graph& graph)
{
  std::vector<int> ranks(static_cast<std::size_t>(graph.size()));
  std::vector<Domain> pieces;
  std::vector<Domain> domains;
  const auto add = [&](Domain domain) {
    if (domain.size > kPiece)
      domains.push_back(std::move(domain));
    else if (domain.size > 0)
      pieces.push_back({std::move(domain.vertices), domain.size, domain.firstPlace, {}});
  };
  std::vector<int> all(ranks.size());
  std::iota(all.begin(), all.end(), 0);
  add({std::move(all), graph.size(), 0, graph});
  while (!domains.empty()) {
    std::vector<std::array<Domain, 2>> parts(domains.size());
    parallelFor(static_cast<Index>(domains.size()),
                [&](Index k) { parts[k] = cutInTwo(std::exchange(domains[k], {}), ranks); });
    domains.clear();
    for (std::array<Domain, 2>& pair : parts)
      for (Domain& domain : pair) add(std::move(domain));
  }
  rankPieces(graph, pieces, ranks);
  return ranks;
}

}  // namespace holdfast

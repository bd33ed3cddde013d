#include "holdfast/ordering/coarsening.h"

#include <numeric>
#include <utility>

namespace holdfast {
namespace {

constexpr int kUnmatched = -1;

std::vector<int> shuffled(int count, RandomNumbers& random)
{
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random() % k]);
  return order;
}

/// Of each vertex: the one that it is joined with; itself where there is none.
std::vector<int> heavyEdgeMatching(const Graph& graph, int mostWeight, RandomNumbers& random)
{
  std::vector<int> mate(static_cast<std::size_t>(graph.size()), kUnmatched);
  for (const int vertex : shuffled(graph.size(), random)) {
    if (mate[vertex] != kUnmatched) continue;
    int best = vertex;
    int heaviest = 0;
    graph.forEachEdge(vertex, [&](int other, int weight) {
      if (weight <= heaviest || mate[other] != kUnmatched) return;
      if (graph.weight[vertex] + graph.weight[other] > mostWeight) return;
      heaviest = weight;
      best = other;
    });
    mate[vertex] = best;
    mate[best] = vertex;
  }
  return mate;
}

}  // namespace

CoarserGraph coarsened(const Graph& graph, int mostWeight, RandomNumbers& random)
{
  const std::vector<int> mate = heavyEdgeMatching(graph, mostWeight, random);
  CoarserGraph result;
  result.clusterOf.resize(mate.size());
  int clusters = 0;
  for (int v = 0; v < graph.size(); ++v)
    if (mate[v] >= v) result.clusterOf[v] = result.clusterOf[mate[v]] = clusters++;

  Graph& coarse = result.graph;
  coarse.start.reserve(static_cast<std::size_t>(clusters) + 1);
  coarse.neighbour.reserve(graph.neighbour.size());
  coarse.edgeWeight.reserve(graph.neighbour.size());
  std::vector<int> edgeTo(static_cast<std::size_t>(clusters), -1);
  for (int v = 0; v < graph.size(); ++v) {
    if (mate[v] < v) continue;
    const int own = result.clusterOf[v];
    const int first = coarse.start.back();
    int degree = 0;
    const auto addEdges = [&](int vertex) {
      graph.forEachEdge(vertex, [&](int neighbour, int weight) {
        const int other = result.clusterOf[neighbour];
        if (other == own) return;
        degree += weight;
        if (edgeTo[other] >= first) {
          coarse.edgeWeight[edgeTo[other]] += weight;
          return;
        }
        edgeTo[other] = static_cast<int>(coarse.neighbour.size());
        coarse.neighbour.push_back(other);
        coarse.edgeWeight.push_back(weight);
      });
    };
    addEdges(v);
    if (mate[v] != v) addEdges(mate[v]);
    coarse.weight.push_back(graph.weight[v] + (mate[v] != v ? graph.weight[mate[v]] : 0));
    coarse.degree.push_back(degree);
    coarse.start.push_back(static_cast<int>(coarse.neighbour.size()));
  }
  return result;
}

}  // namespace holdfast

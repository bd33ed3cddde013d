#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/ordering/bisection.h>
#include <holdfast/ordering/minimum_degree.h>
#include <holdfast/ordering/nested_dissection.h>

#include "support/one_core.h"
#include "support/random.h"

namespace holdfast {
namespace {

Graph graphOf(const std::vector<std::set<int>>& neighbours)
{
  Graph graph;
  for (const std::set<int>& its : neighbours) {
    graph.neighbour.insert(graph.neighbour.end(), its.begin(), its.end());
    graph.start.push_back(static_cast<int>(graph.neighbour.size()));
    graph.degree.push_back(static_cast<int>(its.size()));
  }
  graph.edgeWeight.assign(graph.neighbour.size(), 1);
  graph.weight.assign(neighbours.size(), 1);
  return graph;
}

void join(std::vector<std::set<int>>& neighbours, int a, int b)
{
  neighbours[a].insert(b);
  neighbours[b].insert(a);
}

/// Squares, each split along a random diagonal.
Graph triangleGrid(int columns, int rows, unsigned seed)
{
  test::Random random(seed);
  std::vector<std::set<int>> neighbours(static_cast<std::size_t>(columns * rows));
  const auto at = [&](int column, int row) { return row * columns + column; };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (column + 1 < columns) join(neighbours, at(column, row), at(column + 1, row));
      if (row + 1 < rows) join(neighbours, at(column, row), at(column, row + 1));
      if (column + 1 == columns || row + 1 == rows) continue;
      if (random.integer(0, 1) == 0)
        join(neighbours, at(column, row), at(column + 1, row + 1));
      else
        join(neighbours, at(column + 1, row), at(column, row + 1));
    }
  return graphOf(neighbours);
}

/// What each vertex reaches over up to two edges.
std::vector<std::set<int>> overTwoEdges(const Graph& graph)
{
  std::vector<std::set<int>> reached(static_cast<std::size_t>(graph.size()));
  for (int v = 0; v < graph.size(); ++v) {
    graph.forEachEdge(v, [&](int u, int /*weight*/) {
      reached[v].insert(u);
      graph.forEachEdge(u, [&](int w, int /*weight*/) { reached[v].insert(w); });
    });
    reached[v].erase(v);
  }
  return reached;
}

/// The connected parts of some vertices under these ties.
std::vector<std::vector<int>> connectedParts(const std::vector<std::set<int>>& ties, const std::vector<int>& vertices)
{
  std::set<int> left(vertices.begin(), vertices.end());
  std::vector<std::vector<int>> parts;
  while (!left.empty()) {
    std::vector<int> part{*left.begin()};
    left.erase(left.begin());
    for (std::size_t k = 0; k < part.size(); ++k)
      for (const int u : ties[part[k]])
        if (left.erase(u) > 0) part.push_back(u);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Expects that few of the last vertices of a part leave it in pieces, and the same of its pieces.
void expectCutByFew(const std::vector<std::set<int>>& ties, const std::vector<int>& ranks, std::vector<int> part)
{
  if (part.size() < 300) return;
  std::ranges::sort(part, {}, [&](int v) { return ranks[v]; });
  const std::size_t most = part.size() * 2 / 3;
  std::size_t removed = 0;
  std::vector<std::vector<int>> pieces;
  const auto isWhole = [&] {
    return pieces.empty() || std::ranges::max(pieces, {}, &std::vector<int>::size).size() > most;
  };
  while (isWhole() && removed < part.size()) {
    ++removed;
    pieces = connectedParts(ties, {part.begin(), part.end() - static_cast<std::ptrdiff_t>(removed)});
  }
  EXPECT_LT(static_cast<double>(removed), 2.2 * std::sqrt(static_cast<double>(part.size()))) << "of " << part.size();
  for (std::vector<int>& piece : pieces) expectCutByFew(ties, ranks, std::move(piece));
}

void expectPermutation(std::vector<int> ranks, int size)
{
  std::vector<int> all(static_cast<std::size_t>(size));
  std::iota(all.begin(), all.end(), 0);
  std::ranges::sort(ranks);
  EXPECT_EQ(ranks, all);
}

TEST(NestedDissection, RanksEachVertexOnce)
{
  for (const auto& [columns, rows] : {std::pair{0, 0}, {1, 1}, {15, 10}, {60, 30}, {500, 3}})
    expectPermutation(nestedDissection(triangleGrid(columns, rows, 1)), columns * rows);
}

TEST(NestedDissection, LetsTwoLayersDivideWhatIsLeft)
{
  const Graph graph = triangleGrid(56, 40, 2);
  std::vector<int> all(static_cast<std::size_t>(graph.size()));
  std::iota(all.begin(), all.end(), 0);
  expectCutByFew(overTwoEdges(graph), nestedDissection(graph), all);
}

TEST(NestedDissection, TakesGraphsInPiecesAndVerticesThatAllOthersMeet)
{
  std::vector<std::set<int>> pieces(900);
  for (int k = 0; k + 1 < 900; ++k)
    if (k % 30 != 29) join(pieces, k, k + 1);
  expectPermutation(nestedDissection(graphOf(pieces)), 900);
  std::vector<std::set<int>> star(2000);
  for (int k = 1; k < 2000; ++k) join(star, 0, k);
  expectPermutation(nestedDissection(graphOf(star)), 2000);
  std::vector<std::set<int>> all(300);
  for (int a = 0; a < 300; ++a)
    for (int b = 0; b < a; ++b) join(all, a, b);
  expectPermutation(nestedDissection(graphOf(all)), 300);
  expectPermutation(nestedDissection(graphOf(std::vector<std::set<int>>(1000))), 1000);
}

TEST(NestedDissection, IsTheSameOnOneCore)
{
  const Graph graph = triangleGrid(80, 70, 3);
  const std::vector<int> ranks = nestedDissection(graph);
  const test::OneCore one;
  EXPECT_EQ(nestedDissection(graph), ranks);
}

TEST(Bisection, CountsWhatItCutsAndKeepsTheSharesOfItsSides)
{
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Graph graph = triangleGrid(25, 20, seed);
    const Bisection parts = bisect(graph);
    std::array<std::int64_t, 2> weight{};
    std::int64_t cut = 0;
    for (int v = 0; v < graph.size(); ++v) {
      ++weight[parts.side[v]];
      int external = 0;
      graph.forEachEdge(v, [&](int u, int /*weight*/) { external += parts.side[u] != parts.side[v] ? 1 : 0; });
      EXPECT_EQ(parts.external[v], external);
      cut += external;
    }
    EXPECT_EQ(parts.cut, cut / 2);
    EXPECT_EQ(parts.weight, weight);
    EXPECT_LE(std::max(weight[0], weight[1]), 300);
    EXPECT_LE(parts.cut, 60) << "straight across: 39";
  }
}

TEST(Coarsening, KeepsWeightsAndCuts)
{
  const Graph graph = triangleGrid(20, 15, 4);
  RandomNumbers random(7);
  CoarserGraph coarser = coarsened(coarsened(graph, 4, random).graph, 3, random);
  EXPECT_EQ(std::accumulate(coarser.graph.weight.begin(), coarser.graph.weight.end(), 0), 300);
  EXPECT_LE(std::ranges::max(coarser.graph.weight), 3);
  coarser = coarsened(graph, 2, random);
  EXPECT_LT(coarser.graph.size(), 200);
  std::vector<int> side(static_cast<std::size_t>(coarser.graph.size()));
  for (int& its : side) its = static_cast<int>(random() % 2);
  const auto cutOf = [](const Graph& of, const auto& sideOf) {
    int cut = 0;
    for (int v = 0; v < of.size(); ++v) {
      int degree = 0;
      of.forEachEdge(v, [&](int u, int weight) {
        degree += weight;
        cut += sideOf(u) != sideOf(v) ? weight : 0;
      });
      EXPECT_EQ(of.degree[v], degree);
    }
    return cut;
  };
  EXPECT_EQ(cutOf(coarser.graph, [&](int v) { return side[v]; }),
            cutOf(graph, [&](int v) { return side[coarser.clusterOf[v]]; }));
}

TEST(PieceOrder, AlwaysEliminatesAVertexWithFewestTies)
{
  const Graph graph = triangleGrid(16, 14, 5);
  std::vector<int> piece;
  for (int row = 3; row < 10; ++row)
    for (int column = 2; column < 12; ++column) piece.push_back(row * 16 + column);
  PieceOrder orderOf(graph);
  const std::vector<int> order = orderOf(piece);
  std::vector<std::set<int>> ties = overTwoEdges(graph);
  std::set<int> left(piece.begin(), piece.end());
  for (const int next : order) {
    ASSERT_EQ(left.count(next), 1);
    for (const int other : left) EXPECT_LE(ties[next].size(), ties[other].size());
    left.erase(next);
    for (const int a : ties[next]) {
      for (const int b : ties[next])
        if (a != b) ties[a].insert(b);
      ties[a].erase(next);
    }
  }
  EXPECT_TRUE(left.empty());
  EXPECT_EQ(orderOf(piece), order) << "nothing is left of the piece before";
}

}  // namespace
}  // namespace holdfast

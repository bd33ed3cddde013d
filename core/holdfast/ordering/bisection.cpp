#include "holdfast/ordering/bisection.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

namespace holdfast {
namespace {

// Found on generated and scanned meshes: more of each leaves the factor no smaller.
constexpr int kCoarsest = 40;     // vertices of the coarsest graph
constexpr int kTrials = 3;        // of which the best counts
constexpr int kLarge = 3000;      // a graph of so many vertices is bisected by trials from a coarser one on, ...
constexpr int kTriedShare = 16;   // ... which has this part of its vertices, ...
constexpr int kMostTried = 3000;  // ... and so many at most
constexpr int kPasses = 8;
constexpr int kPatience = 60;  // moves of a pass that find nothing better, one after the other

constexpr double kLargestShare = 0.6;

/// What is to be small: the cut, and a little more where the parts are uneven.
double cost(const Bisection& parts)
{
  const auto [lighter, heavier] = std::minmax(parts.weight[0], parts.weight[1]);
  const double unevenness = static_cast<double>(heavier - lighter) / static_cast<double>(heavier + lighter);
  return static_cast<double>(parts.cut) * (1 + unevenness * unevenness);
}

/// Moves vertices between two parts as long as that helps.
class Refinement {
 public:
  Refinement(const Graph& graph, Bisection& parts)
      : graph_(graph),
        parts_(parts),
        most_(std::max(static_cast<std::int64_t>(kLargestShare * static_cast<double>(total())), total() / 2 + 1)),
        isLocked_(static_cast<std::size_t>(graph.size()), false),
        isNear_(isLocked_)
  {
    for (int v = 0; v < graph_.size(); ++v)
      if (parts_.external[v] > 0) addNear(v);
  }

  void run()
  {
    for (int pass = 0; pass < kPasses && improve(); ++pass) {
    }
  }

 private:
  using Queue = std::vector<std::pair<int, int>>;  // a heap of gains and vertices; some are out of date

  [[nodiscard]] std::int64_t total() const { return parts_.weight[0] + parts_.weight[1]; }
  [[nodiscard]] std::int64_t excess() const
  {
    return std::max<std::int64_t>(0, std::max(parts_.weight[0], parts_.weight[1]) - most_);
  }

  void addNear(int vertex)
  {
    if (isNear_[vertex]) return;
    isNear_[vertex] = true;
    near_.push_back(vertex);
  }

  /// Moves each vertex once at most, the best first, and takes the last moves back that found nothing better. Tells
  /// whether the parts are better than before.
  bool improve()
  {
    for (Queue& queue : queues_) queue.clear();
    for (const int v : near_)
      if (parts_.external[v] > 0) queues_[parts_.side[v]].emplace_back(parts_.gain(graph_, v), v);
    for (Queue& queue : queues_) std::ranges::make_heap(queue);

    const auto state = [&] { return std::pair(excess(), cost(parts_)); };
    const auto before = state();
    auto best = before;
    std::size_t kept = 0;
    std::vector<int> moved;
    while (moved.size() - kept < kPatience) {
      const std::optional<int> from = nextSide();
      if (!from) break;
      moved.push_back(queues_[*from].front().second);
      moveFirst(*from);
      if (const auto now = state(); now < best) {
        best = now;
        kept = moved.size();
      }
    }
    for (const int v : moved) isLocked_[v] = false;
    for (std::size_t k = moved.size(); k > kept; --k) parts_.move(graph_, moved[k - 1]);
    return best < before;
  }

  /// The side that the next vertex comes from.
  [[nodiscard]] std::optional<int> nextSide()
  {
    const std::array<bool, 2> has{hasMove(0), hasMove(1)};
    if (!has[0] && !has[1]) return std::nullopt;
    const int heavier = parts_.weight[0] >= parts_.weight[1] ? 0 : 1;
    if (has[heavier] && excess() > 0) return heavier;
    if (!has[0] || !has[1]) return has[0] ? 0 : 1;
    const int gains[] = {queues_[0].front().first, queues_[1].front().first};
    return gains[0] == gains[1] ? heavier : gains[0] > gains[1] ? 0 : 1;
  }

  /// Tells whether the first vertex in the queue may move, after those are gone that may not.
  [[nodiscard]] bool hasMove(int side)
  {
    Queue& queue = queues_[side];
    while (!queue.empty()) {
      const auto [gain, v] = queue.front();
      const bool isCurrent = !isLocked_[v] && parts_.side[v] == side && parts_.gain(graph_, v) == gain;
      if (isCurrent && (parts_.weight[1 - side] + graph_.weight[v] <= most_ || parts_.weight[side] > most_))
        return true;
      removeFirst(queue);
    }
    return false;
  }

  static void removeFirst(Queue& queue)
  {
    std::ranges::pop_heap(queue);
    queue.pop_back();
  }

  void moveFirst(int side)
  {
    const int v = queues_[side].front().second;
    removeFirst(queues_[side]);
    isLocked_[v] = true;
    parts_.move(graph_, v);
    graph_.forEachEdge(v, [&](int u, int /*weight*/) {
      addNear(u);
      if (isLocked_[u] || parts_.external[u] == 0) return;
      Queue& queue = queues_[parts_.side[u]];
      queue.emplace_back(parts_.gain(graph_, u), u);
      std::ranges::push_heap(queue);
    });
  }

  const Graph& graph_;
  Bisection& parts_;
  std::int64_t most_;  // that a part may weigh
  std::vector<bool> isLocked_;
  std::vector<bool> isNear_;
  std::vector<int> near_;  // vertices that had an edge to the other side at some time
  std::array<Queue, 2> queues_;
};

/// Part 0 grows from a random vertex to half of the weight, always by the vertex that adds least to the cut.
Bisection grown(const Graph& graph, RandomNumbers& random)
{
  Bisection parts;
  parts.side.assign(static_cast<std::size_t>(graph.size()), 1);
  parts.external.assign(parts.side.size(), 0);
  parts.weight[1] = std::accumulate(graph.weight.begin(), graph.weight.end(), std::int64_t{0});
  std::priority_queue<std::pair<int, int>> rim;
  while (parts.weight[0] < parts.weight[1]) {
    while (!rim.empty() && parts.side[rim.top().second] == 0) rim.pop();
    int next = rim.empty() ? static_cast<int>(random() % parts.side.size()) : rim.top().second;
    while (parts.side[next] == 0) next = (next + 1) % graph.size();
    parts.move(graph, next);
    graph.forEachEdge(next, [&](int u, int /*weight*/) { rim.emplace(parts.gain(graph, u), u); });
  }
  return parts;
}

/// The best of `kTrials` that `make()` makes.
template <class Make>
Bisection bestOf(const Make& make)
{
  Bisection best = make();
  for (int trial = 1; trial < kTrials; ++trial)
    if (Bisection parts = make(); cost(parts) < cost(best)) best = std::move(parts);
  return best;
}

/// The parts of a coarser graph as those of the finer one.
Bisection refined(const Graph& graph, const CoarserGraph& coarser, const Bisection& coarse)
{
  Bisection parts{{}, {}, coarse.weight, coarse.cut};
  parts.side.reserve(coarser.clusterOf.size());
  for (const int cluster : coarser.clusterOf) parts.side.push_back(coarse.side[cluster]);
  parts.external.assign(parts.side.size(), 0);
  for (int v = 0; v < graph.size(); ++v)
    if (coarse.external[coarser.clusterOf[v]] > 0)
      graph.forEachEdge(v,
                        [&](int u, int weight) { parts.external[v] += parts.side[u] != parts.side[v] ? weight : 0; });
  Refinement(graph, parts).run();
  return parts;
}

/// Bisects a coarser graph and refines its parts. From the first graph with up to `tried` vertices on, the best of
/// several trials counts.
Bisection multilevel(const Graph& graph, int mostWeight, int tried, RandomNumbers& random)
{
  if (graph.size() <= tried) return bestOf([&] { return multilevel(graph, mostWeight, 0, random); });
  if (graph.size() > kCoarsest) {
    const CoarserGraph coarser = coarsened(graph, mostWeight, random);
    if (20 * coarser.graph.size() <= 19 * graph.size())  // else hardly any vertex has found another
      return refined(graph, coarser, multilevel(coarser.graph, mostWeight, tried, random));
  }
  return bestOf([&] {
    Bisection parts = grown(graph, random);
    Refinement(graph, parts).run();
    return parts;
  });
}

}  // namespace

void Bisection::move(const Graph& graph, int vertex)
{
  const int from = side[vertex];
  side[vertex] = static_cast<std::uint8_t>(1 - from);
  cut -= gain(graph, vertex);
  weight[from] -= graph.weight[vertex];
  weight[1 - from] += graph.weight[vertex];
  external[vertex] = graph.degree[vertex] - external[vertex];
  graph.forEachEdge(vertex, [&](int u, int edgeWeight) { external[u] += side[u] == from ? edgeWeight : -edgeWeight; });
}

Bisection bisect(const Graph& graph)
{
  RandomNumbers random(2);
  const std::int64_t total = std::accumulate(graph.weight.begin(), graph.weight.end(), std::int64_t{0});
  const int mostWeight = static_cast<int>(1 + 3 * total / (std::int64_t{2} * kCoarsest));
  const int tried = graph.size() < kLarge ? 0 : std::min(kMostTried, graph.size() / kTriedShare);
  return multilevel(graph, mostWeight, tried, random);
}

}  // namespace holdfast

#include "app/generated_constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <span>

#include <nlohmann/json.hpp>

namespace holdfast::test {
namespace {

using Json = nlohmann::json;

constexpr double kEnd = 0.08;
constexpr double kShift = 0.1;
constexpr double kTurnDegrees = 20;
constexpr double kPointShift = 0.02;

struct Extent {
  PlainPoint low{};
  PlainPoint high{};
  std::size_t longest = 0;
};

Extent extentOf(const PlainMesh& mesh)
{
  Extent extent;
  extent.low.fill(std::numeric_limits<double>::infinity());
  extent.high.fill(-std::numeric_limits<double>::infinity());
  for (const auto& face : mesh.faces)
    for (const long v : face)
      for (std::size_t k = 0; k < 3; ++k) {
        extent.low[k] = std::min(extent.low[k], mesh.positions[v][k]);
        extent.high[k] = std::max(extent.high[k], mesh.positions[v][k]);
      }
  for (std::size_t k = 1; k < 3; ++k)
    if (extent.high[k] - extent.low[k] > extent.high[extent.longest] - extent.low[extent.longest]) extent.longest = k;
  return extent;
}

/// A displacement that varies slowly over the whole mesh.
class SmoothField {
 public:
  SmoothField(double diagonal, Random& random) : diagonal_(diagonal)
  {
    for (Wave& wave : waves_) {
      for (double& number : wave.direction) number = random.uniform(-1, 1);
      wave.phase = random.uniform(0, 2 * std::numbers::pi);
    }
  }

  [[nodiscard]] PlainPoint operator()(const PlainPoint& p) const
  {
    PlainPoint shift{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [direction, phase] = waves_[k];
      const double along = direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2];
      shift[k] = kPointShift * diagonal_ * std::sin(2 * std::numbers::pi * along / diagonal_ + phase);
    }
    return shift;
  }

 private:
  struct Wave {
    PlainPoint direction{};
    double phase = 0;
  };

  double diagonal_;
  std::array<Wave, 3> waves_;
};

/// Makes the entries of one file.
class Generator {
 public:
  Generator(const PlainMesh& mesh, Random& random)
      : mesh_(mesh),
        random_(random),
        extent_(extentOf(mesh)),
        diagonal_(diagonalOf(mesh)),
        field_(diagonal_, random),
        limit_(std::min(kMostPointsOfAKind, mesh.positions.size() / 20))
  {
  }

  Json run()
  {
    addEnds();
    for (const std::size_t face : shuffledFaces()) addPointIn(face);
    return std::move(list_);
  }

 private:
  enum class Kind { Vertex, Edge, Face };

  void addEnds()
  {
    const std::size_t axis = extent_.longest;
    const double length = extent_.high[axis] - extent_.low[axis];
    const double below = extent_.low[axis] + kEnd * length;
    const double above = extent_.high[axis] - kEnd * length;
    PlainPoint point{};
    PlainPoint normal{};
    point[axis] = below;
    normal[axis] = -1;
    PlainPoint min = extent_.low;
    min[axis] = above;
    PlainPoint shift{};
    shift[(axis + 1) % 3] = kShift * diagonal_;
    list_.push_back(
        {{"type", "fixed"}, {"name", "low end"}, {"select", {{"halfspace", {{"point", point}, {"normal", normal}}}}}});
    list_.push_back({{"type", "handle"},
                     {"name", "high end"},
                     {"select", {{"box", {{"min", min}, {"max", extent_.high}}}}},
                     {"rotate", {{"axis", {1, 2, 3}}, {"degrees", kTurnDegrees}}},
                     {"translate", shift}});
    for (const PlainPoint& p : mesh_.positions)
      if (p[axis] <= below || p[axis] >= above) taken_.insert(p);
  }

  std::vector<std::size_t> shuffledFaces()
  {
    std::vector<std::size_t> faces(mesh_.faces.size());
    for (std::size_t k = 0; k < faces.size(); ++k) faces[k] = k;
    for (std::size_t k = faces.size(); k > 1; --k)
      std::swap(faces[k - 1], faces[static_cast<std::size_t>(random_.integer(0, static_cast<long>(k) - 1))]);
    return faces;
  }

  /// A point of the kind of which there are fewest, where the face has room for it.
  void addPointIn(std::size_t face)
  {
    const auto fewest = std::min_element(counts_.begin(), counts_.end());
    if (*fewest == limit_) return;
    const auto kind = static_cast<Kind>(fewest - counts_.begin());
    const std::vector<long>& corners = mesh_.faces[face];
    const std::size_t needed = kind == Kind::Vertex ? 1 : kind == Kind::Edge ? 2 : corners.size();
    if (!take({corners.data(), needed})) return;
    ++*fewest;
    if (kind == Kind::Vertex) addVertex(corners[0]);
    if (kind == Kind::Edge) addEdge(corners[0], corners[1]);
    if (kind == Kind::Face) addFace(face);
  }

  /// Takes the places of these vertices if none of them is taken and no two are the same.
  bool take(std::span<const long> vertices)
  {
    std::set<PlainPoint> places;
    for (const long v : vertices) places.insert(mesh_.positions[v]);
    const bool isFree = places.size() == vertices.size() &&
                        std::none_of(places.begin(), places.end(), [&](const auto& p) { return taken_.contains(p); });
    if (isFree) taken_.insert(places.begin(), places.end());
    return isFree;
  }

  void addVertex(long v)
  {
    const PlainPoint& p = mesh_.positions[v];
    addPoint("vertex", {{"vertex", v}}, p);
  }

  void addEdge(long i, long j)
  {
    const double t = random_.uniform(0.05, 0.95);
    PlainPoint p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = t * mesh_.positions[i][k] + (1 - t) * mesh_.positions[j][k];
    addPoint("edge", {{"edge", {i, j}}, {"t", t}}, p);
  }

  void addFace(std::size_t face)
  {
    std::vector<double> weights;
    for (std::size_t k = 0; k < mesh_.faces[face].size(); ++k) weights.push_back(random_.uniform(0.05, 1));
    double sum = 0;
    for (const double weight : weights) sum += weight;
    PlainPoint p{};
    for (std::size_t c = 0; c < weights.size(); ++c) {
      weights[c] /= sum;
      for (std::size_t k = 0; k < 3; ++k) p[k] += weights[c] * mesh_.positions[mesh_.faces[face][c]][k];
    }
    addPoint("face", {{"face", face}, {"weights", weights}}, p);
  }

  /// To a place and by a shift, in turns.
  void addPoint(const std::string& kind, Json at, PlainPoint rest)
  {
    const PlainPoint shift = field_(rest);
    for (std::size_t k = 0; k < 3; ++k) rest[k] += shift[k];
    Json point{{"type", "point"}, {"name", kind + " " + std::to_string(list_.size())}, {"at", std::move(at)}};
    if (list_.size() % 2 == 0)
      point["target"] = rest;
    else
      point["move"] = shift;
    list_.push_back(std::move(point));
  }

  const PlainMesh& mesh_;
  Random& random_;
  Extent extent_;
  double diagonal_;
  SmoothField field_;
  std::size_t limit_;
  std::array<std::size_t, 3> counts_{};
  std::set<PlainPoint> taken_;
  Json list_ = Json::array();
};

}  // namespace

std::string generatedConstraints(const PlainMesh& mesh, Random& random)
{
  const Json file{{"format", "holdfast-constraints"}, {"version", 1}, {"constraints", Generator(mesh, random).run()}};
  return file.dump(1);
}

}  // namespace holdfast::test

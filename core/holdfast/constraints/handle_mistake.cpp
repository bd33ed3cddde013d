#include "holdfast/constraints/handle_mistake.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

using Mistake = std::optional<HandleMistake>;

// Fewer points never say how they turn.
constexpr std::size_t kLeastTargets = 3;
// The sine of the angle between x and y from which on y says the plane of both to half of its digits.
constexpr double kParallel = 1e-8;
// The axis of a rotation within rounding of none is noise.
constexpr double kNoRotation = 8 * std::numeric_limits<double>::epsilon();

/// The place of the first id that stands in the list before; as many as there are where all differ.
std::size_t firstRepeated(const std::vector<Index>& ids)
{
  std::vector<std::pair<Index, std::size_t>> places;
  for (std::size_t k = 0; k < ids.size(); ++k) places.emplace_back(ids[k], k);
  std::sort(places.begin(), places.end());
  std::size_t first = ids.size();
  for (std::size_t k = 1; k < places.size(); ++k)
    if (places[k].first == places[k - 1].first) first = std::min(first, places[k].second);
  return first;
}

/// `key` gives something for each vertex, `count` in all.
Mistake mistakeInList(const Handle& handle, const char* key, std::size_t count)
{
  const VertexIds* vertices = std::get_if<VertexIds>(&handle.select.what);
  if (vertices == nullptr)
    return HandleMistake{".select",
                         fmt::format("\"{}\" has one entry for each vertex of a list; select by \"vertices\"", key)};
  if (const std::size_t k = firstRepeated(vertices->ids); k < vertices->ids.size())
    return HandleMistake{
        fmt::format(".select.vertices[{}]", k),
        fmt::format("vertex {} stands in this list before, and \"{}\" has one entry for each vertex; keep one",
                    vertices->ids[k], key)};
  if (count != vertices->ids.size())
    return HandleMistake{fmt::format(".{}", key),
                         fmt::format("{} given for the {} vertices of \"select\"; give one for each, in their order",
                                     count, vertices->ids.size())};
  return std::nullopt;
}

Mistake mistakeInFrame(const Frame& frame, const std::string& key)
{
  if (frame.x.isZero(0)) return HandleMistake{key + ".x", "a direction cannot be zero in x, y and z"};
  if (frame.y.isZero(0)) return HandleMistake{key + ".y", "a direction cannot be zero in x, y and z"};
  const double sine = frame.x.stableNormalized().cross(frame.y.stableNormalized()).norm();
  if (sine <= kParallel)
    return HandleMistake{key + ".y", R"(is parallel to "x", so the frame could turn about it; give another direction)"};
  return std::nullopt;
}

struct MotionMistake {
  const Handle& handle;

  Mistake operator()(const FrameMotion& motion) const
  {
    if (Mistake mistake = mistakeInFrame(motion.from, ".frame.from")) return mistake;
    if (Mistake mistake = mistakeInFrame(motion.to, ".frame.to")) return mistake;
    const Eigen::Matrix3d R = axesOf(motion.to) * axesOf(motion.from).transpose();
    if (motion.turns != 0 && rotationLog(R).norm() <= kNoRotation)
      return HandleMistake{".frame.turns",
                           R"(the frames have the same axes, so there is no axis to turn about; use "rotate")"};
    return std::nullopt;
  }
  Mistake operator()(const VertexTargets& targets) const
  {
    if (Mistake mistake = mistakeInList(handle, "targets", targets.places.size())) return mistake;
    if (targets.places.size() < kLeastTargets)
      return HandleMistake{
          ".targets", fmt::format(R"(at least {} vertices say how a handle turns, this one has {}; use constraints )"
                                  R"(of type "point" for single vertices)",
                                  kLeastTargets, targets.places.size())};
    return std::nullopt;
  }
  template <class Motion>
  Mistake operator()(const Motion& /*motion*/) const
  {
    return std::nullopt;
  }
};

}  // namespace

std::optional<HandleMistake> findMistake(const Handle& handle)
{
  if (Mistake mistake = std::visit(MotionMistake{handle}, handle.motion)) return mistake;
  return handle.rotations.empty() ? std::nullopt : mistakeInList(handle, "rotations", handle.rotations.size());
}

}  // namespace holdfast

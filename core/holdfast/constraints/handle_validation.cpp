#include "holdfast/constraints/handle_validation.h"

#include <limits>
#include <set>

#include <fmt/format.h>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

using PossibleError = std::optional<HandleError>;

// Fewer points never say how they turn.
constexpr std::size_t kLeastTargets = 3;
// The sine of the angle between x and y from which on y says the plane of both to half of its digits.
constexpr double kParallel = 1e-8;
// The axis of a rotation within rounding of none is noise.
constexpr double kNoRotation = 8 * std::numeric_limits<double>::epsilon();

/// The place of the first id that repeats one before it; their number where all differ.
std::size_t firstRepeated(const std::vector<Index>& ids)
{
  std::set<Index> known;
  std::size_t k = 0;
  while (k < ids.size() && known.insert(ids[k]).second) ++k;
  return k;
}

/// `key` gives something for each vertex, `count` in all.
PossibleError errorInList(const HandleConstraint& handle, const char* key, std::size_t count)
{
  const VertexIds* vertices = std::get_if<VertexIds>(&handle.select.what);
  if (vertices == nullptr)
    return HandleError{".select",
                       fmt::format("\"{}\" has one entry for each vertex of a list; select by \"vertices\"", key)};
  if (const std::size_t k = firstRepeated(vertices->ids); k < vertices->ids.size())
    return HandleError{
        fmt::format(".select.vertices[{}]", k),
        fmt::format("vertex {} stands in this list before, and \"{}\" has one entry for each vertex; keep one",
                    vertices->ids[k], key)};
  if (count != vertices->ids.size())
    return HandleError{fmt::format(".{}", key),
                       fmt::format("{} given for the {} vertices of \"select\"; give one for each, in their order",
                                   count, vertices->ids.size())};
  return std::nullopt;
}

PossibleError errorInFrame(const Frame& frame, const std::string& key)
{
  if (frame.x.isZero(0)) return HandleError{key + ".x", "a direction cannot be zero in x, y and z"};
  if (frame.y.isZero(0)) return HandleError{key + ".y", "a direction cannot be zero in x, y and z"};
  const double sine = frame.x.stableNormalized().cross(frame.y.stableNormalized()).norm();
  if (sine <= kParallel)
    return HandleError{key + ".y", R"(is parallel to "x", so the frame could turn about it; give another direction)"};
  return std::nullopt;
}

struct MotionError {
  const HandleConstraint& handle;

  PossibleError operator()(const FrameMotion& motion) const
  {
    if (PossibleError error = errorInFrame(motion.from, ".frame.from")) return error;
    if (PossibleError error = errorInFrame(motion.to, ".frame.to")) return error;
    const Eigen::Matrix3d R = axesOf(motion.to) * axesOf(motion.from).transpose();
    if (motion.turns != 0 && rotationLog(R).norm() <= kNoRotation)
      return HandleError{".frame.turns",
                         R"(the frames have the same axes, so there is no axis to turn about; use "rotate")"};
    return std::nullopt;
  }
  PossibleError operator()(const VertexTargets& targets) const
  {
    if (PossibleError error = errorInList(handle, "targets", targets.places.size())) return error;
    if (targets.places.size() < kLeastTargets)
      return HandleError{".targets",
                         fmt::format(R"(at least {} vertices say how a handle turns, this one has {}; use constraints )"
                                     R"(of type "point" for single vertices)",
                                     kLeastTargets, targets.places.size())};
    return std::nullopt;
  }
  template <class Motion>
  PossibleError operator()(const Motion& /*motion*/) const
  {
    return std::nullopt;
  }
};

}  // namespace

std::optional<HandleError> validateHandle(const HandleConstraint& handle)
{
  if (PossibleError error = std::visit(MotionError{handle}, handle.motion)) return error;
  return handle.rotations.empty() ? std::nullopt : errorInList(handle, "rotations", handle.rotations.size());
}

}  // namespace holdfast

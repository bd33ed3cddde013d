#pragma once
/// What a deformation made of the part: numbers and a verdict. The equations may hold, and the part be spoilt all the
/// same. docs/math.md defines the numbers, docs/errors.md the findings.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

enum class ResultStatus {
  NotMeasured,  ///< nothing was solved
  Fine,         ///< nothing was found in what was looked at
  Doubtful      ///< `ResultVerdict::warnings` names the findings
};

/// The name in reports: "not measured", "fine", "doubtful".
[[nodiscard]] std::string_view name(ResultStatus status);

/// How many times as large as at rest things of one kind are.
struct RatioVerdict {
  double least = 1;
  double most = 1;
  Index shrunk = 0;  ///< how many are below their limit, and their change can be seen
  Index grown = 0;   ///< above it
};

/// Vertices that stand out by far more than constraints near them ask for.
struct OvershootVerdict {
  Index vertices = 0;
  double largest = 0;  ///< how far a vertex stands out at most, of those that points of faces and edges hang on
  double asked = 0;    ///< what constraints near such a vertex ask for at most; 0 where there are none
};

/// The one motion that the targets of a part's points come nearest to.
struct TargetMotion {
  double degrees = 0;
  Vector3 axis = Vector3::Zero();  ///< of length 1; zero for no rotation
  double scale = 1;
  Vector3 shift = Vector3::Zero();  ///< of the mean of the points, model units
  double moved = 0;  ///< of targets from points without the mean shift, root of the mean square, model units
  double left = 0;   ///< of targets from what the motion makes of the points, the same
};

/// Lengths in model units.
struct ResultVerdict {
  ResultStatus status = ResultStatus::NotMeasured;
  std::vector<std::string> warnings;  ///< kinds of findings that are about the result
  double foldDegrees = 0;  ///< the largest change of the angle between faces that folds them; 0 without folds
  Index foldedFaces = 0;
  RatioVerdict edges;
  RatioVerdict areas;
  RatioVerdict volumes;  ///< of closed parts
  OvershootVerdict overshoot;
  // What takes longer than a frame of a drag; not there until it was looked for.
  std::optional<Index> invertedFaces;
  std::optional<Index> crossingFaces;
  std::vector<TargetMotion> targetMotions;  ///< of the parts with three points or more
};

}  // namespace holdfast

#pragma once
/// Numbers and a verdict say what a deformation made of the part. The equations may hold, and the part be spoilt all
/// the same. docs/math.md defines the numbers, docs/errors.md the findings.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// The verdict on a result.
enum class ResultStatus {
  NotMeasured,  ///< nothing was solved
  Fine,         ///< nothing doubtful was found in what was looked at
  Doubtful      ///< `ResultVerdict::warnings` names the findings
};

/// Returns the name of a status in reports: "not measured", "fine", "doubtful".
[[nodiscard]] std::string_view name(ResultStatus status);

/// The sizes of things of one kind, as multiples of those at rest.
struct RatioVerdict {
  double least = 1;
  double most = 1;
  Index shrunk = 0;  ///< how many are below their limit; of edges and areas only where the change is seen
  Index grown = 0;   ///< how many are above their limit, with the same exception
};

/// Vertices that stand out by far more than constraints near them ask for.
struct OvershootVerdict {
  Index vertices = 0;
  /// The distance by which a vertex stands out at most, beyond how it does at rest. Vertices count on which points of
  /// faces and edges hang.
  double largest = 0;
  double asked = 0;  ///< the largest difference that constraints near `vertices` ask for; 0 where there are none
};

/// The one motion that the targets of a part's points come nearest to. It rotates and scales the points about their
/// mean, and shifts them.
struct TargetMotion {
  double degrees = 0;
  Vector3 axis = Vector3::Zero();  ///< of length 1; zero where there is no rotation
  double scale = 1;
  Vector3 shift = Vector3::Zero();  ///< how far the mean of the points moves, model units
  double moved = 0;  ///< how far targets lie from points without `shift`: the root of the mean square, model units
  double left = 0;   ///< how far targets lie from what the motion makes of the points: the same mean
};

/// The verdict, with all lengths in model units.
///
///     const ResultVerdict& verdict = result.report.result;
///     std::cout << name(verdict.status) << ", edges at most " << verdict.edges.most << " times as long\n";
///     for (const std::string& kind : verdict.warnings) std::cerr << "warning: " << kind << '\n';
///     if (verdict.invertedFaces.value_or(0) > 0) std::cerr << *verdict.invertedFaces << " faces are inverted\n";
struct ResultVerdict {
  ResultStatus status = ResultStatus::NotMeasured;
  std::vector<std::string> warnings;  ///< the kinds of the findings that are about the result
  double foldDegrees = 0;  ///< the largest change of the angle between faces that folds them; 0 without folds
  Index foldedFaces = 0;
  RatioVerdict edges;
  RatioVerdict areas;
  RatioVerdict volumes;  ///< of closed parts; negative where a part is inside out
  OvershootVerdict overshoot;
  // These take longer to look for than a frame of a drag. They are absent until they were looked for.
  std::optional<Index> invertedFaces;
  std::optional<Index> crossingFaces;
  std::vector<TargetMotion> targetMotions;  ///< of the parts with three points or more
};

}  // namespace holdfast

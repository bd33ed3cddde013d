#pragma once
/// Checks of the results of one mesh. Some can be afforded in each frame of a drag; others wait until it rests.

#include <optional>

#include <holdfast/threads/progress.h>
#include <holdfast/verdict/crossing_faces.h>
#include <holdfast/verdict/result_findings.h>
#include <holdfast/verdict/result_verdict.h>

namespace holdfast {

/// The numbers of a result, and the findings that they lead to.
struct CheckedResult {
  ResultVerdict verdict;
  Findings findings;
};

class ResultCheck {
 public:
  /// `mesh` and `atRest` must stay alive as long as this. O(T log T).
  ResultCheck(const SolverMesh& mesh, const Positions& atRest);

  /// Checks folds, edges, areas, volumes and vertices that overshoot. `now` has the finite positions of the file's
  /// vertices under `system`. O(T + rows), over all cores.
  [[nodiscard]] CheckedResult ofFrame(const Positions& now, const ConstraintSystem& system);

  /// Adds the rest to `verdict`, which is that of a frame, and returns the findings about it. These are about faces
  /// that are inverted or cross others, about targets, and about regions that stay level. O(T log T), over all cores.
  /// Throws what `progress` throws.
  [[nodiscard]] Findings addRest(ResultVerdict& verdict, const Positions& now, const ConstraintSystem& system,
                                 RotationSource rotations, Progress& progress = noProgress());

 private:
  [[nodiscard]] DeformedSurface surfaceAt(const Positions& now) const { return {mesh_, rest_, atRest_, now}; }

  const SolverMesh& mesh_;
  const Positions& atRest_;
  RestSurface rest_;
  std::optional<OvershootSearch> overshoot_;  // made where points first hang on several vertices
  std::optional<CrossingSearch> crossings_;   // made when it is first needed
};

/// Enters the kinds of `findings` about a result in its verdict, and what they make of it.
void takeOver(const Findings& findings, ResultVerdict& verdict);

/// Returns targets as `ResultVerdict` has them.
[[nodiscard]] std::vector<TargetMotion> targetMotionsOf(const std::vector<WholeMotion>& motions);

}  // namespace holdfast

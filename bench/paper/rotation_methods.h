#pragma once
/// \file
/// One task by several ways to choose rotations, measured.

#include "bench/paper/task_measures.h"

namespace holdfast::paper {

/// None, given, found over edges, found smooth.
struct RotationMethod {
  const char* name;
  RotationSource source;
  HandleRotation handle;
};
[[nodiscard]] const std::vector<RotationMethod>& rotationMethods();

struct RotationOutcome {
  double edges = 0;   ///< `edgeError`
  double volume = 0;  ///< `volumeError`
  DihedralError dihedral;
  double residual = 0;
  int iterations = 0;  ///< where rotations are found
  double seconds = 0;  ///< from mesh to result
};

/// Throws std::runtime_error where the task is not solved, or rotations are not found to `change`.
[[nodiscard]] RotationOutcome outcomeOf(const SurveyTask& task, const RotationMethod& method,
                                        double change = kFoundChange);

}  // namespace holdfast::paper

#pragma once
/// \file
/// How far a deformed mesh is from its rest shape, up to a rigid motion.

#include "bench/paper/survey_tasks.h"

namespace holdfast::paper {

/// Root of the mean square of the relative changes of length of all edges of all triangles.
[[nodiscard]] double edgeError(const SurveyTask& task, const Positions& deformed);

/// Relative change of the volume that the triangles enclose; of no meaning for open meshes.
[[nodiscard]] double volumeError(const SurveyTask& task, const Positions& deformed);

/// Changes of the angle between the normals of two neighbours, in degrees.
struct DihedralError {
  double rms = 0;  ///< root of the mean square over inner edges
  double largest = 0;
};
[[nodiscard]] DihedralError dihedralError(const SurveyTask& task, const Positions& deformed);

/// Largest distance of a fixed vertex or one of the handle to its place, as a share of the diagonal.
[[nodiscard]] double residual(const SurveyTask& task, const Positions& deformed);

}  // namespace holdfast::paper

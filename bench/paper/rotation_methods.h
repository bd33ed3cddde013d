#pragma once
/// \file
/// Ways to find the shape of a task, which differ in their rotations, and what comes of each.

#include <functional>
#include <string>
#include <vector>

#include "bench/paper/task_measures.h"

namespace holdfast::paper {

struct RotationOutcome {
  double edges = 0;   ///< `edgeError`
  double volume = 0;  ///< `volumeError`
  DihedralError dihedral;
  double residual = 0;
  int iterations = 0;  ///< where rotations are found
  double seconds = 0;  ///< from mesh to result
  bool isConverged = true;
};

[[nodiscard]] RotationOutcome measured(const SurveyTask& task, const Positions& deformed);

/// Tasks that differ in the places of their handle alone, in their order.
using Motion = std::vector<SurveyTask>;

struct RotationMethod {
  std::string name;
  /// The outcome of each task of the motion. Methods that iterate end where no vertex moves by more than `change`, a
  /// share of the diagonal. Throws std::runtime_error where a task is not solved.
  std::function<std::vector<RotationOutcome>(const Motion& motion, double change)> run;
};

/// None, given, found over edges, found smooth. Each task starts from the rest shape; rotations that are not found
/// throw.
[[nodiscard]] std::vector<RotationMethod> ownMethods();

/// The three methods of CGAL's Surface_mesh_deformation on one thread. Each task starts from the shape of the one
/// before, and its seconds and iterations count from the first one. Throws std::runtime_error where the build has no
/// CGAL.
[[nodiscard]] std::vector<RotationMethod> cgalMethods();

/// Of the headers that were compiled. Throws as `cgalMethods` does.
[[nodiscard]] std::string cgalVersion();

/// Returns the methods of both.
[[nodiscard]] std::vector<RotationMethod> allRotationMethods();

}  // namespace holdfast::paper

#pragma once
/// \file
/// Every experiment: one function each, in a source of its own.

#include <string>
#include <vector>

#include "bench/paper/rotation_methods.h"
#include "bench/paper/section.h"
#include "bench/paper/workbench.h"

namespace holdfast::paper {

/// What an experiment needs besides the project.
enum class Needs {
  Nothing,  ///< seconds
  Time,     ///< minutes, or a quiet machine
  Models    ///< what scripts/paper.sh fetches: meshes, the headers of CGAL
};

struct Experiment {
  const char* title;  ///< of its section
  Needs needs;
  Section (*run)(const Workbench& bench);  ///< returns the section without its title
};

/// All of them, in the order of the page.
[[nodiscard]] const std::vector<Experiment>& allExperiments();

/// The section with its title.
[[nodiscard]] Section run(const Experiment& experiment, const Workbench& bench);

[[nodiscard]] Section cotangentDefinition(const Workbench& bench);     ///< Fig. 1
[[nodiscard]] Section unsymmetricSubdivision(const Workbench& bench);  ///< Fig. 2
[[nodiscard]] Section badlyShapedTriangles(const Workbench& bench);    ///< Fig. 3
[[nodiscard]] Section rotatedNormals(const Workbench& bench);          ///< Fig. 4 and 5
[[nodiscard]] Section rotationSpheres(const Workbench& bench);         ///< Fig. 6
[[nodiscard]] Section rigidEyes(const Workbench& bench);               ///< Fig. 7
[[nodiscard]] Section keptDistance(const Workbench& bench);            ///< Fig. 8
[[nodiscard]] Section solversOnBadTriangles(const Workbench& bench);   ///< Fig. 9
[[nodiscard]] Section deformedModels(const Workbench& bench);          ///< Fig. 10, meshes of the project
[[nodiscard]] Section deformedScans(const Workbench& bench);           ///< Fig. 10, fetched meshes
[[nodiscard]] Section conflictingPoints(const Workbench& bench);       ///< Fig. 11
[[nodiscard]] Section hardAgainstSoft(const Workbench& bench);         ///< Fig. 12
[[nodiscard]] Section stabilityOfOwnMeshes(const Workbench& bench);    ///< Table 1, meshes of the project
[[nodiscard]] Section stabilityOfModels(const Workbench& bench);       ///< Table 1, fetched meshes
[[nodiscard]] Section stabilityOfDragon(const Workbench& bench);       ///< Table 1, fetched mesh of 438,000 vertices
[[nodiscard]] Section causesOfInstability(const Workbench& bench);     ///< "future work"
[[nodiscard]] Section manyConstraints(const Workbench& bench);         ///< "future work"
[[nodiscard]] Section bendsAndTwists(const Workbench& bench);          ///< rotation methods
[[nodiscard]] Section surveyTasks(const Workbench& bench);             ///< rotation methods
[[nodiscard]] Section surveyScans(const Workbench& bench);             ///< rotation methods, seconds

/// The tasks of the survey by these methods, without a result.
[[nodiscard]] Section tasksBy(const std::vector<RotationMethod>& methods);

/// Fig. 12 on generated meshes of so many thousand vertices.
[[nodiscard]] Section costsOfMeshes(const Workbench& bench, const std::vector<std::string>& thousands);

}  // namespace holdfast::paper

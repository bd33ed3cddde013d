#pragma once
/// \file
/// Every experiment: one function each, in a source of its own.

#include <vector>

#include "bench/paper/section.h"
#include "bench/paper/workbench.h"

namespace holdfast::paper {

/// What an experiment needs besides the project.
enum class Needs {
  Nothing,  ///< seconds
  Time,     ///< minutes, or a quiet machine
  Models    ///< meshes that scripts/paper.sh fetches
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
[[nodiscard]] Section stabilityOfOwnMeshes(const Workbench& bench);    ///< Table 1
[[nodiscard]] Section stabilityOfModels(const Workbench& bench);       ///< Table 1
[[nodiscard]] Section causesOfInstability(const Workbench& bench);     ///< "future work"
[[nodiscard]] Section manyConstraints(const Workbench& bench);         ///< "future work"
[[nodiscard]] Section bendsAndTwists(const Workbench& bench);          ///< rotation methods
[[nodiscard]] Section surveyTasks(const Workbench& bench);             ///< rotation methods

}  // namespace holdfast::paper

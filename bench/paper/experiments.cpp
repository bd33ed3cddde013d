#include "bench/paper/experiments.h"

namespace holdfast::paper {

const std::vector<Experiment>& allExperiments()
{
  static const std::vector<Experiment> kAll{
      {"Figure 1: cotangents and areas", Needs::Nothing, cotangentDefinition},
      {"Figure 2: unsymmetric subdivision", Needs::Nothing, unsymmetricSubdivision},
      {"Table 1: solvers, weights and precision", Needs::Nothing, stabilityOfOwnMeshes},
      {"Table 1: solvers, weights and precision, on the models of the paper", Needs::Models, stabilityOfModels},
      {"Beyond the paper: causes of instability", Needs::Nothing, causesOfInstability},
      {"Beyond the paper: many constraints of two and three variables", Needs::Time, manyConstraints},
      {"Beyond the paper: rotations by bends and twists", Needs::Time, bendsAndTwists},
      {"Beyond the paper: rotations in tasks of the survey", Needs::Nothing, surveyTasks},
  };
  return kAll;
}

Section run(const Experiment& experiment, const Workbench& bench)
{
  Section section = experiment.run(bench);
  section.title = experiment.title;
  return section;
}

}  // namespace holdfast::paper

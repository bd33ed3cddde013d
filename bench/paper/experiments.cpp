#include "bench/paper/experiments.h"

namespace holdfast::paper {

const std::vector<Experiment>& allExperiments()
{
  static const std::vector<Experiment> kAll{
      {"Figure 1: cotangents and areas", Needs::Nothing, cotangentDefinition},
      {"Figure 2: unsymmetric subdivision", Needs::Nothing, unsymmetricSubdivision},
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

#include "bench/paper/experiments.h"

namespace holdfast::paper {

const std::vector<Experiment>& allExperiments()
{
  static const std::vector<Experiment> kAll{
      {"Figure 1: cotangents and areas", Needs::Nothing, cotangentDefinition},
      {"Figure 2: unsymmetric subdivision", Needs::Nothing, unsymmetricSubdivision},
      {"Figure 3: badly shaped triangles", Needs::Nothing, badlyShapedTriangles},
      {"Figures 4 and 5: rotated normals", Needs::Nothing, rotatedNormals},
      {"Figure 6: rotations on the sphere", Needs::Nothing, rotationSpheres},
      {"Figure 7: rigid eyes", Needs::Nothing, rigidEyes},
      {"Figure 8: a kept distance", Needs::Nothing, keptDistance},
      {"Figure 9: solvers on badly shaped triangles", Needs::Nothing, solversOnBadTriangles},
      {"Figure 10: deformed models", Needs::Nothing, deformedModels},
      {"Figure 10, continued: scans", Needs::Models, deformedScans},
      {"Figure 11: conflict, compromise, resolution", Needs::Nothing, conflictingPoints},
      {"Figure 12: hard against soft", Needs::Time, hardAgainstSoft},
      {"Table 1: solvers, weights and precision", Needs::Nothing, stabilityOfOwnMeshes},
      {"Table 1, continued: scans and a CAD mesh", Needs::Models, stabilityOfModels},
      {"Table 1, continued: the Dragon", Needs::Models, stabilityOfDragon},
      {"Beyond the paper: causes of instability", Needs::Nothing, causesOfInstability},
      {"Beyond the paper: many constraints of two and three variables", Needs::Time, manyConstraints},
      {"Beyond the paper: bends and twists", Needs::Models, bendsAndTwists},
      {"Beyond the paper: tasks of the survey", Needs::Models, surveyTasks},
      {"Beyond the paper: rotations found on large meshes", Needs::Models, surveyScans},
  };
  return kAll;
}

Section run(const Experiment& experiment, const Workbench& bench)
{
  Section section = experiment.run(bench);
  section.title = experiment.title;
  if (section.commands.empty()) section.commands.push_back("scripts/paper.sh \"" + section.title + '"');
  return section;
}

}  // namespace holdfast::paper

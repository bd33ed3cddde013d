// Names the constraints that contradict others, and what would mend each conflict. Ends with 4 where there are any.
//   read_conflicts MESH CONSTRAINTS
#include <iostream>

#include <holdfast/holdfast.h>

int main(int argc, char** argv)
try {
  if (argc != 3) throw std::runtime_error("read_conflicts MESH CONSTRAINTS");
  const holdfast::Model model = holdfast::makeModel(holdfast::readMesh(argv[1]).mesh, argv[1]);
  const holdfast::Report report = holdfast::diagnoseConstraints(model, holdfast::readConstraints(argv[2]), argv[2]);
  int conflicts = 0;
  for (const holdfast::ConstraintOutcome& outcome : report.constraints)
    for (const holdfast::ConflictSet& set : outcome.conflictSets) {
      if (!set.isConflict) continue;
      ++conflicts;
      std::cout << outcome.name << " is " << set.gap.norm() << " away from what these imply:";
      for (const std::string& name : set.with) std::cout << ' ' << name;
      std::cout << "; disable " << set.disable << '\n';
    }
  return conflicts == 0 ? 0 : 4;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}

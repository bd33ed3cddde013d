// Moves a target in small steps, as a drag does: one factorisation, and one solution for each frame.
//   drag_in_a_loop MESH CONSTRAINTS NAME      NAME: of a point constraint
#include <iostream>

#include <holdfast/holdfast.h>

int main(int argc, char** argv)
try {
  if (argc != 4) throw std::runtime_error("drag_in_a_loop MESH CONSTRAINTS NAME");
  holdfast::Deformer deformer(holdfast::makeModel(holdfast::readMesh(argv[1]).mesh, argv[1]));
  deformer.setConstraints(holdfast::readConstraints(argv[2]));
  auto& point = std::get<holdfast::PointConstraint>(deformer.constraint(argv[3]).what);
  const holdfast::Vector3 start = std::get<holdfast::Target>(point.to).place;
  for (int frame = 0; frame < 5; ++frame) {
    deformer.setTarget(argv[3], start + 0.1 * frame * holdfast::Vector3::UnitZ());
    const holdfast::SolveReport report = deformer.deform().report.solve;
    std::cout << "frame " << frame << ": " << report.message << '\n';
    if (report.status == holdfast::SolveStatus::Failed) return 1;
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}

#include <iostream>

#include <holdfast/holdfast.h>

int main()
try {
  const holdfast::MeshDocument document = holdfast::readMesh("bracket.obj");
  const holdfast::Model model = holdfast::makeModel(document.mesh, "bracket.obj");
  const holdfast::DeformResult result = holdfast::deform(model, holdfast::readConstraints("bracket.constraints.json"));
  std::cout << result.report.solve.message << '\n';
  if (result.report.solve.status == holdfast::SolveStatus::Failed) return 1;
  holdfast::writeMesh("deformed.obj", document, result.positions);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}

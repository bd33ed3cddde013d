#include <cstdlib>
#include <fstream>

#include <vtkNew.h>

#include <holdfast/holdfast.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h>
#include <holdfast/widgets/mesh/poly_data.h>

/// Deforms the bracket, writes fields over it, and expects that VTK would draw the deformed positions of that file. The
/// name of a widget is that of its class.
int main()
{
  const holdfast::Model model = holdfast::makeModel(holdfast::readMesh("bracket.obj").mesh, "bracket.obj");
  const holdfast::ConstraintList constraints = holdfast::readConstraints("bracket.constraints.json");
  const holdfast::DeformResult result = holdfast::deform(model, constraints);
  const std::vector<holdfast::Field> fields = holdfast::fieldsOf(model, result);
  std::ofstream("fields.vtp") << holdfast::fieldsToVtp(model.mesh, result.positions, fields, {}).bytes;
  const holdfast::Mesh read = holdfast::readMesh("fields.vtp").mesh;
  const holdfast::Positions written = holdfast::positionsOf(*holdfast::toPolyData(read, read.positions));
  const vtkNew<vtkHoldfastGizmoWidget> gizmo;
  const bool isNamed = gizmo->IsA("vtkHoldfastGizmoWidget") != 0;
  return isNamed && written == result.positions && written != model.mesh.positions ? EXIT_SUCCESS : EXIT_FAILURE;
}

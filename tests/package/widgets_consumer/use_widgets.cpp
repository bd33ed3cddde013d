#include <cstdlib>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/fields.h>
#include <holdfast/io/files/output_file.h>
#include <holdfast/widgets/files/any_mesh_file.h>
#include <holdfast/widgets/files/poly_data_file.h>

/// Deforms the bracket, writes fields over it, and expects to read the deformed positions from that file.
int main()
{
  const holdfast::Model model = holdfast::makeModel(holdfast::readAnyMesh("bracket.obj").mesh, "bracket.obj");
  const holdfast::ConstraintList constraints = holdfast::readConstraints("bracket.constraints.json");
  holdfast::NoProgress progress;
  const holdfast::DeformResult result = holdfast::deform(model, constraints, "bracket.constraints.json", {}, progress);
  const std::vector<holdfast::Field> fields = holdfast::fieldsOf(model, result);
  holdfast::OutputFile("fields.vtp", holdfast::fieldsToVtp(model.mesh, result.positions, fields, {}).bytes).commit();
  const holdfast::Positions written = holdfast::readAnyMesh("fields.vtp").mesh.positions;
  return written == result.positions && written != model.mesh.positions ? EXIT_SUCCESS : EXIT_FAILURE;
}

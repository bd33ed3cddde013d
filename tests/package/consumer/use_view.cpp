#include <cstdlib>

#include <holdfast/view/field_file.h>

int main()
{
  holdfast::Mesh mesh{holdfast::Positions(3, 3), {}};
  mesh.positions << 0, 0, 0, 3, 0, 0, 0, 4, 0;
  mesh.faces.add({0, 1, 2});
  return holdfast::fieldsToVtp(mesh, mesh.positions, {}, {}).bytes.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}

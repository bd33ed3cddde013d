#include <cstdlib>

#include <holdfast/base/error.h>
#include <holdfast/mesh/bounding_box.h>
#include <holdfast/mesh/mesh.h>

int main()
{
  holdfast::Mesh mesh{holdfast::Positions(3, 3), {}};
  mesh.positions << 0, 0, 0, 3, 0, 0, 0, 4, 0;
  mesh.faces.add({0, 1, 2});
  try {
    throw holdfast::InputError({"mesh.obj", 3, ""}, "exceptions cross the library's border");
  } catch (const holdfast::InputError& error) {
    if (error.location().line != 3) return EXIT_FAILURE;
  }
  return holdfast::boundingBoxDiagonal(mesh.positions) == 5 ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Deforms a mesh that is given as matrices: positions (n x 3) and triangles (m x 3).
#include <iostream>

#include <holdfast/holdfast.h>

int main()
{
  // A strip of 2 x 10 squares, one unit wide.
  holdfast::Positions positions(33, 3);
  holdfast::Triangles triangles(40, 3);
  for (int k = 0; k < 33; ++k) positions.row(k) << k / 3, k % 3, 0;
  for (int k = 0; k < 20; ++k) {
    const int corner = k / 2 * 3 + k % 2;
    triangles.row(2 * k) << corner, corner + 3, corner + 1;
    triangles.row(2 * k + 1) << corner + 1, corner + 3, corner + 4;
  }
  const holdfast::Model model = holdfast::makeModel({positions, holdfast::Polygons(triangles)});

  // One end is fixed; the midpoint of an edge at the other end goes to a place.
  holdfast::ConstraintList list;
  list.constraints = {
      {"end", true, holdfast::FixedConstraint{{holdfast::VertexIds{{0, 1, 2, 3, 4, 5}}}}},
      {"tip", true, holdfast::PointConstraint{holdfast::AtEdge{30, 31, 0.5}, holdfast::Target{{9, 0.5, 3}}}}};
  const holdfast::DeformResult result = holdfast::deform(model, list);

  std::cout << result.report.solve.message << '\n' << result.positions.bottomRows(3) << '\n';
  return result.report.solve.status == holdfast::SolveStatus::Ok ? 0 : 1;
}

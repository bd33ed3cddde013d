// Fig. 6: the rotations of a surface on the sphere of quaternions, between two, three and four that are given.

#include <algorithm>
#include <string>
#include <vector>

#include <Eigen/QR>
#include <fmt/format.h>

#include <holdfast/widgets/rotation_sphere/rotation_projection.h>

#include "bench/paper/experiments.h"
#include "bench/paper/panels.h"

namespace holdfast::paper {
namespace {

constexpr const char* kPlateWithDiscs = "data/plate_unsymmetric.off";

/// Four discs near the corners, rotated by 40 degrees about axes that span all of space.
ConstraintList fourHandles()
{
  const auto handle = [](const char* name, double x, double y, const Vector3& axis) {
    return Constraint{name, true,
                      HandleConstraint{{InSphere{{x, y, 0}, 9}}, AxisRotation{axis, 40, {}}, Vector3(0, 0, 8), {}}};
  };
  return {"mm",
          {handle("first", 24, 24, {1, 0, 0}), handle("second", 76, 24, {-0.5, 0.87, 0}),
           handle("third", 76, 76, {-0.5, -0.87, 0}), handle("fourth", 24, 76, {0, 0, 1})}};
}

/// How far rotations lie outside the smallest convex set that holds the given ones, which are independent.
struct Outside {
  double leastWeight = 1;  ///< of all weights of the given ones; negative outside
  double offSpan = 0;      ///< the largest distance from their line, plane or space, radians
};

Outside outsideOf(const Columns3& rotations, const std::vector<BoundaryRotation>& given)
{
  const Index count = static_cast<Index>(given.size());
  Eigen::MatrixXd corners(4, count);  // the last row: weights have the sum 1
  for (Index k = 0; k < count; ++k) corners.col(k) << given[k].q, 1;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(corners);
  Outside outside;
  for (const auto& q : rotations.rowwise()) {
    const Eigen::Vector4d place(q.x(), q.y(), q.z(), 1);
    const Eigen::VectorXd weights = qr.solve(place);
    outside.leastWeight = std::min(outside.leastWeight, weights.minCoeff());
    outside.offSpan = std::max(outside.offSpan, (corners * weights - place).norm());
  }
  return outside;
}

}  // namespace

Section rotationSpheres(const Workbench& bench)
{
  const std::vector<std::pair<std::string, std::string>> lists{
      {"two", "data/plate_unsymmetric.two_handles.constraints.json"},
      {"three", "data/plate_unsymmetric.three_handles.constraints.json"},
      {"four", bench.write("figure_06_four.constraints.json", fourHandles())}};
  Section section;
  section.paper =
      "rotations of the free vertices on the sphere of unit quaternions: on an arc between two boundary rotations, in "
      "a triangle of three.";
  section.method =
      "the plate with discs that rotate about different axes, also four of them, which span a tetrahedron. Each "
      "logarithm q is written as a mean of the given ones: weights of sum 1, none of them negative inside.";
  Table table{{"given rotations", "least weight of any vertex", "off their arc, plane or space, radians"}, {}};
  std::vector<Picture> tiles;
  std::vector<Picture> spheres;
  for (const auto& [name, list] : lists) {
    section.commands.push_back(bench.deform("figure_06_" + name, kPlateWithDiscs, list).command);
    const Deformed shown = deformed(kPlateWithDiscs, list);
    const Outside outside = outsideOf(shown.result.rotations, boundaryRotations(shown.result));
    section.numbers[name + " least weight"] = outside.leastWeight;
    section.numbers[name + " off span"] = outside.offSpan;
    table.rows.push_back({name, fmt::format("{:.1e}", outside.leastWeight), fmt::format("{:.1e}", outside.offSpan)});
    const PictureSize size{320, 240};
    const Panel panel{name, &shown, ColorBy::Angle, MeshEdges::Sharp, RestGhost::Hidden, {}};
    tiles.push_back(drawnPanels({panel}, {.back = {0.3, -1.5, 1.2}, .up = {0, 0, 1}, .panel = size}).front());
    spheres.push_back(drawnSphere("", shown, size));
  }
  tiles.insert(tiles.end(), spheres.begin(), spheres.end());
  section.tables = {table};
  section.result = "Up to rounding, no rotation lies outside the given ones.";
  const std::string path = bench.picture("figure_06.png");
  writeFile(path, toPng(tiled(tiles, 3), path));
  section.pictures = {
      {"figure_06.png", "Plates with two, three and four given rotations, and their rotations on the sphere", true}};
  return section;
}

}  // namespace holdfast::paper

// Fig. 1: the angles and the area of the cotangent weights (10), drawn from what the code computes.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <holdfast/deform/model.h>
#include <holdfast/operators/cotangents.h>
#include <holdfast/operators/operators.h>

#include "bench/paper/experiments.h"
#include "bench/paper/svg.h"

namespace holdfast::paper {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// A vertex among `radii.size()` neighbours, in a plane: vertex 0 in the middle.
Model fan(const std::vector<double>& radii, const std::vector<double>& degrees)
{
  const Index count = static_cast<Index>(radii.size());
  Mesh mesh{Positions::Zero(count + 1, 3), {}};
  for (Index k = 0; k < count; ++k) {
    const double angle = degrees[k] / kDegrees;
    mesh.positions.row(k + 1) << radii[k] * std::cos(angle), radii[k] * std::sin(angle), 0;
    mesh.faces.add({0, k + 1, (k + 1) % count + 1});
  }
  return makeModel(std::move(mesh), "fan");
}

/// From the cotangents at the corners of a triangle, the first of which is the vertex in the middle.
Point2 circumcenter(const Positions& positions, const Triangle& triangle, const CornerCotangents& cotangents)
{
  Eigen::Vector3d weights;
  for (int k = 0; k < 3; ++k) weights[k] = 2 * cotangents[k] / (1 + cotangents[k] * cotangents[k]);  // sin of twice it
  weights /= weights.sum();
  Point2 center = Point2::Zero();
  for (int k = 0; k < 3; ++k) center += weights[k] * positions.row(triangle[k]).head<2>().transpose();
  return center;
}

double polygonArea(const std::vector<Point2>& corners)
{
  double twice = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point2& a = corners[k];
    const Point2& b = corners[(k + 1) % corners.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/// What the code says of a fan.
struct Ring {
  explicit Ring(const Model& model)
      : positions(model.solverMesh.rest),
        triangles(model.solverMesh.triangles),
        cotangents(cornerCotangents(positions, triangles)),
        literalArea(literalVoronoiAreas(positions, triangles)[0]),
        mixedArea(mixedVoronoiAreas(positions, triangles)[0])
  {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      cell.push_back(circumcenter(positions, triangles[t], cotangents[t]));
      trianglesArea += polygonArea({corner(t, 0), corner(t, 1), corner(t, 2)});
    }
  }

  [[nodiscard]] Point2 corner(std::size_t triangle, int k) const
  {
    return positions.row(triangles[triangle][k]).head<2>();
  }
  /// The angle across the edge to neighbour j, on the left and on the right of it, in radians.
  [[nodiscard]] double left(std::size_t j) const { return std::atan2(1, cotangents[j][2]); }
  [[nodiscard]] double right(std::size_t j) const { return std::atan2(1, cotangents[before(j)][1]); }
  /// Equation (10): the cotangent weights by the angles and the area of this ring.
  [[nodiscard]] double weight(std::size_t j) const
  {
    return (cotangents[j][2] + cotangents[before(j)][1]) / (2 * literalArea);
  }
  [[nodiscard]] std::size_t before(std::size_t j) const { return (j + triangles.size() - 1) % triangles.size(); }

  Positions positions;
  std::vector<Triangle> triangles;
  std::vector<CornerCotangents> cotangents;
  double literalArea;
  double mixedArea;
  std::vector<Point2> cell;
  double trianglesArea = 0;
};

/// To pixels.
Point2 placed(const Point2& point)
{
  return {290 + 210 * point.x(), 250 - 210 * point.y()};
}

std::vector<Point2> placed(std::vector<Point2> points)
{
  for (Point2& point : points) point = placed(point);
  return points;
}

/// The arc of the angle at `apex`, and its name and size in the middle of it.
void drawAngle(Svg& svg, const Point2& apex, const Point2& from, const Point2& to, const std::string& name)
{
  constexpr int kSteps = 24;
  constexpr double kRadius = 0.2;
  const Point2 first = (from - apex).normalized();
  const double angle = std::atan2(first.x() * (to - apex).y() - first.y() * (to - apex).x(), first.dot(to - apex));
  std::vector<Point2> arc;
  for (int k = 0; k <= kSteps; ++k)
    arc.push_back(placed(Point2(apex + kRadius * (Eigen::Rotation2Dd(angle * k / kSteps) * first))));
  svg.polyline(arc, {"#d55e00", 2, "none", ""});
  const Point2 middle = placed(Point2(apex + 1.75 * kRadius * (Eigen::Rotation2Dd(angle / 2) * first)));
  svg.text(middle, fmt::format("{} = {:.1f}&#176;", name, std::abs(angle) * kDegrees), Anchor::Middle, 14, "#b34700");
}

std::string drawing(const Ring& ring)
{
  Svg svg(600, 470);
  for (std::size_t t = 0; t < ring.triangles.size(); ++t)
    svg.polygon(placed({ring.corner(t, 0), ring.corner(t, 1), ring.corner(t, 2)}), {"#7a818c", 1.2, "#f2f4f7", ""});
  svg.polygon(placed(ring.cell), {"#0072b2", 1.5, "#cfe3f2", ""});
  for (std::size_t t = 0; t < ring.triangles.size(); ++t)
    svg.line(placed(ring.corner(t, 0)), placed(ring.corner(t, 1)), {"#7a818c", 1.2, "none", ""});
  svg.line(placed(ring.corner(0, 0)), placed(ring.corner(0, 1)), {"#20242c", 3, "none", ""});
  drawAngle(svg, ring.corner(0, 2), ring.corner(0, 0), ring.corner(0, 1), "&#945;");
  drawAngle(svg, ring.corner(ring.before(0), 1), ring.corner(0, 1), ring.corner(0, 0), "&#946;");
  svg.disc(placed(ring.corner(0, 0)), 4, "#20242c");
  svg.text(placed(ring.corner(0, 0)) + Point2(-10, 20), "p_i", Anchor::End, 16);
  svg.text(placed(ring.corner(0, 1)) + Point2(8, 16), "p_j", Anchor::Start, 16);
  svg.text(placed(ring.cell[3]) + Point2(20, -8), fmt::format("Area(i) = {:.4f}", ring.literalArea), Anchor::Start, 14,
           "#0072b2");
  svg.text({20, 26}, fmt::format("w_ij = (cot &#945; + cot &#946;) / (2 Area(i)) = {:.4f}", ring.weight(0)),
           Anchor::Start, 16);
  return svg.str();
}

/// The largest difference between (10), the cotangent weights of the ring, and the row of the Laplacian.
double differenceFromLaplacian(const Model& model, const Ring& ring)
{
  const SparseMatrix L = makeOperators(model.solverMesh, Weights::CotangentPaper).L();
  const double perSquaredLength = std::pow(model.solverMesh.diagonal, 2);  // L is in diagonals
  double difference = 0;
  for (std::size_t j = 0; j < ring.triangles.size(); ++j)
    difference =
        std::max(difference, std::abs(-L.coeff(0, static_cast<Index>(j) + 1) / perSquaredLength - ring.weight(j)));
  return difference;
}

Table tableOf(const Ring& ring)
{
  Table table{{"neighbour", "alpha, degrees", "beta, degrees", "w_ij"}, {}};
  for (std::size_t j = 0; j < ring.triangles.size(); ++j)
    table.rows.push_back({fmt::format("{}", j + 1), fmt::format("{:.2f}", ring.left(j) * kDegrees),
                          fmt::format("{:.2f}", ring.right(j) * kDegrees), fmt::format("{:.4f}", ring.weight(j))});
  return table;
}

}  // namespace

Section cotangentDefinition(const Workbench& bench)
{
  const Model model = fan({1.05, 0.92, 1.0, 1.1, 0.95, 1.02}, {8, 66, 128, 186, 247, 307});
  const Ring ring(model);
  const Ring obtuse(fan({0.25, 1, 1, 1, 1, 1}, {8, 14, 95, 175, 255, 362}));
  writeFile(bench.picture("figure_01.svg"), drawing(ring));
  Section section;
  section.paper = "the angles and the Voronoi area in the cotangent weights (10).";
  section.method =
      "a vertex with six neighbours. Angles come from the code's cotangents, the cell from the circumcentres that "
      "follow from them, Area(i) from the code's formula.";
  section.tables = {tableOf(ring)};
  section.numbers = {{"cell area", polygonArea(ring.cell)},
                     {"literal area", ring.literalArea},
                     {"mixed area", ring.mixedArea},
                     {"difference from L", differenceFromLaplacian(model, ring)},
                     {"obtuse literal area", obtuse.literalArea},
                     {"obtuse mixed area", obtuse.mixedArea},
                     {"obtuse triangles", obtuse.trianglesArea}};
  section.result = fmt::format(
      "The cell that is drawn has the area {:.6f}, Area(i) is {:.6f}, and the row of L differs from these weights by "
      "{:.1e} at most. Obtuse angles make Area(i) as printed {:.3f} at another vertex whose "
      "triangles have the area {:.3f}; the mixed area, which the default weights take, is {:.3f}.",
      polygonArea(ring.cell), ring.literalArea, section.numbers["difference from L"], obtuse.literalArea,
      obtuse.trianglesArea, obtuse.mixedArea);
  section.pictures = {
      {"figure_01.svg", "The angles across an edge and the Voronoi cell, from the code's numbers", true}};
  return section;
}

}  // namespace holdfast::paper

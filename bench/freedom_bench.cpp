// What constraints cost that leave freedom: planes, directions at odds with them, tolerances; and what tolerances are
// good for: noise that is not printed into the surface.

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/geometry/bounding_box.h>

#include "bench/benchmarks.h"
#include "bench/dragged_mesh.h"
#include "bench/measure.h"
#include "bench/random.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {
namespace {

/// The points of a scene, as many as there are, each with what `free` makes of it.
template <class Free>
ConstraintList withFreePoints(const Mesh& mesh, std::size_t count, const Free& free)
{
  ConstraintList list = isolatedFacePoints(mesh, std::min<Index>(static_cast<Index>(count), mesh.faces.size() / 30));
  Random random(7);
  for (std::size_t k = kEnds; k < list.constraints.size(); ++k)
    free(std::get<PointConstraint>(list.constraints[k].what), random);
  return list;
}

Vector3 randomDirection(Random& random)
{
  return Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)).normalized();
}

/// The ends, and vertices all over that each stay on a level plane of their own.
ConstraintList sliding(const Mesh& mesh, std::size_t count)
{
  ConstraintList list = isolatedFacePoints(mesh, 1);
  list.constraints.resize(kEnds);
  const Eigen::AlignedBox3d box = boundingBox(mesh.positions);
  VertexIds ids;
  const Index step = std::max<Index>(1, mesh.vertexCount() / static_cast<Index>(2 * count));
  for (Index v = 0; v < mesh.vertexCount() && ids.ids.size() < count; v += step)
    if (std::abs(mesh.positions(v, 0) - box.center().x()) < 0.35 * box.sizes().x()) ids.ids.push_back(v);
  list.constraints.push_back({"slide", true, SlideConstraint{{std::move(ids)}, OnPlane{}}});
  return list;
}

/// A bend of the whole mesh, by model units.
Vector3 bent(const Vector3& place, double length)
{
  const double x = place.x() / length;
  return place + length * Vector3(0, 0.05 * x * x, 0.03 * std::sin(3 * x + place.y() / length));
}

/// Root mean square of the distances of `positions` from where the bend takes them, of the points that are held out.
struct HeldOut {
  std::vector<std::pair<Index, Vector3>> vertices;

  [[nodiscard]] double rms(const Positions& positions) const
  {
    double sum = 0;
    for (const auto& [vertex, place] : vertices) sum += (positions.row(vertex).transpose() - place).squaredNorm();
    return std::sqrt(sum / static_cast<double>(vertices.size()));
  }
};

}  // namespace

void freedom(benchmark::State& state, const Mesh& mesh)
{
  const double diagonal = boundingBoxDiagonal(mesh.positions);
  constexpr std::size_t kSlide = 5000;
  const std::vector<std::pair<std::string, ConstraintList>> lists{
      {"ends alone", withFreePoints(mesh, 0, [](PointConstraint&, Random&) {})},
      {"5,000 on planes", sliding(mesh, kSlide)},
      {"100 exact", withFreePoints(mesh, 100, [](PointConstraint&, Random&) {})},
      {"100 at odds", withFreePoints(mesh, 100,
                                     [&](PointConstraint& point, Random& random) {
                                       point.to = OnPlane{{}, randomDirection(random), 1e-3 * diagonal};
                                     })},
      {"100 in balls",
       withFreePoints(mesh, 100, [&](PointConstraint& point, Random&) { point.within = WithinBall{1e-3 * diagonal}; })},
      {"1,000 in balls", withFreePoints(mesh, 1000, [&](PointConstraint& point, Random&) {
         point.within = WithinBall{1e-3 * diagonal};
       })}};
  Samples samples;
  for ([[maybe_unused]] auto turn : state)
    for (const auto& [row, list] : lists) {
      DraggedMesh dragged(mesh);
      samples.add(row, "first", 1000 * dragged.deform(list));
      samples.add(row, "frame", 1000 * dragged.frame(list));
      samples.add(row, "residual", dragged.report().maxResidualRelative);
    }
  for (const auto& [row, list] : lists) {
    const std::string base = row == "5,000 on planes" ? "ends alone" : "100 exact";
    samples.addRatios("first : " + base, {row, "first"}, {base, "first"});
    samples.addRatios("frame : " + base, {row, "frame"}, {base, "frame"});
  }
  samples.report(state);
}

void manyBoxes(benchmark::State& state, const Mesh& mesh)
{
  constexpr std::size_t kBoxes = 10'000;
  const double diagonal = boundingBoxDiagonal(mesh.positions);
  const ConstraintList boxes = withFreePoints(mesh, kBoxes, [&](PointConstraint& point, Random&) {
    point.within = WithinBox{Vector3::Constant(1e-3 * diagonal)};
  });
  const ConstraintList exact = withFreePoints(mesh, kBoxes, [](PointConstraint&, Random&) {});
  const Model model = makeModel(mesh);
  Samples samples;
  for ([[maybe_unused]] auto turn : state)
    for (const auto& [row, list] :
         {std::pair<std::string, const ConstraintList&>("exact", exact), {"in boxes", boxes}}) {
      int factorizations = 0;
      StoppableProgress progress([] { return false; },
                                 [&](std::string_view step) {
                                   if (step.find(": factorisation ") != std::string_view::npos) ++factorizations;
                                 });
      DeformResult result;
      samples.add(row, "seconds", secondsOf([&] { result = deform(model, list, "list", {}, progress); }));
      if (result.report.solve.status != SolveStatus::Ok) throw std::runtime_error(result.report.solve.message);
      samples.add(row, "factorisations of an axis", factorizations);
      samples.add(row, "residual", result.report.solve.maxResidualRelative);
    }
  samples.report(state);
}

void heldOutNoise(benchmark::State& state, const Mesh& mesh)
{
  constexpr Index kPoints = 2000;
  constexpr Index kEachHeldOut = 5;
  const double length = boundingBox(mesh.positions).sizes().x();
  const double sigma = 5e-4 * length;
  Random random(3);
  ConstraintList exact;
  HeldOut heldOut;
  const auto noise = [&] {  // three of about the normal distribution
    Vector3 sum = Vector3::Zero();
    for (int k = 0; k < 12; ++k)
      sum += Vector3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    return Vector3(sigma / std::sqrt(3.0) * sum);
  };
  const std::vector<Index> order = random.permutation(mesh.vertexCount());
  for (Index k = 0; k < std::min(kPoints, mesh.vertexCount() / 10); ++k) {
    const Index v = order[k];
    const Vector3 measured = bent(mesh.positions.row(v), length) + noise();
    if (k % kEachHeldOut == 0)
      heldOut.vertices.emplace_back(v, measured);
    else
      exact.constraints.push_back({"P" + std::to_string(k), true, PointConstraint{AtVertex{v}, Target{measured}}});
  }
  const Model model = makeModel(mesh);
  Samples samples;
  for ([[maybe_unused]] auto turn : state)
    for (const auto& [row, within] : {std::pair<std::string, PointTolerance>("exact", Exactly{}),
                                      {"within sigma", WithinBall{sigma}},
                                      {"weight 100", Weighted{100}}}) {
      ConstraintList list = exact;
      for (Constraint& constraint : list.constraints) std::get<PointConstraint>(constraint.what).within = within;
      DeformResult result;
      samples.add(row, "seconds", secondsOf([&] { result = deform(model, list); }));
      samples.add(row, "RMS in sigmas", heldOut.rms(result.positions) / sigma);
      samples.add(row, "residual", result.report.solve.maxResidualRelative);
    }
  samples.report(state);
}

}  // namespace holdfast::bench

#include "bench/paper/rotation_methods.h"

#ifdef HOLDFAST_WITH_CGAL

#include <optional>
#include <stdexcept>
#include <utility>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>

#include "bench/measure.h"

namespace holdfast::paper {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using CgalMesh = CGAL::Surface_mesh<Point>;

/// Many times those of the slowest task.
constexpr int kMostIterations = 30000;

CgalMesh::Vertex_index vertexOf(Index v)
{
  return CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(v));
}

CgalMesh cgalMesh(const SurveyTask& task)
{
  CgalMesh mesh;
  for (Index v = 0; v < task.rest.rows(); ++v)
    mesh.add_vertex(Point(task.rest(v, 0), task.rest(v, 1), task.rest(v, 2)));
  for (Index t = 0; t < task.triangles.rows(); ++t)
    mesh.add_face(vertexOf(task.triangles(t, 0)), vertexOf(task.triangles(t, 1)), vertexOf(task.triangles(t, 2)));
  return mesh;
}

Positions positionsOf(const CgalMesh& mesh)
{
  Positions result(static_cast<Index>(mesh.number_of_vertices()), 3);
  for (const auto v : mesh.vertices()) result.row(v.idx()) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  return result;
}

/// A mesh that is deformed task by task.
template <CGAL::Deformation_algorithm_tag kTag>
class CgalDeformation {
 public:
  explicit CgalDeformation(const SurveyTask& task) : mesh_(cgalMesh(task)), deformation_(mesh_), last_(task.rest)
  {
    for (const auto v : mesh_.vertices()) deformation_.insert_roi_vertex(v);
    for (const auto* ids : {&task.fixed, &task.handle})
      for (const Index v : *ids) deformation_.insert_control_vertex(vertexOf(v));
    if (!deformation_.preprocess()) throw std::runtime_error(task.name + ": CGAL cannot factorise its system");
  }

  [[nodiscard]] const Positions& positions() const { return last_; }
  [[nodiscard]] int iterations() const { return iterations_; }

  /// Iterates from the last shape; returns whether that converges.
  bool moveTo(const SurveyTask& task, double change)
  {
    const Positions targets = task.targets();
    for (const Index v : task.handle)
      deformation_.set_target_position(vertexOf(v), Point(targets(v, 0), targets(v, 1), targets(v, 2)));
    for (int k = 0; k < kMostIterations; ++k)
      if (iterate() <= change * task.diagonal()) return true;
    return false;
  }

 private:
  /// Returns how far the vertex that moves most has moved.
  double iterate()
  {
    deformation_.deform(1, 0);
    ++iterations_;
    const Positions before = std::exchange(last_, positionsOf(mesh_));
    return (last_ - before).rowwise().norm().maxCoeff();
  }

  CgalMesh mesh_;
  CGAL::Surface_mesh_deformation<CgalMesh, CGAL::Default, CGAL::Default, kTag> deformation_;
  Positions last_;
  int iterations_ = 0;
};

template <CGAL::Deformation_algorithm_tag kTag>
std::vector<RotationOutcome> outcomesByCgal(const Motion& motion, double change)
{
  std::vector<RotationOutcome> outcomes;
  std::optional<CgalDeformation<kTag>> deformation;
  double seconds = bench::secondsOf([&] { deformation.emplace(motion.front()); });
  for (const SurveyTask& task : motion) {
    bool isConverged = false;
    seconds += bench::secondsOf([&] { isConverged = deformation->moveTo(task, change); });
    outcomes.push_back(measured(task, deformation->positions()));
    outcomes.back().iterations = deformation->iterations();
    outcomes.back().seconds = seconds;
    outcomes.back().isConverged = isConverged;
  }
  return outcomes;
}

}  // namespace

std::vector<RotationMethod> cgalMethods()
{
  return {{"ORIGINAL_ARAP", outcomesByCgal<CGAL::ORIGINAL_ARAP>},
          {"SPOKES_AND_RIMS", outcomesByCgal<CGAL::SPOKES_AND_RIMS>},
          {"SRE_ARAP", outcomesByCgal<CGAL::SRE_ARAP>}};
}

std::string cgalVersion()
{
  return CGAL_VERSION_STR;
}

}  // namespace holdfast::paper

#else

#include <stdexcept>

namespace holdfast::paper {
namespace {

[[noreturn]] void failWithoutCgal()
{
  throw std::runtime_error("this build has no CGAL; scripts/paper.sh fetches its headers, or install libcgal-dev");
}

}  // namespace

std::vector<RotationMethod> cgalMethods()
{
  failWithoutCgal();
}

std::string cgalVersion()
{
  failWithoutCgal();
}

}  // namespace holdfast::paper

#endif

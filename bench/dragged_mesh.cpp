#include "bench/dragged_mesh.h"

#include <stdexcept>
#include <utility>

#include <holdfast/mesh/vertex_normals.h>

#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {

DraggedMesh::DraggedMesh(const std::shared_ptr<const Model>& model)
    : deformer_(model), corners_(cornerVertices(model->mesh.faces)), normals_(model->mesh.vertexCount(), 3)
{
}

double DraggedMesh::deform(const ConstraintList& list)
{
  const double seconds = secondsOf([&] {
    result_ = deformer_.deform(list);
    areaWeightedNormals(result_.positions, deformer_.model().mesh.faces, corners_, normals_);
  });
  if (report().status != SolveStatus::Ok) throw std::runtime_error(report().message);
  return seconds;
}

double DraggedMesh::frame(ConstraintList list)
{
  constexpr int kFrames = 10;
  std::vector<double> seconds;
  for (int k = 1; k <= kFrames; ++k) {
    turnHandle(list, 2.0 * k);
    seconds.push_back(deform(list));
  }
  return median(std::move(seconds));
}

}  // namespace holdfast::bench

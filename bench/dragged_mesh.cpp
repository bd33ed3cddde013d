#include "bench/dragged_mesh.h"

#include <stdexcept>
#include <utility>

#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {

DraggedMesh::DraggedMesh(const std::shared_ptr<const Model>& model)
    : deformer_(model, {}, DeformerMode::Interactive),
      normals_(model->mesh.faces, model->mesh.faces.corners(), model->mesh.vertexCount())
{
}

double DraggedMesh::deform(const ConstraintList& list)
{
  const double seconds = secondsOf([&] {
    result_ = deformer_.deform(list);
    normals_.at(result_.positions);
  });
  if (report().status != SolveStatus::Ok) throw std::runtime_error(report().message);
  return seconds;
}

template <class Change>
double DraggedMesh::frames(ConstraintList list, const Change& change)
{
  constexpr int kFrames = 10;
  std::vector<double> seconds;
  for (int k = 1; k <= kFrames; ++k) {
    change(list, k);
    seconds.push_back(deform(list));
  }
  return median(std::move(seconds));
}

double DraggedMesh::frame(ConstraintList list)
{
  return frames(std::move(list), [](ConstraintList& changed, int k) { turnHandle(changed, 2.0 * k); });
}

double DraggedMesh::movedFrame(ConstraintList list)
{
  const double step = 1e-3 * deformer_.model().solverMesh.diagonal;
  return frames(std::move(list), [step](ConstraintList& changed, int /*k*/) { moveHandle(changed, step); });
}

}  // namespace holdfast::bench

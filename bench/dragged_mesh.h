#pragma once
/// \file
/// A mesh that is deformed again and again, as the window does it.

#include <memory>

#include <holdfast/deform/deformer.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast::bench {

class DraggedMesh {
 public:
  explicit DraggedMesh(const Mesh& mesh) : DraggedMesh(std::make_shared<const Model>(makeModel(mesh))) {}
  explicit DraggedMesh(const std::shared_ptr<const Model>& model);

  /// Seconds to positions and normals under `list`. Throws std::runtime_error where a constraint is not met.
  double deform(const ConstraintList& list);
  /// The median over some frames in which the handle of a scene turns on.
  double frame(ConstraintList list);
  /// The same for frames in which it moves on without turning.
  double movedFrame(ConstraintList list);

  [[nodiscard]] const Model& model() const noexcept { return deformer_.model(); }
  [[nodiscard]] const SolveReport& report() const noexcept { return result_.report.solve; }
  [[nodiscard]] const Positions& positions() const noexcept { return result_.positions; }

 private:
  /// Changes the list before each frame.
  template <class Change>
  double frames(ConstraintList list, const Change& change);

  Deformer deformer_;
  DeformResult result_;
  AreaWeightedNormals normals_;
};

}  // namespace holdfast::bench

#pragma once
/// What a list of points would do to a document, before it is taken in.

#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/model.h>

namespace holdfast {

/// One `near` point of the list. Lengths in model units, places on the mesh at rest.
struct ImportedPoint {
  Index index = 0;  ///< place in the list
  Vector3 place = Vector3::Zero();
  SurfaceLocation at;   ///< what is closest to `place` on the surface: a vertex, an edge or a face
  double distance = 0;  ///< from `place` to there
};

struct ImportPreview {
  std::vector<ImportedPoint> points;  ///< in the order of the list
  Index others = 0;                   ///< constraints of the list that are no `near` points
  Index takenNames = 0;               ///< constraints whose names are taken: `pasted` would call them something else
  double maxDistance = 0;             ///< of the points; 0 where there are none
  double meanDistance = 0;
};

/// Looks at `imported` before it is taken into the document with the list `present`.
[[nodiscard]] ImportPreview previewImport(const ConstraintList& imported, const ConstraintList& present,
                                          const Model& model);

}  // namespace holdfast

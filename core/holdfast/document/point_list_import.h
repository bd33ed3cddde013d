#pragma once
/// What a list of points would do to a document, before it is taken in.

#include <string>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/model.h>

namespace holdfast {

/// One `near` point of the list. Lengths in model units, places on the mesh at rest.
struct ImportedPoint {
  Index index = 0;           ///< place in the list
  std::string name;          ///< as in the list
  bool isNameTaken = false;  ///< by a constraint of the document: `pasted` would call the point something else
  Vector3 place = Vector3::Zero();
  Vector3 onSurface = Vector3::Zero();  ///< the point of the surface that is closest to `place`
  SurfaceLocation at;                   ///< where that is: a vertex, an edge or a face
  double distance = 0;                  ///< from `place` to there
};

struct ImportPreview {
  std::vector<ImportedPoint> points;  ///< in the order of the list
  Index others = 0;                   ///< constraints of the list that are no `near` points
  Index takenNames = 0;               ///< of all constraints of the list
  double maxDistance = 0;             ///< of the points; 0 where there are none
  double meanDistance = 0;
  double medianDistance = 0;
  Index fartherThanTolerance = 0;
};

/// Looks at `imported` before it is taken into the document with the list `present`. A point counts as far from the
/// surface beyond `tolerance`, model units: it may be in another unit or another coordinate system. O(log T) for each
/// point after O(T log T).
[[nodiscard]] ImportPreview previewImport(const ConstraintList& imported, const ConstraintList& present,
                                          const Model& model, double tolerance);

}  // namespace holdfast

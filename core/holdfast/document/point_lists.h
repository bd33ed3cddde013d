#pragma once
/// These functions write and read points as tables that spreadsheets know, for the clipboard. They also look at points
/// before they are taken in.

#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/model.h>

namespace holdfast {

/// Returns the constraints at `indices` as text, every double in its shortest exact form. Where all are points with
/// targets, the text is a point list (docs/formats.md), else a constraint file. In point lists a point lies at its
/// `near` place, or where it is at rest. A shift becomes a target, and none is disabled. Throws for points that the
/// mesh does not have, and as `constraintsToJson` does.
[[nodiscard]] std::string toClipboardText(const ConstraintList& list, const std::vector<Index>& indices,
                                          const Model& model);

/// Returns the constraints of a constraint file, a session, a point list, or cells with tabs. Throws as
/// `readConstraints` does.
[[nodiscard]] ConstraintList fromClipboardText(std::string_view text);

/// This is one `near` point of the list. Lengths are in model units, and places are on the mesh at rest.
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

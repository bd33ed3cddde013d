#pragma once
/// The sections of the inspector, one for each property of constraints. A layout takes them; `editor` outlives them.

#include <holdfast/window/inspector/inspector_section.h>

namespace holdfast {

/// Where one point lies: ids and weights. Hidden for several points.
[[nodiscard]] InspectorSection* newLocationSection(Editor& editor);
/// Where points go: to a place, or by a shift.
[[nodiscard]] InspectorSection* newTargetSection(Editor& editor);
/// How many vertices fixed, rigid and handle constraints hold.
[[nodiscard]] InspectorSection* newVerticesSection(Editor& editor);
/// How handles turn and where they go.
[[nodiscard]] InspectorSection* newHandleSection(Editor& editor);
/// The frames between which handles go, and the whole turns between them.
[[nodiscard]] InspectorSection* newFrameSection(Editor& editor);
/// Rotations and targets of the vertices that one handle lists; for others the reason why not.
[[nodiscard]] InspectorSection* newSingleVerticesSection(Editor& editor);
/// Which places relative constraints keep together, and how.
[[nodiscard]] InspectorSection* newRelativeSection(Editor& editor);
/// Whether constraints hold and how hard they pull: of one, or the largest values of several.
[[nodiscard]] InspectorSection* newOutcomeSection(Editor& editor);

}  // namespace holdfast

#pragma once
/// The tools that the tool box offers. The caller owns them; editor and viewport outlive them.

#include <holdfast/widgets/interaction/region_widget.h>
#include <holdfast/window/tools/widget_tool.h>

namespace holdfast {

/// A click on a glyph selects its constraint; Shift or Ctrl adds or removes it. A click beside all glyphs selects none.
[[nodiscard]] Tool* newSelectTool(Editor& editor, Viewport& viewport);
/// A click holds the point under the cursor where it is.
[[nodiscard]] Tool* newPointTool(Editor& editor, Viewport& viewport);
/// Two clicks make a relative constraint. An arrow shows the vector of the one that is selected, whatever tool is
/// chosen.
[[nodiscard]] Tool* newRelativeTool(Editor& editor, Viewport& viewport);
/// Selects vertices by a brush, a rectangle or a lasso, or a whole side by one click.
[[nodiscard]] Tool* newRegionTool(RegionShape shape, Editor& editor, Viewport& viewport);
/// A closed curve selects what is inside it; a constraint keeps the curve. Any other selection removes it.
[[nodiscard]] Tool* newCurveTool(Editor& editor, Viewport& viewport);
/// Two clicks place a ruler, which is there as long as the tool is chosen.
[[nodiscard]] Tool* newRulerTool(Editor& editor, Viewport& viewport);

}  // namespace holdfast

#pragma once
/// The tools that the tool box offers. The caller owns them; editor and viewport outlive them.

#include <holdfast/widgets/interaction/region_widget.h>
#include <holdfast/window/tools/widget_tool.h>

namespace holdfast {

/// A click on a glyph selects its constraint; Shift or Ctrl adds or removes it. A click beside all glyphs selects none.
[[nodiscard]] Tool* newSelectTool(Editor& editor, Viewport& viewport);
/// A click holds the point under the cursor where it is. V, E and F choose vertices, edges or faces only; A the
/// nearest.
[[nodiscard]] Tool* newPointTool(Editor& editor, Viewport& viewport);
/// Two clicks make a relative constraint of the vector from the first place to the second. If one relative constraint
/// alone is selected, an arrow shows its vector, whichever tool is chosen.
[[nodiscard]] Tool* newRelativeTool(Editor& editor, Viewport& viewport);
/// Selects vertices by a brush, a rectangle or a lasso, or a whole side by one click.
[[nodiscard]] Tool* newRegionTool(RegionShape shape, Editor& editor, Viewport& viewport);
/// Draws a closed curve, which selects what is inside it, again each time that one of its places is dragged. A
/// constraint made of it keeps the curve, not the ids. Any other selection removes the curve.
[[nodiscard]] Tool* newCurveTool(Editor& editor, Viewport& viewport);
/// Two clicks place a ruler, which follows the surface and shows the distance now and at rest. Its ends can be dragged;
/// Escape takes it away. It is there as long as the tool is chosen.
[[nodiscard]] Tool* newRulerTool(Editor& editor, Viewport& viewport);

}  // namespace holdfast

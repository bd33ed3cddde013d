#pragma once
/// Tools: their base, and those that the tool box offers. The caller owns them; editor and viewport outlive them.

#include <utility>

#include <vtkNew.h>

#include <holdfast/widgets/interaction/region_widget.h>
#include <holdfast/window/viewport/tool.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

/// Makes its widget, and tells it the surface, its regions and the pixel ratio, as far as it wants to know them.
template <class Widget>
class ToolOf : public Tool {
 public:
  ToolOf(Editor& editor, Viewport& viewport, QObject* parent = nullptr, vtkNew<Widget> widget = {})
      : Tool(editor, viewport, *widget, parent), widget_(std::move(widget))
  {
  }

  [[nodiscard]] Widget& widget() const { return *widget_; }

 protected:
  void followSurface() override
  {
    if constexpr (requires { widget().SetSurface(viewport().surface()); }) widget().SetSurface(viewport().surface());
    if constexpr (requires { widget().SetRegions(nullptr); })
      widget().SetRegions(editor().isOpen() ? editor().mesh().regions : nullptr);
  }
  void followDisplay() override
  {
    if constexpr (requires { widget().SetPixelRatio(1); }) widget().SetPixelRatio(viewport().pixelRatio());
  }

 private:
  vtkNew<Widget> widget_;
};

/// A click on a glyph selects its constraint; Shift or Ctrl adds or removes it. A click beside all glyphs selects none.
[[nodiscard]] Tool* newSelectTool(Editor& editor, Viewport& viewport);
/// A click holds the point under the cursor where it is.
[[nodiscard]] Tool* newPointTool(Editor& editor, Viewport& viewport);
/// Two clicks make a relative constraint. An arrow shows the vector of the selected one, whatever tool is chosen.
[[nodiscard]] Tool* newRelativeTool(Editor& editor, Viewport& viewport);
/// Selects vertices by a brush, a rectangle or a lasso, or a whole side by one click. While `reachesThrough` is
/// checked, rectangle and lasso select hidden vertices, too.
[[nodiscard]] Tool* newRegionTool(RegionShape shape, Editor& editor, Viewport& viewport, QAction& reachesThrough);
/// A closed curve selects what is inside it; a constraint keeps the curve. Any other selection removes it.
[[nodiscard]] Tool* newCurveTool(Editor& editor, Viewport& viewport);
/// A click keeps the point under the cursor in the list of measurements.
[[nodiscard]] Tool* newProbeTool(Editor& editor, Viewport& viewport);
/// Two clicks place a ruler, which is shown and listed from then on, whatever tool is chosen.
[[nodiscard]] Tool* newRulerTool(Editor& editor, Viewport& viewport);

/// VTK's plane, beside any tool: the side that its arrow does not point to is cut away, and cannot be picked.
QObject* newSectionTool(Editor& editor, Viewport& viewport, QAction& isOn, QObject* parent);

}  // namespace holdfast

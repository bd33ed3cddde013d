#pragma once
/// Makes the tools that the tool box offers, and has their base. The caller owns the tools. Editor and viewport outlive
/// them.

#include <utility>

#include <vtkNew.h>

#include <holdfast/widgets/interaction/vtkHoldfastRegionWidget.h>
#include <holdfast/window/viewport/tool.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

/// A tool with a widget of one class. It makes the widget, and tells it the surface, the surface's regions and the
/// pixel ratio, as far as the widget has setters for them.
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

/// Makes a tool that selects constraints. A click on a glyph selects its constraint; with Shift or Ctrl it adds or
/// removes it. A click beside all glyphs selects none.
[[nodiscard]] Tool* newSelectTool(Editor& editor, Viewport& viewport);
/// Makes a tool that holds points. A click holds the point under the cursor where it is.
[[nodiscard]] Tool* newPointTool(Editor& editor, Viewport& viewport);
/// Makes a tool that adds a relative constraint with two clicks. An arrow shows the vector of the selected one,
/// whatever tool is chosen.
[[nodiscard]] Tool* newRelativeTool(Editor& editor, Viewport& viewport);
/// Makes a tool that selects vertices by a brush, a rectangle or a lasso, or a whole side by one click. While
/// `reachesThrough` is checked, rectangle and lasso select hidden vertices, too.
[[nodiscard]] Tool* newRegionTool(RegionShape shape, Editor& editor, Viewport& viewport, QAction& reachesThrough);
/// Makes a tool that draws a closed curve and selects what is inside it. A constraint keeps the curve. Any other
/// selection removes it.
[[nodiscard]] Tool* newCurveTool(Editor& editor, Viewport& viewport);
/// Makes a tool that probes. A click keeps the point under the cursor in the list of measurements.
[[nodiscard]] Tool* newProbeTool(Editor& editor, Viewport& viewport);
/// Makes a tool that places a ruler with two clicks. The ruler is shown and listed from then on, whatever tool is
/// chosen.
[[nodiscard]] Tool* newRulerTool(Editor& editor, Viewport& viewport);

/// Makes a section tool, which works beside any tool and shows VTK's plane. The side that the plane's arrow does not
/// point to is cut away, and cannot be picked.
QObject* newSectionTool(Editor& editor, Viewport& viewport, QAction& isOn, QObject* parent);

/// Makes a mirror tool, which works beside any tool. While one mirror alone is selected it shows its plane as VTK's
/// plane, which the mouse moves and turns. The list is solved when the plane is let go.
QObject* newMirrorTool(Editor& editor, Viewport& viewport, QObject* parent);

}  // namespace holdfast

#pragma once
/// The base of tools.

#include <utility>

#include <vtkNew.h>

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

}  // namespace holdfast

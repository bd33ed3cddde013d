#pragma once
/// \file
/// Paints a region of vertices along the surface.

#include <vector>

#include <holdfast/widgets/editor.h>
#include <holdfast/widgets/tool.h>
#include <holdfast/widgets/tools/region_selection.h>

namespace holdfast {

class Viewport;

/// A stroke selects the vertices that the brush touches along the surface; with Shift besides those selected, with Ctrl
/// it takes them away. [ and ] make the brush smaller and larger. A stroke that begins beside the surface turns the
/// picture.
class BrushTool : public Tool {
  Q_OBJECT

 public:
  BrushTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  bool press(const Pointer& pointer) override;
  bool hover(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void leave() override;
  bool key(const QKeyEvent& event) override;
  bool cancel() override;
  void paint(QPainter& painter) const override;

 private:
  [[nodiscard]] bool dab(const Pointer& pointer);
  void dabsTo(const Pointer& pointer);

  Editor& editor_;
  Viewport& viewport_;
  double radius_ = 24;  // of the viewport's pixels
  bool isOver_ = false;
  bool isStroking_ = false;
  Pointer at_;
  SelectionMode mode_ = SelectionMode::Replace;
  std::vector<Index> before_;   // selected when the stroke began
  std::vector<Index> reached_;  // by the stroke
};

}  // namespace holdfast

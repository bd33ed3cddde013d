#pragma once
/// \file
/// Places points of the surface that are to be held.

#include <holdfast/view/surface_picker.h>
#include <holdfast/widgets/editor.h>
#include <holdfast/widgets/tool.h>

namespace holdfast {

class Viewport;

/// A click holds the point under the cursor where it is. V, E and F take vertices, edges or faces only; A what is
/// nearest.
class PointTool : public Tool {
  Q_OBJECT

 public:
  PointTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  void end() override;
  bool hover(const Pointer& pointer) override;
  void click(const Pointer& pointer) override;
  void leave() override;
  [[nodiscard]] bool wants(const QKeyEvent& event) const override;
  bool key(const QKeyEvent& event) override;

  [[nodiscard]] PickKind kind() const noexcept { return kind_; }

 private:
  [[nodiscard]] std::optional<SurfacePick> pickAt(const Pointer& pointer);

  Editor& editor_;
  Viewport& viewport_;
  PickKind kind_ = PickKind::Nearest;
  Pointer last_;
};

}  // namespace holdfast

#pragma once
/// \file
/// Selects a smooth side or a whole part with one click.

#include <holdfast/widgets/editor.h>
#include <holdfast/widgets/tool.h>

namespace holdfast {

class Viewport;

/// A click selects the side around it, as far as the surface bends by no more than an angle from face to face; a double
/// click the whole connected part. [ and ] change the angle.
class FloodTool : public Tool {
  Q_OBJECT

 public:
  FloodTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  void click(const Pointer& pointer) override;
  void doubleClick(const Pointer& pointer) override;
  bool key(const QKeyEvent& event) override;

 private:
  Editor& editor_;
  Viewport& viewport_;
  double degrees_ = 20;
};

}  // namespace holdfast

#pragma once
/// \file
/// Selects vertices by a rectangle or a free line around them on the screen.

#include <QPointF>
#include <QTimer>
#include <memory>
#include <vector>

#include <holdfast/view/screen_selection.h>
#include <holdfast/widgets/editor.h>
#include <holdfast/widgets/tool.h>
#include <holdfast/widgets/tools/region_selection.h>

namespace holdfast {

class Viewport;

enum class ScreenShape { Rectangle, Lasso };

/// A drag draws the shape; what is visible in it is selected when the button comes up. Shift adds, Ctrl takes away, and
/// with Alt what is hidden counts, too.
class ScreenRegionTool : public Tool {
  Q_OBJECT

 public:
  ScreenRegionTool(ScreenShape shape, Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  bool press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  bool cancel() override;
  void paint(QPainter& painter) const override;

 private:
  [[nodiscard]] std::vector<QPointF> outline() const;
  void goOn();

  const ScreenShape shape_;
  Editor& editor_;
  Viewport& viewport_;
  std::vector<QPointF> way_;  // of the mouse; empty without a gesture
  // On large meshes finding what is seen takes several turns of the event loop.
  std::unique_ptr<ScreenSelection> finding_;
  SelectionMode mode_ = SelectionMode::Replace;
  QTimer next_;
};

}  // namespace holdfast

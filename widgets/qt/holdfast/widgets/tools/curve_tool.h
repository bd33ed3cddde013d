#pragma once
/// \file
/// Draws a closed curve on the surface around a feature.

#include <optional>
#include <vector>

#include <holdfast/view/surface_picker.h>
#include <holdfast/widgets/editor.h>
#include <holdfast/widgets/tool.h>

namespace holdfast {

class Viewport;

/// Clicks place vertices that shortest paths of edges join; a click on the first one, a double click or Enter closes
/// the curve and selects what is inside. A constraint made of it keeps the curve, not the ids. Backspace takes the last
/// place back.
class CurveTool : public Tool {
  Q_OBJECT

 public:
  CurveTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  void end() override;
  bool hover(const Pointer& pointer) override;
  void click(const Pointer& pointer) override;
  void doubleClick(const Pointer& pointer) override;
  void leave() override;
  bool key(const QKeyEvent& event) override;
  bool cancel() override;
  void paint(QPainter& painter) const override;

 private:
  [[nodiscard]] std::optional<Index> vertexAt(const Pointer& pointer);
  [[nodiscard]] bool isOnFirst(const Pointer& pointer) const;
  [[nodiscard]] std::vector<Index> wayBetween(Index from, Index to) const;
  [[nodiscard]] QPointF placeOf(Index vertex) const;
  void paintWay(QPainter& painter, const std::vector<Index>& way) const;
  void place(Index vertex);
  void close();
  void forget();

  Editor& editor_;
  Viewport& viewport_;
  std::vector<Index> places_;             // file vertices that were clicked
  std::vector<std::vector<Index>> ways_;  // from each to the next, file vertices
  std::vector<Index> preview_;            // from the last one to the one under the cursor
  QString trouble_;                       // why the curve could not be closed
};

}  // namespace holdfast

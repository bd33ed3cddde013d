#pragma once
/// \file
/// What is written and drawn over the picture: the legend, what the tool draws, whether the picture is older than the
/// document, and what to do where nothing is open.

#include <QPalette>
#include <QPixmap>
#include <QWidget>
#include <optional>
#include <vector>

#include <holdfast/window/model/editor.h>
#include <holdfast/window/viewport/viewport_legend.h>

namespace holdfast {

class Tool;
class Viewport;

/// Covers a viewport, and leaves the mouse to it.
class ViewportOverlay : public QWidget {
  Q_OBJECT

 public:
  ViewportOverlay(Editor& editor, Viewport& viewport);

  /// Those that paint over the picture.
  void setTools(std::vector<const Tool*> tools);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintLegend(QPainter& painter);
  [[nodiscard]] ViewportLegend legend() const;
  void addCounts(ViewportLegend& legend) const;
  void paintSolveState(QPainter& painter) const;
  void paintWelcome(QPainter& painter) const;

  Editor& editor_;
  Viewport& viewport_;
  std::vector<const Tool*> tools_;
  // The legend as it was painted last: halos take longer than most pictures.
  std::optional<ViewportLegend> paintedLegend_;
  QPalette paintedPalette_;
  QPixmap legendPicture_;
};

/// What the picture says of its age, in a sentence; empty where it shows what was asked for.
[[nodiscard]] QString solveStateText(const Editor& editor);

}  // namespace holdfast

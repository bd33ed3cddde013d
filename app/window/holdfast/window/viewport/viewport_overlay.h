#pragma once
/// Over the picture: the legend, what tools paint, whether it is older than the document.

#include <QFont>
#include <QPalette>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <holdfast/window/model/editor.h>
#include <holdfast/window/viewport/viewport_legend.h>

namespace holdfast {

class Tool;
class Viewport;

class ViewportOverlay : public QWidget {
  Q_OBJECT

 public:
  ViewportOverlay(Editor& editor, Viewport& viewport);

  /// They paint over the picture; null for none.
  void setTools(std::vector<const Tool*> tools);

  [[nodiscard]] LegendContent legend() const;

  /// What rulers and arrows in the layer of the widgets say, as in the latest picture, and where that is painted.
  using RulerLabels = std::vector<std::pair<QRectF, QString>>;
  [[nodiscard]] const RulerLabels& rulerLabels() const noexcept { return rulerLabels_; }

  /// A probe that is in the picture.
  struct ShownProbe {
    QPointF place;
    bool isBehind = false;  ///< the surface hides it
    QRectF label;           ///< inside the picture, and clear of other labels
    QString text;           ///< its number in the list, and its value of the field that colours the surface
  };
  [[nodiscard]] std::vector<ShownProbe> shownProbes() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintLegend(QPainter& painter);
  void paintSolveState(QPainter& painter) const;
  void followCursor();
  void followPicture();
  [[nodiscard]] RulerLabels currentRulerLabels() const;
  /// The size of a label, with its margins.
  [[nodiscard]] QRectF plateOf(const QString& text) const;
  void paintProbes(QPainter& painter) const;
  void paintCursor(QPainter& painter) const;
  void paintNote(QPainter& painter, const QRectF& text, const QString& words) const;
  /// In the lower left corner.
  [[nodiscard]] QRectF cursorNote() const;
  [[nodiscard]] QString cursorText() const;

  Editor& editor_;
  Viewport& viewport_;
  std::vector<const Tool*> tools_;
  // The legend as painted last: halos take longer than most pictures.
  std::optional<std::tuple<LegendContent, QPalette, QFont, QSize>> painted_;
  QPixmap legendPicture_;
  QTimer clock_;       // while the document is solved
  QRectF cursorNote_;  // as it was last
  RulerLabels rulerLabels_;
};

/// Why the picture is older than the document; empty if it is current.
[[nodiscard]] QString solveStateText(const Editor& editor);

}  // namespace holdfast

#pragma once
/// Paints over the picture: the legend, what tools paint, and whether the picture is older than the document.

#include <QPointF>
#include <QRectF>
#include <QTimer>
#include <QWidget>
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

  /// Sets the tools that paint over the picture. Null stands for no tool.
  void setTools(std::vector<const Tool*> tools);

  [[nodiscard]] LegendContent legend() const;

  /// These two paint again what has changed. A drag changes little from picture to picture.
  void followLegend();
  void followState();

  /// The texts of rulers and arrows in the layer of the widgets in the latest picture, and the boxes that they are
  /// painted in.
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
  void paintState(QPainter& painter) const;
  void followCursor();
  void followPicture();
  [[nodiscard]] RulerLabels currentRulerLabels() const;
  /// Returns the size of a label with its margins.
  [[nodiscard]] QRectF plateOf(const QString& text) const;
  void paintProbes(QPainter& painter) const;
  void paintCursor(QPainter& painter) const;
  void paintNote(QPainter& painter, const QRectF& text, const QString& words) const;
  /// Returns the box of the note in the lower left corner.
  [[nodiscard]] QRectF cursorNote() const;
  [[nodiscard]] QString cursorText() const;
  [[nodiscard]] QString valueAtPlace(const Coloring& coloring, const SurfaceLocation& location) const;
  /// Returns what the upper left corner says: why the picture is not that of the document.
  [[nodiscard]] QString stateText() const;

  Editor& editor_;
  Viewport& viewport_;
  std::vector<const Tool*> tools_;
  QTimer clock_;  // while the document is solved
  // The last ones:
  LegendContent legend_;
  QString stateText_;
  QRectF cursorNote_;
  RulerLabels rulerLabels_;
};

/// Returns why the picture is older than the document; empty if it is current.
[[nodiscard]] QString solveStateText(const Editor& editor);

}  // namespace holdfast

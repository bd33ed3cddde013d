#pragma once
/// \file
/// The legend over the picture: what colours mean, and how many constraints have which status.

#include <QFontMetricsF>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <vector>

#include <holdfast/deform/report.h>
#include <holdfast/widgets/color/color_map.h>

class QColor;
class QPainter;
class QPalette;

namespace holdfast {

/// In the lower right corner of an area. Each entry is above the one added before.
class ViewportLegend {
 public:
  ViewportLegend(const QRectF& area, const QFontMetricsF& metrics);

  void addScale(const ColorScale& scale);
  void addLine(const QString& text);
  /// How many constraints have this status, with the glyph's colour.
  void addCount(ConstraintStatus status, Index count);

  /// With a halo that keeps it legible over the mesh.
  void paint(QPainter& painter, const QPalette& palette) const;

  /// Whether the same is painted.
  friend bool operator==(const ViewportLegend&, const ViewportLegend&) = default;

 private:
  struct Text {
    QRectF box;
    QString text;

    friend bool operator==(const Text&, const Text&) = default;
  };
  struct Tick {
    double y = 0;
    double length = 0;

    friend bool operator==(const Tick&, const Tick&) = default;
  };
  struct Ball {
    QPointF middle;
    ConstraintStatus status = ConstraintStatus::Met;

    friend bool operator==(const Ball&, const Ball&) = default;
  };

  void addText(double right, double middle, const QString& text);
  void addTick(const ColorScale& scale, double value, const QString& text, double length);
  void paintHalo(QPainter& painter, const QColor& color) const;
  void paintScale(QPainter& painter) const;

  QRectF area_;
  QFontMetricsF metrics_;
  double top_;  // of the entries so far
  QRectF bar_;  // empty without a scale
  ColorScale scale_;
  std::vector<Tick> ticks_;
  std::vector<Text> words_;
  std::vector<Ball> balls_;
};

}  // namespace holdfast

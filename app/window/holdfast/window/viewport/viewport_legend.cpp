#include "holdfast/window/viewport/viewport_legend.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QMarginsF>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmapCache>
#include <algorithm>
#include <limits>

#include <holdfast/widgets/color/scalar_legend.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {
namespace {

constexpr double kMargin = 14;
constexpr double kScaleWidth = 14;
constexpr double kShortTick = 4;
constexpr double kLongTick = 12;
constexpr double kIcon = 14;
// Of the note in the lower left corner.
constexpr double kNoteLines = 5;
constexpr double kHalo = 4;
constexpr int kHaloOpacity = 200;
// Numbers that are closer, in lines, would touch.
constexpr double kLeastLineShare = 0.9;
// Of the colours that are not on the scale, in lines.
constexpr double kOutsideShare = 0.7;

/// The scale from the top down as a picture of one pixel's width.
QImage pictureOf(const ColorScale& scale, int height)
{
  QImage image(1, height, QImage::Format_RGB32);
  for (int y = 0; y < height; ++y) image.setPixelColor(0, y, toQColor(colorAt(scale, 1 - (y + 0.5) / height)));
  return image;
}

/// The halo of a line of text in the painter's font. Few lines change from picture to picture, and a halo takes longer
/// than all else that is painted: halos are kept.
QPixmap haloOf(const QString& text, const QPainter& painter, const QFontMetricsF& metrics, const QColor& paper)
{
  const double scale = painter.combinedTransform().m11();
  const QString key =
      QString("halo %1 %2 %3 ").arg(scale).arg(paper.name(QColor::HexArgb), painter.font().key()) + text;
  QPixmap halo;
  if (QPixmapCache::find(key, &halo)) return halo;
  halo = QPixmap((scale * QSizeF(metrics.horizontalAdvance(text) + 2 * kHalo, metrics.height() + 2 * kHalo)).toSize());
  halo.setDevicePixelRatio(scale);
  halo.fill(Qt::transparent);
  QPainter once(&halo);
  once.setRenderHint(QPainter::Antialiasing);
  QPainterPath letters;
  letters.addText(kHalo, kHalo + metrics.ascent(), painter.font(), text);
  once.strokePath(letters, QPen(paper, kHalo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  QPixmapCache::insert(key, halo);
  return halo;
}

/// The places of everything. What is added is above what was added before.
class Layout {
 public:
  Layout(const QRectF& area, const QFontMetricsF& metrics)
      : area_(area.adjusted(kMargin, kMargin, -kMargin, -kMargin)), metrics_(metrics), top_(area_.bottom())
  {
  }

  void addScale(const ColorScale& scale)
  {
    const double height = std::clamp(0.34 * area_.height(), 90.0, 260.0);
    const double outside = scale.outside == Outside::Marked ? 1.6 * metrics_.height() : 0;
    bar_ = QRectF(area_.right() - kScaleWidth, top_ - height - metrics_.height() / 2 - outside, kScaleWidth, height);
    double last = std::numeric_limits<double>::infinity();
    for (const Tick& tick : ticksOf(scale)) {
      const double y = heightOf(scale, tick.value);
      if (last - y < kLeastLineShare * metrics_.height()) continue;
      addTick(scale, tick.value, QString::fromStdString(tick.text), kShortTick);
      last = y;
    }
    if (outside > 0) {
      addOutside(bar_.bottom() + metrics_.height(), kBelowColor,
                 QCoreApplication::translate("ViewportLegend", "below"));
      addOutside(bar_.top() - metrics_.height(), kBeyondColor, QCoreApplication::translate("ViewportLegend", "beyond"));
    }
    if (scale.promise && *scale.promise > scale.low && *scale.promise < scale.high)
      addTick(scale, *scale.promise, QCoreApplication::translate("ViewportLegend", "promised"), kLongTick);
    top_ = bar_.top() - outside - kMargin / 2;
    const QStringList title = QString::fromStdString(scale.title).split('\n');
    for (auto line = title.rbegin(); line != title.rend(); ++line) addLine(*line, 1);
    top_ -= kMargin;
  }

  /// Returns its middle. `height`: in lines.
  double addLine(const QString& text, double height, double indent = 0)
  {
    top_ -= height * metrics_.height();
    addText(area_.right() - indent, top_ + metrics_.height() / 2, text);
    return top_ + metrics_.height() / 2;
  }

  void addCount(ConstraintStatus status, Index count)
  {
    const double middle = addLine(QString("%1 %2").arg(count).arg(statusText(status)), 1.25, kIcon + 6);
    icons_.emplace_back(QRectF(area_.right() - kIcon, middle - kIcon / 2, kIcon, kIcon).toRect(), status);
  }

  void addGap() { top_ -= kMargin / 2; }

  [[nodiscard]] QRectF box() const
  {
    QRectF box = bar_;
    for (const auto& [place, text] : words_)
      box |= QRectF(place.x(), place.y() - metrics_.ascent(), metrics_.horizontalAdvance(text), metrics_.height());
    for (const auto& [place, status] : icons_) box |= place;
    for (const auto& [place, color] : outside_) box |= place;
    return box;
  }

  void paint(QPainter& painter, const QPalette& palette, const std::optional<ColorScale>& scale) const
  {
    QColor paper = palette.color(QPalette::Window);
    paper.setAlpha(kHaloOpacity);
    for (const auto& [place, text] : words_)
      painter.drawPixmap(place - QPointF(kHalo, kHalo + metrics_.ascent()), haloOf(text, painter, metrics_, paper));
    painter.setPen(QPen(paper, kHalo));
    painter.drawLines(ticks_);

    painter.setPen(palette.color(QPalette::WindowText));
    painter.setBrush(Qt::NoBrush);
    if (scale) {
      painter.drawImage(bar_, pictureOf(*scale, static_cast<int>(bar_.height())));
      painter.drawRect(bar_);
    }
    for (const auto& [place, color] : outside_) {
      painter.fillRect(place, color);
      painter.drawRect(place);
    }
    painter.drawLines(ticks_);
    for (const auto& [place, text] : words_) painter.drawText(place, text);
    for (const auto& [place, status] : icons_) statusIcon(status, palette).paint(&painter, place);
  }

 private:
  void addText(double right, double middle, const QString& text)
  {
    const QPointF corner(right - metrics_.horizontalAdvance(text), middle - metrics_.height() / 2);
    words_.emplace_back(corner + QPointF(0, metrics_.ascent()), text);
  }

  void addTick(const ColorScale& scale, double value, const QString& text, double length)
  {
    const double y = heightOf(scale, value);
    ticks_.push_back({bar_.left() - length, y, bar_.left(), y});
    addText(bar_.left() - length - 4, y, text);
  }

  [[nodiscard]] double heightOf(const ColorScale& scale, double value) const
  {
    return bar_.bottom() - shareOf(scale, value) * bar_.height();
  }

  /// Adds the marks of values that are not on the scale.
  void addOutside(double middle, const Color& color, const QString& text)
  {
    const double height = kOutsideShare * metrics_.height();
    outside_.emplace_back(QRectF(bar_.left(), middle - height / 2, bar_.width(), height), toQColor(color));
    addText(bar_.left() - kShortTick - 4, middle, text);
  }

  QRectF area_;
  QFontMetricsF metrics_;
  double top_;  // the next line ends here
  QRectF bar_;
  QVector<QLineF> ticks_;
  std::vector<std::pair<QPointF, QString>> words_;  // by the beginnings of their baselines
  std::vector<std::pair<QRect, ConstraintStatus>> icons_;
  std::vector<std::pair<QRectF, QColor>> outside_;
};

/// At the right of `area`.
Layout layOut(const LegendContent& legend, const QFont& font, const QRectF& area)
{
  Layout layout(area, QFontMetricsF(font));
  if (legend.scale) layout.addScale(*legend.scale);
  if (!legend.line.isEmpty()) {
    layout.addLine(legend.line, 1);
    layout.addGap();
  }
  for (const auto& [status, count] : legend.counts) layout.addCount(status, count);
  return layout;
}

/// How far the legend is from the right of `area`.
QPointF shiftOf(const LegendContent& legend, const QRectF& box, const QFont& font, const QRectF& area)
{
  if (legend.side == LegendSide::Right) return {};
  return {area.left() + kMargin - box.left(), -kNoteLines * QFontMetricsF(font).height() - kMargin};
}

}  // namespace

void paint(const LegendContent& legend, QPainter& painter, const QRectF& area, const QPalette& palette)
{
  if (legend.side == LegendSide::Hidden) return;
  const Layout layout = layOut(legend, painter.font(), area);
  painter.save();
  painter.translate(shiftOf(legend, layout.box(), painter.font(), area));
  layout.paint(painter, palette, legend.scale);
  painter.restore();
}

QRectF boxOf(const LegendContent& legend, const QFont& font, const QRectF& area)
{
  if (legend.side == LegendSide::Hidden) return {};
  const QRectF box = layOut(legend, font, area).box();
  return box.translated(shiftOf(legend, box, font, area)) + QMarginsF(kHalo, kHalo, kHalo, kHalo);
}

}  // namespace holdfast

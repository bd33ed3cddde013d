#include "holdfast/window/viewport/viewport_legend.h"

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QStringList>
#include <algorithm>

#include <holdfast/widgets/color/scalar_legend.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/window/controls/vtk_palette.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {
namespace {

constexpr double kLegendMargin = 14;
constexpr double kScaleWidth = 14;
constexpr double kShortTick = 4;
constexpr double kLongTick = 12;
constexpr double kBall = 9;
constexpr double kHalo = 4;
constexpr int kHaloOpacity = 200;

/// The scale from the top down as a picture of one pixel's width.
QImage pictureOf(const ColorScale& scale, int height)
{
  QImage image(1, height, QImage::Format_RGB32);
  for (int y = 0; y < height; ++y) {
    const double share = 1 - (y + 0.5) / height;
    image.setPixelColor(0, y, toQColor(mapColor(share, scale.map)));
  }
  return image;
}

}  // namespace

ViewportLegend::ViewportLegend(const QRectF& area, const QFontMetricsF& metrics)
    : area_(area.adjusted(kLegendMargin, kLegendMargin, -kLegendMargin, -kLegendMargin)),
      metrics_(metrics),
      top_(area_.bottom())
{
}

void ViewportLegend::addText(double right, double middle, const QString& text)
{
  const double width = metrics_.horizontalAdvance(text);
  words_.push_back({{right - width, middle - metrics_.height() / 2, width, metrics_.height()}, text});
}

void ViewportLegend::addTick(const ColorScale& scale, double value, const QString& text, double length)
{
  const double y = bar_.bottom() - shareOf(scale, value) * bar_.height();
  ticks_.push_back({y, length});
  addText(bar_.left() - length - 4, y, text);
}

void ViewportLegend::addScale(const ColorScale& scale)
{
  const double height = std::clamp(0.34 * area_.height(), 90.0, 260.0);
  bar_ = QRectF(area_.right() - kScaleWidth, top_ - height - metrics_.height() / 2, kScaleWidth, height);
  scale_ = scale;
  for (const holdfast::Tick& tick : ticksOf(scale))
    addTick(scale, tick.value, QString::fromStdString(tick.text), kShortTick);
  if (scale.promise && *scale.promise > scale.low && *scale.promise < scale.high)
    addTick(scale, *scale.promise, QCoreApplication::translate("ViewportLegend", "promised"), kLongTick);

  top_ = bar_.top() - kLegendMargin / 2;
  const QStringList title = QString::fromStdString(scale.title).split('\n');
  for (auto line = title.rbegin(); line != title.rend(); ++line) {
    top_ -= metrics_.height();
    addText(area_.right(), top_ + metrics_.height() / 2, *line);
  }
  top_ -= kLegendMargin;
}

void ViewportLegend::addLine(const QString& text)
{
  top_ -= metrics_.height();
  addText(area_.right(), top_ + metrics_.height() / 2, text);
  top_ -= kLegendMargin / 2;
}

void ViewportLegend::addCount(ConstraintStatus status, Index count)
{
  top_ -= 1.25 * metrics_.height();
  const double middle = top_ + metrics_.height() / 2;
  addText(area_.right() - kBall - 6, middle, QString("%1 %2").arg(count).arg(statusText(status)));
  balls_.push_back({{area_.right() - kBall / 2, middle}, status});
}

void ViewportLegend::paintHalo(QPainter& painter, const QColor& color) const
{
  QPainterPath words;
  for (const Text& each : words_)
    words.addText(each.box.left(), each.box.top() + metrics_.ascent(), painter.font(), each.text);
  painter.strokePath(words, QPen(color, kHalo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setPen(QPen(color, kHalo));
  for (const Tick& tick : ticks_)
    painter.drawLine(QPointF(bar_.left() - tick.length, tick.y), QPointF(bar_.left(), tick.y));
}

void ViewportLegend::paint(QPainter& painter, const QPalette& palette) const
{
  QColor paper = palette.color(QPalette::Window);
  paper.setAlpha(kHaloOpacity);
  paintHalo(painter, paper);
  painter.setPen(palette.color(QPalette::WindowText));
  painter.setBrush(Qt::NoBrush);
  if (!bar_.isEmpty()) paintScale(painter);
  for (const Text& words : words_)
    painter.drawText(QPointF(words.box.left(), words.box.top() + metrics_.ascent()), words.text);
  for (const Ball& ball : balls_) {
    painter.setBrush(ball.status == ConstraintStatus::Disabled ? QBrush(Qt::NoBrush)
                                                               : toQColor(glyphColor(ball.status)));
    painter.drawEllipse(ball.middle, kBall / 2, kBall / 2);
  }
}

void ViewportLegend::paintScale(QPainter& painter) const
{
  painter.drawImage(bar_, pictureOf(scale_, static_cast<int>(bar_.height())));
  painter.drawRect(bar_);
  for (const Tick& tick : ticks_)
    painter.drawLine(QPointF(bar_.left() - tick.length, tick.y), QPointF(bar_.left(), tick.y));
}

}  // namespace holdfast

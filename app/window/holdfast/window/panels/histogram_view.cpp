#include "holdfast/window/panels/histogram_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include <holdfast/window/controls/theme.h>

namespace holdfast {
namespace {

constexpr double kShareOfBar = 0.9;
constexpr double kHeadroom = 1.06;  // over the highest bar
constexpr double kGap = 4;          // between texts and lines
constexpr double kPixelsPerTick = 62;

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent)
{
  setAccessibleName(tr("Chart of the distribution"));
  setMinimumSize(160, 110);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
}

void HistogramView::setHistogram(const Histogram& histogram, const ChartTexts& texts, std::optional<double> marked)
{
  histogram_ = histogram;
  texts_ = texts;
  marked_ = marked;
  hovered_.reset();
  setAccessibleName(texts.title);
  update();
}

Index HistogramView::largestCount() const
{
  return histogram_.counts.empty()
             ? 1
             : std::max<Index>(1, *std::max_element(histogram_.counts.begin(), histogram_.counts.end()));
}

QRectF HistogramView::plot() const
{
  const QFontMetricsF metrics(font());
  double widest = 0;
  for (const Tick& tick : countTicks(largestCount()))
    widest = std::max(widest, metrics.horizontalAdvance(QString::fromStdString(tick.text)));
  const double line = metrics.height();
  return QRectF(rect()).adjusted(line + widest + 3 * kGap, kGap, -1.5 * line, -2 * (line + kGap));
}

void HistogramView::paintEvent(QPaintEvent* /*event*/)
{
  const PictureColors colors = pictureColors(palette());
  const QRectF area = plot();
  const double line = fontMetrics().height();
  const double width = area.width() / static_cast<double>(std::max<Index>(1, barCount()));
  const auto heightOf = [&](double count) {
    return area.height() * count / (kHeadroom * static_cast<double>(largestCount()));
  };
  QPainter painter(this);
  painter.fillRect(rect(), toQColor(colors.ground));

  painter.setPen(toQColor(colors.ink));
  for (const Tick& tick : countTicks(largestCount())) {
    const double y = area.bottom() - heightOf(tick.value);
    painter.fillRect(QRectF(area.left(), y, area.width(), 1), toQColor(colors.grid));
    painter.drawText(QRectF(0, y - line / 2, area.left() - kGap, line), Qt::AlignRight | Qt::AlignVCenter,
                     QString::fromStdString(tick.text));
  }
  for (Index bar = 0; bar < barCount(); ++bar) {
    const double height = heightOf(static_cast<double>(histogram_.counts[bar]));
    const double left = area.left() + width * (static_cast<double>(bar) + (1 - kShareOfBar) / 2);
    painter.fillRect(QRectF(left, area.bottom() - height, kShareOfBar * width, height), toQColor(colors.bar));
  }
  for (const Tick& tick :
       edgeTicks(histogram_, std::max<Index>(2, static_cast<Index>(this->width() / kPixelsPerTick)))) {
    const double x = area.left() + width * tick.value;
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + kGap));
    painter.drawText(QRectF(x - kPixelsPerTick, area.bottom() + kGap, 2 * kPixelsPerTick, line), Qt::AlignHCenter,
                     QString::fromStdString(tick.text));
  }
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.drawLine(area.topLeft(), area.bottomLeft());
  painter.drawText(QRectF(area.left(), height() - line - kGap / 2, area.width(), line), Qt::AlignCenter,
                   texts_.valueAxis);
  if (marked_ && barCount() > 0) {
    const double x = area.left() + width * placeAmongBins(histogram_, *marked_);
    painter.setPen(QPen(toQColor(colors.accent), 2, Qt::DashLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  }

  painter.rotate(-90);
  painter.setPen(toQColor(colors.ink));
  painter.drawText(QRectF(-area.bottom(), kGap / 2, area.height(), line), Qt::AlignCenter, texts_.countAxis);
}

std::optional<Index> HistogramView::barAt(const QPointF& place) const
{
  const QRectF area = plot();
  if (!area.contains(place)) return std::nullopt;
  const auto bar = static_cast<Index>(static_cast<double>(barCount()) * (place.x() - area.left()) / area.width());
  if (bar >= barCount() || histogram_.counts[bar] == 0) return std::nullopt;
  return bar;
}

QPointF HistogramView::middleOf(Index bar) const
{
  const QRectF area = plot();
  const double share = (static_cast<double>(bar) + 0.5) / static_cast<double>(barCount());
  return {area.left() + share * area.width(), area.center().y()};
}

void HistogramView::mouseMoveEvent(QMouseEvent* event)
{
  hover(barAt(event->localPos()));
}

void HistogramView::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() != Qt::LeftButton) return;
  if (const auto bar = barAt(event->localPos())) Q_EMIT barClicked(*bar);
}

void HistogramView::keyPressEvent(QKeyEvent* event)
{
  switch (event->key()) {
    case Qt::Key_Left:
      return hover(nextBar(-1));
    case Qt::Key_Right:
      return hover(nextBar(1));
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (hovered_) Q_EMIT barClicked(*hovered_);
      return;
    default:
      return QWidget::keyPressEvent(event);
  }
}

std::optional<Index> HistogramView::nextBar(Index step) const
{
  const Index first = step > 0 ? 0 : barCount() - 1;
  for (Index bar = hovered_ ? *hovered_ + step : first; bar >= 0 && bar < barCount(); bar += step)
    if (histogram_.counts[bar] > 0) return bar;
  return hovered_;
}

void HistogramView::hover(std::optional<Index> bar)
{
  if (bar == hovered_) return;
  hovered_ = bar;
  setCursor(bar ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (!bar) return QToolTip::hideText();
  QToolTip::showText(mapToGlobal(middleOf(*bar).toPoint()), texts_.describe(*bar), this);
}

}  // namespace holdfast

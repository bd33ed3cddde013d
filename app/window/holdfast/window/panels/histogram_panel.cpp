#include "holdfast/window/panels/histogram_panel.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSplitter>
#include <QToolTip>
#include <algorithm>
#include <limits>
#include <unordered_set>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/fields.h>
#include <holdfast/widgets/rotation_sphere/rotation_projection.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

constexpr double kShareOfBar = 0.9;
constexpr double kHeadroom = 1.06;  // over the highest bar
constexpr double kTextGap = 4;      // between texts and lines
constexpr double kPixelsPerTick = 62;

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

// Powers of ten of the scale of residuals: below the first there is only rounding, and the promise is inside.
constexpr int kFirstPower = -17;
constexpr int kLastPower = -11;

constexpr Index kMostAngleBins = 25;

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
  return histogram_.counts.empty() ? 1 : std::max<Index>(1, std::ranges::max(histogram_.counts));
}

QRectF HistogramView::plot() const
{
  const QFontMetricsF metrics(font());
  double widest = 0;
  for (const Tick& tick : countTicks(largestCount()))
    widest = std::max(widest, metrics.horizontalAdvance(QString::fromStdString(tick.text)));
  const double line = metrics.height();
  return QRectF(rect()).adjusted(line + widest + 3 * kTextGap, kTextGap, -1.5 * line, -2 * (line + kTextGap));
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
    painter.drawText(QRectF(0, y - line / 2, area.left() - kTextGap, line), Qt::AlignRight | Qt::AlignVCenter,
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
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + kTextGap));
    painter.drawText(QRectF(x - kPixelsPerTick, area.bottom() + kTextGap, 2 * kPixelsPerTick, line), Qt::AlignHCenter,
                     QString::fromStdString(tick.text));
  }
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.drawLine(area.topLeft(), area.bottomLeft());
  painter.drawText(QRectF(area.left(), height() - line - kTextGap / 2, area.width(), line), Qt::AlignCenter,
                   texts_.valueAxis);
  if (marked_ && barCount() > 0) {
    const double x = area.left() + width * placeAmongBins(histogram_, *marked_);
    painter.setPen(QPen(toQColor(colors.accent), 2, Qt::DashLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  }

  // The title names what is counted as well.
  if (QFontMetricsF(font()).horizontalAdvance(texts_.countAxis) > area.height()) return;
  painter.rotate(-90);
  painter.setPen(toQColor(colors.ink));
  painter.drawText(QRectF(-area.bottom(), kTextGap / 2, area.height(), line), Qt::AlignCenter, texts_.countAxis);
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
  const int key = event->key();
  if (key == Qt::Key_Left) return hover(nextBar(-1));
  if (key == Qt::Key_Right) return hover(nextBar(1));
  if (key != Qt::Key_Return && key != Qt::Key_Enter && key != Qt::Key_Space) return QWidget::keyPressEvent(event);
  if (hovered_) Q_EMIT barClicked(*hovered_);
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

HistogramPanel::HistogramPanel(Editor& editor) : editor_(editor)
{
  setObjectName("histogramPanel");
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->setChildrenCollapsible(false);
  residuals_ = makePage("residuals");
  angles_ = makePage("angles");
  splitter->addWidget(residuals_.content);
  splitter->addWidget(angles_.content);
  fill(*this, splitter);
  connect(residuals_.view, &HistogramView::barClicked, this, &HistogramPanel::pickConstraints);
  connect(angles_.view, &HistogramView::barClicked, this,
          [this](Index bar) { Q_EMIT verticesPicked(placesInBin(angles_.view->histogram(), angles_.values, bar)); });
  connect(&editor_, &Editor::opened, this, &HistogramPanel::refresh);
  connect(&editor_, &Editor::deformed, this, &HistogramPanel::refresh);
}

HistogramPanel::Page HistogramPanel::makePage(const QString& name)
{
  Page page;
  page.title = newText(name + "Title");
  page.title->setContentsMargins(6, 2, 6, 2);
  page.view = named(new HistogramView, name + "View");
  auto* chart = new QWidget;
  newLayout<QVBoxLayout>(chart, 0, 2, {page.title, page.view})->setStretch(1, 1);
  page.content = new HintedContent(chart, name + "Hint");
  return page;
}

void HistogramPanel::refresh()
{
  if (!isVisible()) return;
  residuals_.values.clear();
  angles_.values.clear();
  if (editor_.deformation()) {
    refreshResiduals();
    refreshAngles();
  }
  const auto showPage = [&](const Page& page, const QString& hint) {
    if (!page.values.empty()) return page.content->showContent();
    page.content->showHint(editor_.isOpen() ? hint : tr("No mesh is open."));
  };
  showPage(residuals_, tr("No residuals yet: add a constraint."));
  showPage(angles_, tr("No rotation yet: rotate a handle."));
}

void HistogramPanel::refreshResiduals()
{
  const DeformResult& deformation = *editor_.deformation();
  const double diagonal = editor_.model()->solverMesh.diagonal;
  std::vector<double> shares;
  Index withinLimits = 0;
  for (const ConstraintOutcome& outcome : deformation.report.constraints) {
    shares.push_back(outcome.residual ? *outcome.residual / diagonal : kNoValue);
    withinLimits += outcome.residual && *outcome.residual <= outcome.limit ? 1 : 0;
  }
  const Histogram histogram = logarithmicHistogram(shares, kFirstPower, kLastPower);
  if (histogram.valueCount == 0) return;
  const double promise = std::ranges::min(deformation.details->diagnosis.limits) / diagonal;
  ChartTexts texts;
  texts.title =
      tr("Residuals: %1 of %2 within their limits (dashed: the smallest)").arg(withinLimits).arg(histogram.valueCount);
  texts.valueAxis = tr("residual / diagonal of the bounding box");
  texts.countAxis = tr("constraints");
  const std::string units = editor_.deformedState()->list.units;
  texts.describe = [=](Index bar) {
    const double low = histogram.edges[bar];
    const double high = histogram.edges[bar + 1];
    return tr("%1 to %2 of the diagonal (%3 to %4)\nconstraints: %5")
        .arg(roundedText(low), roundedText(high), roundedText(low * diagonal), lengthText(high * diagonal, {units}))
        .arg(histogram.counts[bar]);
  };
  residuals_.values = std::move(shares);
  residuals_.title->setText(texts.title);
  residuals_.view->setHistogram(histogram, texts, promise);
}

void HistogramPanel::refreshAngles()
{
  const DeformResult& deformation = *editor_.deformation();
  if (!hasRotation(boundaryRotations(deformation))) return;
  angles_.values = fieldOf(*editor_.model(), deformation, FieldKind::RotationAngleDegrees).values;
  const SolverMesh& mesh = editor_.model()->solverMesh;
  for (std::size_t v = 0; v < angles_.values.size(); ++v)
    if (mesh.componentOf[mesh.weld.unknownOf[v]] < 0) angles_.values[v] = kNoValue;
  const Histogram histogram = linearHistogram(angles_.values, TickSteps::Degrees, kMostAngleBins);
  ChartTexts texts;
  texts.title = tr("Rotation angles of vertices");
  texts.valueAxis = tr("angle, degrees (whole turns counted)");
  texts.countAxis = tr("vertices");
  texts.describe = [=](Index bar) {
    return tr("%1° to %2°\nvertices: %3")
        .arg(roundedText(histogram.edges[bar]), roundedText(histogram.edges[bar + 1]))
        .arg(histogram.counts[bar]);
  };
  angles_.title->setText(texts.title);
  angles_.view->setHistogram(histogram, texts, std::nullopt);
}

void HistogramPanel::pickConstraints(Index bar)
{
  // What is shown may be older than the list: constraints are found by their names.
  std::unordered_set<std::string> names;
  for (const Index k : placesInBin(residuals_.view->histogram(), residuals_.values, bar))
    names.insert(editor_.deformation()->report.constraints[k].name);
  const std::vector<Constraint>& list = editor_.list().constraints;
  std::vector<Index> places;
  for (std::size_t k = 0; k < list.size(); ++k)
    if (names.count(list[k].name) > 0) places.push_back(static_cast<Index>(k));
  Q_EMIT constraintsPicked(places);
}

}  // namespace holdfast

#include "holdfast/window/panels/histogram_view.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <holdfast/window/controls/render_request.h>
#include <holdfast/window/controls/vtk_palette.h>

namespace holdfast {
namespace {

constexpr float kShareOfBar = 0.9F;
constexpr double kHeadroom = 1.06;  // of the highest bar
constexpr double kTextPixels = 12;
constexpr double kPixelsPerTick = 62;

vtkSmartPointer<vtkTable> tableOf(const std::vector<double>& x, const std::vector<double>& y)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const auto& [name, values] : {std::pair("x", &x), std::pair("y", &y)}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const double value : *values) column->InsertNextValue(value);
    table->AddColumn(column);
  }
  return table;
}

void setColor(vtkPen& pen, const Color& color)
{
  pen.SetColorF(color.red, color.green, color.blue);
}

void setTicks(vtkAxis& axis, const std::vector<Tick>& ticks)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const Tick& tick : ticks) {
    positions->InsertNextValue(tick.value);
    labels->InsertNextValue(tick.text);
  }
  axis.SetCustomTickPositions(positions, labels);
}

void setLook(vtkAxis& axis, const PictureColors& colors, double ratio)
{
  for (vtkTextProperty* const text : {axis.GetLabelProperties(), axis.GetTitleProperties()}) {
    text->SetColor(colors.ink.red, colors.ink.green, colors.ink.blue);
    text->SetFontFamilyToArial();
    text->SetBold(0);
    text->SetFontSize(static_cast<int>(std::lround(kTextPixels * ratio)));
  }
  setColor(*axis.GetPen(), colors.ink);
  setColor(*axis.GetGridPen(), colors.grid);
}

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent)
{
  title_ = new QLabel(this);
  title_->setContentsMargins(6, 2, 6, 2);
  title_->setWordWrap(true);
  view_ = new QVTKOpenGLNativeWidget(this);
  view_->setObjectName("chart");
  view_->setAccessibleName(tr("Chart of the distribution"));
  view_->setMinimumSize(160, 110);
  // Sizes are given in pixels of the window, as in the viewport.
  view_->setEnableHiDPI(false);
  view_->setMouseTracking(true);
  view_->setFocusPolicy(Qt::StrongFocus);
  view_->installEventFilter(this);
  drawing_ = new RenderRequest(*view_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(title_);
  column->addWidget(view_, 1);
  context_->SetRenderWindow(view_->renderWindow());
  // What the mouse does is told here, and drawn once.
  context_->GetInteractor()->SetInteractorStyle(nullptr);
  // Bars and axes lie along the pixels.
  view_->renderWindow()->SetMultiSamples(0);
  context_->GetScene()->AddItem(chart_);
  chart_->SetInteractive(false);
  chart_->SetShowLegend(false);
  chart_->SetBarWidthFraction(kShareOfBar);
}

HistogramView::~HistogramView() = default;

QWidget* HistogramView::chartView() const
{
  return view_;
}

void HistogramView::setHistogram(const Histogram& histogram, const ChartTexts& texts, std::optional<double> marked)
{
  histogram_ = histogram;
  texts_ = texts;
  marked_ = marked;
  hovered_.reset();
  title_->setText(texts.title);
  view_->setAccessibleName(texts.title);
  rebuild();
}

void HistogramView::warmUp()
{
  ChartTexts texts;
  texts.valueAxis = texts.countAxis = "0";
  setHistogram({Scaling::Linear, {0, 1, 2}, {1, 2}, 3, 0}, texts, 1.0);
  view_->grabFramebuffer();
  setHistogram({}, {}, std::nullopt);
}

void HistogramView::rebuild()
{
  const PictureColors colors = pictureColors(palette());
  context_->GetRenderer()->SetBackground(colors.ground.red, colors.ground.green, colors.ground.blue);
  chart_->ClearPlots();
  addBars(colors);
  addMark(colors);
  setAxes(colors);
  drawing_->post();
}

void HistogramView::addBars(const PictureColors& colors)
{
  std::vector<double> x;
  std::vector<double> heights;
  for (std::size_t bar = 0; bar < histogram_.counts.size(); ++bar) {
    x.push_back(static_cast<double>(bar) + 0.5);
    heights.push_back(static_cast<double>(histogram_.counts[bar]));
  }
  if (x.empty()) return;
  vtkPlot& bars = *chart_->AddPlot(vtkChart::BAR);
  bars.SetInputData(tableOf(x, heights), 0, 1);
  const Color& color = colors.bar;
  bars.GetBrush()->SetColorF(color.red, color.green, color.blue);
  bars.GetPen()->SetLineType(vtkPen::NO_PEN);
}

void HistogramView::addMark(const PictureColors& colors)
{
  if (!marked_ || histogram_.counts.empty()) return;
  const double x = placeAmongBins(histogram_, *marked_);
  const auto highest = static_cast<double>(*std::max_element(histogram_.counts.begin(), histogram_.counts.end()));
  vtkPlot& line = *chart_->AddPlot(vtkChart::LINE);
  line.SetInputData(tableOf({x, x}, {0, kHeadroom * std::max(1.0, highest)}), 0, 1);
  setColor(*line.GetPen(), colors.accent);
  line.GetPen()->SetLineType(vtkPen::DASH_LINE);
  line.SetWidth(static_cast<float>(2 * devicePixelRatioF()));
}

void HistogramView::setAxes(const PictureColors& colors)
{
  vtkAxis& values = *chart_->GetAxis(vtkAxis::BOTTOM);
  vtkAxis& counts = *chart_->GetAxis(vtkAxis::LEFT);
  Index largest = 1;
  for (const Index count : histogram_.counts) largest = std::max(largest, count);
  values.SetBehavior(vtkAxis::FIXED);
  values.SetRange(0, std::max<double>(1, static_cast<double>(histogram_.counts.size())));
  values.SetTitle(texts_.valueAxis.toStdString());
  values.SetGridVisible(false);
  setTicks(values, edgeTicks(histogram_, static_cast<Index>(std::max(2.0, view_->width() / kPixelsPerTick))));
  counts.SetBehavior(vtkAxis::FIXED);
  counts.SetRange(0, kHeadroom * static_cast<double>(largest));
  counts.SetTitle(texts_.countAxis.toStdString());
  setTicks(counts, countTicks(largest));
  for (vtkAxis* const axis : {&values, &counts}) setLook(*axis, colors, devicePixelRatioF());
}

std::optional<Index> HistogramView::barAt(const QPointF& place) const
{
  const double ratio = view_->devicePixelRatioF();
  const double x = (place.x() + 0.5) * ratio;
  const double y = (view_->height() - place.y() - 0.5) * ratio;
  const int* const low = chart_->GetPoint1();
  const int* const high = chart_->GetPoint2();
  if (x < low[0] || x >= high[0] || y < low[1] || y > high[1]) return std::nullopt;
  const auto bars = static_cast<double>(histogram_.counts.size());
  const auto bar = static_cast<Index>(bars * (x - low[0]) / (high[0] - low[0]));
  if (bar >= static_cast<Index>(histogram_.counts.size()) || histogram_.counts[bar] == 0) return std::nullopt;
  return bar;
}

QPointF HistogramView::middleOf(Index bar) const
{
  const double ratio = view_->devicePixelRatioF();
  const int* const low = chart_->GetPoint1();
  const int* const high = chart_->GetPoint2();
  const double share = (static_cast<double>(bar) + 0.5) / static_cast<double>(histogram_.counts.size());
  const double x = low[0] + share * (high[0] - low[0]);
  const double y = (low[1] + high[1]) / 2;
  return {x / ratio - 0.5, view_->height() - y / ratio - 0.5};
}

bool HistogramView::eventFilter(QObject* watched, QEvent* event)
{
  if (watched != view_) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::Wheel:
      return true;
    case QEvent::MouseMove:
      hover(barAt(static_cast<QMouseEvent*>(event)->localPos()));
      return true;
    case QEvent::Leave:
      hover(std::nullopt);
      return false;
    case QEvent::MouseButtonRelease:
      handleRelease(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::KeyPress:
      return handleKey(static_cast<QKeyEvent*>(event)->key());
    case QEvent::Resize:
      // More room, more numbers.
      rebuild();
      return false;
    default:
      return QWidget::eventFilter(watched, event);
  }
}

void HistogramView::handleRelease(const QMouseEvent& event)
{
  if (event.button() != Qt::LeftButton) return;
  if (const auto bar = barAt(event.localPos())) Q_EMIT barClicked(*bar);
}

bool HistogramView::handleKey(int key)
{
  switch (key) {
    case Qt::Key_Left:
      hover(nextBar(-1));
      return true;
    case Qt::Key_Right:
      hover(nextBar(1));
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (hovered_) Q_EMIT barClicked(*hovered_);
      return true;
    default:
      return false;
  }
}

std::optional<Index> HistogramView::nextBar(Index step) const
{
  const auto bars = static_cast<Index>(histogram_.counts.size());
  for (Index bar = hovered_ ? *hovered_ + step : (step > 0 ? 0 : bars - 1); bar >= 0 && bar < bars; bar += step)
    if (histogram_.counts[bar] > 0) return bar;
  return hovered_;
}

void HistogramView::hover(std::optional<Index> bar)
{
  if (bar == hovered_) return;
  hovered_ = bar;
  view_->setCursor(bar ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (!bar) return QToolTip::hideText();
  QToolTip::showText(view_->mapToGlobal(middleOf(*bar).toPoint()), texts_.describe(*bar), view_);
}

void HistogramView::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  rebuild();
}

void HistogramView::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

}  // namespace holdfast

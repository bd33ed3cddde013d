#include "holdfast/window/viewport/viewport_overlay.h"

#include <QPainter>
#include <utility>

#include <holdfast/deform/outcomes.h>
#include <holdfast/window/text/color_text.h>
#include <holdfast/window/viewport/tool.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {
namespace {

constexpr double kNoteMargin = 14;

// A shorter wait needs no number, and in a drag no word.
constexpr double kSecondsUnsaid = 0.5;
constexpr int kMillisecondsBetweenTimes = 200;

}  // namespace

QString solveStateText(const Editor& editor)
{
  switch (editor.solveState()) {
    case SolveState::Nothing:
    case SolveState::Current:
      break;
    case SolveState::Solving: {
      const bool isLong = editor.secondsOlder() >= kSecondsUnsaid;
      // A drag's frames follow one another faster than a word can be read.
      if (editor.deformation() && editor.history().isInGesture() && !isLong) return {};
      const QString text = editor.deformation() ? ViewportOverlay::tr("Older than the constraints: solving")
                                                : ViewportOverlay::tr("At rest: solving");
      return isLong ? ViewportOverlay::tr("%1, %2 s").arg(text).arg(editor.secondsOlder(), 0, 'f', 1) : text;
    }
    case SolveState::Cancelled:
      return ViewportOverlay::tr("Older than the constraints: solving was stopped. F5 solves again.");
    case SolveState::Unusable:
      return ViewportOverlay::tr("Older than the constraints: they cannot be solved.") + '\n' + editor.error();
  }
  return {};
}

ViewportOverlay::ViewportOverlay(Editor& editor, Viewport& viewport)
    : QWidget(&viewport), editor_(editor), viewport_(viewport)
{
  setObjectName("overlay");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  for (const auto& signal : {&Editor::opened, &Editor::solveStateChanged, &Editor::stepChanged})
    connect(&editor_, signal, this, qOverload<>(&QWidget::update));
  clock_.setInterval(kMillisecondsBetweenTimes);
  connect(&clock_, &QTimer::timeout, this, [this] { update(0, 0, width(), fontMetrics().height() * 3); });
  connect(&editor_, &Editor::solveStateChanged, &clock_,
          [this] { editor_.solveState() == SolveState::Solving ? clock_.start() : clock_.stop(); });
}

void ViewportOverlay::setTools(std::vector<const Tool*> tools)
{
  tools_ = std::move(tools);
  update();
}

void ViewportOverlay::paintEvent(QPaintEvent* /*event*/)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!editor_.isOpen()) return;
  paintLegend(painter);
  paintSolveState(painter);
  for (const Tool* tool : tools_) {
    if (tool == nullptr) continue;
    painter.save();
    tool->paint(painter);
    painter.restore();
  }
}

LegendContent ViewportOverlay::legend() const
{
  LegendContent legend;
  const ColorBy field = viewport_.colors().field;
  const auto& deformation = editor_.deformation();
  if (const auto& coloring = viewport_.coloring())
    legend.scale = coloring->scale;
  else if (deformation && field != ColorBy::None)
    legend.line = tr("%1: nothing to show").arg(fieldText(field).name);
  if (!deformation || !viewport_.display().areConstraintsShown) return legend;
  for (const ConstraintStatus status :
       {ConstraintStatus::Disabled, ConstraintStatus::Missed, ConstraintStatus::Conflicting,
        ConstraintStatus::Redundant, ConstraintStatus::Met})
    if (const Index count = countOf(deformation->report, status); count > 0) legend.counts.emplace_back(status, count);
  return legend;
}

void ViewportOverlay::paintLegend(QPainter& painter)
{
  const std::tuple key(legend(), palette(), font(), size() * devicePixelRatioF());
  if (painted_ != key) {
    painted_ = key;
    legendPicture_ = QPixmap(size() * devicePixelRatioF());
    legendPicture_.setDevicePixelRatio(devicePixelRatioF());
    legendPicture_.fill(Qt::transparent);
    QPainter once(&legendPicture_);
    once.setRenderHint(QPainter::Antialiasing);
    once.setFont(font());
    paint(legend(), once, rect(), palette());
  }
  painter.drawPixmap(0, 0, legendPicture_);
}

void ViewportOverlay::paintSolveState(QPainter& painter) const
{
  const QString text = solveStateText(editor_);
  if (text.isEmpty()) return;
  const QRectF available(0, 0, width() - 4 * kNoteMargin, height());
  QRectF box = painter.fontMetrics().boundingRect(available.toRect(), Qt::AlignLeft | Qt::TextWordWrap, text);
  box.moveTo(kNoteMargin + 8, kNoteMargin + 5);
  QColor plate = palette().color(QPalette::Window);
  plate.setAlpha(225);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(box.adjusted(-8, -5, 8, 5), 4, 4);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(box, Qt::AlignLeft | Qt::TextWordWrap, text);
}

}  // namespace holdfast

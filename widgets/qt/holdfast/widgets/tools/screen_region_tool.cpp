#include "holdfast/widgets/tools/screen_region_tool.h"

#include <QPainter>
#include <cmath>

#include <holdfast/widgets/viewport.h>

namespace holdfast {
namespace {

// Of the viewport's pixels: what is drawn with less is a click, and selects nothing.
constexpr double kLeastSize = 3;

// Vertices in one turn of the event loop: some 15 milliseconds at the most.
constexpr Index kAtOnce = 12'000;

}  // namespace

ScreenRegionTool::ScreenRegionTool(ScreenShape shape, Editor& editor, Viewport& viewport, QObject* parent)
    : Tool(parent), shape_(shape), editor_(editor), viewport_(viewport)
{
  next_.setSingleShot(true);
  connect(&next_, &QTimer::timeout, this, &ScreenRegionTool::goOn);
}

QString ScreenRegionTool::hint() const
{
  return (shape_ == ScreenShape::Rectangle ? tr("Drag a rectangle.") : tr("Draw around vertices.")) + ' ' +
         tr("Shift adds, Ctrl takes away, Alt reaches through. Then F: fixed, H: handle, R: rigid");
}

bool ScreenRegionTool::press(const Pointer& pointer)
{
  finding_.reset();
  way_ = {pointer.place};
  return true;
}

void ScreenRegionTool::drag(const Pointer& pointer)
{
  way_.push_back(pointer.place);
  Q_EMIT changed();
}

std::vector<QPointF> ScreenRegionTool::outline() const
{
  if (shape_ == ScreenShape::Lasso) return way_;
  const QPointF a = way_.front();
  const QPointF b = way_.back();
  return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
}

void ScreenRegionTool::release(const Pointer& pointer)
{
  way_.push_back(pointer.place);
  const auto shape = outline();
  way_.clear();
  Q_EMIT changed();

  const QRectF bounds = QPolygonF(QVector<QPointF>(shape.begin(), shape.end())).boundingRect();
  if (std::max(bounds.width(), bounds.height()) < kLeastSize) return;
  std::vector<DisplayPoint> polygon;
  for (const QPointF& place : shape) polygon.push_back(viewport_.toDisplayPoint(place));
  const ScreenReach reach = pointer.modifiers & Qt::AltModifier ? ScreenReach::Through : ScreenReach::VisibleOnly;
  finding_ = std::make_unique<ScreenSelection>(viewport_.renderer(), viewport_.picker()->surface(), polygon, reach);
  mode_ = selectionModeOf(pointer.modifiers);
  goOn();
}

void ScreenRegionTool::goOn()
{
  if (!finding_) return;
  finding_->advance(kAtOnce);
  if (!finding_->isDone()) return next_.start(0);
  const auto inside = finding_->inside();
  finding_.reset();
  editor_.selectVertices(joined(editor_.selectedVertices(), inside, mode_));
}

bool ScreenRegionTool::cancel()
{
  if (way_.empty() && !finding_) return false;
  way_.clear();
  finding_.reset();
  Q_EMIT changed();
  return true;
}

void ScreenRegionTool::paint(QPainter& painter) const
{
  if (way_.size() < 2) return;
  const auto shape = outline();
  const QPolygonF polygon(QVector<QPointF>(shape.begin(), shape.end()));
  painter.setBrush(QColor(30, 120, 255, 40));
  // Light below dark: seen on every surface.
  painter.setPen(QPen(QColor(255, 255, 255, 210), 3));
  painter.drawPolygon(polygon);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(20, 90, 210), 1.2));
  painter.drawPolygon(polygon);
}

}  // namespace holdfast

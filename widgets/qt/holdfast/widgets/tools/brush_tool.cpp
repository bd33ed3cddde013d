#include "holdfast/widgets/tools/brush_tool.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include <holdfast/widgets/viewport.h>

namespace holdfast {
namespace {

constexpr double kSmallest = 4;
constexpr double kLargest = 300;
constexpr double kStep = 1.2;

// Dabs of a quick stroke follow one another by this share of the radius.
constexpr double kSpacing = 0.4;

}  // namespace

BrushTool::BrushTool(Editor& editor, Viewport& viewport, QObject* parent)
    : Tool(parent), editor_(editor), viewport_(viewport)
{
}

QString BrushTool::hint() const
{
  return tr("Paint a region. Shift adds, Ctrl takes away, [ and ] size the brush. Then F: fixed, H: handle, R: rigid");
}

bool BrushTool::dab(const Pointer& pointer)
{
  vtkRenderer& renderer = viewport_.renderer();
  const auto pick = viewport_.picker()->pick(renderer, pointer.display.x(), pointer.display.y(), PickKind::Face, 0);
  if (!pick) return false;
  const DisplayPoint beside = pointer.display + DisplayPoint(radius_ * viewport_.pixelRatio(), 0);
  const double radius = (atDepthOf(renderer, pick->place, beside) - pick->place).norm();
  const auto touched = editor_.mesh().regions->within(radius, pick->place, pick->face, editor_.positions());
  reached_ = joined(reached_, touched, SelectionMode::Add);
  return true;
}

bool BrushTool::press(const Pointer& pointer)
{
  before_ = editor_.selectedVertices();
  reached_.clear();
  mode_ = selectionModeOf(pointer.modifiers);
  at_ = pointer;
  if (!dab(pointer)) return false;
  isStroking_ = true;
  editor_.selectVertices(joined(before_, reached_, mode_));
  return true;
}

void BrushTool::dabsTo(const Pointer& pointer)
{
  const DisplayPoint from = at_.display;
  const double spacing = kSpacing * radius_ * viewport_.pixelRatio();
  const int count = std::max(1, static_cast<int>(std::ceil((pointer.display - from).norm() / spacing)));
  for (int k = 1; k <= count; ++k) {
    Pointer between = pointer;
    between.display = from + (pointer.display - from) * k / count;
    // Where the stroke leaves the surface for a while nothing is painted.
    static_cast<void>(dab(between));
  }
}

void BrushTool::drag(const Pointer& pointer)
{
  dabsTo(pointer);
  at_ = pointer;
  editor_.selectVertices(joined(before_, reached_, mode_));
  Q_EMIT changed();
}

void BrushTool::release(const Pointer& pointer)
{
  at_ = pointer;
  isStroking_ = false;
}

bool BrushTool::hover(const Pointer& pointer)
{
  at_ = pointer;
  isOver_ = true;
  Q_EMIT changed();
  return true;
}

void BrushTool::leave()
{
  isOver_ = false;
  Q_EMIT changed();
}

bool BrushTool::key(const QKeyEvent& event)
{
  if (event.key() != Qt::Key_BracketLeft && event.key() != Qt::Key_BracketRight) return false;
  const double factor = event.key() == Qt::Key_BracketLeft ? 1 / kStep : kStep;
  radius_ = std::clamp(radius_ * factor, kSmallest, kLargest);
  Q_EMIT changed();
  return true;
}

bool BrushTool::cancel()
{
  if (!isStroking_) return false;
  isStroking_ = false;
  editor_.selectVertices(before_);
  return true;
}

void BrushTool::paint(QPainter& painter) const
{
  if (!isOver_ && !isStroking_) return;
  painter.setBrush(Qt::NoBrush);
  // Dark on light and light on dark: a ring that reads on every surface.
  painter.setPen(QPen(QColor(255, 255, 255, 200), 3));
  painter.drawEllipse(at_.place, radius_, radius_);
  painter.setPen(QPen(QColor(20, 22, 26), 1.2));
  painter.drawEllipse(at_.place, radius_, radius_);
}

}  // namespace holdfast

#include "holdfast/widgets/tools/curve_tool.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include <holdfast/constraints/curve_selector.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/viewport.h>

namespace holdfast {
namespace {

// Of the viewport's pixels.
constexpr double kCloseReach = 12;
constexpr double kDot = 4;

constexpr std::size_t kLeastPlaces = 3;

}  // namespace

CurveTool::CurveTool(Editor& editor, Viewport& viewport, QObject* parent)
    : Tool(parent), editor_(editor), viewport_(viewport)
{
}

QString CurveTool::hint() const
{
  if (!trouble_.isEmpty()) return trouble_;
  if (places_.empty()) return tr("Click places around a feature to draw a closed curve along the edges");
  if (places_.size() < kLeastPlaces) return tr("Click on; Backspace takes the last place back, Escape all");
  return tr("Click the first place, or press Enter, to close the curve; Backspace takes the last place back");
}

std::optional<Index> CurveTool::vertexAt(const Pointer& pointer)
{
  const auto pick = viewport_.picker()->pick(viewport_.renderer(), pointer.display.x(), pointer.display.y(),
                                             PickKind::Vertex, kCloseReach * viewport_.pixelRatio());
  if (!pick) return std::nullopt;
  return std::get<AtVertex>(pick->location).vertex;
}

QPointF CurveTool::placeOf(Index vertex) const
{
  return viewport_.toPlace(toDisplay(viewport_.renderer(), editor_.positions().row(vertex).transpose()).head<2>());
}

bool CurveTool::isOnFirst(const Pointer& pointer) const
{
  if (places_.size() < kLeastPlaces) return false;
  const QPointF way = placeOf(places_.front()) - pointer.place;
  return std::hypot(way.x(), way.y()) < kCloseReach;
}

std::vector<Index> CurveTool::wayBetween(Index from, Index to) const
{
  const Weld& weld = editor_.model()->solverMesh.weld;
  ShortestPaths paths(editor_.mesh().regions->graph());
  std::vector<Index> way = paths.path(weld.unknownOf[from], weld.unknownOf[to]);
  for (Index& unknown : way) unknown = weld.firstVertexOf[unknown];
  return way;
}

void CurveTool::place(Index vertex)
{
  if (!places_.empty()) {
    auto way = wayBetween(places_.back(), vertex);
    if (vertex == places_.back() || way.empty()) return;
    ways_.push_back(std::move(way));
  }
  places_.push_back(vertex);
  preview_.clear();
  trouble_.clear();
}

bool CurveTool::hover(const Pointer& pointer)
{
  preview_.clear();
  const auto vertex = isOnFirst(pointer) ? std::optional(places_.front()) : vertexAt(pointer);
  if (vertex && !places_.empty())
    preview_ = wayBetween(places_.back(), *vertex);
  else if (vertex)
    preview_ = {*vertex};
  Q_EMIT changed();
  return true;
}

void CurveTool::click(const Pointer& pointer)
{
  if (isOnFirst(pointer)) return close();
  if (const auto vertex = vertexAt(pointer)) place(*vertex);
  Q_EMIT changed();
}

void CurveTool::doubleClick(const Pointer& /*pointer*/)
{
  close();
}

void CurveTool::close()
{
  if (places_.size() < kLeastPlaces) return;
  InsideCurve curve;
  for (const Index vertex : places_) curve.through.push_back(AtVertex{vertex});
  const Model& model = *editor_.model();
  SurfaceLocator locator(model.mesh, model.triangulation);
  CurveSelector selector(model.mesh, model.solverMesh, locator);
  try {
    auto inside = selector.select(curve, {});
    forget();
    editor_.selectVertices(std::move(inside), Selection{curve});
  } catch (const InputError& error) {
    trouble_ = tr("This curve encloses nothing: %1").arg(QString::fromStdString(error.reason()));
  }
  Q_EMIT changed();
}

void CurveTool::forget()
{
  places_.clear();
  ways_.clear();
  preview_.clear();
  trouble_.clear();
}

void CurveTool::end()
{
  forget();
}

void CurveTool::leave()
{
  preview_.clear();
  Q_EMIT changed();
}

bool CurveTool::key(const QKeyEvent& event)
{
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    close();
    return true;
  }
  if (event.key() != Qt::Key_Backspace || places_.empty()) return false;
  places_.pop_back();
  if (!ways_.empty()) ways_.pop_back();
  preview_.clear();
  Q_EMIT changed();
  return true;
}

bool CurveTool::cancel()
{
  if (places_.empty()) return false;
  forget();
  Q_EMIT changed();
  return true;
}

void CurveTool::paintWay(QPainter& painter, const std::vector<Index>& way) const
{
  QPolygonF line;
  for (const Index vertex : way) line << placeOf(vertex);
  painter.drawPolyline(line);
}

void CurveTool::paint(QPainter& painter) const
{
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(QColor(255, 255, 255, 210), 4), QPen(QColor(200, 60, 0), 2)}) {
    painter.setPen(pen);
    for (const auto& way : ways_) paintWay(painter, way);
  }
  for (const QPen& pen : {QPen(QColor(255, 255, 255, 210), 3.5), QPen(QColor(200, 60, 0), 1.5, Qt::DashLine)}) {
    painter.setPen(pen);
    paintWay(painter, preview_);
  }
  painter.setPen(QPen(Qt::white, 1));
  painter.setBrush(QColor(200, 60, 0));
  for (const Index vertex : places_) painter.drawEllipse(placeOf(vertex), kDot, kDot);
  if (places_.size() >= kLeastPlaces) {
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(QColor(255, 255, 255, 210), 3.5), QPen(QColor(200, 60, 0), 1.5)}) {
      painter.setPen(pen);
      painter.drawEllipse(placeOf(places_.front()), kCloseReach, kCloseReach);
    }
  } else if (places_.empty() && preview_.size() == 1) {
    painter.drawEllipse(placeOf(preview_.front()), kDot, kDot);
  }
}

}  // namespace holdfast

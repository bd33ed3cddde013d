#include "holdfast/window/controls/icons.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <functional>

namespace holdfast {
namespace {

// Signs are drawn on a square of 24 x 24.
constexpr double kSide = 24;

QPainterPath arrowTo(const QPointF& tip, double angle)
{
  QPainterPath path;
  path.moveTo(0, 0);
  path.lineTo(-5, -3.2);
  path.lineTo(-5, 3.2);
  path.closeSubpath();
  return QTransform().translate(tip.x(), tip.y()).rotate(angle).map(path);
}

void drawSelect(QPainter& painter)
{
  QPainterPath path;
  path.moveTo(6, 3);
  path.lineTo(6, 19);
  path.lineTo(10, 15.4);
  path.lineTo(12.8, 21);
  path.lineTo(15.4, 19.8);
  path.lineTo(12.7, 14.3);
  path.lineTo(18, 14);
  path.closeSubpath();
  painter.drawPath(path);
}

void drawPoint(QPainter& painter)
{
  painter.drawPolygon(QPolygonF({{3, 19}, {21, 19}, {12, 4}}));
  painter.setBrush(painter.pen().color());
  painter.drawEllipse(QPointF(12, 14), 2.6, 2.6);
}

void drawRelative(QPainter& painter)
{
  painter.drawEllipse(QPointF(5, 19), 2.6, 2.6);
  painter.drawLine(QPointF(7, 17), QPointF(15, 9));
  painter.setBrush(painter.pen().color());
  painter.drawPath(arrowTo({17, 7}, -45));
  painter.drawEllipse(QPointF(19.4, 4.6), 2.2, 2.2);
}

void drawBrush(QPainter& painter)
{
  painter.drawEllipse(QPointF(9.5, 14.5), 6.5, 6.5);
  painter.drawLine(QPointF(14.2, 9.8), QPointF(20.5, 3.5));
  painter.setBrush(painter.pen().color());
  for (const QPointF& place : {QPointF(7.5, 13), QPointF(11, 13.5), QPointF(9, 17)}) painter.drawEllipse(place, 1, 1);
}

void drawRectangle(QPainter& painter)
{
  QPen dashed = painter.pen();
  dashed.setDashPattern({2.2, 1.8});
  dashed.setCapStyle(Qt::FlatCap);
  painter.setPen(dashed);
  painter.drawRect(QRectF(3.5, 5.5, 17, 13));
}

void drawLasso(QPainter& painter)
{
  QPainterPath path;
  path.moveTo(7, 16);
  path.cubicTo(-1, 12, 4, 3, 13, 4);
  path.cubicTo(23, 5, 23, 14, 14, 16);
  path.cubicTo(9, 17, 7, 17, 7, 16);
  path.cubicTo(7, 19, 9, 20, 11, 21);
  painter.drawPath(path);
}

void drawFlood(QPainter& painter)
{
  painter.drawPolygon(QPolygonF({{12, 3}, {20.5, 8}, {12, 13}, {3.5, 8}}));
  painter.drawPolyline(QPolygonF({{3.5, 8}, {3.5, 16}, {12, 21}, {20.5, 16}, {20.5, 8}}));
  painter.drawLine(QPointF(12, 13), QPointF(12, 21));
  QColor filled = painter.pen().color();
  filled.setAlphaF(filled.alphaF() * 0.55);
  painter.setBrush(filled);
  painter.drawPolygon(QPolygonF({{12, 3}, {20.5, 8}, {12, 13}, {3.5, 8}}));
}

void drawCurve(QPainter& painter)
{
  QPainterPath path;
  path.moveTo(12, 4);
  path.cubicTo(22, 4, 22, 13, 17, 17);
  path.cubicTo(12, 21, 4, 20, 4, 13);
  path.cubicTo(4, 8, 7, 4, 12, 4);
  painter.drawPath(path);
  painter.setBrush(painter.pen().color());
  for (const QPointF& place : {QPointF(12, 4), QPointF(17, 17), QPointF(4, 13)}) painter.drawEllipse(place, 2, 2);
}

void drawRuler(QPainter& painter)
{
  painter.drawPolygon(QPolygonF({{3, 16}, {16, 3}, {21, 8}, {8, 21}}));
  for (const double at : {0.25, 0.5, 0.75})
    painter.drawLine(QPointF(3 + 13 * at, 16 - 13 * at), QPointF(5.5 + 13 * at, 18.5 - 13 * at));
}

void drawFix(QPainter& painter)
{
  painter.drawEllipse(QPointF(12, 8), 4.5, 4.5);
  painter.drawLine(QPointF(12, 12.5), QPointF(12, 17));
  painter.drawLine(QPointF(4.5, 17), QPointF(19.5, 17));
  for (double x = 6; x < 20; x += 4) painter.drawLine(QPointF(x, 17), QPointF(x - 2, 20.5));
}

void drawHandle(QPainter& painter)
{
  painter.drawLine(QPointF(12, 5), QPointF(12, 19));
  painter.drawLine(QPointF(5, 12), QPointF(19, 12));
  painter.setBrush(painter.pen().color());
  painter.drawPath(arrowTo({12, 2}, -90));
  painter.drawPath(arrowTo({12, 22}, 90));
  painter.drawPath(arrowTo({2, 12}, 180));
  painter.drawPath(arrowTo({22, 12}, 0));
}

void drawRigid(QPainter& painter)
{
  painter.drawRoundedRect(QRectF(4, 4, 16, 16), 3, 3);
  painter.setBrush(painter.pen().color());
  for (const QPointF& place : {QPointF(8.5, 8.5), QPointF(15.5, 8.5), QPointF(8.5, 15.5), QPointF(15.5, 15.5)})
    painter.drawEllipse(place, 1.6, 1.6);
  painter.drawLine(QPointF(8.5, 8.5), QPointF(15.5, 15.5));
  painter.drawLine(QPointF(15.5, 8.5), QPointF(8.5, 15.5));
}

void drawTurnBack(QPainter& painter)
{
  QPainterPath path;
  path.moveTo(8, 7);
  path.lineTo(14, 7);
  path.arcTo(QRectF(8.5, 7, 11, 11), 90, -180);
  path.lineTo(9, 18);
  painter.drawPath(path);
  painter.setBrush(painter.pen().color());
  painter.drawPath(arrowTo({3.5, 7}, 180));
}

void drawTurnForth(QPainter& painter)
{
  painter.translate(kSide, 0);
  painter.scale(-1, 1);
  drawTurnBack(painter);
}

void drawOpen(QPainter& painter)
{
  painter.drawPolyline(QPolygonF({{3, 19}, {3, 5}, {9, 5}, {11, 7.5}, {19, 7.5}, {19, 10}}));
  painter.drawPolygon(QPolygonF({{3, 19}, {6.5, 10}, {22, 10}, {18.5, 19}}));
}

void drawSave(QPainter& painter)
{
  painter.drawPolygon(QPolygonF({{4, 4}, {17, 4}, {20, 7}, {20, 20}, {4, 20}}));
  painter.drawRect(QRectF(8, 4, 7, 5));
  painter.drawRect(QRectF(7.5, 13, 9, 7));
}

void drawImport(QPainter& painter)
{
  painter.drawPolyline(QPolygonF({{4, 14}, {4, 20}, {20, 20}, {20, 14}}));
  painter.drawLine(QPointF(12, 3), QPointF(12, 11));
  painter.setBrush(painter.pen().color());
  painter.drawPath(arrowTo({12, 15.5}, 90));
}

void drawFrame(QPainter& painter)
{
  for (const double turn : {0.0, 90.0, 180.0, 270.0}) {
    painter.save();
    painter.translate(kSide / 2, kSide / 2);
    painter.rotate(turn);
    painter.drawPolyline(QPolygonF({{-9, -4}, {-9, -9}, {-4, -9}}));
    painter.restore();
  }
  painter.drawEllipse(QPointF(12, 12), 3, 3);
}

void draw(Sign sign, QPainter& painter)
{
  switch (sign) {
    case Sign::Select:
      return drawSelect(painter);
    case Sign::Point:
      return drawPoint(painter);
    case Sign::Relative:
      return drawRelative(painter);
    case Sign::Brush:
      return drawBrush(painter);
    case Sign::Rectangle:
      return drawRectangle(painter);
    case Sign::Lasso:
      return drawLasso(painter);
    case Sign::Flood:
      return drawFlood(painter);
    case Sign::Curve:
      return drawCurve(painter);
    case Sign::Ruler:
      return drawRuler(painter);
    case Sign::Fix:
      return drawFix(painter);
    case Sign::Handle:
      return drawHandle(painter);
    case Sign::Rigid:
      return drawRigid(painter);
    case Sign::Undo:
      return drawTurnBack(painter);
    case Sign::Redo:
      return drawTurnForth(painter);
    case Sign::Open:
      return drawOpen(painter);
    case Sign::Save:
      return drawSave(painter);
    case Sign::Import:
      return drawImport(painter);
    case Sign::Frame:
      return drawFrame(painter);
  }
}

class SignEngine : public QIconEngine {
 public:
  SignEngine(Sign sign, const QPalette& palette) : sign_(sign), palette_(palette) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State /*state*/) override
  {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / kSide, rect.height() / kSide);
    painter->setPen(QPen(palette_.color(group, QPalette::WindowText), 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->setBrush(Qt::NoBrush);
    draw(sign_, *painter);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
  {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  [[nodiscard]] QIconEngine* clone() const override { return new SignEngine(sign_, palette_); }

 private:
  Sign sign_;
  QPalette palette_;
};

}  // namespace

QIcon iconOf(Sign sign, const QPalette& palette)
{
  return QIcon(new SignEngine(sign, palette));
}

}  // namespace holdfast

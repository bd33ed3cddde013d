#include "holdfast/window/controls/icons.h"

#include <QIconEngine>
#include <QPainter>
#include <array>
#include <sstream>

namespace holdfast {
namespace {

constexpr double kSide = 24;

struct Drawing {
  const char* lines;
  const char* filled;
};

// In the order of `Sign`.
constexpr std::array kDrawings{
    Drawing{"M6 3 L6 19 L10 15.4 L12.8 21 L15.4 19.8 L12.7 14.3 L18 14 Z", ""},
    Drawing{"M3 19 L21 19 L12 4 Z", "O12 14 2.6"},
    Drawing{"O5 19 2.6 M7 17 L15 9", "M17 7 L11.2 8.3 L15.7 12.8 Z O19.4 4.6 2.2"},
    Drawing{"O9.5 14.5 6.5 M14.2 9.8 L20.5 3.5", "O7.5 13 1 O11 13.5 1 O9 17 1"},
    Drawing{"M7 5.5 L3.5 5.5 L3.5 8.5 M3.5 10.5 L3.5 13.5 M3.5 15.5 L3.5 18.5 L7 18.5 M10.2 18.5 L13.8 18.5"
            "M17 18.5 L20.5 18.5 L20.5 15.5 M20.5 13.5 L20.5 10.5 M20.5 8.5 L20.5 5.5 L17 5.5 M13.8 5.5 L10.2 5.5",
            ""},
    Drawing{"M7 16 C-1 12 4 3 13 4 C23 5 23 14 14 16 C9 17 7 17 7 16 C7 19 9 20 11 21", ""},
    Drawing{"M3.5 8 L3.5 16 L12 21 L20.5 16 L20.5 8 M12 13 L12 21", "M12 3 L20.5 8 L12 13 L3.5 8 Z"},
    Drawing{"M12 4 C22 4 22 13 17 17 C12 21 4 20 4 13 C4 8 7 4 12 4", "O12 4 2 O17 17 2 O4 13 2"},
    Drawing{"M3 16 L16 3 L21 8 L8 21 Z M6.25 12.75 L8.75 15.25 M9.5 9.5 L12 12 M12.75 6.25 L15.25 8.75", ""},
    Drawing{"O12 12 6.5 M12 2.5 L12 8 M12 16 L12 21.5 M2.5 12 L8 12 M16 12 L21.5 12", "O12 12 1.6"},
    Drawing{"O12 8 4.5 M12 12.5 L12 17 M4.5 17 L19.5 17 M6 17 L4 20.5 M10 17 L8 20.5 M14 17 L12 20.5 M18 17 L16 20.5",
            ""},
    Drawing{"M12 5 L12 19 M5 12 L19 12",
            "M12 2 L8.8 7 L15.2 7 Z M12 22 L15.2 17 L8.8 17 Z M2 12 L7 15.2 L7 8.8 Z"
            "M22 12 L17 8.8 L17 15.2 Z"},
    Drawing{
        "M7 4 L17 4 C18.7 4 20 5.3 20 7 L20 17 C20 18.7 18.7 20 17 20 L7 20 C5.3 20 4 18.7 4 17 L4 7 C4 5.3 5.3 4 7 4"
        "M8.5 8.5 L15.5 15.5 M15.5 8.5 L8.5 15.5",
        "O8.5 8.5 1.6 O15.5 8.5 1.6 O8.5 15.5 1.6 O15.5 15.5 1.6"},
    Drawing{"M8 7 L14 7 C17 7 19.5 9.5 19.5 12.5 C19.5 15.5 17 18 14 18 L9 18", "M3.5 7 L8.5 10.2 L8.5 3.8 Z"},
    Drawing{"M16 7 L10 7 C7 7 4.5 9.5 4.5 12.5 C4.5 15.5 7 18 10 18 L15 18", "M20.5 7 L15.5 10.2 L15.5 3.8 Z"},
    Drawing{"M3 8 L3 3 L8 3 M16 3 L21 3 L21 8 M21 16 L21 21 L16 21 M8 21 L3 21 L3 16 O12 12 3", ""},
    Drawing{"M3 8 L3 3 L8 3 M11 3 L15 3 L15 7 M15 10 L15 15 L10 15 M7 15 L3 15 L3 11",
            "M9 9 L21 13.5 L16 16 L13.5 21 Z"}};

class DrawnEngine : public QIconEngine {
 public:
  DrawnEngine(double side, std::function<void(QPainter&, QIcon::Mode)> draw) : side_(side), draw_(std::move(draw)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State /*state*/) override
  {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / side_, rect.height() / side_);
    draw_(*painter, mode);
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

  [[nodiscard]] QIconEngine* clone() const override { return new DrawnEngine(side_, draw_); }

 private:
  double side_;
  std::function<void(QPainter&, QIcon::Mode)> draw_;
};

}  // namespace

QIcon iconOf(Sign sign, const QPalette& palette)
{
  return drawnIcon(kSide, [sign, palette](QPainter& painter, QIcon::Mode mode) {
    const auto& [lines, filled] = kDrawings[static_cast<std::size_t>(sign)];
    const QColor& color =
        palette.color(mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::WindowText);
    painter.setPen(QPen(color, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(drawnPath(lines));
    painter.setBrush(color);
    painter.drawPath(drawnPath(filled));
  });
}

QIcon programIcon()
{
  return drawnIcon(kSide, [](QPainter& painter, QIcon::Mode /*mode*/) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor("#24467c"));
    painter.drawRoundedRect(QRectF(0.5, 0.5, 23, 23), 5, 5);
    painter.setBrush(QColor("#8fc7d8"));
    painter.drawPath(drawnPath("M2.5 19.5 C7 19.5 8 9.5 12 9.5 C16 9.5 17 19.5 21.5 19.5 Z"));
    painter.setBrush(QColor("#f4d35e"));
    painter.drawPath(drawnPath("O12 8.5 3.6"));
  });
}

QIcon drawnIcon(double side, std::function<void(QPainter& painter, QIcon::Mode mode)> draw)
{
  return QIcon(new DrawnEngine(side, std::move(draw)));
}

QPainterPath drawnPath(const char* text)
{
  QPainterPath path;
  std::istringstream in(text);
  std::array<double, 6> n{};
  for (char command = 0; in >> command;) {
    const std::size_t count = command == 'Z' ? 0 : command == 'C' ? 6 : command == 'O' ? 3 : 2;
    for (std::size_t k = 0; k < count; ++k) in >> n[k];
    if (command == 'M') path.moveTo(n[0], n[1]);
    if (command == 'L') path.lineTo(n[0], n[1]);
    if (command == 'C') path.cubicTo(n[0], n[1], n[2], n[3], n[4], n[5]);
    if (command == 'O') path.addEllipse(QPointF(n[0], n[1]), n[2], n[2]);
    if (command == 'Z') path.closeSubpath();
  }
  return path;
}

}  // namespace holdfast

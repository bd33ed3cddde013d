#include "holdfast/window/controls/status_style.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <array>

namespace holdfast {
namespace {

// Drawn in a square of this side, at the sizes that displays of one, two and three times the usual density ask for.
constexpr double kFormSide = 16;
constexpr std::array kPixels = {16, 24, 32, 48};

constexpr double kQuiet = 0.55;  // the share of the text's colour in a quiet one

struct Shades {
  const char* onLight;
  const char* onDark;
};

Shades shadesOf(std::optional<ConstraintStatus> status)
{
  if (!status) return {"#6b6b6b", "#a8a8a8"};
  switch (*status) {
    case ConstraintStatus::Met:
      return {"#00704f", "#45c79a"};
    case ConstraintStatus::Redundant:
      return {"#3a66a8", "#8fb7ee"};
    case ConstraintStatus::Conflicting:
      return {"#c23b00", "#ff8f5e"};
    case ConstraintStatus::Missed:
      return {"#8b3a8f", "#e09be3"};
    case ConstraintStatus::Independent:
    case ConstraintStatus::Disabled:
      break;
  }
  return {"#6b6b6b", "#a8a8a8"};
}

void drawLines(QPainter& painter, const QPen& pen, std::initializer_list<QPointF> points)
{
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(points.begin(), static_cast<int>(points.size()));
}

/// Draws one form in a square of `kFormSide`.
class Form {
 public:
  Form(QPainter& painter, const QColor& color, const QColor& paper) : painter_(painter), color_(color), paper_(paper) {}

  void met() const
  {
    fill([](QPainterPath& path) { path.addEllipse(QPointF(8, 8), 6.5, 6.5); });
    drawLines(painter_, pen(paper_, 1.8), {{4.9, 8.3}, {7.2, 10.6}, {11.2, 5.8}});
  }
  void redundant() const
  {
    ring(Qt::SolidLine);
    drawLines(painter_, pen(color_, 1.5), {{5.4, 6.6}, {10.6, 6.6}});
    drawLines(painter_, pen(color_, 1.5), {{5.4, 9.4}, {10.6, 9.4}});
  }
  void conflicting() const
  {
    fill([](QPainterPath& path) { path.addPolygon(QPolygonF({{8, 1.2}, {15.2, 14.2}, {0.8, 14.2}, {8, 1.2}})); });
    drawLines(painter_, pen(paper_, 1.8), {{8, 5.8}, {8, 9.4}});
    drawLines(painter_, pen(paper_, 1.9), {{8, 12.0}, {8, 12.1}});
  }
  void missed() const
  {
    fill([](QPainterPath& path) { path.addPolygon(QPolygonF({{8, 0.8}, {15.2, 8}, {8, 15.2}, {0.8, 8}, {8, 0.8}})); });
    drawLines(painter_, pen(paper_, 1.7), {{5.2, 8}, {10.8, 8}});
  }
  void independent() const
  {
    ring(Qt::SolidLine);
    fill([](QPainterPath& path) { path.addEllipse(QPointF(8, 8), 2.2, 2.2); });
  }
  void disabled() const { ring(Qt::DashLine); }
  void unsolved() const
  {
    fill([](QPainterPath& path) {
      for (const double x : {3.2, 8.0, 12.8}) path.addEllipse(QPointF(x, 8), 1.5, 1.5);
    });
  }

 private:
  template <class Make>
  void fill(Make make) const
  {
    QPainterPath path;
    make(path);
    painter_.fillPath(path, color_);
  }
  void ring(Qt::PenStyle style) const
  {
    QPen line = pen(color_, 1.5);
    line.setStyle(style);
    painter_.setPen(line);
    painter_.setBrush(Qt::NoBrush);
    painter_.drawEllipse(QPointF(8, 8), 6.2, 6.2);
  }
  static QPen pen(const QColor& color, double width)
  {
    return {color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
  }

  QPainter& painter_;
  QColor color_;
  QColor paper_;
};

void draw(std::optional<ConstraintStatus> status, const Form& form)
{
  if (!status) return form.unsolved();
  switch (*status) {
    case ConstraintStatus::Independent:
      return form.independent();
    case ConstraintStatus::Met:
      return form.met();
    case ConstraintStatus::Redundant:
      return form.redundant();
    case ConstraintStatus::Conflicting:
      return form.conflicting();
    case ConstraintStatus::Missed:
      return form.missed();
    case ConstraintStatus::Disabled:
      return form.disabled();
  }
}

}  // namespace

Lightness lightnessOf(const QPalette& palette)
{
  return palette.color(QPalette::Base).lightness() < palette.color(QPalette::Text).lightness() ? Lightness::Dark
                                                                                               : Lightness::Light;
}

QColor quietColor(const QPalette& palette)
{
  const QColor text = palette.color(QPalette::Active, QPalette::Text);
  const QColor base = palette.color(QPalette::Active, QPalette::Base);
  const auto mixed = [](double a, double b) { return kQuiet * a + (1 - kQuiet) * b; };
  return QColor::fromRgbF(mixed(text.redF(), base.redF()), mixed(text.greenF(), base.greenF()),
                          mixed(text.blueF(), base.blueF()));
}

QColor statusColor(std::optional<ConstraintStatus> status, Lightness background)
{
  const Shades shades = shadesOf(status);
  return {background == Lightness::Dark ? shades.onDark : shades.onLight};
}

QIcon statusIcon(std::optional<ConstraintStatus> status, Lightness background)
{
  const QColor paper = background == Lightness::Dark ? QColor("#202020") : QColor("#ffffff");
  QIcon icon;
  const auto add = [&](int pixels, QIcon::Mode mode, const QColor& color, const QColor& within) {
    QPixmap pixmap(pixels, pixels);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(pixels / kFormSide, pixels / kFormSide);
    draw(status, Form(painter, color, within));
    painter.end();
    icon.addPixmap(pixmap, mode);
  };
  for (const int pixels : kPixels) {
    add(pixels, QIcon::Normal, statusColor(status, background), paper);
    // On the colour of selected rows, which is one of the forms' own.
    add(pixels, QIcon::Selected, Qt::white, QColor("#202020"));
  }
  return icon;
}

}  // namespace holdfast

#include "holdfast/window/controls/status_style.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/window/controls/icons.h>
#include <holdfast/window/controls/theme.h>

namespace holdfast {
namespace {

constexpr double kQuiet = 0.68;  // the share of the text's colour in a quiet one

// WCAG 2.2 asks as much of signs (1.4.11).
constexpr double kLeastContrast = 3;

/// A body has the colour of the picture's glyphs, and an outline where the paper has nearly that colour. Lines without
/// a body, and texts, are in the colour for light or dark paper.
struct Look {
  std::optional<ConstraintStatus> status;
  const char* onLight;
  const char* onDark;
  const char* body;
  const char* lines;
  Qt::PenStyle style = Qt::SolidLine;
};

constexpr std::array kLooks{
    Look{std::nullopt, "#666666", "#a8a8a8", "", "O3.2 8 0.7 O8 8 0.7 O12.8 8 0.7"},
    Look{ConstraintStatus::Met, "#00704f", "#45c79a", "O8 8 6.5", "M4.9 8.3 L7.2 10.6 L11.2 5.8"},
    Look{ConstraintStatus::Redundant, "#3a66a8", "#8fb7ee", "O8 8 6.5", "M5.2 6.5 L10.8 6.5 M5.2 9.5 L10.8 9.5"},
    Look{ConstraintStatus::Conflicting, "#b83600", "#ff8f5e", "M8 1.2 L15.2 14.2 L0.8 14.2 Z",
         "M8 5.8 L8 9.4 M8 12 L8 12.1"},
    Look{ConstraintStatus::Missed, "#8b3a8f", "#e09be3", "M8 0.8 L15.2 8 L8 15.2 L0.8 8 Z", "M5.2 8 L10.8 8"},
    Look{ConstraintStatus::Independent, "#666666", "#a8a8a8", "", "O8 8 6.2 O8 8 0.9 O8 8 2.2"},
    Look{ConstraintStatus::Disabled, "#666666", "#a8a8a8", "", "O8 8 6.2", Qt::DashLine}};

const Look& lookOf(std::optional<ConstraintStatus> status)
{
  return *std::find_if(kLooks.begin(), kLooks.end(), [&](const Look& look) { return look.status == status; });
}

}  // namespace

QColor quietColor(const QPalette& palette)
{
  const QColor& text = palette.color(QPalette::Active, QPalette::Text);
  const QColor& base = palette.color(QPalette::Active, QPalette::Base);
  const auto mixed = [](double a, double b) { return kQuiet * a + (1 - kQuiet) * b; };
  return QColor::fromRgbF(mixed(text.redF(), base.redF()), mixed(text.greenF(), base.greenF()),
                          mixed(text.blueF(), base.blueF()));
}

QColor statusColor(std::optional<ConstraintStatus> status, const QPalette& palette)
{
  return {isDark(palette) ? lookOf(status).onDark : lookOf(status).onLight};
}

QIcon statusIcon(std::optional<ConstraintStatus> status, const QPalette& palette)
{
  constexpr double kSide = 16;
  return drawnIcon(kSide, [&look = lookOf(status), palette](QPainter& painter, QIcon::Mode mode) {
    const bool isSelected = mode == QIcon::Selected;
    const QColor& paper = palette.color(QPalette::Active, isSelected ? QPalette::Highlight : QPalette::Base);
    const QColor ink = isSelected ? QColor(Qt::white) : statusColor(look.status, palette);
    if (*look.body == 0)
      return painter.strokePath(drawnPath(look.lines), QPen(ink, 1.7, look.style, Qt::RoundCap, Qt::RoundJoin));
    const QColor body = toQColor(glyphColor(*look.status));
    const QPainterPath form = drawnPath(look.body);
    painter.fillPath(form, body);
    if (contrast(body, paper) < kLeastContrast)
      painter.strokePath(form, QPen(palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text), 1.4));
    const QColor sign = contrast(body, Qt::white) >= kLeastContrast ? QColor(Qt::white) : QColor("#202020");
    painter.strokePath(drawnPath(look.lines), QPen(sign, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  });
}

}  // namespace holdfast

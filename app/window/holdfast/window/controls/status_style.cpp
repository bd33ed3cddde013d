#include "holdfast/window/controls/status_style.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include <holdfast/window/controls/icons.h>
#include <holdfast/window/controls/theme.h>

namespace holdfast {
namespace {

constexpr double kQuiet = 0.55;  // the share of the text's colour in a quiet one

/// Lines are in the colour; those within a filled form are in the colour of the paper.
struct Look {
  std::optional<ConstraintStatus> status;
  const char* onLight;
  const char* onDark;
  const char* filled;
  const char* lines;
  const char* inPaper = "";
  Qt::PenStyle style = Qt::SolidLine;
};

constexpr std::array kLooks{
    Look{std::nullopt, "#6b6b6b", "#a8a8a8", "O3.2 8 1.5 O8 8 1.5 O12.8 8 1.5", ""},
    Look{ConstraintStatus::Met, "#00704f", "#45c79a", "O8 8 6.5", "", "M4.9 8.3 L7.2 10.6 L11.2 5.8"},
    Look{ConstraintStatus::Redundant, "#3a66a8", "#8fb7ee", "", "O8 8 6.2 M5.4 6.6 L10.6 6.6 M5.4 9.4 L10.6 9.4"},
    Look{ConstraintStatus::Conflicting, "#c23b00", "#ff8f5e", "M8 1.2 L15.2 14.2 L0.8 14.2 Z", "",
         "M8 5.8 L8 9.4 M8 12 L8 12.1"},
    Look{ConstraintStatus::Missed, "#8b3a8f", "#e09be3", "M8 0.8 L15.2 8 L8 15.2 L0.8 8 Z", "", "M5.2 8 L10.8 8"},
    Look{ConstraintStatus::Independent, "#6b6b6b", "#a8a8a8", "O8 8 2.2", "O8 8 6.2"},
    Look{ConstraintStatus::Disabled, "#6b6b6b", "#a8a8a8", "", "O8 8 6.2", "", Qt::DashLine}};

const Look& lookOf(std::optional<ConstraintStatus> status)
{
  return *std::find_if(kLooks.begin(), kLooks.end(), [&](const Look& look) { return look.status == status; });
}

}  // namespace

QColor quietColor(const QPalette& palette)
{
  const QColor text = palette.color(QPalette::Active, QPalette::Text);
  const QColor base = palette.color(QPalette::Active, QPalette::Base);
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
  const QColor paperAround(isDark(palette) ? "#202020" : "#ffffff");
  return drawnIcon(kSide, [&look = lookOf(status), ownColor = statusColor(status, palette), paperAround](
                              QPainter& painter, QIcon::Mode mode) {
    // Selected rows have a colour that is also one of the forms'.
    const bool isSelected = mode == QIcon::Selected;
    const QColor color = isSelected ? QColor(Qt::white) : ownColor;
    const QColor paper = isSelected ? QColor("#202020") : paperAround;
    painter.fillPath(drawnPath(look.filled), color);
    painter.strokePath(drawnPath(look.lines), QPen(color, 1.5, look.style, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(drawnPath(look.inPaper), QPen(paper, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  });
}

}  // namespace holdfast

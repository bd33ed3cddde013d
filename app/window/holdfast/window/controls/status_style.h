#pragma once
/// Says how the status of a constraint looks everywhere. Each status has a form of its own, and the colour of its
/// glyphs.

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <optional>

#include <holdfast/deform/report.h>

namespace holdfast {

/// Returns a colour for less important texts. It is between those of text and background, and still readable.
[[nodiscard]] QColor quietColor(const QPalette& palette);

/// Returns a colour that is readable on the palette's background. No status means that the constraint was not solved
/// yet.
[[nodiscard]] QColor statusColor(std::optional<ConstraintStatus> status, const QPalette& palette);

[[nodiscard]] QIcon statusIcon(std::optional<ConstraintStatus> status, const QPalette& palette);

}  // namespace holdfast

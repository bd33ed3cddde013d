#pragma once
/// How the status of a constraint looks everywhere: each one has a form of its own, and the colour of its glyphs.

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <optional>

#include <holdfast/deform/report.h>

namespace holdfast {

/// For less important texts: between text and background, still readable.
[[nodiscard]] QColor quietColor(const QPalette& palette);

/// Readable on the palette's background. No status means that the constraint was not solved yet.
[[nodiscard]] QColor statusColor(std::optional<ConstraintStatus> status, const QPalette& palette);

[[nodiscard]] QIcon statusIcon(std::optional<ConstraintStatus> status, const QPalette& palette);

}  // namespace holdfast

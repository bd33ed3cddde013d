#pragma once
/// Paints the legend over the picture: what colours mean, and how many constraints have which status.

#include <QRectF>
#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include <holdfast/deform/report.h>
#include <holdfast/widgets/scene/scene_contents.h>

class QFont;
class QPainter;
class QPalette;

namespace holdfast {

/// Holds what the legend says. The first member is at the bottom.
struct LegendContent {
  std::optional<ColorScale> scale;
  QString line;                                            ///< may be empty
  std::vector<std::pair<ConstraintStatus, Index>> counts;  ///< how many have this status
  LegendSide side = LegendSide::Right;

  friend bool operator==(const LegendContent&, const LegendContent&) = default;
};

/// Paints the legend into a lower corner of `area`. At the left it is above the note about what is under the cursor. A
/// halo keeps it legible over the mesh.
void paint(const LegendContent& legend, QPainter& painter, const QRectF& area, const QPalette& palette);

/// Returns the box around what `paint` paints; an empty box if that is nothing.
[[nodiscard]] QRectF boxOf(const LegendContent& legend, const QFont& font, const QRectF& area);

}  // namespace holdfast

#pragma once
/// The legend over the picture: what colours mean, and how many constraints have which status.

#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include <holdfast/deform/report.h>
#include <holdfast/widgets/color/color_map.h>

class QPainter;
class QPalette;
class QRectF;

namespace holdfast {

/// From below.
struct LegendContent {
  std::optional<ColorScale> scale;
  QString line;                                            ///< may be empty
  std::vector<std::pair<ConstraintStatus, Index>> counts;  ///< how many have this status

  friend bool operator==(const LegendContent&, const LegendContent&) = default;
};

/// In the lower right corner of `area`, with a halo that keeps it legible over the mesh.
void paint(const LegendContent& legend, QPainter& painter, const QRectF& area, const QPalette& palette);

}  // namespace holdfast

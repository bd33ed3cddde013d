#pragma once
/// Where labels stand over the picture: inside it, and apart from one another.

#include <QRectF>
#include <vector>

namespace holdfast {

/// `box`, moved by as little as brings it inside `room`; at its upper left corner where it is larger.
[[nodiscard]] QRectF movedInto(QRectF box, const QRectF& room);

/// The same, and moved up or down by as little as keeps it clear of all that is `taken`; where there is no such place
/// inside `room`, as `movedInto` gives it.
[[nodiscard]] QRectF movedClear(const QRectF& box, const QRectF& room, const std::vector<QRectF>& taken);

}  // namespace holdfast

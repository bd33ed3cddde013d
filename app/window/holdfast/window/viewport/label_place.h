#pragma once
/// Places labels over the picture: inside it, and apart from one another.

#include <QRectF>
#include <vector>

namespace holdfast {

/// Returns `box`, moved by as little as brings it inside `room`. A box that is larger than `room` goes to its upper
/// left corner.
[[nodiscard]] QRectF movedInto(QRectF box, const QRectF& room);

/// Returns what `movedInto` returns, moved up or down by as little as keeps it clear of all that is `taken`. If no such
/// place is inside `room`, it returns what `movedInto` returns.
[[nodiscard]] QRectF movedClear(const QRectF& box, const QRectF& room, const std::vector<QRectF>& taken);

}  // namespace holdfast

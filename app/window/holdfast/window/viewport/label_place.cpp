#include "holdfast/window/viewport/label_place.h"

#include <algorithm>
#include <cmath>

namespace holdfast {
namespace {

constexpr double kLabelGap = 2;

}  // namespace

QRectF movedInto(QRectF box, const QRectF& room)
{
  box.moveLeft(std::max(room.left(), std::min(box.left(), room.right() - box.width())));
  box.moveTop(std::max(room.top(), std::min(box.top(), room.bottom() - box.height())));
  return box;
}

QRectF movedClear(const QRectF& box, const QRectF& room, const std::vector<QRectF>& taken)
{
  const QRectF wanted = movedInto(box, room);
  std::vector<double> tops{wanted.top()};
  for (const QRectF& other : taken) {
    tops.push_back(other.top() - kLabelGap - wanted.height());
    tops.push_back(other.bottom() + kLabelGap);
  }
  std::ranges::stable_sort(tops, {}, [&](double top) { return std::abs(top - wanted.top()); });
  for (const double top : tops) {
    const QRectF place(QPointF(wanted.left(), top), wanted.size());
    if (room.contains(place) && std::ranges::none_of(taken, [&](const QRectF& t) { return t.intersects(place); }))
      return place;
  }
  return wanted;
}

}  // namespace holdfast

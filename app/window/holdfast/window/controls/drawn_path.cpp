#include "holdfast/window/controls/drawn_path.h"

#include <array>
#include <sstream>

namespace holdfast {

QPainterPath drawnPath(const char* text)
{
  QPainterPath path;
  std::istringstream in(text);
  std::array<double, 6> n{};
  for (char command = 0; in >> command;) {
    const std::size_t count = command == 'Z' ? 0 : command == 'C' ? 6 : command == 'O' ? 3 : 2;
    for (std::size_t k = 0; k < count; ++k) in >> n[k];
    switch (command) {
      case 'M':
        path.moveTo(n[0], n[1]);
        break;
      case 'L':
        path.lineTo(n[0], n[1]);
        break;
      case 'C':
        path.cubicTo(n[0], n[1], n[2], n[3], n[4], n[5]);
        break;
      case 'O':
        path.addEllipse(QPointF(n[0], n[1]), n[2], n[2]);
        break;
      default:
        path.closeSubpath();
    }
  }
  return path;
}

}  // namespace holdfast

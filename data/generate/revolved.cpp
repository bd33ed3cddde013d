#include "revolved.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace holdfast::generate {

double Revolution::edgeAt(double radius) const
{
  return 2 * std::numbers::pi * radius / static_cast<double>(count);
}

std::vector<Meridian> straightMeridian(const Meridian& from, const Meridian& to, double edge)
{
  const double length = std::hypot(to.radius - from.radius, to.along - from.along);
  const Index rows = std::max<Index>(1, std::lround(length / (kRowHeight * edge)));
  std::vector<Meridian> result;
  for (Index i = 1; i <= rows; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(rows);
    result.push_back({(1 - t) * from.radius + t * to.radius, (1 - t) * from.along + t * to.along});
  }
  return result;
}

Shell::BandEnds addRevolved(Shell& shell, const std::string& group, const Revolution& revolution,
                            const std::vector<Meridian>& meridian)
{
  const Circle& frame = revolution.frame;
  const Vector3 axis = frame.x.cross(frame.y);
  const auto place = [&](Index row, double t) -> Vector3 {
    const Circle ring{frame.centre + meridian[row].along * axis, frame.x, frame.y, meridian[row].radius};
    return ring.at(2 * std::numbers::pi * t);
  };
  return shell.addBand(group, {static_cast<Index>(meridian.size()) - 1, revolution.count, place});
}

Shell::BandEnds addCylinder(Shell& shell, const std::string& group, const Revolution& revolution, const Meridian& from,
                            const Meridian& to)
{
  std::vector<Meridian> meridian{from};
  const double edge = revolution.edgeAt(std::max(from.radius, to.radius));
  for (const Meridian& point : straightMeridian(from, to, edge)) meridian.push_back(point);
  return addRevolved(shell, group, revolution, meridian);
}

}  // namespace holdfast::generate

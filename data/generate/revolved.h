#pragma once
/// \file
/// Bores, bosses and other surfaces of revolution.

#include "shell.h"

namespace holdfast::generate {

/// The height of an equilateral triangle of side 1: how far apart the rings of a band are, per edge length.
inline constexpr double kRowHeight = 0.866;

/// A point of a meridian: distance from the axis, and place along it.
struct Meridian {
  double radius;
  double along;
};

/// An axis, as the direction x cross y through the centre of `frame` (whose radius plays no part), and the number of
/// vertices of each ring around it.
struct Revolution {
  Circle frame;
  Index count;

  /// The edge length of a ring.
  [[nodiscard]] double edgeAt(double radius) const;
};

/// A straight piece of a meridian, its first point left out, in steps that suit rings of this edge length.
[[nodiscard]] std::vector<Meridian> straightMeridian(const Meridian& from, const Meridian& to, double edge);

/// Adds a ring for each point of the meridian. Outside is to the right of the meridian as drawn with the radius to the
/// right and the axis upwards when it runs upwards.
Shell::BandEnds addRevolved(Shell& shell, const std::string& group, const Revolution& revolution,
                            const std::vector<Meridian>& meridian);

/// The same with a straight meridian: a cylinder or a cone.
Shell::BandEnds addCylinder(Shell& shell, const std::string& group, const Revolution& revolution, const Meridian& from,
                            const Meridian& to);

}  // namespace holdfast::generate

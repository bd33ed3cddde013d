#pragma once
/// \file
/// The parts of the gizmo, and where it stands.

#include <holdfast/base/types.h>

namespace holdfast {

/// What can be grabbed. The square of an axis lies across it.
enum class GizmoPart { None, Center, ArrowX, ArrowY, ArrowZ, SquareX, SquareY, SquareZ, RingX, RingY, RingZ, ViewRing };

inline constexpr int kGizmoPartCount = 12;  ///< `None` included

enum class GizmoPartKind { None, Center, Arrow, Square, Ring, ViewRing };

[[nodiscard]] constexpr GizmoPartKind kindOf(GizmoPart part)
{
  if (part == GizmoPart::None) return GizmoPartKind::None;
  if (part == GizmoPart::Center) return GizmoPartKind::Center;
  if (part <= GizmoPart::ArrowZ) return GizmoPartKind::Arrow;
  if (part <= GizmoPart::SquareZ) return GizmoPartKind::Square;
  return part <= GizmoPart::RingZ ? GizmoPartKind::Ring : GizmoPartKind::ViewRing;
}

/// Whether the part turns; all others but `None` move.
[[nodiscard]] constexpr bool isRotation(GizmoPart part)
{
  return kindOf(part) == GizmoPartKind::Ring || kindOf(part) == GizmoPartKind::ViewRing;
}

/// 0, 1 and 2 for what belongs to x, y and z; -1 for what belongs to no axis.
[[nodiscard]] constexpr int axisIndexOf(GizmoPart part)
{
  const GizmoPartKind kind = kindOf(part);
  const bool hasAxis = kind == GizmoPartKind::Arrow || kind == GizmoPartKind::Square || kind == GizmoPartKind::Ring;
  return hasAxis ? (static_cast<int>(part) - static_cast<int>(GizmoPart::ArrowX)) % 3 : -1;
}

/// Where a gizmo stands: the columns of `axes` are orthonormal and right-handed.
struct GizmoFrame {
  Vector3 center = Vector3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

}  // namespace holdfast

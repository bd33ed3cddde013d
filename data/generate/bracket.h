#pragma once
/// \file
/// A machined bracket in millimetres: a base plate with four counterbored bolt holes, an upright wall with a bearing
/// seat in a boss, two gussets and three machining pads. x runs along the base, y from front to back, z up.

#include "grouped_mesh.h"

namespace holdfast::generate {

namespace bracket {

inline constexpr double kBaseTop = 12;
inline constexpr double kBoltX = 49;  // the bolts stand at (+-kBoltX, +-kBoltY)
inline constexpr double kBoltY = 19;
inline constexpr double kWallFront = 18;
inline constexpr double kWallBack = 30;
inline constexpr double kBoreHeight = 50;
inline constexpr double kBossFront = 10;
inline constexpr double kBossRadius = 21;

}  // namespace bracket

/// Closed, one part, outward. Groups: base, wall, fillet, gusset_1, gusset_2, boss, bore, screw_1 to screw_4, bolt_1
/// to bolt_4, pad_1 to pad_3.
[[nodiscard]] GroupedMesh makeBracket();

}  // namespace holdfast::generate

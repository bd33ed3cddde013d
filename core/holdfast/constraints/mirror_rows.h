#pragma once
/// The rows of mirrors, and what partners hand on to one another.

#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/constraints/mirror_pairs.h>

namespace holdfast {

/// A mirror with its partners, unknowns.
struct MirrorPlane {
  Index constraint = 0;  ///< place in the list
  Vector3 normal;        ///< of length 1
  MirrorPairs partners;
};

/// Adds the rows of the mirror at this place of the list: two for each pair, and one for each unknown on the plane.
/// `rest` has the places of the unknowns at rest.
void addMirrorRows(ConstraintSystem& system, const MirrorConstraint& mirror, const MirrorPairs& partners,
                   Index constraint, const Positions& rest);

/// Gives the partners of unknowns whose rotations are given the images of these, and so with rigid regions and flat
/// unknowns. `hasRotation` says for each unknown whether its rotation is given, and follows. With several planes this
/// goes on until every image has its own.
void handOnRotations(ConstraintSystem& system, const std::vector<MirrorPlane>& mirrors, std::vector<bool>& hasRotation);

}  // namespace holdfast

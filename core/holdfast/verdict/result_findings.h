#pragma once
/// The findings about a result: one for each thing that its user would not call fine. docs/errors.md lists them.

#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/rotation/rotation_options.h>
#include <holdfast/verdict/crossing_faces.h>
#include <holdfast/verdict/overshoot.h>
#include <holdfast/verdict/shape_change.h>
#include <holdfast/verdict/stated_motion.h>

namespace holdfast {

/// Returns the file faces at hinges, ascending, each once.
[[nodiscard]] std::vector<Index> facesAtFolds(const DeformedSurface& surface, const std::vector<int>& hinges);

/// Adds findings about folds, edges, areas and volumes beyond their limits.
void addShapeFindings(Findings& findings, const DeformedSurface& surface, const ShapeChange& change);

void addOvershootFindings(Findings& findings, const Overshoot& overshoot);

/// These add findings about triangles, see `invertedTriangles` and `CrossingSearch`.
void addInverted(Findings& findings, const SolverMesh& mesh, const std::vector<int>& triangles);
void addCrossing(Findings& findings, const SolverMesh& mesh, const CrossingTriangles& crossing);

/// Adds findings about targets that are their points turned, scaled or shifted as a whole, as far as the detail of the
/// surface shows it. A rotation counts where rotations are given and none is.
void addTargetFindings(Findings& findings, const SolverMesh& mesh, const ConstraintSystem& system,
                       RotationSource rotations);

void addLevelRegions(Findings& findings, const std::vector<LevelRegion>& regions, RotationSource rotations);

}  // namespace holdfast

#include "holdfast/verdict/result_findings.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/mesh/index_lists.h>

namespace holdfast {
namespace {

// A share of the diagonal: targets that lie farther off as a whole were measured in other coordinates.
constexpr double kFarShift = 0.1;

/// Adds a finding, unless it is about nothing. `text` follows the word for one or for many.
void addAbout(Findings& findings, const char* kind, const char* idsOf, std::vector<Index> ids,
              const CountedWords& words, const std::string& text)
{
  if (!ids.empty()) findings.push_back(makeFinding(kind, idsOf, std::move(ids), {words.one + text, words.many + text}));
}

const char* const kGentler = "; ask for a smaller move there, or let rotations be found";

/// What a part's rotation is given by, whatever its size.
bool hasStatedRotation(const ConstraintSystem& system, const SolverMesh& mesh, int part)
{
  return std::ranges::any_of(system.rotations, [&](const GivenRotation& given) {
    return given.isStated && !given.q.isZero(0) && mesh.componentOf[given.unknown] == part;
  });
}

/// Tells whether constraints other than points hold vertices of the part in their places.
bool isHeldElsewhere(const ConstraintSystem& system, const SolverMesh& mesh, int part)
{
  return std::ranges::any_of(system.rows, [&](const ConstraintRow& row) {
    return row.kind == RowKind::Position && row.corners == 0 && mesh.componentOf[row.terms.front().index] == part;
  });
}

void addTurned(Findings& findings, const WholeMotion& whole)
{
  const double degrees = whole.motion.degrees;
  if (2 * std::sin(degrees / 2 * kDegree) <= kVisibleDetail) return;
  const Vector3& axis = whole.motion.axis;
  addAbout(
      findings, "turned_targets", "constraint", whole.constraints, {"point goes", "points go"},
      fmt::format(" where a rotation by {:.3g} degrees about ({:.3g}, {:.3g}, {:.3g}) takes them, and no rotation is "
                  "given: detail keeps its directions; let rotations be found, or turn the mesh first if "
                  "the targets were measured in other coordinates",
                  degrees, axis.x(), axis.y(), axis.z()));
}

void addScaled(Findings& findings, const WholeMotion& whole)
{
  const double scale = whole.motion.scale;
  if (std::abs(scale - 1) <= kVisibleDetail) return;
  addAbout(findings, "scaled_targets", "constraint", whole.constraints, {"point goes", "points go"},
           fmt::format(
               " where a scaling by {:.4g} takes them: detail keeps its size; scale the mesh or the targets first if "
               "their units differ",
               scale));
}

void addShifted(Findings& findings, const WholeMotion& whole, double diagonal)
{
  const Vector3& shift = whole.motion.shift;
  if (shift.norm() <= kFarShift * diagonal) return;
  addAbout(
      findings, "shifted_targets", "constraint", whole.constraints, {"point is", "points are"},
      fmt::format(" shifted by ({:.4g}, {:.4g}, {:.4g}) as a whole, while other constraints hold the same part; align "
                  "the targets with the mesh first if they were measured in other coordinates",
                  shift.x(), shift.y(), shift.z()));
}

}  // namespace

std::vector<Index> facesAtFolds(const DeformedSurface& surface, const std::vector<int>& hinges)
{
  std::vector<int> triangles;
  for (const int h : hinges)
    triangles.insert(triangles.end(), {surface.rest.hinges[h].first, surface.rest.hinges[h].second});
  return facesOf(surface.mesh, triangles);
}

void addShapeFindings(Findings& findings, const DeformedSurface& surface, const ShapeChange& change)
{
  addAbout(findings, "folded_faces", "face", facesAtFolds(surface, change.foldedHinges),
           {"face lies folded back on a neighbour", "faces lie folded back on neighbours"},
           fmt::format(": the angle between them changed by up to {:.0f} degrees{}", change.foldDegrees, kGentler));
  addAbout(
      findings, "stretched_edges", "vertex", change.lengths.grown, {"vertex is", "vertices are"},
      fmt::format(" at {} more than {:g} times as long as at rest, by up to {:.3g}{}",
                  change.lengths.grownCount == 1 ? "an edge" : "edges", kLengthLimit, change.lengths.most, kGentler));
  addAbout(
      findings, "shortened_edges", "vertex", change.lengths.shrunk, {"vertex is", "vertices are"},
      fmt::format(" at {} less than 1/{:g} as long as at rest, down to {:.3g}{}",
                  change.lengths.shrunkCount == 1 ? "an edge" : "edges", kLengthLimit, change.lengths.least, kGentler));
  addAbout(findings, "grown_faces", "face", change.areas.grown, {"face has", "faces have"},
           fmt::format(" triangles of more than {:g} times the area at rest, up to {:.3g}{}", kAreaLimit,
                       change.areas.most, kGentler));
  addAbout(findings, "shrunk_faces", "face", change.areas.shrunk, {"face has", "faces have"},
           fmt::format(" triangles of less than 1/{:g} of the area at rest, down to {:.3g}{}", kAreaLimit,
                       change.areas.least, kGentler));
  std::vector<Index> parts = change.volumes.grown;
  parts.insert(parts.end(), change.volumes.shrunk.begin(), change.volumes.shrunk.end());
  addAbout(findings, "changed_volume", "vertex", std::move(parts), {"closed part encloses", "closed parts enclose"},
           fmt::format(
               " less than 1/{0:g} or more than {0:g} times the volume at rest: {1:.3g} to {2:.3g} of it (a vertex of "
               "each is named){3}",
               kVolumeLimit, change.volumes.least, change.volumes.most, kGentler));
}

void addOvershootFindings(Findings& findings, const Overshoot& overshoot)
{
  const std::string size = fmt::format("stand out by up to {:.3g}, where targets near them ask for {:.3g} at most",
                                       overshoot.largest, overshoot.asked);
  addAbout(findings, "overshooting_vertices", "vertex", overshoot.vertices,
           {"vertex of the surface", "vertices of the surface"}, fmt::format(" {}", size));
  addAbout(
      findings, "overshooting_points", "constraint", overshoot.constraints, {"point makes", "points make"},
      fmt::format(" vertices {}: the points nearly contradict one another; leave some of them out, keep them farther "
                  "apart than the faces are large, or use the solver \"soft\": its weight is their "
                  "tolerance",
                  size));
}

void addInverted(Findings& findings, const SolverMesh& mesh, const std::vector<int>& triangles)
{
  addAbout(findings, "inverted_faces", "face", facesOf(mesh, triangles), {"face is", "faces are"},
           fmt::format(" turned over against the surface around{}", kGentler));
}

void addCrossing(Findings& findings, const SolverMesh& mesh, const CrossingTriangles& crossing)
{
  addAbout(findings, "crossing_faces", "face", facesOf(mesh, crossing.triangles), {"face crosses", "faces cross"},
           fmt::format(" others and did not at rest: the surface passes through itself{}{}",
                       crossing.areAll ? "" : ", in so many places that only a part was searched", kGentler));
}

void addTargetFindings(Findings& findings, const SolverMesh& mesh, const ConstraintSystem& system,
                       RotationSource rotations)
{
  for (const WholeMotion& whole : wholeMotions(system, mesh)) {
    const bool isSeen = whole.motion.moved > kVisible * mesh.diagonal;
    if (isSeen && !whole.explainsTargets()) continue;
    if (isHeldElsewhere(system, mesh, whole.part)) addShifted(findings, whole, mesh.diagonal);
    if (!isSeen) continue;
    if (rotations == RotationSource::Given && !hasStatedRotation(system, mesh, whole.part)) addTurned(findings, whole);
    addScaled(findings, whole);
  }
  addAbout(
      findings, "swapped_targets", "constraint", swappedTargets(system, mesh), {"constraint asks", "constraints ask"},
      " for the place of another one, which asks for theirs, or for a vector that points the other way; exchange the "
      "targets if they were swapped");
}

void addLevelRegions(Findings& findings, const std::vector<LevelRegion>& regions, RotationSource rotations)
{
  std::vector<Index> constraints;
  double degrees = 0;
  for (const LevelRegion& region : regions) {
    constraints.push_back(region.constraint);
    degrees = std::max(degrees, region.degrees);
  }
  addAbout(findings, "level_regions", "constraint", std::move(constraints),
           {"region keeps its rotation", "regions keep their rotation"},
           fmt::format(" while the surface around turns by up to {:.3g} degrees against it; {}give handles a rotation",
                       degrees, rotations == RotationSource::Given ? "let rotations be found, or " : ""));
}

}  // namespace holdfast

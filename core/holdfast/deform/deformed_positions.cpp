#include "holdfast/deform/deformed_positions.h"

#include <array>

#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

/// Tells for each unknown whether it is several vertices of the file.
std::vector<char> sharedUnknowns(const Weld& weld)
{
  std::vector<char> isShared(static_cast<std::size_t>(weld.unknownCount), 0);
  if (weld.unknownCount == static_cast<Index>(weld.unknownOf.size())) return isShared;
  for (std::size_t v = 0; v < weld.unknownOf.size(); ++v)
    if (weld.firstVertexOf[weld.unknownOf[v]] != static_cast<int>(v)) isShared[weld.unknownOf[v]] = 1;
  return isShared;
}

/// `target`; but at rest the coordinates of the file, of which vertices that are one unknown may have 0 and -0.
Eigen::RowVector3d pinned(const Vector3& target, const Eigen::RowVector3d& rest, bool isShared)
{
  Eigen::RowVector3d place = target;
  for (Index k = 0; k < 3; ++k)
    if (isShared && place[k] == rest[k]) place[k] = rest[k];
  return place;
}

/// The rows that hold single coordinates of vertices by themselves, the later ones first.
std::vector<const ConstraintRow*> coordinateRows(const ConstraintSystem& system, const Diagnosis& diagnosis)
{
  std::vector<const ConstraintRow*> result;
  for (std::size_t r = system.rows.size(); r-- > 0;) {
    const ConstraintRow& row = system.rows[r];
    if (row.directions.areAll() || row.kind != RowKind::Position || row.terms.size() > 1) continue;
    if (diagnosis.status[r] != RowStatus::Conflicting && row.directions.coordinates().any()) result.push_back(&row);
  }
  return result;
}

/// Takes single coordinates of vertices that are no pins as they are asked for.
void copyCoordinates(Positions& positions, const std::vector<const ConstraintRow*>& rows, const std::vector<int>& pinOf,
                     const std::vector<int>& unknownOf)
{
  if (rows.empty()) return;
  std::vector<std::array<const ConstraintRow*, 3>> rowOf(pinOf.size());
  for (const ConstraintRow* const row : rows)
    for (std::size_t k = 0; k < 3; ++k)
      if (row->directions.coordinates()[k]) rowOf[row->terms.front().index][k] = row;
  parallelBlocks(positions.rows(), [&](Index v) {
    for (std::size_t k = 0; k < 3; ++k)
      if (const ConstraintRow* const row = rowOf[unknownOf[v]][k]; row != nullptr && pinOf[unknownOf[v]] < 0)
        positions(v, static_cast<Index>(k)) = row->target[static_cast<Index>(k)];
  });
}

}  // namespace

Positions deformedPositions(const Model& model, const ConstraintSystem& system, const Diagnosis& diagnosis,
                            const Columns3& u)
{
  const std::vector<int>& unknownOf = model.solverMesh.weld.unknownOf;
  std::vector<int> pinOf(static_cast<std::size_t>(model.solverMesh.unknownCount()), -1);
  for (Index r = static_cast<Index>(system.rows.size()) - 1; r >= 0; --r)
    if (system.rows[r].isPin() && diagnosis.status[r] != RowStatus::Conflicting)
      pinOf[system.rows[r].terms.front().index] = static_cast<int>(r);
  const std::vector<char> isShared = sharedUnknowns(model.solverMesh.weld);
  const Positions& rest = model.mesh.positions;
  const bool isApart = model.solverMesh.weld.joinsApart;
  Positions positions(rest.rows(), 3);
  parallelBlocks(rest.rows(), [&](Index v) {
    const Index unknown = unknownOf[v];
    const bool isPin = pinOf[unknown] >= 0;
    const bool rests = isPin && isApart && system.rows[pinOf[unknown]].shift.isZero(0);
    // Vertices that are one unknown within a tolerance keep places of their own, and -0 stays -0.
    if (rests || (!isPin && u.row(unknown).isZero(0)))
      positions.row(v) = rest.row(v);
    else if (isPin)
      positions.row(v) = pinned(system.rows[pinOf[unknown]].target, rest.row(v), isShared[unknown] != 0);
    else
      positions.row(v) = rest.row(v) + u.row(unknown);
  });
  copyCoordinates(positions, coordinateRows(system, diagnosis), pinOf, unknownOf);
  return positions;
}

}  // namespace holdfast

#include "holdfast/verdict/overshoot.h"

#include <algorithm>

#include <Eigen/Geometry>

#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

/// The vertices on which the points of such rows hang, ascending.
std::vector<Index> hungVertices(const ConstraintSystem& system, const SolverMesh& mesh)
{
  std::vector<bool> isHung(static_cast<std::size_t>(mesh.unknownCount()), false);
  for (const ConstraintRow& row : system.rows)
    if (hangsOnSeveral(row))
      for (const Term& term : row.terms) isHung[term.index] = true;
  std::vector<Index> vertices;
  for (Index u = 0; u < mesh.unknownCount(); ++u)
    if (isHung[u]) vertices.push_back(mesh.weld.firstVertexOf[u]);
  return vertices;
}

/// The rows that hang on each unknown.
IndexLists rowsOfUnknowns(const ConstraintSystem& system, Index unknownCount)
{
  return IndexLists(unknownCount, [&](const auto& add) {
    for (std::size_t r = 0; r < system.rows.size(); ++r)
      for (const Term& term : system.rows[r].terms) add(term.index, static_cast<Index>(r));
  });
}

/// The mean shift of the rows of each part that say where something is.
std::vector<Vector3> meanShifts(const ConstraintSystem& system, const SolverMesh& mesh)
{
  std::vector<Vector3> sums(static_cast<std::size_t>(mesh.componentCount), Vector3::Zero());
  std::vector<double> counts(sums.size(), 0);
  for (const ConstraintRow& row : system.rows) {
    if (row.kind != RowKind::Position || mesh.componentOf[row.terms.front().index] < 0) continue;
    sums[mesh.componentOf[row.terms.front().index]] += row.shift;
    ++counts[mesh.componentOf[row.terms.front().index]];
  }
  for (std::size_t part = 0; part < sums.size(); ++part) sums[part] /= std::max(1.0, counts[part]);
  return sums;
}

/// How much what rows ask for differs: the extent of the shifts of positions and of `mean`, that of all positions of
/// the part, and the shifts of differences.
class AskedFor {
 public:
  explicit AskedFor(const Vector3& mean) : box_(mean) {}
  void add(const ConstraintRow& row)
  {
    if (row.kind == RowKind::Position)
      box_.extend(row.shift);
    else
      difference_ = std::max(difference_, row.shift.stableNorm());
  }
  [[nodiscard]] double size() const { return std::max(difference_, box_.sizes().stableNorm()); }

 private:
  Eigen::AlignedBox3d box_;
  double difference_ = 0;
};

}  // namespace

bool hangsOnSeveral(const ConstraintRow& row)
{
  const std::size_t points = row.kind == RowKind::Position ? 1 : 2;
  return row.kind != RowKind::Region && row.terms.size() > points;
}

OvershootSearch::OvershootSearch(const RestSurface& rest, Index vertexCount)
    : neighbours_(vertexCount, [&](const auto& add) {
        for (std::size_t t = 0; t < rest.triangles.size(); ++t)
          for (int k = 0; k < 3; ++k) {
            if ((rest.ownSides[t] >> static_cast<unsigned>(k) & 1U) == 0) continue;
            add(rest.triangles[t][k], rest.triangles[t][(k + 1) % 3]);
            add(rest.triangles[t][(k + 1) % 3], rest.triangles[t][k]);
          }
      })
{
}

double OvershootSearch::standsOut(const DeformedSurface& surface, Index vertex) const
{
  const std::span<const Index> neighbours = neighbours_[vertex];
  Vector3 before = Vector3::Zero();
  Vector3 after = Vector3::Zero();
  for (const Index other : neighbours) {
    before += (surface.atRest.row(vertex) - surface.atRest.row(other)).transpose();
    after += (surface.now.row(vertex) - surface.now.row(other)).transpose();
  }
  const double count = std::max<double>(1, static_cast<double>(neighbours.size()));
  return std::abs(after.stableNorm() - before.stableNorm()) / count;
}

Overshoot OvershootSearch::find(const DeformedSurface& surface, const ConstraintSystem& system) const
{
  const std::vector<Index> vertices = hungVertices(system, surface.mesh);
  std::vector<double> out(vertices.size());
  parallelBlocks(static_cast<Index>(out.size()), [&](Index k) { out[k] = standsOut(surface, vertices[k]); });
  Overshoot result;
  if (!out.empty()) result.largest = std::ranges::max(out);
  if (result.largest > kVisible * surface.mesh.diagonal) addVertices(result, surface.mesh, system, vertices, out);
  return result;
}

void OvershootSearch::addVertices(Overshoot& result, const SolverMesh& mesh, const ConstraintSystem& system,
                                  const std::vector<Index>& vertices, const std::vector<double>& out) const
{
  const IndexLists rowsOf = rowsOfUnknowns(system, mesh.unknownCount());
  const std::vector<Vector3> means = meanShifts(system, mesh);
  const auto forRowsAt = [&](Index vertex, const auto& visit) {
    for (const Index row : rowsOf[mesh.weld.unknownOf[vertex]]) visit(system.rows[row]);
  };
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (out[k] <= kVisible * mesh.diagonal) continue;
    AskedFor asked(means[mesh.componentOf[mesh.weld.unknownOf[vertices[k]]]]);
    const auto ask = [&](const ConstraintRow& row) { asked.add(row); };
    forRowsAt(vertices[k], ask);
    for (const Index other : neighbours_[vertices[k]]) forRowsAt(other, ask);
    if (out[k] <= kOvershootLimit * asked.size()) continue;
    result.asked = std::max(result.asked, asked.size());
    result.vertices.push_back(vertices[k]);
    forRowsAt(vertices[k], [&](const ConstraintRow& row) {
      if (hangsOnSeveral(row)) result.constraints.push_back(row.constraint);
    });
  }
  result.constraints = sortedOnce(std::move(result.constraints));
}

}  // namespace holdfast

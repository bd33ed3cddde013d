#include "holdfast/rotation/rotation_energy.h"

#include <cmath>

#include <holdfast/geometry/enclosing_sphere.h>
#include <holdfast/geometry/rotation_fit.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/operators/model_size.h>
#include <holdfast/rotation/edge_weights.h>

namespace holdfast {
namespace {

/// What makes rows of the Laplacian count as much as edges at `kBendingLength`, the mesh having this diameter. Uniform
/// rows are not integrated: on regular triangles of edges h their squares are h^2 / 12 of those of cotangents, beside
/// those of their edges.
double bendingWeight(const SolverMesh& mesh, const std::vector<EdgeWeight>& edges, Weights weights, double diameter)
{
  if (weights != Weights::Uniform || edges.empty())
    return kBendingLength * rowsInDiameters(weights, diameter / mesh.diagonal);
  double squares = 0;
  for (const EdgeWeight& edge : edges) squares += (mesh.rest.row(edge.i) - mesh.rest.row(edge.j)).squaredNorm();
  const double length = std::sqrt(squares / static_cast<double>(edges.size())) / diameter;
  return kBendingLength * std::sqrt(12.0) / length;
}

/// A term |alpha t + Q s - b|^2, with p_i = t + Q s_i in a region, and how much it counts.
struct RegionTerm {
  double share = 0;
  double alpha = 0;
  Vector3 s = Vector3::Zero();
  Vector3 b = Vector3::Zero();
};

/// The best Q with t = place - Q rest, both from `center`.
Eigen::Quaterniond fittedAbout(const RegionHold& hold, const Vector3& center, const std::vector<RegionTerm>& terms,
                               const Eigen::Quaterniond& near)
{
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& [share, alpha, s, b] : terms)
    covariance += share * (b - alpha * (hold.place - center)) * (s - alpha * (hold.rest - center)).transpose();
  return hold.kind == RegionHold::Kind::AboutAxis ? fittedRotationAbout(hold.axis, covariance, near)
                                                  : fittedRotation(covariance, near);
}

/// The best Q for any t.
Eigen::Quaterniond fittedTerms(const std::vector<RegionTerm>& terms, const Eigen::Quaterniond& near)
{
  RegionTerm mean;
  for (const auto& [share, alpha, s, b] : terms) {
    mean.share += share * alpha * alpha;
    mean.s += share * alpha * s;
    mean.b += share * alpha * b;
  }
  if (mean.share > 0) {
    mean.s /= mean.share;
    mean.b /= mean.share;
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& [share, alpha, s, b] : terms)
    covariance += share * (b - alpha * mean.b) * (s - alpha * mean.s).transpose();
  return fittedRotation(covariance, near);
}

}  // namespace

std::string_view name(RotationSource source)
{
  constexpr std::array kNames{"given", "found", "found-smooth"};
  return kNames[static_cast<std::size_t>(source)];
}

std::string_view sizeName(RotationSource source)
{
  return source == RotationSource::FoundSmooth ? "diameter" : "diagonal";
}

FreeRotations::FreeRotations(const ConstraintSystem& system, Index unknownCount)
    : kindOf(static_cast<std::size_t>(unknownCount), Kind::Own)
{
  DisjointSets sets(unknownCount);
  sets.uniteEach(system.rigidRegions);
  std::vector<std::vector<Index>> members(static_cast<std::size_t>(unknownCount));  // by representative
  for (const std::vector<Index>& region : system.rigidRegions)
    for (const Index unknown : region) members[sets.find(unknown)].push_back(unknown);
  for (const GivenRotation& given : system.rotations) {
    kindOf[given.unknown] = Kind::Given;
    for (const Index unknown : members[sets.find(given.unknown)]) kindOf[unknown] = Kind::Given;
    members[sets.find(given.unknown)].clear();
  }
  for (std::vector<Index>& region : members) {
    if (region.empty()) continue;
    region = sortedOnce(std::move(region));
    if (region.size() == 1) continue;
    for (const Index unknown : region) kindOf[unknown] = Kind::OfRegion;
    regions.push_back(std::move(region));
  }
}

RotationEnergy::RotationEnergy(const SolverMesh& mesh, const Operators& operators, RotationSource source)
    : rest_(mesh.rest), size_(source == RotationSource::FoundSmooth ? enclosingDiameter(mesh.rest) : mesh.diagonal)
{
  // Negative weights would leave no minimum, so cotangents are guarded whatever the Laplacian has.
  const bool areGuarded = operators.weights != Weights::CotangentPaper;
  const std::vector<EdgeWeight> edges =
      rotationEdgeWeights(areGuarded ? operators : makeOperators(mesh, Weights::Cotangent)).edges;
  std::vector<Eigen::Triplet<double, int>> entries;
  for (const auto& [i, j, weight] : edges) {
    const auto row = static_cast<int>(unknownsOf_.size());
    entries.emplace_back(row, i, std::sqrt(weight));
    entries.emplace_back(row, j, -std::sqrt(weight));
    unknownsOf_.push_back({i, j});
  }
  if (source == RotationSource::FoundSmooth) {
    const auto first = static_cast<int>(unknownsOf_.size());
    const SparseMatrix rows = bendingWeight(mesh, edges, operators.weights, size_) * weightedRows(operators).matrix();
    for (int j = 0; j < rows.outerSize(); ++j)
      for (SparseMatrix::InnerIterator entry(rows, j); entry; ++entry)
        entries.emplace_back(first + static_cast<int>(entry.row()), j, entry.value());
    for (int i = 0; i < rows.rows(); ++i) unknownsOf_.push_back({i, i});
  }
  SparseMatrix A(static_cast<Index>(unknownsOf_.size()), mesh.unknownCount());
  A.setFromTriplets(entries.begin(), entries.end());
  A_ = std::make_shared<const EnergyMatrix>(std::move(A));
  v_ = A_->times(rest_.rowwise() - rest_.colwise().mean());
}

Columns3 RotationEnergy::wanted(const UnknownRotations& R) const
{
  Columns3 result(v_.rows(), 3);
  parallelBlocks(v_.rows(), [&](Index k) {
    const Vector3 v = v_.row(k);
    const auto [a, b] = unknownsOf_[k];
    result.row(k) = (a == b ? R[a] * v : (R[a] * v + R[b] * v) / 2) - v;
  });
  return result;
}

UnknownRotations RotationEnergy::fitted(const Columns3& u, const FreeRotations& free, UnknownRotations R) const
{
  const Columns3 deformed = v_ + A_->times(u);
  parallelBlocks(u.rows(), [&](Index i) {
    if (free.kindOf[i] != FreeRotations::Kind::Own) return;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    A_->forEachInColumn(i, [&](Index row, double /*value*/) {
      const auto [a, b] = unknownsOf_[row];
      if (a != i && b != i) return;
      const double share = a == b ? 1 : 0.5;
      covariance += (share * deformed.row(row).transpose()) * v_.row(row);
    });
    R[i] = fittedRotation(covariance, R[i]);
  });
  for (std::size_t k = 0; k < free.regions.size(); ++k) {
    const std::vector<Index>& region = free.regions[k];
    const RegionHold hold = free.holds.empty() ? RegionHold() : free.holds[k];
    if (hold.kind == RegionHold::Kind::Whole) continue;
    const Eigen::Quaterniond common = fittedRegion(region, hold, u, deformed, R);
    for (const Index unknown : region) R[unknown] = common;
  }
  return R;
}

double RotationEnergy::value(const Columns3& u, const UnknownRotations& R) const
{
  const Columns3 deformed = v_ + A_->times(u);
  Eigen::VectorXd squares(v_.rows());
  parallelBlocks(v_.rows(), [&](Index k) {
    const Vector3 v = v_.row(k);
    const Vector3 x = deformed.row(k);
    const auto [a, b] = unknownsOf_[k];
    squares[k] = ((x - R[a] * v).squaredNorm() + (x - R[b] * v).squaredNorm()) / 2;
  });
  return squares.sum();
}

Eigen::Quaterniond RotationEnergy::fittedRegion(const std::vector<Index>& region, const RegionHold& hold,
                                                const Columns3& u, const Columns3& deformed,
                                                const UnknownRotations& R) const
{
  std::vector<Index> rows;
  for (const Index i : region) A_->forEachInColumn(i, [&](Index row, double /*value*/) { rows.push_back(row); });
  const auto isInside = [&](Index i) { return std::ranges::binary_search(region, i); };
  const Vector3 center = rest_.row(region.front());
  std::vector<RegionTerm> terms;
  for (const Index row : sortedOnce(std::move(rows))) {
    RegionTerm inside;
    Vector3 outside = deformed.row(row);
    bool isWhole = true;
    A_->forEachInRow(row, [&](Index i, double value) {
      isWhole = isWhole && isInside(i);
      if (!isInside(i)) return;
      const Vector3 s = rest_.row(i).transpose() - center;
      inside.alpha += value;
      inside.s += value * s;
      outside -= value * (s + u.row(i).transpose());
    });
    if (isWhole) continue;
    const Vector3 v = v_.row(row);
    for (const int unknown : unknownsOf_[row]) {
      const bool turnsToo = isInside(unknown);
      terms.push_back({0.5, inside.alpha, turnsToo ? Vector3(inside.s - v) : inside.s,
                       turnsToo ? Vector3(-outside) : Vector3(R[unknown] * v - outside)});
    }
  }
  return hold.kind == RegionHold::Kind::None ? fittedTerms(terms, R[region.front()])
                                             : fittedAbout(hold, center, terms, R[region.front()]);
}

}  // namespace holdfast

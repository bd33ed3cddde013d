#include "holdfast/solve/bounded_rows.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <holdfast/factor/multifrontal.h>
#include <holdfast/factor/multipliers.h>
#include <holdfast/ordering/minimum_degree.h>
#include <holdfast/solve/offset_bound.h>

namespace holdfast {
namespace {

constexpr int kMostFactorizations = 60;

// Steps end this far before a bound.
constexpr double kToTheBound = 0.995;

// Of the work that pulls could do within the bounds: what the minimum may be off. Rounding of large meshes ends the
// steps before, where they get shorter than `kStalled` of their length; then so much may be left.
constexpr double kGapOfWork = 1e-15;
constexpr double kStalled = 1e-2;
constexpr double kUsableGapOfWork = 1e-7;

// Rows of the pattern alone: their squares are nothing beside the entries of any energy.
constexpr double kPatternOnly = 1e-150;

// Rows that weigh nothing have this weight, beside which all numbers of an energy are large.
constexpr double kLeastWeight = 1e-100;

/// One finite bound: sign * r <= most.
struct Side {
  Index row = 0;
  double sign = 1;
  double most = 0;
  double size = 1;  // the room between the bounds of the row
};

std::vector<Side> sidesOf(const std::vector<RowBound>& bounds)
{
  std::vector<Side> sides;
  for (std::size_t r = 0; r < bounds.size(); ++r) {
    const auto& [low, high, weight] = bounds[r];
    const double size = roomBetween(low, high);
    if (std::isfinite(high)) sides.push_back({static_cast<Index>(r), 1, high, size});
    if (std::isfinite(low)) sides.push_back({static_cast<Index>(r), -1, -low, size});
  }
  return sides;
}

/// The longest step along which no number falls below 0.
double longestStep(const Eigen::VectorXd& numbers, const Eigen::VectorXd& change)
{
  double longest = std::numeric_limits<double>::infinity();
  for (Index k = 0; k < numbers.size(); ++k)
    if (change[k] < 0) longest = std::min(longest, -numbers[k] / change[k]);
  return longest;
}

/// The independent rows that are not bounded.
std::vector<Index> exactRows(const EliminatedConstraints& eliminated, const std::vector<Index>& bounded)
{
  std::vector<Index> exact;
  std::ranges::set_difference(independentRows(eliminated.dependencies, eliminated.rows.size()), bounded,
                              std::back_inserter(exact));
  return exact;
}

/// What the exact rows leave free.
SparseMatrix freeBasis(const EliminatedConstraints& eliminated, const std::vector<Index>& exact, Index unknowns)
{
  const Elimination elimination(eliminated.rows, exact, unknowns, eliminated.isHeld);
  return elimination.kept().empty() ? elimination.Q2() : elimination.wholeQ2();
}

SparseRows rowsAt(const EliminatedConstraints& eliminated, const std::vector<Index>& places, Index unknowns)
{
  std::vector<RowTerms> rows;
  for (const Index place : places) rows.push_back(eliminated.rows[place]);
  return constraintMatrix(rows, unknowns);
}

/// The lower triangle of [M, K^T; K, D], with room for D, from that of M, whose columns are in this order.
SparseMatrix withRowsBelow(const SparseMatrix& lower, const std::vector<int>& order, const SparseMatrix& K)
{
  const Index size = lower.cols();
  return assembled<SparseMatrix>(size + K.rows(), size + K.rows(), [&](Index k, ColumnSum& sum) {
    if (k >= size) return sum.add(static_cast<int>(k), kPatternOnly);
    sum.addColumn(lower, k);
    sum.addColumn(K, order[static_cast<std::size_t>(k)], size);
  });
}

Columns3 asColumns(const Eigen::VectorXd& values)
{
  Columns3 columns = Columns3::Zero(values.size(), 3);
  columns.col(0) = values;
  return columns;
}

}  // namespace

BoundedRows::BoundedRows(std::shared_ptr<const EnergyMatrix> A, const EliminatedConstraints& eliminated,
                         const std::vector<Index>& bounded)
    : A_(std::move(A)),
      B_(rowsAt(eliminated, bounded, A_->cols())),
      exactCount_(exactRows(eliminated, bounded).size()),
      Q2_(freeBasis(eliminated, exactRows(eliminated, bounded), A_->cols())),
      reduced_(B_ * Q2_.columns())
{
  const ReducedMatrix C(A_, std::make_shared<const TwoWayMatrix>(Q2_), SparseMatrix(A_->cols(), 0),
                        kPatternOnly * reduced_);
  lower_ = C.gramLower();
  SymbolicFactor structure = analyze(lower_, minimumDegreeOrder(lower_));
  lower_ = withRowsBelow(lower_, structure.order, reduced_);
  symbolic_ = std::make_shared<const SymbolicFactor>(withMultipliers(structure, lower_));
  placeOf_.resize(symbolic_->order.size());
  for (int k = 0; k < symbolic_->size(); ++k) placeOf_[static_cast<std::size_t>(symbolic_->order[k])] = k;
}

/// Of [M, K^T; K, -1/D], which is M + K^T D K for the columns of M. Large weights would take the digits of M in that
/// sum.
Result<std::unique_ptr<const PackedFactor>> BoundedRows::factorOf(const Eigen::VectorXd& weights) const
{
  SparseMatrix lower = lower_;
  const Index columns = reduced_.cols();
  for (Index r = 0; r < weights.size(); ++r) {
    const int place = placeOf_[static_cast<std::size_t>(columns + r)];
    lower.coeffRef(place, place) = -1 / std::max(weights[r], kLeastWeight);
  }
  return factorizeMultifrontal(symbolic_, std::move(lower));
}

Eigen::VectorXd BoundedRows::gradientAt(const Eigen::VectorXd& u, const Eigen::VectorXd& f) const
{
  return -Q2_.transposeTimes(A_->transposeTimes(A_->residual(asColumns(f), asColumns(u)))).col(0);
}

Eigen::VectorXd BoundedRows::solve(const PackedFactor& factor, const Eigen::VectorXd& g) const
{
  std::vector<double> x(4 * placeOf_.size(), 0);
  for (Index k = 0; k < g.size(); ++k) x[4 * static_cast<std::size_t>(placeOf_[k])] = g[k];
  factor.solveForward(x);
  factor.solveBackward(x);
  Eigen::VectorXd z(g.size());
  for (Index k = 0; k < z.size(); ++k) z[k] = x[4 * static_cast<std::size_t>(placeOf_[k])];
  return z;
}

Result<std::unique_ptr<const BoundedOffsets>> BoundedRows::offsetsOf(const BoundedStart& start,
                                                                     const std::vector<RowBound>& bounds,
                                                                     const std::function<void(int)>& announce) const
{
  const std::vector<Side> sides = sidesOf(bounds);
  const auto count = static_cast<Index>(sides.size());
  Eigen::VectorXd weights(B_.rows());
  for (Index r = 0; r < weights.size(); ++r) weights[r] = bounds[r].weight;
  Eigen::VectorXd u = start.u;
  Eigen::VectorXd offsets = B_ * u - start.targets;
  const auto alongRows = [&](const Eigen::VectorXd& ofSides) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(B_.rows());
    for (Index k = 0; k < count; ++k) sum[sides[k].row] += sides[k].sign * ofSides[k];
    return sum;
  };
  if (exactCount_ == 0 && count == 0 && weights.isZero(0)) {  // nothing holds the surface along this axis
    return {std::make_unique<BoundedOffsets>(BoundedOffsets{std::move(offsets), std::vector<char>(bounds.size(), 0)})};
  }
  Eigen::VectorXd room(count);
  for (Index k = 0; k < count; ++k) room[k] = sides[k].most - sides[k].sign * offsets[sides[k].row];
  // All bounds begin with the same product of room and force.
  Eigen::VectorXd forces = (start.work / static_cast<double>(std::max<Index>(count, 1))) * room.cwiseInverse();
  for (int step = 1; step <= kMostFactorizations; ++step) {
    const double gap = room.dot(forces);
    if (step > 1 && (count == 0 || gap <= kGapOfWork * start.work)) break;
    announce(step);
    Eigen::VectorXd stiffness = weights;
    for (Index k = 0; k < count; ++k) stiffness[sides[k].row] += forces[k] / room[k];
    auto factor = factorOf(stiffness);
    if (!factor) return {nullptr, std::move(factor.failure)};
    const Eigen::VectorXd gradient = gradientAt(u, start.f) + reduced_.transpose() * weights.cwiseProduct(offsets);
    // The step after which products of room and force are `products`, to first order.
    const auto stepTo = [&](const Eigen::VectorXd& products) -> Eigen::VectorXd {
      const Eigen::VectorXd pushes = products.cwiseQuotient(room);
      return solve(*factor.value, -gradient - reduced_.transpose() * alongRows(pushes));
    };
    const auto changeOfRoom = [&](const Eigen::VectorXd& z) {
      const Eigen::VectorXd change = reduced_ * z;
      Eigen::VectorXd result(count);
      for (Index k = 0; k < count; ++k) result[k] = -sides[k].sign * change[sides[k].row];
      return result;
    };
    const auto changeOfForces = [&](const Eigen::VectorXd& products, const Eigen::VectorXd& ofRoom) {
      return Eigen::VectorXd((products - forces.cwiseProduct(ofRoom)).cwiseQuotient(room) - forces);
    };
    Eigen::VectorXd products = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd z = stepTo(products);
    if (count > 0) {
      const Eigen::VectorXd roomBy = changeOfRoom(z);
      const Eigen::VectorXd forcesBy = changeOfForces(products, roomBy);
      const double length = std::min({1.0, longestStep(room, roomBy), longestStep(forces, forcesBy)});
      const double left = (room + length * roomBy).dot(forces + length * forcesBy) / gap;
      products = Eigen::VectorXd::Constant(count, left * left * left * gap / static_cast<double>(count)) -
                 roomBy.cwiseProduct(forcesBy);
      z = stepTo(products);
    }
    if (!z.allFinite()) return {nullptr, "a step between the bounds is not finite"};
    const Eigen::VectorXd roomBy = changeOfRoom(z);
    const Eigen::VectorXd forcesBy = changeOfForces(products, roomBy);
    const double length =
        std::min(1.0, kToTheBound * std::min(longestStep(room, roomBy), longestStep(forces, forcesBy)));
    if (length < kStalled && gap <= kUsableGapOfWork * start.work) break;
    u += length * (Q2_.columns() * z);
    offsets = B_ * u - start.targets;
    room += length * roomBy;
    forces += length * forcesBy;
  }
  if (count > 0 && !(room.dot(forces) <= kUsableGapOfWork * start.work))
    return {nullptr, "the places within the bounds keep no digits"};
  auto result = std::make_unique<BoundedOffsets>();
  result->isAtBound.assign(bounds.size(), 0);
  for (Index k = 0; k < count; ++k) {
    const auto& [row, sign, most, size] = sides[k];
    if (!(room[k] * start.work < forces[k] * size * size)) continue;
    result->isAtBound[row] = 1;
    offsets[row] = sign * most;
  }
  for (Index r = 0; r < offsets.size(); ++r) offsets[r] = std::clamp(offsets[r], bounds[r].low, bounds[r].high);
  result->offsets = std::move(offsets);
  return {std::move(result)};
}

}  // namespace holdfast

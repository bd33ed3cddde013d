#include "holdfast/solve/bounded_rows.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include <holdfast/factor/multifrontal.h>
#include <holdfast/ordering/elimination_order.h>
#include <holdfast/solve/offset_bound.h>

namespace holdfast {
namespace {

constexpr int kMostFactorizations = 60;

// Steps end this far before a bound.
constexpr double kToTheBound = 0.995;

// Of the work that pulls could do within the bounds: what the minimum may be off.
constexpr double kGapOfWork = 1e-15;

// Rows of the pattern alone: their squares are nothing beside the entries of any energy.
constexpr double kPatternOnly = 1e-150;

/// One finite bound: sign * r <= most.
struct Side {
  Index row = 0;
  double sign = 1;
  double most = 0;
  double size = 1;  // of what is bounded
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
SparseMatrix freeBasis(const EliminatedConstraints& eliminated, const std::vector<Index>& exact, Index unknowns,
                       const std::vector<int>& ranks)
{
  const Elimination elimination(eliminated.rows, exact, unknowns, eliminated.isHeld);
  return orderedColumns(elimination.kept().empty() ? elimination.Q2() : elimination.wholeQ2(), ranks);
}

SparseRows rowsAt(const EliminatedConstraints& eliminated, const std::vector<Index>& places, Index unknowns)
{
  std::vector<RowTerms> rows;
  for (const Index place : places) rows.push_back(eliminated.rows[place]);
  return constraintMatrix(rows, unknowns);
}

Columns3 asColumns(const Eigen::VectorXd& values)
{
  Columns3 columns = Columns3::Zero(values.size(), 3);
  columns.col(0) = values;
  return columns;
}

}  // namespace

BoundedRows::BoundedRows(std::shared_ptr<const EnergyMatrix> A, const EliminatedConstraints& eliminated,
                         const std::vector<Index>& bounded, const std::vector<int>& ranks)
    : A_(std::move(A)),
      B_(rowsAt(eliminated, bounded, A_->cols())),
      exactCount_(exactRows(eliminated, bounded).size()),
      Q2_(freeBasis(eliminated, exactRows(eliminated, bounded), A_->cols(), ranks)),
      reduced_(B_ * Q2_.columns())
{
  const ReducedMatrix C(A_, std::make_shared<const TwoWayMatrix>(Q2_), SparseMatrix(A_->cols(), 0),
                        kPatternOnly * reduced_);
  lower_ = C.gramLower();
  std::vector<int> order(static_cast<std::size_t>(lower_.cols()));
  std::iota(order.begin(), order.end(), 0);
  symbolic_ = std::make_shared<const SymbolicFactor>(analyze(lower_, order));
  placeOf_.resize(order.size());
  for (int k = 0; k < symbolic_->size(); ++k) placeOf_[static_cast<std::size_t>(symbolic_->order[k])] = k;
}

Result<std::unique_ptr<const PackedFactor>> BoundedRows::factorOf(const Eigen::VectorXd& weights) const
{
  SparseMatrix lower = lower_;
  for (Index r = 0; r < reduced_.rows(); ++r)
    for (SparseRows::InnerIterator a(reduced_, r); a; ++a)
      for (SparseRows::InnerIterator b(reduced_, r); b; ++b)
        if (placeOf_[a.col()] >= placeOf_[b.col()])
          lower.coeffRef(placeOf_[a.col()], placeOf_[b.col()]) += weights[r] * a.value() * b.value();
  return factorizeMultifrontal(symbolic_, std::move(lower));
}

Eigen::VectorXd BoundedRows::gradientAt(const Eigen::VectorXd& u, const Eigen::VectorXd& f) const
{
  return -Q2_.transposeTimes(A_->transposeTimes(A_->residual(asColumns(f), asColumns(u)))).col(0);
}

Eigen::VectorXd BoundedRows::solve(const PackedFactor& factor, const Eigen::VectorXd& g) const
{
  std::vector<double> x(4 * placeOf_.size(), 0);
  for (std::size_t k = 0; k < placeOf_.size(); ++k) x[4 * static_cast<std::size_t>(placeOf_[k])] = g[k];
  factor.solveForward(x);
  factor.solveBackward(x);
  Eigen::VectorXd z(g.size());
  for (std::size_t k = 0; k < placeOf_.size(); ++k) z[k] = x[4 * static_cast<std::size_t>(placeOf_[k])];
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
    u += length * (Q2_.columns() * z);
    offsets = B_ * u - start.targets;
    room += length * roomBy;
    forces += length * forcesBy;
  }
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

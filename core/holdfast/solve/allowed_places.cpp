#include "holdfast/solve/allowed_places.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>

#include <holdfast/factor/dense_cholesky.h>
#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/numbers/term.h>

namespace holdfast {
namespace {

constexpr int kMostSteps = 200;

// Steps end this far before a bound.
constexpr double kToBound = 0.99;

// The gap shrinks by this factor at most in a step: the path to the minimum is followed from within.
constexpr double kCentering = 0.1;

// Of the work that pulls could do within the bounds: what the minimum may be off.
constexpr double kGap = 1e-15;

// A bound that can be met with less room than this share of its size cannot be met.
constexpr double kLeastRoom = 1e-9;

// With this much room there is no need to look for more.
constexpr double kMuchRoom = 0.05;

/// The matrix M with M r = directions.held(r).
Eigen::Matrix3d matrixOf(const RowDirections& directions)
{
  Eigen::Matrix3d M;
  for (Index k = 0; k < 3; ++k) M.col(k) = directions.held(Vector3::Unit(k));
  return M;
}

/// `r` with `held` in place of the part of it that the directions hold.
Vector3 withHeld(const RowDirections& directions, const Vector3& r, const Vector3& held)
{
  return r + (held - directions.held(r));
}

/// One bound g(r) <= 0 of the offset r of a point: of a ball (|r / size|^2 - 1) / 2, with the part of r that its
/// directions hold; of half a space (normal . r - most) / size.
struct Bound {
  Index point = 0;
  bool isBall = false;
  double size = 1;
  Vector3 normal = Vector3::Zero();
  double most = 0;
  RowDirections directions = {};  // of a ball

  [[nodiscard]] double value(const Vector3& r) const
  {
    return isBall ? ((directions.held(r) / size).squaredNorm() - 1) / 2 : (normal.dot(r) - most) / size;
  }
  [[nodiscard]] Vector3 gradient(const Vector3& r) const
  {
    return isBall ? Vector3(directions.held(r) / size / size) : Vector3(normal / size);
  }
  [[nodiscard]] Eigen::Matrix3d curvature() const
  {
    if (!isBall) return Eigen::Matrix3d::Zero();
    return matrixOf(directions) / size / size;
  }

  /// The nearest offset at the bound.
  [[nodiscard]] Vector3 onto(const Vector3& r) const
  {
    if (!isBall) return r + (most - normal.dot(r)) * normal;
    const Vector3 held = directions.held(r);
    return withHeld(directions, r, held * (size / held.norm()));
  }

  /// The longest step along `step` that does not leave the bound; r lies within.
  [[nodiscard]] double longest(const Vector3& r, const Vector3& step) const
  {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    if (!isBall) {
      const double along = normal.dot(step);
      return along > 0 ? (most - normal.dot(r)) / along : kNever;
    }
    const Vector3 held = directions.held(r);
    const Vector3 heldStep = directions.held(step);
    const double a = heldStep.squaredNorm();
    if (a == 0) return kNever;
    const double b = held.dot(heldStep);
    const double c = held.squaredNorm() - size * size;  // below 0
    const double root = std::sqrt(b * b - a * c);
    return b > 0 ? -c / (b + root) : (root - b) / a;
  }
};

/// y^T P y / 2 + q^T y.
struct Quadratic {
  Eigen::MatrixXd P;
  Eigen::VectorXd q;
};

/// An equation sum of coefficient * y_index = to.
struct Equation {
  std::vector<Term> terms;
  double to = 0;
  std::vector<Index> names;  ///< see `ChosenOffsets::contradicted`: the equation's own name is the first
};

/// What equations fix of y, and what they leave free. Later ones that contradict those before are left out.
class FixedSums {
 public:
  FixedSums(const std::vector<Equation>& equations, Index count) : particular_(Eigen::VectorXd::Zero(count))
  {
    DisjointSets columns(count);
    for (const Equation& equation : equations)
      for (const Term& term : equation.terms) columns.unite(equation.terms.front().index, term.index);
    std::map<Index, Group> groups;  // by representative
    for (const Equation& equation : equations)
      if (!equation.terms.empty()) groups[columns.find(equation.terms.front().index)].equations.push_back(&equation);
    std::vector<Eigen::Triplet<double, int>> entries;
    int next = 0;
    for (Index y = 0; y < count; ++y)
      if (const auto group = groups.find(columns.find(y)); group != groups.end())
        group->second.columns.push_back(y);
      else
        entries.emplace_back(static_cast<int>(y), next++, 1);
    for (const auto& [representative, group] : groups) solve(group, entries, next);
    free_ = SparseMatrix(count, next);
    free_.setFromTriplets(entries.begin(), entries.end());
  }

  [[nodiscard]] const SparseMatrix& free() const { return free_; }
  [[nodiscard]] const std::map<Index, std::vector<Index>>& contradicted() const { return contradicted_; }

  /// Returns the y that meets the equations and is nearest to `y`.
  [[nodiscard]] Eigen::VectorXd nearest(const Eigen::VectorXd& y) const
  {
    return particular_ + free_ * (free_.transpose() * (y - particular_));
  }

 private:
  /// Equations that share columns.
  struct Group {
    std::vector<const Equation*> equations;
    std::vector<Index> columns;  // ascending
  };

  // What is left of an equation by those before it is rounding below this share.
  static constexpr double kFollows = 1e-10;
  // Offsets in diagonals that differ by this are the same.
  static constexpr double kAgrees = 5e-13;

  /// Gram and Schmidt, twice for the digits. Each direction is a sum of equations, which `sums` has.
  void solve(const Group& group, std::vector<Eigen::Triplet<double, int>>& entries, int& next)
  {
    const auto count = static_cast<Index>(group.columns.size());
    const auto rows = static_cast<Index>(group.equations.size());
    Eigen::MatrixXd directions(count, 0);
    Eigen::MatrixXd sums(rows, 0);  // of equations: each direction
    Eigen::VectorXd to(rows);
    for (Index r = 0; r < rows; ++r) {
      to[r] = group.equations[r]->to;
      Eigen::VectorXd left = Eigen::VectorXd::Zero(count);
      for (const Term& term : group.equations[r]->terms)
        left[std::ranges::lower_bound(group.columns, term.index) - group.columns.begin()] += term.coefficient;
      const double size = left.norm();
      Eigen::VectorXd sum = Eigen::VectorXd::Unit(rows, r);
      for (int twice = 0; twice < 2; ++twice) {
        const Eigen::VectorXd shares = directions.transpose() * left;
        left -= directions * shares;
        sum -= sums * shares;
      }
      if (left.norm() > kFollows * size) {
        directions.conservativeResize(Eigen::NoChange, directions.cols() + 1);
        sums.conservativeResize(Eigen::NoChange, sums.cols() + 1);
        directions.rightCols<1>() = left / left.norm();
        sums.rightCols<1>() = sum / left.norm();
      } else if (std::abs(sum.dot(to)) > kAgrees * sum.lpNorm<1>()) {
        contradict(group, sum, r);
      }
    }
    for (Index c = 0; c < directions.cols(); ++c)
      for (Index k = 0; k < count; ++k) particular_[group.columns[k]] += directions(k, c) * sums.col(c).dot(to);
    const Eigen::MatrixXd Q = Eigen::HouseholderQR<Eigen::MatrixXd>(directions).householderQ();
    for (Index c = directions.cols(); c < count; ++c, ++next)
      for (Index k = 0; k < count; ++k)
        if (Q(k, c) != 0) entries.emplace_back(static_cast<int>(group.columns[k]), next, Q(k, c));
  }

  void contradict(const Group& group, const Eigen::VectorXd& sum, Index row)
  {
    const Index own = group.equations[row]->names.front();
    std::vector<Index>& others = contradicted_[own];
    if (!others.empty()) return;
    for (Index r = 0; r <= row; ++r)
      if (std::abs(sum[r]) > kFollows * sum.lpNorm<Eigen::Infinity>())
        std::ranges::copy_if(group.equations[r]->names, std::back_inserter(others),
                             [&](Index name) { return name != own; });
  }

  Eigen::VectorXd particular_;
  SparseMatrix free_;
  std::map<Index, std::vector<Index>> contradicted_;
};

class OffsetChooser {
 public:
  OffsetChooser(const std::array<AxisPull, 3>& axes, const std::vector<AllowedOffset>& allowed)
      : axes_(axes), allowed_(allowed)
  {
    for (std::size_t k = 0; k < 3; ++k) first_[k + 1] = first_[k] + axes[k].offsets.cols();
    y_ = Eigen::VectorXd::Zero(first_[3]);
    const std::vector<Equation> fixed = equations();
    if (!fixed.empty()) fixed_.emplace(fixed, first_[3]);
  }

  ChosenOffsets chosen()
  {
    ChosenOffsets result;
    result.isOutOfReach.assign(allowed_.size(), 0);
    result.isAtBound.assign(allowed_.size(), 0);
    start();
    for (std::size_t i = 0; i < allowed_.size(); ++i)
      if (!admit(static_cast<Index>(i))) result.isOutOfReach[i] = 1;
    const Quadratic energy = energyOf(result.isOutOfReach);
    const double work = workOf(energy);
    markBounds(minimise(energy, work, std::nullopt), work, result.isAtBound);
    result.offsets = offsets(y_);
    for (const Bound& bound : reached_) result.offsets.row(bound.point) = bound.onto(result.offsets.row(bound.point));
    for (std::size_t i = 0; i < allowed_.size(); ++i) bringWithin(result, static_cast<Index>(i));
    if (fixed_) result.contradicted = fixed_->contradicted();
    return result;
  }

 private:
  /// What is fixed, sums first: all else keeps to them.
  [[nodiscard]] std::vector<Equation> equations() const
  {
    std::vector<Equation> result;
    for (std::size_t k = 0; k < 3; ++k)
      for (Index r = 0; r < axes_[k].fixed.rows(); ++r) {
        Equation& equation = result.emplace_back(Equation{{}, axes_[k].fixedTo[r], {}});
        for (const Index number : axes_[k].fixedBy[static_cast<std::size_t>(r)]) equation.names.push_back(-1 - number);
        for (SparseRows::InnerIterator entry(axes_[k].fixed, r); entry; ++entry)
          equation.terms.push_back({first_[k] + entry.col(), entry.value()});
      }
    for (std::size_t i = 0; i < allowed_.size(); ++i)
      for (const Vector3& normal : zeroAlong(allowed_[i])) {
        const auto point = static_cast<Index>(i);
        Equation& equation =
            result.emplace_back(Equation{{}, -normal.dot(offset(Eigen::VectorXd::Zero(first_[3]), point)), {point}});
        for (std::size_t k = 0; k < 3; ++k) {
          if (normal[static_cast<Index>(k)] == 0) continue;
          for (SparseRows::InnerIterator entry(axes_[k].offsets, point); entry; ++entry)
            equation.terms.push_back({first_[k] + entry.col(), normal[static_cast<Index>(k)] * entry.value()});
          if (const auto by = axes_[k].constantBy.find(point); by != axes_[k].constantBy.end())
            for (const Index number : by->second) equation.names.push_back(-1 - number);
        }
      }
    return result;
  }

  /// The directions along which the offset is 0, square to one another.
  [[nodiscard]] static std::vector<Vector3> zeroAlong(const AllowedOffset& allowed)
  {
    if (!allowed.isZero) return {};
    const RowDirections& directions = allowed.directions;
    if (directions.areAll()) return {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
    const Vector3& axis = directions.axis();
    if (directions.areAlongAxis()) return {axis};
    const Vector3 across = axis.unitOrthogonal();
    return {across, axis.cross(across)};
  }

  /// Lets points that follow from no others begin in the middle of their slabs.
  void start()
  {
    for (std::size_t i = 0; i < allowed_.size(); ++i)
      for (const AllowedSlab& slab : allowed_[i].slabs) {
        if (slab.low <= 0 && slab.high >= 0) continue;
        const double middle = std::isinf(slab.low)    ? slab.high - std::abs(slab.high)
                              : std::isinf(slab.high) ? slab.low + std::abs(slab.low)
                                                      : (slab.low + slab.high) / 2;
        for (std::size_t k = 0; k < 3; ++k)
          for (SparseRows::InnerIterator entry(axes_[k].offsets, static_cast<Index>(i)); entry; ++entry)
            if (entry.value() == 1) y_[first_[k] + entry.col()] += middle * slab.normal[static_cast<Index>(k)];
      }
    if (fixed_) y_ = fixed_->nearest(y_);
  }

  [[nodiscard]] Vector3 offset(const Eigen::VectorXd& y, Index point, bool isStep = false) const
  {
    Vector3 r;
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = isStep ? 0 : axes_[k].constant[point];
      for (SparseRows::InnerIterator entry(axes_[k].offsets, point); entry; ++entry)
        sum += entry.value() * y[first_[k] + entry.col()];
      r[static_cast<Index>(k)] = sum;
    }
    return r;
  }

  [[nodiscard]] Positions offsets(const Eigen::VectorXd& y) const
  {
    Positions result(static_cast<Index>(allowed_.size()), 3);
    for (Index i = 0; i < result.rows(); ++i) result.row(i) = offset(y, i);
    return result;
  }

  [[nodiscard]] static std::vector<Bound> boundsOf(const AllowedOffset& allowed, Index point)
  {
    std::vector<Bound> bounds;
    if (allowed.radius > 0) bounds.push_back({point, true, allowed.radius, Vector3::Zero(), 0, allowed.directions});
    for (const AllowedSlab& slab : allowed.slabs) {
      const double width = slab.high - slab.low;
      const double size =
          std::isfinite(width) ? width : std::max(1e-3, std::abs(std::isinf(slab.low) ? slab.high : slab.low));
      if (std::isfinite(slab.high)) bounds.push_back({point, false, size, slab.normal, slab.high});
      if (std::isfinite(slab.low)) bounds.push_back({point, false, size, -slab.normal, -slab.low});
    }
    return bounds;
  }

  /// Adds the bounds of a point, and goes to where all that were added hold. Adds none and returns false where there is
  /// no such place.
  bool admit(Index point)
  {
    const std::size_t before = bounds_.size();
    for (const Bound& bound : boundsOf(allowed_[point], point)) {
      if (!(bound.value(offset(y_, point)) < -kLeastRoom)) static_cast<void>(minimise(boundAsEnergy(bound), 1, bound));
      if (!(bound.value(offset(y_, point)) < -kLeastRoom)) {
        bounds_.resize(before);
        return false;
      }
      bounds_.push_back(bound);
    }
    return true;
  }

  /// g(r(y)), and a little of |y|^2, so that there is one minimum.
  [[nodiscard]] Quadratic boundAsEnergy(const Bound& bound) const
  {
    Quadratic result{Eigen::MatrixXd::Identity(y_.size(), y_.size()) * (1e-9 / bound.size / bound.size),
                     Eigen::VectorXd::Zero(y_.size())};
    addAt(result.P, bound.point, bound.curvature());
    addAt(result.q, bound.point, bound.gradient(constantOf(bound.point)));
    return result;
  }

  [[nodiscard]] Vector3 constantOf(Index point) const
  {
    return {axes_[0].constant[point], axes_[1].constant[point], axes_[2].constant[point]};
  }

  [[nodiscard]] Quadratic energyOf(const std::vector<char>& isOutOfReach) const
  {
    Quadratic result{Eigen::MatrixXd::Zero(y_.size(), y_.size()), Eigen::VectorXd(y_.size())};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index count = first_[k + 1] - first_[k];
      result.P.block(first_[k], first_[k], count, count) = axes_[k].stiffness;
      result.q.segment(first_[k], count) = axes_[k].pull;
    }
    for (std::size_t i = 0; i < allowed_.size(); ++i) {
      const auto& [weight, damping] = std::tie(allowed_[i].weight, allowed_[i].damping);
      if ((weight == 0 && damping == 0) || isOutOfReach[i] != 0) continue;
      const auto point = static_cast<Index>(i);
      const Eigen::Matrix3d held = matrixOf(allowed_[i].directions);
      const Eigen::Matrix3d cost = weight * held + damping * (Eigen::Matrix3d::Identity() - held);
      addAt(result.P, point, cost);
      addAt(result.q, point, cost * constantOf(point));
    }
    return result;
  }

  /// What the pulls at the place that is reached could do within the bounds.
  [[nodiscard]] double workOf(const Quadratic& energy) const
  {
    const Eigen::VectorXd gradient = inFree(energy.P * y_ + energy.q);
    double size = 0;
    for (const Bound& bound : bounds_) size = std::max(size, bound.size);
    return gradient.lpNorm<1>() * size;
  }

  /// J^T M J of the 3 x 3 matrix M over the offset of a point.
  void addAt(Eigen::MatrixXd& P, Index point, const Eigen::Matrix3d& M) const
  {
    for (std::size_t a = 0; a < 3; ++a)
      for (SparseRows::InnerIterator row(axes_[a].offsets, point); row; ++row)
        for (std::size_t b = 0; b < 3; ++b) {
          const double share = M(static_cast<Index>(a), static_cast<Index>(b)) * row.value();
          if (share == 0) continue;
          for (SparseRows::InnerIterator column(axes_[b].offsets, point); column; ++column)
            P(first_[a] + row.col(), first_[b] + column.col()) += share * column.value();
        }
  }

  void addAt(Eigen::VectorXd& q, Index point, const Vector3& v) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      for (SparseRows::InnerIterator entry(axes_[k].offsets, point); entry; ++entry)
        q[first_[k] + entry.col()] += entry.value() * v[static_cast<Index>(k)];
  }

  [[nodiscard]] Eigen::VectorXd inFree(const Eigen::VectorXd& gradient) const
  {
    return fixed_ ? Eigen::VectorXd(fixed_->free().transpose() * gradient) : gradient;
  }

  /// The step that solves H step = -gradient in the free directions.
  [[nodiscard]] Eigen::VectorXd stepOf(const Eigen::MatrixXd& H, const Eigen::VectorXd& gradient) const
  {
    if (!fixed_) return solvedDefinite(H, -gradient);
    const SparseMatrix& free = fixed_->free();
    return free * solvedDefinite(Eigen::MatrixXd(free.transpose() * H) * free, -inFree(gradient));
  }

  /// Rows and columns are scaled: near bounds they differ by many powers of ten.
  [[nodiscard]] static Eigen::VectorXd solvedDefinite(Eigen::MatrixXd H, const Eigen::VectorXd& g)
  {
    const Eigen::VectorXd scale = H.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
    H = scale.asDiagonal() * H * scale.asDiagonal();
    Eigen::MatrixXd L = H;
    for (double more = 1e-15; !factorizeDense(L) && more < 1; more *= 100) {
      H.diagonal().array() += more;
      L = H;
    }
    Eigen::VectorXd solution = scale.cwiseProduct(g);
    L.triangularView<Eigen::Lower>().solveInPlace(solution);
    L.triangularView<Eigen::Lower>().transpose().solveInPlace(solution);
    return scale.cwiseProduct(solution);
  }

  /// Goes from `y_`, where all bounds hold, to where the energy is least within them, or until `stop` has much room.
  /// Returns the multiplier of each bound. `work` is a size of the energy.
  Eigen::VectorXd minimise(const Quadratic& energy, double work, const std::optional<Bound>& stop)
  {
    const auto count = static_cast<Index>(bounds_.size());
    Eigen::VectorXd forces = Eigen::VectorXd::Constant(count, work / static_cast<double>(std::max<Index>(count, 1)));
    if (y_.size() == 0 || (work == 0 && count > 0)) return Eigen::VectorXd::Zero(count);
    if (fixed_ && fixed_->free().cols() == 0) return Eigen::VectorXd::Zero(count);
    for (int step = 0; step < kMostSteps; ++step) {
      if (stop && stop->value(offset(y_, stop->point)) < -kMuchRoom) break;
      Eigen::VectorXd values(count);
      for (Index b = 0; b < count; ++b) values[b] = bounds_[b].value(offset(y_, bounds_[b].point));
      const double gap = -values.dot(forces);
      if (count > 0 && gap <= kGap * work) break;
      const double aim = count > 0 ? kCentering * gap / static_cast<double>(count) : 0;
      Eigen::MatrixXd H = energy.P;
      Eigen::VectorXd gradient = energy.P * y_ + energy.q;
      for (Index b = 0; b < count; ++b) {
        const Bound& bound = bounds_[b];
        const Vector3 slope = bound.gradient(offset(y_, bound.point));
        addAt(H, bound.point, forces[b] * bound.curvature() - forces[b] / values[b] * (slope * slope.transpose()));
        addAt(gradient, bound.point, -aim / values[b] * slope);
      }
      const Eigen::VectorXd dy = stepOf(H, gradient);
      if (!dy.allFinite()) break;
      double length = 1;
      Eigen::VectorXd change(count);
      for (Index b = 0; b < count; ++b) {
        const Bound& bound = bounds_[b];
        const Vector3 r = offset(y_, bound.point);
        const Vector3 dr = offset(dy, bound.point, true);
        change[b] = -forces[b] - aim / values[b] - forces[b] / values[b] * bound.gradient(r).dot(dr);
        length = std::min(length, kToBound * bound.longest(r, dr));
        if (change[b] < 0) length = std::min(length, -kToBound * forces[b] / change[b]);
      }
      y_ += length * dy;
      forces += length * change;
      if (count == 0 || length * dy.lpNorm<Eigen::Infinity>() == 0) break;
    }
    return forces;
  }

  /// At the minimum a bound has either room or a multiplier, and rounding leaves a little of the other. The larger one
  /// tells whether the point is at the bound.
  void markBounds(const Eigen::VectorXd& forces, double work, std::vector<char>& isAtBound)
  {
    for (std::size_t b = 0; b < bounds_.size(); ++b) {
      const double room = -bounds_[b].value(offset(y_, bounds_[b].point));
      if (!(room * work < forces[static_cast<Index>(b)])) continue;
      isAtBound[bounds_[b].point] = 1;
      reached_.push_back(bounds_[b]);
    }
  }

  /// Rounding leaves the path of the interior at its end. Points that are out of reach go as near as they may.
  void bringWithin(ChosenOffsets& chosen, Index point) const
  {
    const AllowedOffset& allowed = allowed_[point];
    Vector3 r = chosen.offsets.row(point);
    const Vector3 held = allowed.directions.held(r);
    if (allowed.radius > 0 && held.norm() > allowed.radius)
      r = withHeld(allowed.directions, r, held * (allowed.radius / held.norm()));
    for (const AllowedSlab& slab : allowed.slabs) {
      const double along = slab.normal.dot(r);
      r += (std::clamp(along, slab.low, slab.high) - along) * slab.normal;
    }
    if (allowed.isZero) r = withHeld(allowed.directions, r, Vector3::Zero());
    chosen.offsets.row(point) = r;
  }

  const std::array<AxisPull, 3>& axes_;
  const std::vector<AllowedOffset>& allowed_;
  std::array<Index, 4> first_{};  // of each axis, in y
  Eigen::VectorXd y_;
  std::optional<FixedSums> fixed_;  // where something is
  std::vector<Bound> bounds_;
  std::vector<Bound> reached_;
};

}  // namespace

ChosenOffsets chooseOffsets(const std::array<AxisPull, 3>& axes, const std::vector<AllowedOffset>& allowed)
{
  return OffsetChooser(axes, allowed).chosen();
}

}  // namespace holdfast

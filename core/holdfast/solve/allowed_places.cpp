#include "holdfast/solve/allowed_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include <holdfast/factor/dense_cholesky.h>
#include <holdfast/solve/block_newton.h>
#include <holdfast/solve/fixed_sums.h>
#include <holdfast/solve/offset_bound.h>

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

/// The sum over the axes of y^T stiffness y / 2, over the points of r^T block r / 2, and q^T y.
struct OffsetEnergy {
  std::array<const Eigen::MatrixXd*, 3> stiffness;
  std::vector<Eigen::Matrix3d> blocks;
  Eigen::VectorXd q;
};

class OffsetChooser {
 public:
  OffsetChooser(const std::array<AxisPull, 3>& axes, const std::vector<AllowedOffset>& allowed)
      : axes_(axes), allowed_(allowed)
  {
    for (std::size_t k = 0; k < 3; ++k) first_[k + 1] = first_[k] + axes[k].offsets.cols();
    y_ = Eigen::VectorXd::Zero(first_[3]);
    const std::vector<SumEquation> fixed = equations();
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
    const OffsetEnergy energy = energyOf(result.isOutOfReach);
    const double work = workOf(energy);
    markBounds(minimise(energy, work, std::nullopt), work, result.isAtBound);
    result.offsets = offsets(y_);
    for (const OffsetBound& bound : reached_)
      result.offsets.row(bound.point) = bound.onto(result.offsets.row(bound.point));
    for (std::size_t i = 0; i < allowed_.size(); ++i) bringWithin(result, static_cast<Index>(i));
    if (fixed_) result.contradicted = fixed_->contradicted();
    return result;
  }

 private:
  /// What is fixed, sums first: all else keeps to them.
  [[nodiscard]] std::vector<SumEquation> equations() const
  {
    std::vector<SumEquation> result;
    for (std::size_t k = 0; k < 3; ++k)
      for (Index r = 0; r < axes_[k].fixed.rows(); ++r) {
        SumEquation& equation = result.emplace_back(SumEquation{{}, axes_[k].fixedTo[r], {}});
        for (const Index number : axes_[k].fixedBy[static_cast<std::size_t>(r)]) equation.names.push_back(-1 - number);
        for (SparseRows::InnerIterator entry(axes_[k].fixed, r); entry; ++entry)
          equation.terms.push_back({first_[k] + entry.col(), entry.value()});
      }
    for (std::size_t i = 0; i < allowed_.size(); ++i)
      for (const Vector3& normal : zeroAlong(allowed_[i])) {
        const auto point = static_cast<Index>(i);
        SumEquation& equation =
            result.emplace_back(SumEquation{{}, -normal.dot(offset(Eigen::VectorXd::Zero(first_[3]), point)), {point}});
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
        const double within = withinBounds(slab.low, slab.high);
        for (std::size_t k = 0; k < 3; ++k)
          for (SparseRows::InnerIterator entry(axes_[k].offsets, static_cast<Index>(i)); entry; ++entry)
            if (entry.value() == 1) y_[first_[k] + entry.col()] += within * slab.normal[static_cast<Index>(k)];
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

  [[nodiscard]] static std::vector<OffsetBound> boundsOf(const AllowedOffset& allowed, Index point)
  {
    std::vector<OffsetBound> bounds;
    if (allowed.radius > 0) bounds.push_back({point, true, allowed.radius, Vector3::Zero(), 0, allowed.directions});
    for (const AllowedSlab& slab : allowed.slabs) {
      const double size = roomBetween(slab.low, slab.high);
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
    for (const OffsetBound& bound : boundsOf(allowed_[point], point)) {
      if (!(bound.value(offset(y_, point)) < -kLeastRoom)) towards(bound);
      if (!(bound.value(offset(y_, point)) < -kLeastRoom)) {
        bounds_.resize(before);
        return false;
      }
      bounds_.push_back(bound);
    }
    return true;
  }

  /// The pull of a bound, and a little of |y|^2, so that there is one minimum.
  void towards(const OffsetBound& bound)
  {
    std::array<Eigen::MatrixXd, 3> little;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index count = first_[k + 1] - first_[k];
      if (k == 0 || !isShared()) little[k] = Eigen::MatrixXd::Identity(count, count) * (1e-9 / bound.size / bound.size);
    }
    const auto ofAxis = [&](std::size_t k) { return &little[isShared() ? 0 : k]; };
    OffsetEnergy energy{{ofAxis(0), ofAxis(1), ofAxis(2)}, noBlocks(), Eigen::VectorXd::Zero(y_.size())};
    energy.blocks[bound.point] = bound.curvatureOfPull();
    addAt(energy.q, bound.point, bound.gradientOfPull(constantOf(bound.point)));
    static_cast<void>(minimise(energy, 1, bound));
  }

  [[nodiscard]] Vector3 constantOf(Index point) const
  {
    return {axes_[0].constant[point], axes_[1].constant[point], axes_[2].constant[point]};
  }

  [[nodiscard]] std::vector<Eigen::Matrix3d> noBlocks() const
  {
    return std::vector<Eigen::Matrix3d>(allowed_.size(), Eigen::Matrix3d::Zero());
  }

  [[nodiscard]] OffsetEnergy energyOf(const std::vector<char>& isOutOfReach) const
  {
    OffsetEnergy result{
        {axes_[0].stiffness, axes_[1].stiffness, axes_[2].stiffness}, noBlocks(), Eigen::VectorXd(y_.size())};
    for (std::size_t k = 0; k < 3; ++k) result.q.segment(first_[k], first_[k + 1] - first_[k]) = axes_[k].pull;
    for (std::size_t i = 0; i < allowed_.size(); ++i) {
      const auto& [weight, damping] = std::tie(allowed_[i].weight, allowed_[i].damping);
      if ((weight == 0 && damping == 0) || isOutOfReach[i] != 0) continue;
      const Eigen::Matrix3d held = matrixOf(allowed_[i].directions);
      result.blocks[i] = weight * held + damping * (Eigen::Matrix3d::Identity() - held);
      addAt(result.q, static_cast<Index>(i), result.blocks[i] * constantOf(static_cast<Index>(i)));
    }
    return result;
  }

  [[nodiscard]] Eigen::VectorXd gradientOf(const OffsetEnergy& energy) const
  {
    Eigen::VectorXd result = energy.q;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index count = first_[k + 1] - first_[k];
      result.segment(first_[k], count).noalias() += *energy.stiffness[k] * y_.segment(first_[k], count);
    }
    for (std::size_t i = 0; i < energy.blocks.size(); ++i)
      if (!energy.blocks[i].isZero(0))
        addAt(result, static_cast<Index>(i), energy.blocks[i] * offset(y_, static_cast<Index>(i), true));
    return result;
  }

  /// What the pulls at the place that is reached could do within the bounds.
  [[nodiscard]] double workOf(const OffsetEnergy& energy) const
  {
    const Eigen::VectorXd gradient = inFree(gradientOf(energy));
    double size = 0;
    for (const OffsetBound& bound : bounds_) size = std::max(size, bound.size);
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

  /// Tells whether points are the same along all axes, pull alike, and follow from nothing.
  [[nodiscard]] bool isShared() const
  {
    return !fixed_ && axes_[0].stiffness == axes_[1].stiffness && axes_[0].stiffness == axes_[2].stiffness &&
           axes_[0].offsets.rows() == axes_[0].offsets.cols();
  }

  /// The step that solves H step = -gradient in the free directions, where H has the stiffness of `energy` and
  /// `blocks`.
  [[nodiscard]] Eigen::VectorXd stepOf(const OffsetEnergy& energy, const std::vector<Eigen::Matrix3d>& blocks,
                                       const Eigen::VectorXd& gradient) const
  {
    if (isShared())
      if (std::optional<Eigen::VectorXd> step = solveBlockNewton(*energy.stiffness[0], blocks, -gradient))
        return *std::move(step);
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(y_.size(), y_.size());
    for (std::size_t k = 0; k < 3; ++k) {
      const Index count = first_[k + 1] - first_[k];
      H.block(first_[k], first_[k], count, count) = *energy.stiffness[k];
    }
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (!blocks[i].isZero(0)) addAt(H, static_cast<Index>(i), blocks[i]);
    if (!fixed_) return solvedDefinite(std::move(H), -gradient);
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
  Eigen::VectorXd minimise(const OffsetEnergy& energy, double work, const std::optional<OffsetBound>& stop)
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
      std::vector<Eigen::Matrix3d> blocks = energy.blocks;
      Eigen::VectorXd gradient = gradientOf(energy);
      for (Index b = 0; b < count; ++b) {
        const OffsetBound& bound = bounds_[b];
        const Vector3 slope = bound.gradient(offset(y_, bound.point));
        blocks[bound.point] += forces[b] * bound.curvature() - forces[b] / values[b] * (slope * slope.transpose());
        addAt(gradient, bound.point, -aim / values[b] * slope);
      }
      const Eigen::VectorXd dy = stepOf(energy, blocks, gradient);
      if (!dy.allFinite()) break;
      double length = 1;
      Eigen::VectorXd change(count);
      for (Index b = 0; b < count; ++b) {
        const OffsetBound& bound = bounds_[b];
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
  std::vector<OffsetBound> bounds_;
  std::vector<OffsetBound> reached_;
};

}  // namespace

ChosenOffsets chooseOffsets(const std::array<AxisPull, 3>& axes, const std::vector<AllowedOffset>& allowed)
{
  return OffsetChooser(axes, allowed).chosen();
}

}  // namespace holdfast

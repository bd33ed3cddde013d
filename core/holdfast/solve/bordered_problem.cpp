#include "holdfast/solve/bordered_problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/solve/column_scaling.h>
#include <holdfast/solve/interleaved_rows.h>
#include <holdfast/threads/long_step.h>

namespace holdfast {
namespace {

// Scaled to a diagonal of 1, a matrix with a smaller reciprocal condition number keeps too few digits.
constexpr double kLeastRcond = 1e-13;

/// Rows by their places in their lists.
struct Edit {
  std::vector<Index> removed;  // of the rows before
  std::vector<Index> added;    // of the rows now
};

/// The places of `rows` in ascending order of their terms.
std::vector<Index> sorted(std::vector<Index> places, const std::vector<RowTerms>& rows)
{
  std::ranges::sort(places, {}, [&](Index place) -> const RowTerms& { return rows[place]; });
  return places;
}

Edit editOf(const EliminatedConstraints& before, const EliminatedConstraints& now)
{
  const auto independentOf = [](const EliminatedConstraints& all) {
    return independentRows(all.dependencies, all.rows.size());
  };
  std::vector<Index> old = independentOf(before);
  std::vector<Index> fresh = independentOf(now);
  // Lists that follow one another are alike but for one place.
  const auto isSame = [&](Index a, Index b) { return before.rows[a] == now.rows[b]; };
  const auto [oldFirst, freshFirst] = std::ranges::mismatch(old, fresh, isSame);
  old.erase(old.begin(), oldFirst);
  fresh.erase(fresh.begin(), freshFirst);
  while (!old.empty() && !fresh.empty() && isSame(old.back(), fresh.back())) {
    old.pop_back();
    fresh.pop_back();
  }
  old = sorted(std::move(old), before.rows);
  fresh = sorted(std::move(fresh), now.rows);
  const auto termsBefore = [&](Index row) -> const RowTerms& { return before.rows[row]; };
  const auto termsNow = [&](Index row) -> const RowTerms& { return now.rows[row]; };
  Edit edit;
  std::ranges::set_difference(old, fresh, std::back_inserter(edit.removed), {}, termsBefore, termsNow);
  std::ranges::set_difference(fresh, old, std::back_inserter(edit.added), {}, termsNow, termsBefore);
  return edit;
}

/// Calls `use(first, count)` for three columns at a time.
template <class Use>
void forEachThree(Index columns, const Use& use)
{
  for (Index first = 0; first < columns; first += 3) use(first, std::min<Index>(3, columns - first));
}

/// The rows of components that `some` are in; the others are empty.
std::vector<RowTerms> connectedTo(const std::vector<Index>& some, const EliminatedConstraints& constraints,
                                  Index unknownCount)
{
  const std::vector<RowTerms>& rows = constraints.rows;
  const std::vector<Index> independent = independentRows(constraints.dependencies, rows.size());
  DisjointSets sets(unknownCount);
  for (const Index row : independent)
    for (const Term& term : rows[row]) sets.unite(rows[row].front().index, term.index);
  std::vector<Index> wanted;
  wanted.reserve(some.size());
  for (const Index row : some) wanted.push_back(sets.find(rows[row].front().index));
  std::ranges::sort(wanted);
  std::vector<RowTerms> result(rows.size());
  for (const Index row : independent)
    if (!rows[row].empty() && std::ranges::binary_search(wanted, sets.find(rows[row].front().index)))
      result[row] = rows[row];
  return result;
}

/// n x removed: the displacements that meet every independent row with 0 but one of those removed, with 1.
SparseMatrix released(const EliminatedConstraints& before, const std::vector<Index>& removed, Index unknownCount)
{
  const std::vector<RowTerms> rows = connectedTo(removed, before, unknownCount);
  std::vector<Index> columnOf(rows.size(), -1);
  for (std::size_t k = 0; k < removed.size(); ++k) columnOf[removed[k]] = static_cast<Index>(k);
  std::vector<Eigen::Triplet<double, int>> entries;
  for (const RowComponent& component : connectedRows(rows, unknownCount)) {
    std::vector<Index> places;
    for (std::size_t k = 0; k < component.rows.size(); ++k)
      if (columnOf[component.rows[k]] >= 0) places.push_back(static_cast<Index>(k));
    if (places.empty()) continue;
    const auto size = static_cast<Index>(component.unknowns.size());
    const Elimination own(localRows(rows, component), independentRows({}, component.rows.size()), size,
                          std::vector<bool>(component.unknowns.size(), false));
    forEachThree(static_cast<Index>(places.size()), [&](Index first, Index count) {
      Columns3 d = Columns3::Zero(static_cast<Index>(component.rows.size()), 3);
      for (Index c = 0; c < count; ++c) d(places[first + c], c) = 1;
      const Columns3 u = own.particular(d);
      for (Index i = 0; i < size; ++i)
        for (Index c = 0; c < count; ++c)
          if (u(i, c) != 0)
            entries.emplace_back(static_cast<int>(component.unknowns[i]),
                                 static_cast<int>(columnOf[component.rows[places[first + c]]]), u(i, c));
    });
  }
  SparseMatrix result(unknownCount, static_cast<Index>(removed.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// The border of a reduced problem of k unknowns.
struct Border {
  SparseMatrix AP;           // n x removed, columns of length 1
  SparseRows K;              // added x (k + removed), rows of length 1
  Eigen::VectorXd scale;     // of the rows of K
  std::vector<Index> added;  // places of these in the list
};

/// Makes rows of length 1; returns what they were multiplied by.
Eigen::VectorXd scaleRows(SparseRows& K)
{
  Eigen::VectorXd scale(K.rows());
  for (Index r = 0; r < K.rows(); ++r) K.row(r) *= scale[r] = 1 / K.row(r).norm();
  return scale;
}

/// These rows over the columns of Q2 and P.
SparseRows keptRows(const EliminatedConstraints& constraints, const std::vector<Index>& rows, const SparseRows& Q2,
                    const SparseMatrix& P)
{
  return assembled<SparseRows>(static_cast<Index>(rows.size()), Q2.cols() + P.cols(), [&](Index i, ColumnSum& sum) {
    for (const Term& term : constraints.rows[rows[i]]) {
      sum.addColumn(Q2, term.index, 0, term.coefficient);
      for (Index k = 0; k < P.cols(); ++k)
        if (const double moved = P.coeff(term.index, k); moved != 0)
          sum.add(static_cast<int>(Q2.cols() + k), term.coefficient * moved);
    }
  });
}

/// The rows of `above`, which has fewer columns, and of `below`.
SparseRows stacked(const SparseRows& above, const SparseRows& below)
{
  return assembled<SparseRows>(above.rows() + below.rows(), below.cols(), [&](Index i, ColumnSum& sum) {
    i < above.rows() ? sum.addColumn(above, i) : sum.addColumn(below, i - above.rows());
  });
}

/// What makes columns of A Q2, and of K below it, of length 1.
Result<Eigen::VectorXd> columnScale(const EnergyMatrix& A, const SparseMatrix& Q2, const SparseRows& K)
{
  Eigen::VectorXd squares(Q2.cols());
  const ReducedColumns columns(A, Q2);
  parallelBlocks(squares.size(), [&](Index k) {
    squares[k] = 0;
    columns.forEachInColumn(k, [&](Index /*row*/, double value) { squares[k] += value * value; });
  });
  for (Index r = 0; r < K.rows(); ++r)
    for (SparseRows::InnerIterator entry(K, r); entry; ++entry) squares[entry.col()] += std::pow(entry.value(), 2);
  return unitScale(squares);
}

/// W (N's size x released and added): how the border is tied to the system of `base`.
SparseMatrix couplings(const ReducedProblem& base, const Border& border)
{
  const Index unknowns = base.scale.size();
  const SparseMatrix ofReleased = transposeProduct(*base.C->A(), border.AP);  // Q2^T of these
  return assembled<SparseMatrix>(
      unknowns + base.kept, ofReleased.cols() + border.K.rows(), [&](Index k, ColumnSum& sum) {
        if (k < ofReleased.cols()) {
          for (SparseMatrix::InnerIterator entry(ofReleased, k); entry; ++entry)
            sum.addColumn(base.C->Q2()->rows(), entry.row(), 0, entry.value());
          return;
        }
        for (SparseRows::InnerIterator entry(border.K, k - ofReleased.cols()); entry && entry.col() < unknowns; ++entry)
          sum.add(static_cast<int>(entry.col()), entry.value());
      });
}

/// Solves the bordered system. Layout of right sides and solutions: unknowns, those added; multipliers, those added.
class FactorAndBorder final : public BorderedFactor {
 public:
  /// `base` has our own factor.
  FactorAndBorder(std::shared_ptr<const ReducedProblem> base, Border border)
      : base_(std::move(base)),
        border_(std::move(border)),
        unknowns_(base_->scale.size()),
        released_(border_.AP.cols()),
        added_(border_.K.rows()),
        rows_(base_->factor->packed()->symbolic().order),
        V_(base_->factor->packed()->solveForward(couplings(*base_, border_))),
        SV_(V_)
  {
    for (int& row : rows_)
      if (row >= unknowns_) row += static_cast<int>(released_);
    for (Index column = 0; column < SV_.cols(); ++column)
      for (SparseMatrix::InnerIterator entry(SV_, column); entry; ++entry)
        if (std::ranges::binary_search(base_->factor->packed()->negative(), static_cast<int>(entry.row())))
          entry.valueRef() *= -1;
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(V_.cols(), V_.cols());
    S.topLeftCorner(released_, released_) = SparseMatrix(border_.AP.transpose() * border_.AP);
    S.bottomLeftCorner(added_, released_) = border_.K.rightCols(released_);
    S.topRightCorner(released_, added_) = S.bottomLeftCorner(added_, released_).transpose();
    S -= SparseMatrix(SV_.transpose() * V_);
    weights_ = S.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    schur_.compute(weights_.asDiagonal() * S * weights_.asDiagonal());
  }

  [[nodiscard]] bool isRegular() const { return weights_.allFinite() && schur_.rcond() > kLeastRcond; }

  [[nodiscard]] Columns3 solve(const Columns3& g) const override
  {
    Columns3 ofBorder(V_.cols(), 3);
    ofBorder << g.middleRows(unknowns_, released_), g.bottomRows(added_);
    gather(rows_, g, x_);
    base_->factor->packed()->solveForward(x_);
    Columns3 result = solvedBackward(ofBorder - SV_.transpose() * forward());
    // C^T C has the squares of kept rows in it; those added are not in the factor.
    result.bottomRows(added_) -= g.bottomRows(added_);
    return result;
  }

  /// The equations of the base hold already, so the pass through L would find zeros.
  [[nodiscard]] Columns3 stepFromBase(const Columns3& u, const Columns3& f, const Columns3& missed) const override
  {
    const EnergyMatrix& A = *base_->C->A();
    Columns3 ofBorder = Columns3::Zero(V_.cols(), 3);
    for (Index k = 0; k < released_; ++k)
      for (SparseMatrix::InnerIterator entry(border_.AP, k); entry; ++entry)
        ofBorder.row(k) += entry.value() * (f.row(entry.row()) - A.rowTimes(entry.row(), u));
    for (Index k = 0; k < added_; ++k) ofBorder.row(released_ + k) = border_.scale[k] * missed.row(border_.added[k]);
    x_.assign(4 * rows_.size(), 0);
    return solvedBackward(ofBorder);
  }

  [[nodiscard]] const std::vector<Index>& added() const override { return border_.added; }
  [[nodiscard]] const SparseRows& K() const noexcept { return border_.K; }

  [[nodiscard]] Index nonzeros() const override { return base_->factor->nonzeros() + V_.nonZeros(); }
  [[nodiscard]] std::string_view method() const override
  {
    return "an earlier factor, bordered by the rows that differ";
  }

 private:
  /// The numbers of `x_`, which solve with L once `PackedFactor::solveForward` has.
  [[nodiscard]] Eigen::Map<Columns3, 0, Eigen::OuterStride<4>> forward() const
  {
    return {x_.data(), V_.rows(), 3, Eigen::OuterStride<4>()};
  }

  /// The rest of a solution: `left` is what `forward()` leaves of the border.
  [[nodiscard]] Columns3 solvedBackward(const Columns3& left) const
  {
    const Columns3 s = weights_.asDiagonal() * schur_.solve(Eigen::MatrixX3d(weights_.asDiagonal() * left));
    forward().noalias() -= V_ * s;
    base_->factor->packed()->solveBackward(x_);
    Columns3 result(static_cast<Index>(rows_.size()) + V_.cols(), 3);
    scatter(rows_, x_, result);
    result.middleRows(unknowns_, released_) = s.topRows(released_);
    result.bottomRows(added_) = s.bottomRows(added_);
    return result;
  }

  std::shared_ptr<const ReducedProblem> base_;
  Border border_;
  Index unknowns_;
  Index released_;
  Index added_;
  std::vector<int> rows_;  // of right sides and solutions: those of `base_`, in its order of elimination
  SparseMatrix V_;         // L^-1 W
  SparseMatrix SV_;        // S V, S with the signs of the factor
  Eigen::VectorXd weights_;
  Eigen::PartialPivLU<Eigen::MatrixXd> schur_;
  mutable std::vector<double> x_;  // memory that every solution uses again
};

}  // namespace

Result<ReducedProblem> makeReducedProblem(std::shared_ptr<const EnergyMatrix> A, SparseMatrix Q2, SparseRows K,
                                          RowsBelow below, Columns3 rest, Backend backend, EliminationOrder order)
{
  const bool isKept = below == RowsBelow::Kept;
  const std::shared_ptr<const StepState> step = currentStep();
  step->stopIfLeftBehind();
  auto [scale, unscaled] = columnScale(*A, Q2, isKept ? SparseRows() : K);
  step->stopIfLeftBehind();
  if (!unscaled.empty()) return {{}, std::move(unscaled)};
  const Columns3 probe = scale.cwiseInverse().asDiagonal() * Columns3(Q2.transpose() * std::exchange(rest, {}));
  Q2 = Q2 * scale.asDiagonal();
  K = K.rows() == 0 ? SparseRows(0, Q2.cols()) : SparseRows(K * scale.asDiagonal());
  if (isKept) scaleRows(K);
  const Index kept = isKept ? K.rows() : 0;
  const auto C = std::make_shared<const ReducedMatrix>(
      std::move(A), std::make_shared<const TwoWayMatrix>(std::move(Q2)), SparseMatrix(), std::move(K));
  FactorResult factor = kept == 0 ? factorize(*C, backend, probe, order) : factorizeKept(*C, C->K(), probe, order);
  if (!factor) return {{}, std::move(factor.failure)};
  return {{C, std::move(scale), kept, std::move(factor.value), nullptr}};
}

Result<ReducedProblem> bordered(const std::shared_ptr<const ReducedProblem>& base, const EliminatedConstraints& before,
                                const EliminatedConstraints& now)
{
  if (before.isHeld != now.isHeld) return {{}, "other parts are held"};
  const Edit edit = editOf(before, now);
  if (edit.removed.size() + edit.added.size() > kMostEdited) return {{}, "too many rows differ"};
  if (base->factor->packed() == nullptr) return {{}, "the factor has no halves"};

  const EnergyMatrix& A = *base->C->A();
  const std::shared_ptr<const TwoWayMatrix>& Q2 = base->C->Q2();
  SparseMatrix P = released(before, edit.removed, A.cols());
  auto [scale, unscaled] = columnScale(A, P, {});
  if (!unscaled.empty()) return {{}, std::move(unscaled)};
  P = P * scale.asDiagonal();
  SparseRows K = keptRows(now, edit.added, Q2->rows(), P);
  Eigen::VectorXd scaleOfK = scaleRows(K);
  const auto factor = std::make_shared<const FactorAndBorder>(
      base, Border{product(A, P), std::move(K), std::move(scaleOfK), edit.added});
  if (!factor->isRegular()) return {{}, "the Schur complement is singular in doubles"};
  ReducedProblem result;
  result.factor = result.border = factor;
  result.scale.resize(base->scale.size() + P.cols());
  result.scale << base->scale, scale;
  result.kept = base->kept + factor->K().rows();
  result.C = std::make_shared<const ReducedMatrix>(base->C->A(), Q2, std::move(P), stacked(base->C->K(), factor->K()));
  return {std::move(result)};
}

}  // namespace holdfast

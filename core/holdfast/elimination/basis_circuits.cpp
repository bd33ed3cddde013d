#include "holdfast/elimination/basis_circuits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include <Eigen/OrderingMethods>

#include <holdfast/elimination/sparse_qr.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// Coefficients below this share of the largest are not followed: together they are less than rounding.
constexpr double kFollowedShare = std::numeric_limits<double>::epsilon() / 16;

// What a QR of many columns may lose to rounding. Circuits that are off by less are corrected once.
constexpr double kRoundingOfQr = 1e-12;

// Rows whose circuits a thread finds at a time.
constexpr Index kRowsAtATime = 1024;

/// Solves R x = r for sparse r, R upper triangular, the diagonal last in each column. Its workspace is cleared where it
/// was touched.
class SparseBackSolve {
 public:
  explicit SparseBackSolve(const SparseMatrix& R)
      : R_(R), x_(Eigen::VectorXd::Zero(R.cols())), isPending_(static_cast<std::size_t>(R.cols()), false)
  {
  }

  /// Entries of x, the last first. `column` has its entries above R.rows().
  template <class Column>
  const std::vector<Term>& solve(const Column& column)
  {
    solution_.clear();
    double largest = 0;
    for (const Term& term : column) add(term.index, term.coefficient);
    while (!pending_.empty()) {
      const Index k = pending_.top();
      pending_.pop();
      isPending_[k] = false;
      const double value = std::exchange(x_[k], 0) / diagonal(k);
      if (std::abs(value) <= kFollowedShare * largest) continue;
      largest = std::max(largest, std::abs(value));
      solution_.push_back({k, value});
      for (SparseMatrix::InnerIterator entry(R_, k); entry.row() < k; ++entry) add(entry.row(), -entry.value() * value);
    }
    return solution_;
  }

 private:
  void add(Index k, double value)
  {
    x_[k] += value;
    if (isPending_[k]) return;
    isPending_[k] = true;
    pending_.push(k);
  }

  [[nodiscard]] double diagonal(Index k) const { return SparseMatrix::ReverseInnerIterator(R_, k).value(); }

  const SparseMatrix& R_;
  Eigen::VectorXd x_;
  std::vector<bool> isPending_;
  std::priority_queue<Index> pending_;
  std::vector<Term> solution_;
};

/// The basis in an order in which its QR fills in little.
std::vector<Index> inFillReducingOrder(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                                       const std::vector<Index>& unknowns)
{
  const SparseMatrix block = transposedBlock(rows, {basis, unknowns});
  Eigen::COLAMDOrdering<int>::PermutationType placeOf;
  Eigen::COLAMDOrdering<int>()(block, placeOf);
  std::vector<Index> result(basis.size());
  for (std::size_t k = 0; k < basis.size(); ++k) result[placeOf.indices()[static_cast<Index>(k)]] = basis[k];
  return result;
}

std::vector<Term> entriesAbove(const SparseMatrix& R, Index column, Index end)
{
  std::vector<Term> result;
  for (SparseMatrix::InnerIterator entry(R, column); entry && entry.row() < end; ++entry)
    result.push_back({entry.row(), entry.value()});
  return result;
}

/// A block of columns of length 1, and R of its QR: the basis first.
class BasisQr {
 public:
  BasisQr(const std::vector<RowTerms>& rows, std::vector<Index> order, Index basisSize,
          const std::vector<Index>& unknowns)
      : rows_(std::move(order)), block_(transposedBlock(rows, {rows_, unknowns}))
  {
    constexpr double kAcceptAll = -1;
    lengths_ = normalizeColumns(block_);
    R_ = SparseMatrix(SparseRows(sparseQr(block_, kAcceptAll, WantQ::No, ColumnOrder::AsGiven).R).topRows(basisSize));
    R11_ = R_.leftCols(basisSize);
  }

  [[nodiscard]] Index basisSize() const { return R11_.cols(); }

  [[nodiscard]] const SparseMatrix& R11() const { return R11_; }

  /// `residual` is zero, of as many entries as the block has rows, and is left so.
  [[nodiscard]] Dependency of(Index column, SparseBackSolve& solve, Eigen::VectorXd& residual) const
  {
    std::vector<Term> solution = solve.solve(entriesAbove(R_, column, basisSize()));
    double distance = distanceOf(column, solution, residual);
    if (distance > kRoundingDistance && distance < kRoundingOfQr) {
      std::vector<Term> better = corrected(column, solution);
      if (const double left = distanceOf(column, better, residual); left < distance) {
        solution = std::move(better);
        distance = left;
      }
    }
    Dependency result{rows_[column], {}, distance};
    double largest = 1;
    for (const Term& term : solution) {
      const double coefficient = term.coefficient * lengths_[column] / lengths_[term.index];
      largest = std::max(largest, std::abs(coefficient));
      result.terms.push_back({rows_[term.index], coefficient});
    }
    const double vanishing = kCoefficientThreshold * largest;
    std::erase_if(result.terms, [&](const Term& term) { return std::abs(term.coefficient) <= vanishing; });
    std::ranges::sort(result.terms, {}, &Term::index);
    return result;
  }

 private:
  /// One step of the corrected semi-normal equations (Bjorck, 1987): a + (B^T B)^-1 B^T (b - B a). O(entries of R).
  [[nodiscard]] std::vector<Term> corrected(Index column, const std::vector<Term>& solution) const
  {
    Eigen::VectorXd left = Eigen::VectorXd::Zero(block_.rows());
    addColumn(column, 1, left);
    for (const Term& term : solution) addColumn(term.index, -term.coefficient, left);
    Eigen::VectorXd a = block_.leftCols(basisSize()).transpose() * left;
    R11_.transpose().triangularView<Eigen::Lower>().solveInPlace(a);
    R11_.triangularView<Eigen::Upper>().solveInPlace(a);
    for (const Term& term : solution) a[term.index] += term.coefficient;
    const double followed = kFollowedShare * a.cwiseAbs().maxCoeff();
    std::vector<Term> result;
    for (Index k = 0; k < a.size(); ++k)
      if (std::abs(a[k]) > followed) result.push_back({k, a[k]});
    return result;
  }

  /// |b - sum a_k b_k| / |(1, a)|.
  [[nodiscard]] double distanceOf(Index column, const std::vector<Term>& solution, Eigen::VectorXd& residual) const
  {
    double size = 1;
    addColumn(column, 1, residual);
    for (const Term& term : solution) {
      size = std::hypot(size, term.coefficient);
      addColumn(term.index, -term.coefficient, residual);
    }
    double squares = 0;
    takeColumn(column, squares, residual);
    for (const Term& term : solution) takeColumn(term.index, squares, residual);
    return std::sqrt(squares) / size;
  }

  void addColumn(Index column, double share, Eigen::VectorXd& to) const
  {
    for (SparseMatrix::InnerIterator entry(block_, column); entry; ++entry) to[entry.row()] += share * entry.value();
  }

  void takeColumn(Index column, double& squares, Eigen::VectorXd& from) const
  {
    for (SparseMatrix::InnerIterator entry(block_, column); entry; ++entry) {
      const double value = std::exchange(from[entry.row()], 0);
      squares += value * value;
    }
  }

  std::vector<Index> rows_;
  SparseMatrix block_;
  Eigen::VectorXd lengths_;
  SparseMatrix R_;
  SparseMatrix R11_;
};

}  // namespace

Dependency dependencyOf(Index row, const std::vector<Index>& basis, const Eigen::VectorXd& coefficients,
                        double distance)
{
  Dependency result{row, {}, distance};
  const double largest = coefficients.size() > 0 ? coefficients.cwiseAbs().maxCoeff() : 0;
  const double vanishing = kCoefficientThreshold * std::max(1.0, largest);
  for (Index k = 0; k < coefficients.size(); ++k)
    if (std::abs(coefficients[k]) > vanishing) result.terms.push_back({basis[k], coefficients[k]});
  std::ranges::sort(result.terms, {}, &Term::index);
  return result;
}

std::vector<Dependency> circuitsOf(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                                   const std::vector<Index>& others, const std::vector<Index>& unknowns)
{
  std::vector<Index> order = inFillReducingOrder(rows, basis, unknowns);
  order.insert(order.end(), others.begin(), others.end());
  const BasisQr qr(rows, std::move(order), static_cast<Index>(basis.size()), unknowns);
  std::vector<Dependency> result(others.size());
  const auto count = static_cast<Index>(others.size());
  parallelFor((count + kRowsAtATime - 1) / kRowsAtATime, [&](Index part) {
    SparseBackSolve solve(qr.R11());
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(static_cast<Index>(unknowns.size()));
    for (Index k = part * kRowsAtATime; k < std::min(count, (part + 1) * kRowsAtATime); ++k)
      result[k] = qr.of(qr.basisSize() + k, solve, residual);
  });
  return result;
}

}  // namespace holdfast

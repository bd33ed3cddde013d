#pragma once
/// The elimination of hard constraints: B^T = Q R for independent rows, (14), never as one matrix.

#include <vector>

#include <holdfast/elimination/row_components.h>
#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {

/// `Elimination` over rows of which none is the difference of two unknowns. A pin is an identity column, its value
/// copied; what pins leave of the other rows falls into components, each with a Householder QR of its own, dense when
/// small and sparse when large. Q2 of a large one would be nearly dense: its rows are substituted as far as each has an
/// unknown of its own (`ownUnknowns`), and the rest of them stay in the system.
class BlockElimination {
 public:
  /// One component of the rows that are left without pins.
  struct Block {
    std::vector<Index> rows;  ///< in the order of R1
    std::vector<Index> unknowns;
    SparseMatrix R1;  ///< upper triangular
    SparseMatrix Q1;  ///< unknowns x rows; empty where Q is a product
    SparseMatrix Q2;  ///< unknowns x (unknowns - rows that are not kept)
    Reflections Q;    ///< of a large component
    std::vector<Index> kept;

    [[nodiscard]] bool isLarge() const { return Q.h.size() > 0; }
    /// Q1 y.
    [[nodiscard]] Columns3 spanTimes(const Columns3& y) const;
    /// Q1^T x.
    [[nodiscard]] Columns3 spanTransposeTimes(const Columns3& x) const;
  };

  BlockElimination(const std::vector<RowTerms>& rows, const std::vector<Index>& independent, Index unknownCount,
                   const std::vector<bool>& isHeld);

  /// Orthonormal but for large components; a free unknown has an identity column.
  [[nodiscard]] const SparseMatrix& Q2() const noexcept { return Q2_; }

  /// Orthonormal, with no row kept: see `Elimination::wholeQ2`.
  [[nodiscard]] SparseMatrix wholeQ2() const;

  /// Q1 y with R1^T y = d, (18). Pins are copied bit for bit.
  [[nodiscard]] Columns3 particular(const Columns3& d) const;

  [[nodiscard]] Columns3 multipliers(const Columns3& gradient, Index rowCount) const;

  /// Over these unknowns, which may be groups.
  [[nodiscard]] std::vector<double> sensitivities(std::size_t rowCount) const;

  [[nodiscard]] const std::vector<Block>& blocks() const noexcept { return blocks_; }

 private:
  struct Pin {
    Index unknown;
    Index row;
    double weight;  // 1, but for what is left of relative rows and face points between groups
  };

  [[nodiscard]] static Block denseBlock(const std::vector<RowTerms>& rows, const RowComponent& component);
  [[nodiscard]] static Block sparseBlock(const std::vector<RowTerms>& rows, const RowComponent& component);
  [[nodiscard]] SparseMatrix assembleQ2() const;

  std::vector<Pin> pins_;
  std::vector<RowTerms> pinnedTerms_;  // of each row: its terms at pinned unknowns
  std::vector<Block> blocks_;
  std::vector<bool> isHeld_;
  SparseMatrix Q2_;
};

}  // namespace holdfast

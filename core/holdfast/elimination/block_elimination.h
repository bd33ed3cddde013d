#pragma once
/// The elimination of hard constraints, block by block. It factorises B^T = Q R for independent rows, (14), but never
/// as one matrix.

#include <utility>
#include <vector>

#include <holdfast/elimination/free_parts.h>
#include <holdfast/elimination/row_components.h>
#include <holdfast/elimination/sparse_qr.h>
#include <holdfast/matrices/sparse_products.h>

namespace holdfast {

/// This class does the work of `Elimination` over rows of which none is the difference of two unknowns. A pin is an
/// identity column, and its value is copied. What pins leave of the other rows falls into components. Each component
/// has a Householder QR of its own, dense when it is small and sparse when it is large. Q2 of a large component is that
/// of the parts that it leaves free. Such a part may keep rows, which stay in the system.
class BlockElimination {
 public:
  /// One component of the rows that are left without pins.
  struct Block {
    std::vector<Index> rows;  ///< in the order of R1
    std::vector<Index> unknowns;
    SparseMatrix Q2;              ///< unknowns x (unknowns - rows that are not kept)
    Reflections Q;                ///< of a large component
    std::vector<FreePart> parts;  ///< of a large component

    [[nodiscard]] bool isLarge() const { return Q.h.size() > 0; }
  };

  BlockElimination(const std::vector<RowTerms>& rows, const std::vector<Index>& independent, Index unknownCount,
                   const std::vector<bool>& isHeld);

  /// Returns Q2, which is orthonormal but for large components. A free unknown has an identity column. Each call makes
  /// the matrix anew: O(n + its entries).
  [[nodiscard]] SparseMatrix Q2() const;

  /// Returns how many columns Q2 has. O(n).
  [[nodiscard]] Index freeCount() const;

  /// Returns an orthonormal Q2 for which no row is kept, see `Elimination::wholeQ2`.
  [[nodiscard]] SparseMatrix wholeQ2() const;

  /// Returns Q1 y with R1^T y = d, (18). Pins are copied bit for bit.
  [[nodiscard]] Columns3 particular(const Columns3& d) const;

  [[nodiscard]] Columns3 multipliers(const Columns3& gradient) const;

  /// Returns the sensitivities over these unknowns, which may be groups.
  [[nodiscard]] std::vector<double> sensitivities() const;

  [[nodiscard]] const std::vector<Block>& blocks() const noexcept { return blocks_; }

 private:
  struct Pin {
    Index unknown;
    Index row;
    double weight;  // 1, but for what groups leave of relative rows and face points
  };

  /// One block's part of the matrices below.
  struct Factors {
    SparseMatrix R1;
    SparseMatrix Q1;  // unknowns x rows; empty where Q is a product
  };

  [[nodiscard]] static std::pair<Block, Factors> denseBlock(const std::vector<RowTerms>& rows,
                                                            const RowComponent& component);
  [[nodiscard]] static std::pair<Block, Factors> sparseBlock(const std::vector<RowTerms>& rows,
                                                             const RowComponent& component);

  /// Calls `work(first, end)` for parts of `rows_` that are whole blocks, over all cores.
  template <class Work>
  void forEachPart(const Work& work) const
  {
    parallelFor(static_cast<Index>(parts_.size()) - 1, [&](Index k) { work(parts_[k], parts_[k + 1]); });
  }
  /// Calls `work(block, first, count)` for the large blocks and their places in `rows_`.
  template <class Work>
  void forEachLarge(const Work& work) const
  {
    Index first = 0;
    for (const Block& block : blocks_) {
      if (!block.isLarge()) return;
      const auto count = static_cast<Index>(block.rows.size());
      work(block, first, count);
      first += count;
    }
  }

  std::vector<Pin> pins_;
  std::vector<Block> blocks_;  // the large ones first
  std::vector<Index> rows_;    // of all blocks, one after the other
  SparseMatrix R1_;            // of all blocks: upper triangular, the diagonal last in each column
  TwoWayMatrix Q1_;            // n x rows_; no entries in the columns of large blocks
  TwoWayMatrix pinnedTerms_;   // rows_ x n: terms at pinned unknowns
  std::vector<Index> parts_;   // where parts of `rows_` begin and end that are whole blocks
  std::vector<bool> isHeld_;
  std::size_t rowCount_;
};

}  // namespace holdfast

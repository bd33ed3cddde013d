#include "holdfast/solve/constraint_matrix.h"

namespace holdfast {

SparseMatrix constraintMatrix(const std::vector<RowTerms>& rows, Index unknownCount)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const Term& term : rows[r])
      entries.emplace_back(static_cast<int>(r), static_cast<int>(term.index), term.coefficient);
  SparseMatrix B(static_cast<Index>(rows.size()), unknownCount);
  B.setFromTriplets(entries.begin(), entries.end());
  return B;
}

}  // namespace holdfast

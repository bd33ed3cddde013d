// Nested dissection by METIS, through CHOLMOD.

#include <holdfast/base/cholmod_view_internal.h>
#include <holdfast/solve/nested_dissection_internal.h>

namespace holdfast {

std::mutex& orderingLock()
{
  static std::mutex lock;
  return lock;
}

std::vector<int> nestedDissectionOrder(SparseMatrix lower)
{
  const std::scoped_lock lock(orderingLock());
  cholmod_common common;
  cholmod_start(&common);
  common.print = 0;
  cholmod_sparse view = cholmodView(lower, StoredPart::LowerTriangle);
  std::vector<int> order(static_cast<std::size_t>(lower.cols()));
  const bool isFound = cholmod_metis(&view, nullptr, 0, 0, order.data(), &common) != 0;
  cholmod_finish(&common);
  if (!isFound) order.clear();
  return order;
}

}  // namespace holdfast

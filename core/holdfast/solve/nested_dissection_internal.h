#pragma once
/// Orders of elimination by METIS, which comes with SuiteSparse.

#include <mutex>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// METIS draws from the random numbers of the C library, which it starts anew for each order that it looks for: one at
/// a time, so that the order does not depend on what other threads do.
[[nodiscard]] std::mutex& orderingLock();

/// An order by nested dissection of the symmetric matrix whose lower triangle is `lower`; empty where there is no
/// METIS. Takes six times as long as minimum degree does, and leaves less to compute the larger the matrix is.
[[nodiscard]] std::vector<int> nestedDissectionOrder(SparseMatrix lower);

}  // namespace holdfast

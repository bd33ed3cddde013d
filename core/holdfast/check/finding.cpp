#include "holdfast/check/finding.h"

#include <algorithm>
#include <utility>

namespace holdfast {

Finding makeFinding(std::string kind, std::string idsOf, std::vector<Index> ids, const CountedWords& words)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto count = static_cast<Index>(ids.size());
  if (ids.size() > kMaxFindingIds) ids.resize(kMaxFindingIds);
  return {std::move(kind), count, std::move(idsOf), std::move(ids),
          std::to_string(count) + " " + (count == 1 ? words.one : words.many)};
}

}  // namespace holdfast

#pragma once
/// Something about a mesh that its user should know before it is deformed.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

struct Finding {
  std::string kind;        ///< stable name for programs: "zero_area_faces"
  Index count = 0;         ///< of all, not only of those named
  std::string idsOf;       ///< what the ids are: "vertex", "face" or "constraint", numbered from 0 in file order;
                           ///< "file" and "solution" have no ids; the latter warns of all that was solved
  std::vector<Index> ids;  ///< the first `kMaxFindingIds`, ascending
  std::string message;     ///< one sentence: what was found and what the solver does about it
};

using Findings = std::vector<Finding>;

inline constexpr std::size_t kMaxFindingIds = 20;

/// What follows a count in a sentence: "1 " + one, "12 " + many.
struct CountedWords {
  std::string one;
  std::string many;
};

/// A finding about all of `ids`, which it sorts and cuts to the first few.
[[nodiscard]] inline Finding makeFinding(std::string kind, std::string idsOf, std::vector<Index> ids,
                                         const CountedWords& words)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto count = static_cast<Index>(ids.size());
  if (ids.size() > kMaxFindingIds) ids.resize(kMaxFindingIds);
  return {std::move(kind), count, std::move(idsOf), std::move(ids),
          std::to_string(count) + " " + (count == 1 ? words.one : words.many)};
}

}  // namespace holdfast

#pragma once
/// A finding is something about a mesh, its constraints or a solution that the user should know. It is no error.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// A finding says what was found, and where it applies.
///
///     for (const Finding& finding : model.findings) {
///       std::cerr << finding.message << '\n';
///       if (finding.idsOf == "vertex") highlight(finding.ids);
///     }
struct Finding {
  std::string kind;        ///< a stable name for programs: "zero_area_faces"
  Index count = 0;         ///< how many there are in all, not only in `ids`
  std::string idsOf;       ///< what the ids are: "vertex", "face" or "constraint", numbered from 0 in file order;
                           ///< "file" and "solution" have no ids: "solution" warns of all that was solved
  std::vector<Index> ids;  ///< the first `kMaxFindingIds`, ascending
  std::string message;     ///< one sentence: what was found and what the solver does about it
};

using Findings = std::vector<Finding>;

/// A finding lists no more ids than this.
inline constexpr std::size_t kMaxFindingIds = 20;

/// These words follow a count in a sentence: "1 " + one, "12 " + many.
struct CountedWords {
  std::string one;
  std::string many;
};

/// Makes a finding about all of `ids`. It counts each id once, sorts them, and keeps the first `kMaxFindingIds`. The
/// message is the count, followed by `words`.
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

#pragma once
/// \file
/// Something about a mesh that its user should know before it is deformed.

#include <string>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

struct Finding {
  std::string kind;        ///< stable name for programs: "zero_area_faces"
  Index count = 0;         ///< of all, not only of those named
  std::string idsOf;       ///< what the ids are: "vertex", "face" or "constraint", numbered from 0 in file order;
                           ///< "solution", which has no ids, warns of all that was solved
  std::vector<Index> ids;  ///< the first `kMaxFindingIds`, ascending
  std::string message;     ///< one sentence: what was found and what the solver does about it
};

inline constexpr std::size_t kMaxFindingIds = 20;

/// What follows a count in a sentence: "1 " + one, "12 " + many.
struct CountedWords {
  std::string one;
  std::string many;
};

/// A finding about all of `ids`, which it sorts and cuts to the first few.
[[nodiscard]] Finding makeFinding(std::string kind, std::string idsOf, std::vector<Index> ids,
                                  const CountedWords& words);

}  // namespace holdfast

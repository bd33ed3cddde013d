#include "holdfast/words/spelling.h"

#include <algorithm>
#include <vector>

#include <holdfast/words/lower_case.h>

namespace holdfast {
namespace {

/// Levenshtein's distance, letter case aside.
std::size_t editDistance(std::string_view a, std::string_view b)
{
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lowerCase(a[i]) == lowerCase(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string_view> closestSpelling(std::string_view word, std::span<const std::string_view> known)
{
  constexpr std::size_t kLongestWord = 64;
  if (word.size() > kLongestWord) return std::nullopt;
  std::optional<std::string_view> closest;
  std::size_t smallest = word.size();  // a word that shares no letter is no spelling of it
  for (const std::string_view candidate : known) {
    const std::size_t distance = editDistance(word, candidate);
    if (distance >= smallest || distance > (candidate.size() + 2) / 3) continue;
    smallest = distance;
    closest = candidate;
  }
  return closest;
}

}  // namespace holdfast

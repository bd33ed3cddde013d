#include "holdfast/document/list_edits.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

using Names = std::set<std::string, std::less<>>;

Names namesOf(const ConstraintList& list)
{
  Names names;
  for (const Constraint& constraint : list.constraints) names.insert(constraint.name);
  return names;
}

std::vector<bool> chosen(const ConstraintList& list, const std::vector<Index>& indices)
{
  std::vector<bool> isChosen(list.constraints.size(), false);
  for (const Index index : indices) {
    assert(index >= 0 && index < static_cast<Index>(isChosen.size()));
    isChosen[index] = true;
  }
  return isChosen;
}

ConstraintList partOf(const ConstraintList& list, const std::vector<Index>& indices, bool isWanted)
{
  const std::vector<bool> isChosen = chosen(list, indices);
  ConstraintList part{list.units, {}};
  for (std::size_t k = 0; k < isChosen.size(); ++k)
    if (isChosen[k] == isWanted) part.constraints.push_back(list.constraints[k]);
  return part;
}

void requireUsableName(const ConstraintList& list, const std::string& name, std::optional<Index> owner)
{
  if (name.empty()) throw InputError({}, "the name is empty; every constraint needs one");
  const std::optional<Index> other = indexOf(list, name);
  if (other && other != owner)
    throw InputError({}, fmt::format("{} is the name of constraint {} in the list already; choose another, because "
                                     "reports tell constraints apart by their names",
                                     inQuotes(name), *other + 1));
}

/// Makes names that are not taken, without counting from the start each time.
class NameMaker {
 public:
  explicit NameMaker(Names taken) : taken_(std::move(taken)) {}

  std::string unique(const std::string& name) { return taken_.insert(name).second ? name : counted(stemOf(name)); }

 private:
  /// "P" of "P12", "base " of "base".
  static std::string stemOf(const std::string& name)
  {
    const std::size_t end = name.find_last_not_of("0123456789");
    if (end == std::string::npos) return name + ' ';
    return end + 1 == name.size() ? name + ' ' : name.substr(0, end + 1);
  }

  std::string counted(const std::string& stem)
  {
    // Words in front of a number are the first of their kind: "base", "base 2".
    Index& last = last_.try_emplace(stem, stem.ends_with(' ') ? 1 : 0).first->second;
    std::string candidate;
    do candidate = stem + std::to_string(++last);
    while (!taken_.insert(candidate).second);
    return candidate;
  }

  Names taken_;
  std::map<std::string, Index, std::less<>> last_;  // number tried, by stem
};

}  // namespace

std::optional<Index> indexOf(const ConstraintList& list, std::string_view name)
{
  const auto found = std::ranges::find(list.constraints, name, &Constraint::name);
  if (found == list.constraints.end()) return std::nullopt;
  return found - list.constraints.begin();
}

std::string unusedName(const ConstraintList& list, std::string_view stem)
{
  const Names taken = namesOf(list);
  std::string name;
  Index number = 0;
  do name = fmt::format("{}{}", stem, ++number);
  while (taken.contains(name));
  return name;
}

ConstraintList added(ConstraintList list, Constraint constraint)
{
  requireUsableName(list, constraint.name, std::nullopt);
  list.constraints.push_back(std::move(constraint));
  return list;
}

ConstraintList renamed(ConstraintList list, Index index, std::string name)
{
  requireUsableName(list, name, index);
  list.constraints.at(index).name = std::move(name);
  return list;
}

ConstraintList removed(const ConstraintList& list, const std::vector<Index>& indices)
{
  return partOf(list, indices, false);
}

ConstraintList extracted(const ConstraintList& list, const std::vector<Index>& indices)
{
  return partOf(list, indices, true);
}

ConstraintList moved(ConstraintList list, const std::vector<Index>& indices, Index before)
{
  assert(before >= 0 && before <= static_cast<Index>(list.constraints.size()));
  const std::vector<bool> isMoved = chosen(list, indices);
  ConstraintList result{std::move(list.units), {}};
  const auto take = [&](std::size_t begin, std::size_t end, bool wanted) {
    for (std::size_t k = begin; k < end; ++k)
      if (isMoved[k] == wanted) result.constraints.push_back(std::move(list.constraints[k]));
  };
  const auto middle = static_cast<std::size_t>(before);
  take(0, middle, false);
  take(0, isMoved.size(), true);
  take(middle, isMoved.size(), false);
  return result;
}

ConstraintList withEnabled(ConstraintList list, const std::vector<Index>& indices, Enabling enabling)
{
  for (const Index index : indices) list.constraints.at(index).isEnabled = enabling == Enabling::Enabled;
  return list;
}

ConstraintList pasted(ConstraintList list, ConstraintList other)
{
  NameMaker names(namesOf(list));
  for (Constraint& constraint : other.constraints) {
    constraint.name = names.unique(constraint.name);
    list.constraints.push_back(std::move(constraint));
  }
  if (list.units.empty()) list.units = std::move(other.units);
  return list;
}

}  // namespace holdfast

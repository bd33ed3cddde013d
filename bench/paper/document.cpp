#include "bench/paper/document.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace holdfast::paper {
namespace {

constexpr std::size_t kLineLength = 100;
constexpr const char* kHeading = "## ";

constexpr const char* kIntroduction =
    R"(# The paper, reproduced

    scripts/paper.sh            builds what it needs, fetches the models, runs everything, writes this page
    scripts/paper.sh --small    what needs neither network nor minutes; the other sections stay as they are

H. Masuda, Y. Yoshioka, Y. Furukawa, *Interactive mesh deformation using equality-constrained least
squares*, Computers & Graphics 30 (2006), is "the paper" here. A program (`bench/paper`) runs every
experiment and writes every number of this page, with the command that made it. Deformations are those
of `holdfast-batch`, run in the project's root; what its report does not tell is computed from the
mesh that it has written. A test (`Paper*`) runs the small half and checks orderings and bounds.

The pictures on this page show meshes of the project; those of fetched models stay in `out/paper/`.
Seconds are those of one machine with two cores: compare their ratios.
)";

std::string row(const std::vector<std::string>& cells)
{
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string table(const Table& made)
{
  std::string text = row(made.columns) + '|';
  for (std::size_t column = 0; column < made.columns.size(); ++column) text += "---|";
  text += '\n';
  for (const auto& cells : made.rows) text += row(cells);
  return text;
}

std::string illustration(const Illustration& shown)
{
  if (shown.isCommitted) return fmt::format("![{}](images/paper/{})\n", shown.caption, shown.file);
  return wrapped(fmt::format("`{}`: {}", shown.file, shown.caption));
}

/// Each section of a page by its title, without the blank lines at its end.
std::map<std::string, std::string> sectionsOf(const std::string& page)
{
  std::map<std::string, std::string> sections;
  std::string title;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kHeading)) title = line.substr(std::string_view(kHeading).size());
    if (!title.empty()) sections[title] += line + '\n';
  }
  for (auto& [name, text] : sections) text.erase(text.find_last_not_of('\n') + 2);
  return sections;
}

}  // namespace

std::string wrapped(const std::string& text)
{
  std::string result;
  std::size_t length = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool isFull = length + 1 + word.size() > kLineLength;
    if (length > 0) result += isFull ? '\n' : ' ';
    length = isFull || length == 0 ? word.size() : length + 1 + word.size();
    result += word;
  }
  return result + '\n';
}

std::string toMarkdown(const Section& section)
{
  std::string text = kHeading + section.title + "\n\n" + wrapped("**The paper:** " + section.paper) + '\n' +
                     wrapped("**Here:** " + section.method);
  if (!section.commands.empty()) text += '\n';
  for (const std::string& command : section.commands) text += "    " + command + '\n';
  for (const Table& made : section.tables) text += '\n' + table(made);
  if (!section.result.empty()) text += '\n' + wrapped(section.result);
  for (const Illustration& shown : section.pictures) text += '\n' + illustration(shown);
  return text;
}

std::string document(const std::vector<std::string>& titles, const std::vector<Section>& made,
                     const std::string& before)
{
  const std::map<std::string, std::string> old = sectionsOf(before);
  std::string page = kIntroduction;
  for (const std::string& title : titles) {
    const auto fresh = std::ranges::find(made, title, &Section::title);
    if (fresh != made.end())
      page += '\n' + toMarkdown(*fresh);
    else if (const auto kept = old.find(title); kept != old.end())
      page += '\n' + kept->second;
  }
  return page;
}

std::vector<std::string> titlesOf(const std::string& page)
{
  std::vector<std::string> titles;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(kHeading)) titles.push_back(line.substr(std::string_view(kHeading).size()));
  return titles;
}

}  // namespace holdfast::paper

// docs/widgets.md against the examples that are run, and against the room that it describes.
#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

std::string fileOfProject(const std::string& path)
{
  return test::bytesOf(test::sourceFolder() + "/" + path);
}

std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  return all;
}

/// What stands between each line that begins a part and the next that ends it, without what the first is indented by.
std::vector<std::string> partsOf(const std::string& text, const std::regex& begins, const std::regex& ends)
{
  std::vector<std::string> parts;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_match(line, begins)) continue;
    const std::size_t indent = line.find_first_not_of(' ');
    parts.emplace_back();
    while (std::getline(lines, line) && !std::regex_match(line, ends))
      parts.back() += line.substr(std::min(indent, line.size())) + '\n';
  }
  return parts;
}

std::vector<std::string> printedIn(const std::string& page)
{
  return partsOf(page, std::regex("```cpp"), std::regex("```"));
}

std::vector<std::string> markedIn(const std::string& source)
{
  const std::regex mark(R"( *// \[.*\])");
  return partsOf(source, mark, mark);
}

/// A class of the room whose header is that of a widget or a style. The axes in the corner are VTK's own widget with
/// small changes, and have no section.
struct WidgetHeader {
  std::string name;
  std::string text;
  std::string source;  // the text that implements it
};

std::vector<WidgetHeader> widgetHeaders()
{
  std::vector<WidgetHeader> headers;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::sourceFolder() + "/widgets/holdfast/widgets/interaction")) {
    if (!std::regex_match(entry.path().filename().string(),
                          std::regex(R"(vtkHoldfast(?!Orientation)\w+(Widget|Style)\.h)")))
      continue;
    const std::string text = test::bytesOf(entry.path());
    std::smatch found;
    if (std::regex_search(text, found, std::regex(R"(\nclass (\w+(?:Widget|Style))\s+: public)")))
      headers.push_back({found[1], text, test::bytesOf(std::filesystem::path(entry.path()).replace_extension(".cpp"))});
  }
  return headers;
}

/// From the title of a widget to the next one; empty without it.
std::string sectionOf(const std::string& name, const std::string& page)
{
  const std::size_t begin = page.find("\n## " + name + "\n");
  return begin == std::string::npos ? std::string() : page.substr(begin, page.find("\n## ", begin + 1) - begin);
}

/// Returns the events in the first column of the tables that say when they come and with what call data.
std::set<std::string> eventsIn(const std::string& text)
{
  const std::regex event(R"(\w+Event)");
  std::set<std::string> names;
  for (const std::string& table : partsOf(text, std::regex(R"(\| event *\| when *\| call data *\|)"), std::regex("")))
    for (const std::string& line : linesOf(table)) {
      const std::string cell = line.substr(0, line.find('|', line.find('|') + 1));
      for (std::sregex_iterator match(cell.begin(), cell.end(), event), end; match != end; ++match)
        names.insert(match->str());
    }
  return names;
}

/// Returns the events that a header lists as those that its widget invokes, from that sentence to the class.
std::set<std::string> eventsListedIn(const std::string& header)
{
  const std::regex event(R"(///     (\w+Event) .*)");
  std::set<std::string> names;
  std::smatch match;
  bool isListed = false;
  for (const std::string& line : linesOf(header)) {
    if (line.starts_with("/// These are the events that it invokes")) isListed = true;
    if (!line.starts_with("///")) isListed = false;
    if (isListed && std::regex_match(line, match, event)) names.insert(match[1]);
  }
  return names;
}

/// Returns the events that a source invokes.
std::set<std::string> eventsOf(const std::string& source)
{
  const std::regex event(R"((?:InvokeEvent|Tell)\((?:vtkCommand::)?(\w+Event)\b)");
  std::set<std::string> names;
  for (std::sregex_iterator match(source.begin(), source.end(), event), end; match != end; ++match)
    names.insert((*match)[1]);
  return names;
}

std::vector<std::string> withoutASection(const std::string& page)
{
  std::vector<std::string> names;
  for (const WidgetHeader& header : widgetHeaders())
    if (sectionOf(header.name, page).empty()) names.push_back(header.name);
  return names;
}

TEST(WidgetsDocument, PrintsTheExamplesThatAreRunWordForWord)
{
  const std::vector<std::string> printed = printedIn(fileOfProject("docs/widgets.md"));
  const std::vector<std::string> marked = markedIn(fileOfProject("examples/widget_pictures.cpp"));
  for (const std::string& part : printed) EXPECT_THAT(marked, Contains(part)) << "no example of the program";
  for (const std::string& part : marked) EXPECT_THAT(printed, Contains(part)) << "an example that is not printed";
  EXPECT_GE(printed.size(), widgetHeaders().size());
}

TEST(WidgetsDocument, HasASectionForEveryWidget)
{
  EXPECT_THAT(widgetHeaders(), SizeIs(testing::Ge(8)));
  EXPECT_THAT(withoutASection(fileOfProject("docs/widgets.md")), IsEmpty());
}

TEST(WidgetsDocument, NamesTheEventsThatWidgetsInvoke)
{
  // VTK's own classes invoke these too.
  const std::set<std::string> ofVtk{"StartInteractionEvent", "InteractionEvent", "EndInteractionEvent",
                                    "PlacePointEvent"};
  const std::string page = fileOfProject("docs/widgets.md");
  for (const auto& [name, text, source] : widgetHeaders()) {
    const std::set<std::string> named = eventsIn(sectionOf(name, page));
    const std::set<std::string> invoked = eventsOf(source);
    EXPECT_THAT(invoked, Not(IsEmpty())) << name;
    for (const std::string& event : invoked) EXPECT_TRUE(named.contains(event)) << name << ": " << event;
    for (const std::string& event : named)
      EXPECT_TRUE(invoked.contains(event) || ofVtk.contains(event)) << name << ": " << event;
    EXPECT_EQ(eventsListedIn(text), named) << name << ": its header and the page";
  }
}

TEST(WidgetsDocument, ShowsAPictureOfEveryWidget)
{
  const std::string page = fileOfProject("docs/widgets.md");
  const std::regex picture(R"(\]\((images/\w+\.png)\))");
  std::vector<std::string> missing;
  std::size_t count = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), picture), end; match != end; ++match, ++count)
    if (!std::filesystem::exists(test::sourceFolder() + "/docs/" + (*match)[1].str())) missing.push_back((*match)[1]);
  EXPECT_THAT(missing, IsEmpty());
  EXPECT_EQ(count, widgetHeaders().size());
}

TEST(WidgetsDocumentMustFail, ForALineThatDiffers)
{
  const std::string source = "void f()\n{\n  // [a]\n  one();\n    two();\n  // [a]\n  three();\n}\n";
  EXPECT_THAT(markedIn(source), ElementsAre("one();\n  two();\n"));
  EXPECT_THAT(printedIn("text\n```cpp\none();\n  two();\n```\nmore\n"), ElementsAre("one();\n  two();\n"));
  EXPECT_THAT(markedIn(source), Not(Contains(printedIn("```cpp\none();\n  two() ;\n```\n").front())));
}

TEST(WidgetsDocumentMustFail, ForAHeaderThatListsOtherEvents)
{
  const std::string bindings = "///     MouseMoveEvent    Move: drags\n///\n";
  const std::string title = "/// These are the events that it invokes, without call data:\n///\n";
  const std::string events =
      "///     PickEvent    a click\n///                  beside InteractionEvent\n///\n/// Text.\n";
  EXPECT_THAT(eventsListedIn(bindings + title + events + "class A {\n///     EndEvent    no\n"),
              ElementsAre("PickEvent"));
  EXPECT_THAT(eventsListedIn(bindings + events), IsEmpty()) << "without the sentence";
}

TEST(WidgetsDocumentMustFail, ForAWidgetWithoutASection)
{
  std::string page = fileOfProject("docs/widgets.md");
  const std::string title = "\n## vtkHoldfastRegionWidget\n";
  ASSERT_NE(page.find(title), std::string::npos);
  page.replace(page.find(title), title.size(), "\n");
  EXPECT_THAT(withoutASection(page), ElementsAre("vtkHoldfastRegionWidget"));
}

}  // namespace
}  // namespace holdfast

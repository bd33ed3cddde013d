#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/session_file.h>

#include "support/source_tree.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::Pair;

const std::string kDocument = test::sourceFolder() + "/docs/formats.md";

/// A fenced block of the document: what stands behind the opening fence, and the text.
struct Block {
  std::string kind;
  std::string text;
};

std::vector<Block> blocksOfDocument()
{
  std::vector<Block> blocks;
  std::ifstream document(kDocument);
  bool isInside = false;
  for (std::string line; std::getline(document, line);) {
    if (line.starts_with("```")) {
      isInside = !isInside;
      if (isInside) blocks.push_back({line.substr(3), ""});
    } else if (isInside) {
      blocks.back().text += line + "\n";
    }
  }
  return blocks;
}

std::vector<std::string> blocksOf(const std::string& kind)
{
  std::vector<std::string> texts;
  for (const Block& block : blocksOfDocument())
    if (block.kind == kind) texts.push_back(block.text);
  return texts;
}

std::map<std::string, int> countsByType(const ConstraintList& list)
{
  std::map<std::string, int> counts;
  for (const Constraint& constraint : list.constraints) ++counts[typeName(constraint)];
  return counts;
}

ConstraintList parsedAlone(const std::string& constraint)
{
  return parseConstraintsJson(
      R"({"format": "holdfast-constraints", "version": 1, "constraints": [)" + constraint + "]}", kDocument);
}

TEST(FormatsDocument, CompleteExampleHasEveryType)
{
  const std::vector<std::string> examples = blocksOf("json");
  ASSERT_EQ(examples.size(), 1U);
  const ConstraintList list = parseConstraintsJson(examples[0], kDocument);
  EXPECT_EQ(list.units, "mm");
  EXPECT_THAT(countsByType(list),
              ElementsAre(Pair("coincident", 1), Pair("fixed", 1), Pair("handle", 1), Pair("mirror", 1),
                          Pair("point", 4), Pair("relative", 1), Pair("rigid", 1), Pair("slide", 1)));
  EXPECT_EQ(list.constraints[5].name, "point 6");
  EXPECT_FALSE(list.constraints[2].isEnabled);
}

TEST(FormatsDocument, PointListHasThePointsThatTheTextNames)
{
  const std::vector<std::string> examples = blocksOf("csv");
  ASSERT_EQ(examples.size(), 1U);
  const ConstraintList list = parsePointListCsv(examples[0], kDocument);
  ASSERT_EQ(list.constraints.size(), 3U);
  EXPECT_EQ(list.constraints[1].name, "bolt 2, left");
  EXPECT_EQ(list.constraints[2].name, "point 3");
}

TEST(FormatsDocument, ExamplesOfConstraintsAreReadAndShowEveryType)
{
  std::map<std::string, int> counts;
  for (const std::string& text : blocksOf("json constraint")) {
    SCOPED_TRACE(text);
    const ConstraintList list = parsedAlone(text);
    ASSERT_EQ(list.constraints.size(), 1U);
    ++counts[typeName(list.constraints[0])];
  }
  EXPECT_EQ(counts.size(), std::variant_size_v<decltype(Constraint::what)>);
}

TEST(FormatsDocument, ExamplesOfHandlesShowEveryMotionAndRotationsOfSingleVertices)
{
  std::set<std::size_t> motions;
  bool hasRotations = false;
  for (const std::string& text : blocksOf("json constraint")) {
    const ConstraintList list = parsedAlone(text);
    const HandleConstraint* handle = std::get_if<HandleConstraint>(&list.constraints.at(0).what);
    if (handle == nullptr) continue;
    motions.insert(handle->motion.index());
    hasRotations = hasRotations || !handle->rotations.empty();
  }
  EXPECT_EQ(motions.size(), std::variant_size_v<decltype(HandleConstraint::motion)>);
  EXPECT_TRUE(hasRotations);
}

TEST(FormatsDocument, ExamplesOfSelectionsAreReadAndShowEveryKind)
{
  std::string all;
  for (const std::string& text : blocksOf("json selection")) {
    EXPECT_NO_THROW(static_cast<void>(parsedAlone(R"({"type": "fixed", "select": )" + text + "}"))) << text;
    all += text;
  }
  for (const char* key : {"vertices", "box", "sphere", "halfspace", "component", "curve", "all", "any", "not"})
    EXPECT_THAT(all, testing::HasSubstr('"' + std::string(key) + '"'));
}

TEST(FormatsDocument, ExamplesOfLocationsAreReadAndShowEveryKind)
{
  const std::vector<std::string> examples = blocksOf("json location");
  for (const std::string& text : examples)
    EXPECT_NO_THROW(static_cast<void>(parsedAlone(R"({"type": "point", "move": [0,0,0], "at": )" + text + "}")))
        << text;
  EXPECT_EQ(examples.size(), std::variant_size_v<SurfaceLocation>);
}

TEST(FormatsDocument, ExampleOfAReportIsJsonOfTheVersionNamed)
{
  const std::vector<std::string> examples = blocksOf("json report");
  ASSERT_EQ(examples.size(), 1U);
  const nlohmann::json report = nlohmann::json::parse(examples[0]);
  EXPECT_EQ(report.at("format"), "holdfast-report");
  EXPECT_EQ(report.at("version"), 1);
}

TEST(FormatsDocument, ExampleOfASessionHasEveryKeyOfTheView)
{
  const std::vector<std::string> examples = blocksOf("json session");
  ASSERT_EQ(examples.size(), 1U);
  const SessionFile session = parseSession(examples[0], kDocument);
  const ViewState& view = session.view;
  EXPECT_TRUE(view.camera && view.colorBy && view.range && view.scale && view.colorMap && view.restShape &&
              view.meshEdges && view.surface && view.showsConstraints && view.showsRotations);
  EXPECT_FALSE(session.mesh.path.empty() || session.mesh.absolutePath.empty() || session.mesh.checksum.empty());
  EXPECT_EQ(parseConstraintsJson(examples[0], kDocument).constraints.size(), 1U);
}

TEST(FormatsDocument, HasNoExampleThatNoTestReads)
{
  const std::vector<std::string> known{"json",          "csv",         "json constraint", "json selection",
                                       "json location", "json report", "json session"};
  for (const Block& block : blocksOfDocument())
    EXPECT_EQ(std::count(known.begin(), known.end(), block.kind), 1) << block.kind << "\n" << block.text;
}

}  // namespace
}  // namespace holdfast

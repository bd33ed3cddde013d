// docs/formats.md describes every key of reports and every field.

#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <holdfast/deform/fields.h>
#include <holdfast/deform/report_json.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

std::string document()
{
  return test::bytesOf(test::sourceFolder() + "/docs/formats.md");
}

/// A sheet with a conflict, a finding and, by the solver soft, a weight: everything that reports may have.
Json reportOf(SolverKind kind)
{
  ConstraintList list = test::listOf(
      {test::hold({0, 1, 2}), test::moveBy(AtVertex{24}, {0, 0, 1}), test::moveBy(AtVertex{24}, {0, 0, 2})});
  const DeformResult result =
      test::deformed(test::grid(4, 4), list, {Weights::Cotangent, {kind, Backend::Holdfast, 5}});
  return Json::parse(reportToJson(result.report));
}

void collectKeys(const Json& value, std::set<std::string>& keys)
{
  if (value.is_object())
    for (const auto& [key, member] : value.items()) {
      keys.insert(key);
      collectKeys(member, keys);
    }
  if (value.is_array())
    for (const Json& entry : value) collectKeys(entry, keys);
}

std::set<std::string> keysOf(const Json& value)
{
  std::set<std::string> keys;
  collectKeys(value, keys);
  return keys;
}

TEST(ReportDocument, DescribesEveryKey)
{
  const std::string text = document();
  for (const SolverKind kind : {SolverKind::Hard, SolverKind::Soft})
    for (const std::string& key : keysOf(reportOf(kind)))
      EXPECT_TRUE(std::regex_search(text, std::regex("[`.]" + key + "`"))) << key;
}

TEST(ReportDocument, ExampleHasTheKeysThatReportsHave)
{
  const std::string text = document();
  const std::size_t begin = text.find("```json report\n") + 15;
  const Json example = Json::parse(text.substr(begin, text.find("```", begin) - begin));
  EXPECT_EQ(keysOf(example), keysOf(reportOf(SolverKind::Hard)));
}

TEST(ReportDocument, DescribesEveryField)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  NoProgress progress;
  const DeformResult result = deform(model, test::listOf({test::hold({0})}), "constraints", {}, progress);
  const std::string text = document();
  for (const Field& field : fieldsOf(model, result))
    EXPECT_THAT(text, HasSubstr("| `" + field.name + "` | " + std::to_string(field.components) + " |"));
}

}  // namespace
}  // namespace holdfast

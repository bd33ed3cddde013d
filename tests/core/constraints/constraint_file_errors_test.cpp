#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

using testing::HasSubstr;

const std::string kConstraintsHead = R"({"format": "holdfast-constraints", "version": 1, "constraints": )";

/// `text` is refused: where, and with which words in the reason.
void expectFileRefused(const std::string& text, const std::string& element, const std::string& words)
{
  SCOPED_TRACE(text.substr(0, 300));
  try {
    static_cast<void>(parseConstraintsJson(text, "c.json"));
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "c.json");
    EXPECT_EQ(error.location().element, element);
    EXPECT_THAT(error.reason(), HasSubstr(words));
  }
}

void expectConstraintRefused(const std::string& constraint, const std::string& key, const std::string& words)
{
  expectFileRefused(kConstraintsHead + "[" + constraint + "]}", "constraints[0]" + key, words);
}

void expectSelectionRefused(const std::string& selection, const std::string& key, const std::string& words)
{
  expectConstraintRefused(R"({"type": "fixed", "select": )" + selection + "}", ".select" + key, words);
}

void expectLocationRefused(const std::string& location, const std::string& key, const std::string& words)
{
  expectConstraintRefused(R"({"type": "point", "target": [0,0,0], "at": )" + location + "}", ".at" + key, words);
}

void expectSyntaxError(const std::string& text, Index line, const std::string& column, const std::string& words)
{
  SCOPED_TRACE(text.substr(0, 300));
  try {
    static_cast<void>(parseConstraintsJson(text, "c.json"));
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().line, line);
    EXPECT_EQ(error.location().element, "column " + column);
    EXPECT_THAT(error.reason(), HasSubstr(words));
    EXPECT_EQ(error.reason().find("json.exception"), std::string::npos);
  }
}

TEST(ConstraintFileErrors, SyntaxIsNamedByLineAndColumn)
{
  expectSyntaxError("{\n  \"format\": 1,\n}", 3, "1", "not valid JSON");
  expectSyntaxError("{\"a\": [1, 2,]}", 1, "13", "no comma before a closing bracket");
  expectSyntaxError("{\n\"a\": NaN}", 2, "6", "no NaN");
  expectSyntaxError("{'a': 1}", 1, "2", "double quotes");
  expectSyntaxError("{\"a\": 1} {}", 1, "10", "not valid JSON");
  expectSyntaxError("{\"a\": 1", 1, "8", "unexpected end");
  expectSyntaxError("// words\n{}", 1, "1", "no comments");
  expectSyntaxError("{\"a\": \"\\ud800\"}", 1, "14", "not valid JSON");
}

TEST(ConstraintFileErrors, LongTokensDoNotFillTheMessage)
{
  try {
    static_cast<void>(parseConstraintsJson("{\"" + std::string(100000, 'a'), "c.json"));
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_LT(error.reason().size(), 500U);
  }
}

TEST(ConstraintFileErrors, NumbersTooLargeForADoubleAreRefused)
{
  expectSyntaxError("{\"a\":\n [1, -1e400]}", 2, "11", "-1e400 is too large");
}

TEST(ConstraintFileErrors, NumbersTooSmallForADoubleAreRefused)
{
  expectFileRefused(R"({"a": [1, 1e-400]})", "a[1]", "1e-400 does not fit");
  expectFileRefused("1e-400", "top level", "1e-400 does not fit");
}

TEST(ConstraintFileErrors, DocumentIsAnObjectOfTheKnownFormatAndVersion)
{
  expectFileRefused("[]", "top level", "an object in braces is expected here, this is a list");
  expectFileRefused("null", "top level", "this is null");
  expectFileRefused("{}", "top level", R"("format" is missing)");
  expectFileRefused(R"({"format": 1})", "format", "text in double quotes is expected here, this is an integer");
  expectFileRefused(R"({"format": "holdfast-report", "version": 1})", "format", R"(says "holdfast-report")");
  expectFileRefused(R"({"format": "holdfast-constraints"})", "top level", R"("version" is missing)");
  expectFileRefused(R"({"format": "holdfast-constraints", "version": 3, "new": 1})", "version",
                    "version 3 is newer than this program, which reads versions 1 to 2");
  expectFileRefused(R"({"format": "holdfast-constraints", "version": 0})", "version", "no version 0");
  expectFileRefused(R"({"format": "holdfast-constraints", "version": 1.5})", "version", "not an integer");
  expectFileRefused(R"({"format": "holdfast-constraints", "version": "1"})", "version", "this is text");
  expectFileRefused(R"({"format": "holdfast-constraints", "version": 1})", "top level", R"("constraints" is missing)");
  expectFileRefused(kConstraintsHead + "{}}", "constraints", "a list is expected");
  expectFileRefused(kConstraintsHead + "[], \"units\": 3}", "units", "text in double quotes");
  expectFileRefused(kConstraintsHead + "[], \"bones\": {}}", "bones", "unknown key");
}

TEST(ConstraintFileErrors, UnknownKeysNameTheKnownOnesAndTheClosest)
{
  expectFileRefused(kConstraintsHead + "[], \"unit\": \"mm\"}", "unit",
                    R"(unknown key "unit"; did you mean "units"? Known here: )");
  expectConstraintRefused(R"({"type": "fixed", "selct": {}})", ".selct",
                          R"(did you mean "select"? Known here: "type", "name", "enabled", "extra", "select")");
  expectConstraintRefused(R"({"type": "fixed", "select": {"component": 0}, "Name": "A"})", ".Name",
                          R"(did you mean "name"?)");
  expectConstraintRefused(
      R"({"type": "handle", "select": {"component": 0}, "rotate": {"axis": [0,0,1], "degrees": 1, "centre": [0,0,0]}})",
      ".rotate.centre", R"(did you mean "center"? Known here: "axis", "degrees", "center")");
  expectConstraintRefused(R"({"type": "fixed", "target": [0,0,0]})", ".target", R"("target"; Known here: "type")");
  expectSelectionRefused(R"({"box": {"min": [0,0,0], "max": [1,1,1], "a \"key\"\n": 1}})", R"(.box["a "key"\x0a"])",
                         "unknown key");
  expectSelectionRefused(R"({"sfere": {}})", ".sfere", R"(did you mean "sphere"?)");
  expectLocationRefused(R"({"vertex": 1, "t": 0.5})", ".t", R"(Known here: "vertex")");
  expectLocationRefused(R"({"near": [0,0,0], "weights": [1,0,0]})", ".weights", R"(Known here: "near")");
  expectConstraintRefused(R"({"type": "pint"})", ".type", R"(unknown type "pint"; did you mean "point"?)");
}

TEST(ConstraintFileErrors, RepeatedKeysAreRefused)
{
  expectFileRefused(R"({"format": "holdfast-constraints", "version": 1, "constraints": [], "constraints": []})",
                    "constraints", "more than once");
  expectConstraintRefused(R"({"type": "point", "at": {"vertex": 1}, "target": [0,0,0], "target": [0,0,1]})", ".target",
                          "more than once");
  expectSelectionRefused(R"({"vertices": [1], "vertices": [2]})", ".vertices", "more than once");
  expectLocationRefused(R"({"edge": [1,2], "t": 0, "t": 1})", ".t", "more than once");
}

TEST(ConstraintFileErrors, MissingKeysAreNamed)
{
  expectConstraintRefused("{}", "", R"("type" is missing)");
  expectConstraintRefused(R"({"type": "fixed"})", "", R"("select" is missing)");
  expectConstraintRefused(R"({"type": "rigid"})", "", R"("select" is missing)");
  expectConstraintRefused(R"({"type": "point", "target": [0,0,0]})", "", R"("at" is missing)");
  expectConstraintRefused(R"({"type": "relative", "from": {"vertex": 1}})", "", R"("to" is missing)");
  expectSelectionRefused(R"({"box": {"min": [0,0,0]}})", ".box", R"("max" is missing)");
  expectSelectionRefused(R"({"sphere": {"center": [0,0,0]}})", ".sphere", R"("radius" is missing)");
  expectSelectionRefused(R"({"halfspace": {"point": [0,0,0]}})", ".halfspace", R"("normal" is missing)");
  expectLocationRefused(R"({"edge": [1,2]})", "", R"("t" is missing)");
  expectLocationRefused(R"({"face": 1})", "", R"("weights" is missing)");
  expectConstraintRefused(R"({"type": "handle", "select": {"component": 0}, "rotate": {"axis": [0,0,1]}})", ".rotate",
                          R"("degrees" is missing)");
}

TEST(ConstraintFileErrors, OneOfSeveralKeysIsNeededAndNoMore)
{
  const std::string point = R"({"type": "point", "at": {"vertex": 1})";
  expectConstraintRefused(point + "}", "", R"(one of these keys is missing: "target", "move")");
  expectConstraintRefused(point + R"(, "target": [0,0,0], "move": [0,0,0]})", "", "exclude one another");
  expectConstraintRefused(R"({"type": "handle", "select": {"component": 0}})", "", R"(needs "rotate", "translate")");
  expectSelectionRefused("{}", "", "one of these keys is missing");
  expectSelectionRefused(R"({"component": 0, "vertices": [1]})", "", R"("vertices", "component" exclude one another)");
  expectLocationRefused("{}", "", "one of these keys is missing");
  expectLocationRefused(R"({"vertex": 0, "near": [0,0,0]})", "", "exclude one another");
}

TEST(ConstraintFileErrors, WrongTypesSayWhatIsExpectedAndWhatIsThere)
{
  expectConstraintRefused("7", "", "an object in braces is expected here, this is an integer");
  expectConstraintRefused(R"({"type": 3})", ".type", "text in double quotes");
  expectConstraintRefused(R"({"type": "fixed", "select": {"component": 0}, "name": 3})", ".name", "text");
  expectConstraintRefused(R"({"type": "fixed", "select": {"component": 0}, "name": ""})", ".name", "empty");
  expectConstraintRefused(R"({"type": "fixed", "select": {"component": 0}, "enabled": 1})", ".enabled",
                          "true or false is expected here, this is an integer");
  expectSelectionRefused(R"("all")", "", "an object in braces is expected here, this is text");
  expectSelectionRefused(R"({"vertices": 3})", ".vertices", "a list is expected here");
  expectSelectionRefused(R"({"not": [{"component": 0}]})", ".not", "this is a list");
  expectSelectionRefused(R"({"sphere": {"center": [0,0,0], "radius": "2"}})", ".sphere.radius", "a number is expected");
  expectSelectionRefused(R"({"box": {"min": [0,null,0], "max": [1,1,1]}})", ".box.min[1]", "this is null");
}

TEST(ConstraintFileErrors, IdsAreIntegersFromZero)
{
  expectSelectionRefused(R"({"vertices": [1, -2]})", ".vertices[1]", "-2 is negative; ids count from 0");
  expectSelectionRefused(R"({"vertices": [1.0]})", ".vertices[0]", "not an integer");
  expectSelectionRefused(R"({"vertices": [1e3]})", ".vertices[0]", "not an integer");
  expectSelectionRefused(R"({"vertices": ["1"]})", ".vertices[0]", "an integer is expected here, this is text");
  expectSelectionRefused(R"({"component": -1})", ".component", "negative");
  expectLocationRefused(R"({"vertex": 9223372036854775808})", ".vertex", "too large");
  expectLocationRefused(R"({"vertex": 99999999999999999999999})", ".vertex", "not an integer of at most 64 bits");
  expectLocationRefused(R"({"face": true, "weights": [1,0,0]})", ".face", "an integer is expected");
  expectLocationRefused(R"({"edge": [1, -1], "t": 0})", ".edge[1]", "negative");
}

TEST(ConstraintFileErrors, ListsHaveTheLengthTheyNeed)
{
  expectSelectionRefused(R"({"vertices": []})", ".vertices", "empty");
  expectSelectionRefused(R"({"all": []})", ".all", "empty");
  expectSelectionRefused(R"({"any": []})", ".any", "empty");
  expectLocationRefused(R"({"near": [1, 2]})", ".near", "a list of 3 is expected, [x, y, z]; this one has 2");
  expectLocationRefused(R"({"near": [1, 2, 3, 4]})", ".near", "this one has 4");
  expectLocationRefused(R"({"edge": [1], "t": 0})", ".edge", "a list of 2 is expected");
  expectLocationRefused(R"({"face": 0, "weights": [0.5, 0.5]})", ".weights", "at least 3 corners");
}

TEST(ConstraintFileErrors, EdgesAndFacesHoldTheirPoint)
{
  expectLocationRefused(R"({"edge": [4, 4], "t": 0})", ".edge", "both ends are vertex 4");
  expectLocationRefused(R"({"edge": [4, 5], "t": 1.5})", ".t", "1.5 is outside [0, 1]");
  expectLocationRefused(R"({"edge": [4, 5], "t": -1e-9})", ".t", "outside [0, 1]");
  expectLocationRefused(R"({"face": 0, "weights": [0.5, -0.25, 0.75]})", ".weights[1]", "-0.25 is negative");
  expectLocationRefused(R"({"face": 0, "weights": [0.5, 0.25, 0.125]})", ".weights",
                        "the weights sum to 0.875, not to 1; divide each by that sum");
  expectLocationRefused(R"({"face": 0, "weights": [0, 0, 0]})", ".weights", "give weights above 0");
  expectLocationRefused(R"({"face": 0, "weights": [1e308, 1e308, 1e308]})", ".weights", "not to 1");
}

TEST(ConstraintFileErrors, ShapesAreNotDegenerate)
{
  expectSelectionRefused(R"({"box": {"min": [0,2,0], "max": [1,1,1]}})", ".box", "min 2 is larger than max 1 in y");
  expectSelectionRefused(R"({"sphere": {"center": [0,0,0], "radius": 0}})", ".sphere.radius", "above 0, this is 0");
  expectSelectionRefused(R"({"sphere": {"center": [0,0,0], "radius": -1}})", ".sphere.radius", "above 0");
  expectSelectionRefused(R"({"halfspace": {"point": [0,0,0], "normal": [0,-0.0,0]}})", ".halfspace.normal",
                         "cannot be zero");
  expectConstraintRefused(
      R"({"type": "handle", "select": {"component": 0}, "rotate": {"axis": [0,0,0], "degrees": 1}})", ".rotate.axis",
      "cannot be zero");
}

TEST(ConstraintFileErrors, CurvesHaveThreePlacesAndTwoSides)
{
  expectSelectionRefused(R"({"curve": {"through": [{"vertex": 1}, {"vertex": 2}]}})", ".curve.through",
                         "at least 3 places, this list has 2");
  expectSelectionRefused(R"({"curve": {"through": []}})", ".curve.through", "this list has 0");
  expectSelectionRefused(R"({"curve": {"side": "larger"}})", ".curve", R"("through" is missing)");
  const std::string three = R"({"curve": {"through": [{"vertex": 1}, {"vertex": 2}, {"edge": [3, 3], "t": 0}])";
  expectSelectionRefused(three + "}}", ".curve.through[2].edge", "both ends are vertex 3");
  const std::string curve = R"({"curve": {"through": [{"vertex": 1}, {"vertex": 2}, {"vertex": 3}], )";
  expectSelectionRefused(curve + R"("side": "small"}})", ".curve.side", R"(unknown side "small"; did you mean)");
  expectSelectionRefused(curve + R"("side": 1}})", ".curve.side", "text in double quotes");
  expectSelectionRefused(curve + R"("inside": true}})", ".curve.inside", R"(Known here: "through", "side")");
}

TEST(ConstraintFileErrors, NamesAreUnique)
{
  const std::string a = R"({"type": "fixed", "name": "A", "select": {"component": 0}})";
  const std::string nameless = R"({"type": "fixed", "select": {"component": 0}})";
  const std::string third = R"({"type": "fixed", "name": "fixed 3", "select": {"component": 0}})";
  expectFileRefused(kConstraintsHead + "[" + a + "," + nameless + "," + a + "]}", "constraints[2].name",
                    R"("A" is the name of constraints[0] already)");
  expectFileRefused(kConstraintsHead + "[" + third + "," + a + "," + nameless + "]}", "constraints[2]",
                    R"(default name "fixed 3" is that of constraints[0]; give it a name)");
}

TEST(ConstraintFileErrors, PathLeadsThroughNestedSelections)
{
  expectSelectionRefused(R"({"all": [{"component": 0}, {"not": {"any": [{"sphere": {"center": [0,0]}}]}}]})",
                         ".all[1].not.any[0].sphere.center", "a list of 3");
}

TEST(ConstraintFileErrors, DeepNestingIsRefusedWhateverItsDepth)
{
  for (const int depth : {101, 200, 400, 1000000}) {
    std::string text = kConstraintsHead + R"([{"type": "fixed", "select": )";
    for (int level = 0; level < depth; ++level) text += R"({"not":)";
    try {
      static_cast<void>(parseConstraintsJson(text, "c.json"));
      FAIL() << "was read";
    } catch (const InputError& error) {
      EXPECT_TRUE(error.location().line > 0 || !error.location().element.empty());
    }
  }
  expectFileRefused(std::string(1000000, '['), "[0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0]...",
                    "nested deeper than");
}

TEST(ConstraintFileErrors, WholeSentenceNamesFilePlaceReasonAndRemedy)
{
  try {
    static_cast<void>(parseConstraintsJson(
        kConstraintsHead + R"([{"type": "point", "at": {"edge": [1, 2], "t": 2}, "target": [0,0,0]}]})",
        "bracket.json"));
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "bracket.json: constraints[0].at.t: 2 is outside [0, 1]; 1 is the first vertex of the edge, 0 the "
                 "second");
  }
}

}  // namespace
}  // namespace holdfast

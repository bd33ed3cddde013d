#include "app/report_schema.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <holdfast/check/mesh_check.h>

namespace holdfast::test {
namespace {

using Json = nlohmann::json;

bool isText(const Json& value)
{
  return value.is_string();
}

bool isCount(const Json& value)
{
  return value.is_number_integer() && value >= 0;
}

bool isLength(const Json& value)
{
  return value.is_number() && value >= 0;
}

bool isNull(const Json& value)
{
  return value.is_null();
}

bool isFlagOrNull(const Json& value)
{
  return value.is_null() || value.is_boolean();
}

bool isLengthOrNull(const Json& value)
{
  return value.is_null() || isLength(value);
}

bool isListOf(const Json& value, bool (*isPart)(const Json&))
{
  return value.is_array() && std::all_of(value.begin(), value.end(), isPart);
}

bool isIds(const Json& value)
{
  return isListOf(value, isCount);
}

bool isNames(const Json& value)
{
  return isListOf(value, isText);
}

using Predicate = std::function<bool(const Json&)>;

Predicate isOneOf(const std::set<std::string>& values)
{
  return [values](const Json& value) { return value.is_string() && values.contains(value.get<std::string>()); };
}

struct Key {
  const char* name;
  Predicate holds;
};

/// Collects what is wrong, by JSON path.
class Complaints {
 public:
  void check(const Json& object, const std::string& path, const std::vector<Key>& keys)
  {
    for (const Key& key : keys)
      if (!object.is_object() || !object.contains(key.name))
        text_ += path + "." + key.name + " is missing\n";
      else if (!key.holds(object[key.name]))
        text_ += path + "." + key.name + " must not be " + object[key.name].dump() + "\n";
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

bool isObject(const Json& value)
{
  return value.is_object();
}

bool isArray(const Json& value)
{
  return value.is_array();
}

void checkMesh(Complaints& complaints, const Json& mesh)
{
  complaints.check(mesh, "mesh",
                   {{"vertices", isCount},
                    {"faces", isCount},
                    {"components", isCount},
                    {"bbox_diagonal", isLength},
                    {"findings", isArray}});
  for (const Json& finding : mesh.value("findings", Json::array()))
    complaints.check(finding, "mesh.findings[]",
                     {{"kind", isText},
                      {"count", isCount},
                      {"ids_of", isOneOf({"vertex", "face", "constraint", "file", "solution"})},
                      {"ids", isIds},
                      {"message", isText}});
}

bool isVector(const Json& value)
{
  return value.is_array() && value.size() == 3 && isListOf(value, [](const Json& part) { return part.is_number(); });
}

bool isBoolean(const Json& value)
{
  return value.is_boolean();
}

void checkConflictSet(Complaints& complaints, const Json& conflictSet)
{
  const std::string path = "constraints[].clashes[]";
  complaints.check(
      conflictSet, path,
      {{"with", isNames}, {"rows", isCount}, {"conflict", isBoolean}, {"gap", isVector}, {"length", isLength}});
  if (!conflictSet.value("conflict", false)) return;
  complaints.check(conflictSet, path, {{"repair", isObject}});
  complaints.check(conflictSet.value("repair", Json::object()), path + ".repair", {{"disable", isText}});
  if (conflictSet.value("repair", Json::object()).contains("consistent_target"))
    complaints.check(conflictSet["repair"], path + ".repair", {{"consistent_target", isVector}});
  if (conflictSet.value("repair", Json::object()).contains("found_rotations"))
    complaints.check(conflictSet["repair"], path + ".repair", {{"found_rotations", isBoolean}});
}

void checkConstraint(Complaints& complaints, const Json& constraint, SolveState state)
{
  const bool isSolved = state == SolveState::Solved;
  const std::set<std::string> statuses =
      isSolved ? std::set<std::string>{"met", "redundant", "conflicting", "missed", "disabled"}
               : std::set<std::string>{"independent", "redundant", "conflicting", "disabled"};
  complaints.check(
      constraint, "constraints[]",
      {{"name", isText},
       {"type", isOneOf({"fixed", "handle", "point", "rigid", "relative", "slide", "coincident", "mirror"})},
       {"rows", isCount},
       {"status", isOneOf(statuses)},
       {"residual", isSolved ? Predicate(isLengthOrNull) : Predicate(isNull)},
       {"limit", constraint.value("rows", 0) > 0 ? Predicate(isLength) : Predicate(isNull)},
       {"depends_on", isNames},
       {"gap", isLengthOrNull},
       {"clashes", isArray},
       {"clash_count", isCount},
       {"amplification", isLengthOrNull},
       {"force", isSolved ? Predicate(isLengthOrNull) : Predicate(isNull)},
       {"off_target", isSolved ? Predicate(isLengthOrNull) : Predicate(isNull)},
       {"at_bound", isSolved ? Predicate(isFlagOrNull) : Predicate(isNull)}});
  for (const Json& conflictSet : constraint.value("clashes", Json::array())) checkConflictSet(complaints, conflictSet);
}

void checkSolve(Complaints& complaints, const Json& solve, SolveState state)
{
  const bool isSolved = state == SolveState::Solved;
  const Predicate isMeasured = isSolved ? Predicate(isLength) : Predicate(isNull);
  const std::set<std::string> statuses = isSolved                      ? std::set<std::string>{"ok", "conflicts"}
                                         : state == SolveState::Failed ? std::set<std::string>{"failed"}
                                                                       : std::set<std::string>{"not run"};
  const bool isFound = isSolved && solve.value("rotations", "") != "given";
  complaints.check(solve, "solve",
                   {{"status", isOneOf(statuses)},
                    {"message", isText},
                    {"max_residual", isMeasured},
                    {"max_residual_relative", isMeasured},
                    {"weights", isOneOf({"cotangent", "cotangent-paper", "uniform"})},
                    {"solver", isOneOf({"hard", "soft", "lagrange"})},
                    {"backend", isOneOf({"holdfast", "cholmod", "eigen"})},
                    {"method", isText},
                    {"unknowns", isCount},
                    {"factor_nonzeros", isCount},
                    {"refinement_steps", isCount},
                    {"accuracy", isMeasured},
                    {"rotation_accuracy", isLengthOrNull},
                    {"rotation_disagreement_degrees", isLengthOrNull},
                    {"rotations", isOneOf({"given", "found", "found-smooth"})},
                    {"rotation_iterations", isFound ? Predicate(isCount) : Predicate(isNull)},
                    {"rotation_change", isFound ? Predicate(isLength) : Predicate(isNull)},
                    {"rotation_stop", isFound ? isOneOf({"converged", "iteration_limit"}) : Predicate(isNull)},
                    {"seconds", isObject}});
  complaints.check(solve.value("seconds", Json::object()), "solve.seconds",
                   {{"setup", isLength}, {"decomposition", isLength}, {"solution", isLength}});
}

bool isNumber(const Json& value)
{
  return value.is_number();
}

void checkRatios(Complaints& complaints, const Json& ratios, const std::string& path)
{
  complaints.check(ratios, path, {{"least", isNumber}, {"most", isNumber}, {"shrunk", isCount}, {"grown", isCount}});
}

void checkResult(Complaints& complaints, const Json& result, SolveState state)
{
  const bool isSolved = state == SolveState::Solved;
  complaints.check(result, "result",
                   {{"status", isOneOf(isSolved ? std::set<std::string>{"fine", "doubtful"}
                                                : std::set<std::string>{"not measured"})},
                    {"warnings", isNames},
                    {"target_motions", isArray}});
  for (const Json& motion : result.value("target_motions", Json::array()))
    complaints.check(motion, "result.target_motions[]",
                     {{"degrees", isLength},
                      {"axis", isVector},
                      {"scale", isNumber},
                      {"shift", isVector},
                      {"moved", isLength},
                      {"left", isLength}});
  if (!isSolved) return;
  complaints.check(
      result, "result",
      {{"folds", isObject}, {"inverted_faces", isCount}, {"crossing_faces", isCount}, {"overshoot", isObject}});
  complaints.check(result.value("folds", Json::object()), "result.folds",
                   {{"faces", isCount}, {"largest_degrees", isLength}});
  complaints.check(result.value("overshoot", Json::object()), "result.overshoot",
                   {{"vertices", isCount}, {"largest", isLength}, {"asked", isLength}});
  for (const char* key : {"edges", "areas", "volumes"})
    checkRatios(complaints, result.value(key, Json::object()), std::string("result.") + key);
}

}  // namespace

testing::AssertionResult isReport(const nlohmann::json& report, SolveState state)
{
  Complaints complaints;
  complaints.check(report, "",
                   {{"format", isOneOf({"holdfast-report"})},
                    {"version", [](const Json& version) { return version == 1; }},
                    {"mesh", isObject},
                    {"constraints", isArray},
                    {"skipped_rows", isArray},
                    {"solve", isObject},
                    {"result", isObject}});
  checkMesh(complaints, report.value("mesh", Json::object()));
  for (const Json& row : report.value("skipped_rows", Json::array()))
    complaints.check(row, "skipped_rows[]", {{"line", isCount}, {"name", isText}, {"fault", isText}});
  for (const Json& constraint : report.value("constraints", Json::array()))
    checkConstraint(complaints, constraint, state);
  checkSolve(complaints, report.value("solve", Json::object()), state);
  checkResult(complaints, report.value("result", Json::object()), state);
  if (complaints.text().empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << complaints.text();
}

}  // namespace holdfast::test

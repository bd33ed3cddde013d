#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <holdfast/deform/outcomes.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

constexpr Index kSquares = 200;
constexpr int kInnocent = 10000;
const Vector3 kShift(0.3, -0.2, 0.7);

/// Named constraints of which each planted set is a circuit: no smaller set of them depends.
struct Planted {
  std::vector<std::set<std::string>> circuits;
  std::vector<Constraint> constraints;
  double scale = 1;

  [[nodiscard]] Vector3 shift() const { return scale * kShift; }

  /// Adds a circuit, and takes one member of it off what the others agree on.
  void plant(std::vector<Constraint> members, std::size_t liar)
  {
    std::set<std::string> names;
    for (std::size_t k = 0; k < members.size(); ++k) {
      members[k].name = "circuit " + std::to_string(circuits.size()) + " member " + std::to_string(k);
      if (k == liar) lie(members[k]);
      names.insert(members[k].name);
    }
    circuits.push_back(std::move(names));
    std::move(members.begin(), members.end(), std::back_inserter(constraints));
  }

  void lie(Constraint& member) const
  {
    const Vector3 error = 1e-3 * scale * Vector3(1, 1, 1);
    if (PointConstraint* point = std::get_if<PointConstraint>(&member.what)) std::get<Move>(point->to).shift += error;
    if (HandleConstraint* handle = std::get_if<HandleConstraint>(&member.what)) handle->translate += error;
    if (RelativeConstraint* relative = std::get_if<RelativeConstraint>(&member.what))
      relative->offset = *relative->offset + error;
  }
};

Index vertexAt(Index i, Index j)
{
  return j * (kSquares + 1) + i;
}

/// Two pins and the edges between them; a pin said twice where there is no edge.
std::vector<Constraint> chain(int size, Index j, test::Random& random, const Vector3& shift)
{
  if (size == 2) return {test::moveBy(AtVertex{vertexAt(0, j)}, shift), test::moveBy(AtVertex{vertexAt(0, j)}, shift)};
  std::vector<Constraint> members{test::moveBy(AtVertex{vertexAt(0, j)}, shift),
                                  test::moveBy(AtVertex{vertexAt(size - 2, j)}, shift)};
  for (Index i = 0; i < size - 2; ++i)
    members.push_back(test::moveBy(AtEdge{vertexAt(i, j), vertexAt(i + 1, j), random.uniform(0.3, 0.7)}, shift));
  return members;
}

/// Offsets round a ring of vertices.
std::vector<Constraint> loop(int size, Index j, const Mesh& mesh)
{
  std::vector<Constraint> members;
  for (Index i = 0; i < size; ++i) {
    const Index from = vertexAt(i, j);
    const Index to = vertexAt((i + 1) % size, j);
    members.push_back(
        {"", true,
         RelativeConstraint{AtVertex{from}, AtVertex{to}, Vector3(mesh.positions.row(from) - mesh.positions.row(to))}});
  }
  return members;
}

void plantMixed(Planted& planted, Index j)
{
  const Vector3 shift = planted.shift();
  planted.plant({test::handle({vertexAt(0, j), vertexAt(2, j)}, {}, shift),
                 test::handle({vertexAt(2, j), vertexAt(4, j)}, {}, shift)},
                1);
  planted.plant({test::rigid({vertexAt(0, j + 3), vertexAt(1, j + 3), vertexAt(2, j + 3), vertexAt(3, j + 3)}),
                 test::moveBy(AtVertex{vertexAt(1, j + 3)}, shift), test::moveBy(AtVertex{vertexAt(3, j + 3)}, shift)},
                1);
  planted.plant(
      {test::rigid({vertexAt(10, j + 3), vertexAt(11, j + 3)}), test::handle({vertexAt(10, j + 3)}, {}, shift),
       test::moveBy(AtEdge{vertexAt(11, j + 3), vertexAt(12, j + 3), 0.4}, shift),
       test::moveBy(AtVertex{vertexAt(12, j + 3)}, shift)},
      2);
  const Index face = 2 * ((j + 6) * kSquares + 5);
  planted.plant(
      {test::moveBy(AtFace{face, {0.2, 0.3, 0.5}}, shift), test::moveBy(AtFace{face, {0.5, 0.3, 0.2}}, shift),
       test::moveBy(AtFace{face, {0.3, 0.5, 0.2}}, shift), test::moveBy(AtFace{face, {0.25, 0.35, 0.4}}, shift)},
      3);
}

/// Independent ones: each hangs on a vertex that none before it hangs on.
void addInnocent(Planted& planted, const Mesh& mesh, test::Random& random)
{
  for (int k = 0; k < kInnocent; ++k) {
    const Index i = 2 * (k % (kSquares / 2));
    const Index j = 80 + k / (kSquares / 2);
    const Vector3 shift = planted.scale * test::randomVector(random, 1);
    const double t = random.uniform(0.3, 0.6);
    SurfaceLocation at = AtVertex{vertexAt(i + 1, j)};
    if (k % 3 == 1) at = AtEdge{vertexAt(i, j), vertexAt(i + 1, j), t};
    for (Index face = 2 * (j * kSquares + i); k % 3 == 2 && face < 2 * (j * kSquares + i) + 2; ++face)
      if (std::count(mesh.faces[face].begin(), mesh.faces[face].end(), vertexAt(i + 1, j)) > 0)
        at = AtFace{face, {t, 0.35, 0.65 - t}};
    planted.constraints.push_back(test::moveBy(at, shift));
    planted.constraints.back().name = "innocent " + std::to_string(k);
  }
}

Planted planted(const Mesh& mesh, double scale, std::uint32_t seed)
{
  test::Random random(seed);
  Planted result;
  result.scale = scale;
  for (int size = 2; size <= 12; ++size) {
    result.plant(chain(size, 3 * size, random, result.shift()), random.integer(0, size - 1));
    result.plant(loop(size, 3 * size + 40, mesh), random.integer(0, size - 1));
  }
  plantMixed(result, 0);
  addInnocent(result, mesh, random);
  for (std::size_t k = result.constraints.size() - 1; k > 0; --k)
    std::swap(result.constraints[k], result.constraints[random.integer(0, static_cast<Index>(k))]);
  return result;
}

/// The last member of each circuit conflicts with all other members and with nothing else; nothing else conflicts.
void expectExactlyThePlanted(const Planted& planted, const Report& report)
{
  std::map<std::string, std::set<std::string>> clashing;
  for (const ConstraintOutcome& outcome : report.constraints) {
    if (outcome.status != ConstraintStatus::Conflicting) {
      EXPECT_EQ(outcome.status, ConstraintStatus::Independent) << outcome.name;
      continue;
    }
    ASSERT_EQ(outcome.conflictSets.size(), 1U) << outcome.name;
    const ConflictSet& conflictSet = outcome.conflictSets.front();
    clashing[outcome.name] = {conflictSet.with.begin(), conflictSet.with.end()};
    EXPECT_EQ(conflictSet.with, outcome.dependsOn);
    EXPECT_GT(conflictSet.gap.norm(), 0);
  }
  EXPECT_EQ(clashing.size(), planted.circuits.size());
  for (const std::set<std::string>& circuit : planted.circuits) {
    const auto last = std::find_if(planted.constraints.rbegin(), planted.constraints.rend(),
                                   [&](const Constraint& constraint) { return circuit.contains(constraint.name); });
    std::set<std::string> others = circuit;
    others.erase(last->name);
    EXPECT_EQ(clashing[last->name], others) << last->name;
  }
}

TEST(PlantedCircuits, AreNamedExactlyAmongTenThousandOthersInAnyOrderAndAtAnyScale)
{
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const Mesh mesh =
        test::transformed(test::grid(kSquares, kSquares), Eigen::Affine3d(Eigen::Scaling(scale, scale, scale)));
    const Model model = makeModel(mesh, "mesh");
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(testing::Message() << "scale " << scale << ", seed " << seed);
      const Planted problem = planted(mesh, scale, seed);
      expectExactlyThePlanted(problem, diagnoseConstraints(model, {"", problem.constraints}, "list"));
    }
  }
}

TEST(PlantedCircuits, EndWhereTheProposedRepairIsFollowed)
{
  const Mesh mesh = test::grid(kSquares, kSquares);
  const Model model = makeModel(mesh, "mesh");
  ConstraintList disabled{"", planted(mesh, 1, 7).constraints};
  ConstraintList retargeted = disabled;
  const Report report = diagnoseConstraints(model, disabled, "list");
  std::set<std::string> toDisable;
  for (std::size_t c = 0; c < report.constraints.size(); ++c)
    for (const ConflictSet& conflictSet : report.constraints[c].conflictSets) {
      toDisable.insert(conflictSet.disable);
      Constraint& constraint = retargeted.constraints[c];
      if (!conflictSet.consistentTarget)
        constraint.isEnabled = false;
      else if (PointConstraint* point = std::get_if<PointConstraint>(&constraint.what))
        point->to = Target{*conflictSet.consistentTarget};
      else
        std::get<RelativeConstraint>(constraint.what).offset = conflictSet.consistentTarget;
    }
  for (Constraint& constraint : disabled.constraints)
    if (toDisable.contains(constraint.name)) constraint.isEnabled = false;
  for (const ConstraintList& list : {disabled, retargeted})
    for (const ConstraintOutcome& outcome : diagnoseConstraints(model, list, "list").constraints)
      EXPECT_NE(outcome.status, ConstraintStatus::Conflicting) << outcome.name;
}

/// What each conflict names may bring others forward: points at random, a third of them off.
ConstraintList arguingPoints(const Mesh& mesh, std::uint32_t seed)
{
  test::Random random(seed);
  std::vector<Constraint> constraints;
  for (int k = 0; k < 120; ++k) {
    const double a = random.uniform(0.1, 0.8);
    const double b = random.uniform(0.1, 0.9 - a);
    const Vector3 error = k % 3 == 0 ? test::randomVector(random, 0.1) : Vector3(0, 0, 0);
    constraints.push_back(
        test::moveBy(AtFace{random.integer(0, mesh.faces.size() - 1), {a, b, 1 - a - b}}, kShift + error));
  }
  return test::listOf(std::move(constraints));
}

TEST(PlantedCircuits, EndAtATimeWhereAllThatConflictAreDisabled)
{
  const Mesh mesh = test::plate(8, 8);
  const Model model = makeModel(mesh, "mesh");
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    ConstraintList list = arguingPoints(mesh, seed);
    const Report report = diagnoseConstraints(model, list, "list");
    ASSERT_GT(countOf(report, ConstraintStatus::Conflicting), 1);
    for (std::size_t c = 0; c < list.constraints.size(); ++c)
      if (report.constraints[c].status == ConstraintStatus::Conflicting) list.constraints[c].isEnabled = false;
    EXPECT_EQ(countOf(diagnoseConstraints(model, list, "list"), ConstraintStatus::Conflicting), 0);
  }
}

}  // namespace
}  // namespace holdfast

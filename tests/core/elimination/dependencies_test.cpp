#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>

#include <gtest/gtest.h>

#include <holdfast/elimination/diagnosis.h>
#include <holdfast/elimination/find_dependencies.h>
#include <holdfast/elimination/large_component.h>

#include "support/circuits.h"
#include "support/dense_operators.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

/// The sum of magnitudes of a row and what it is made of: how much larger than the numbers themselves the rounding of
/// sums of them is.
double sizeOf(const Dependency& dependency)
{
  double size = 1;
  for (const Term& term : dependency.terms) size += std::abs(term.coefficient);
  return size;
}

/// A handful of points that depend on one another exactly.
struct DependentPoints {
  std::string name;
  Mesh mesh;
  std::vector<SurfaceLocation> places;
};

void PrintTo(const DependentPoints& points, std::ostream* out)
{
  *out << points.name;
}

std::vector<DependentPoints> dependentPoints()
{
  const Mesh square = test::grid(1, 1);  // faces (0, 1, 3) and (0, 3, 2)
  const Mesh tetrahedron = test::tetrahedron();
  const std::vector<double> thirds{0.25, 0.25, 0.5};
  std::vector<DependentPoints> result{
      {"RepeatedPoints",
       square,
       {AtVertex{0}, AtEdge{0, 1, 0.5}, AtVertex{0}, AtEdge{1, 0, 0.5}, AtFace{0, thirds}, AtFace{0, thirds}}},
      {"VertexEdgeVertex", square, {AtVertex{0}, AtEdge{0, 1, 0.25}, AtVertex{1}, AtEdge{1, 3, 0.5}, AtVertex{3}}},
      {"FivePointsOfOneFace",
       square,
       {AtFace{0, {0.5, 0.25, 0.25}}, AtFace{0, {0.25, 0.5, 0.25}}, AtFace{0, {0.25, 0.25, 0.5}},
        AtFace{0, {0.125, 0.375, 0.5}}, AtFace{0, {0.625, 0.25, 0.125}}}},
      {"EdgesAroundAFace",
       square,
       {AtEdge{0, 1, 0.5}, AtEdge{1, 3, 0.5}, AtEdge{3, 0, 0.5}, AtFace{0, {0.375, 0.375, 0.25}}, AtVertex{1}}},
      {"ThreePointsOfOneEdge",
       square,
       {AtEdge{0, 1, 0.25}, AtEdge{0, 1, 0.5}, AtEdge{0, 1, 0.75}, AtVertex{1}, AtVertex{0}}},
      {"AcrossTwoFaces",
       square,
       {AtFace{0, thirds}, AtFace{1, thirds}, AtEdge{0, 3, 0.5}, AtVertex{1}, AtVertex{2}, AtVertex{3}}},
      {"Apart",
       test::grid(3, 3),
       {AtVertex{0}, AtEdge{14, 15, 0.5}, AtVertex{15}, AtVertex{0}, AtVertex{14}, AtVertex{5}}},
      {"AllEdgesOfATetrahedron",
       tetrahedron,
       {AtEdge{0, 1, 0.5}, AtEdge{0, 2, 0.5}, AtEdge{0, 3, 0.5}, AtEdge{1, 2, 0.5}, AtEdge{1, 3, 0.5},
        AtEdge{2, 3, 0.5}}},
  };
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    test::Random random(seed);
    DependentPoints drawn{"Random" + std::to_string(seed), seed % 2 == 0 ? square : tetrahedron, {}};
    for (long k = random.integer(5, 7); k > 0; --k) drawn.places.push_back(test::randomPlace(random, drawn.mesh));
    result.push_back(std::move(drawn));
  }
  return result;
}

ConstraintList listInOrder(const std::vector<SurfaceLocation>& places, const std::vector<Index>& order)
{
  std::vector<Constraint> constraints;
  for (const Index k : order) constraints.push_back(test::moveBy(places[k], Vector3::Zero()));
  return test::listOf(std::move(constraints));
}

std::vector<RowTerms> rowsOf(const ConstraintSystem& system)
{
  std::vector<RowTerms> rows;
  for (const ConstraintRow& row : system.rows) rows.push_back(row.terms);
  return rows;
}

void expectSame(const std::vector<Dependency>& found, const std::vector<Dependency>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].row, expected[k].row);
    const double size = sizeOf(expected[k]);
    ASSERT_EQ(found[k].terms.size(), expected[k].terms.size()) << "of row " << found[k].row;
    for (std::size_t p = 0; p < found[k].terms.size(); ++p) {
      EXPECT_EQ(found[k].terms[p].index, expected[k].terms[p].index);
      EXPECT_NEAR(found[k].terms[p].coefficient, expected[k].terms[p].coefficient, 1e-12 * size);
    }
  }
}

using OfComponent = std::vector<Dependency> (*)(const std::vector<RowTerms>&, const RowComponent&, double);

std::vector<Dependency> bySolverOfComponents(OfComponent method, const std::vector<RowTerms>& rows, Index unknowns)
{
  std::vector<Dependency> all;
  for (const RowComponent& component : connectedRows(rows, unknowns))
    for (Dependency& dependency : method(rows, component, kRankTolerance)) all.push_back(std::move(dependency));
  std::sort(all.begin(), all.end(), [](const Dependency& a, const Dependency& b) { return a.row < b.row; });
  return all;
}

class Dependencies : public testing::TestWithParam<DependentPoints> {
 protected:
  Triangulation triangulation_ = triangulate(GetParam().mesh);
  SolverMesh solverMesh_ = makeSolverMesh(GetParam().mesh, triangulation_);
  std::vector<Index> first_ = firstOrder();

  static std::vector<Index> firstOrder()
  {
    std::vector<Index> order(GetParam().places.size());
    std::iota(order.begin(), order.end(), Index{0});
    return order;
  }

  [[nodiscard]] test::Circuits circuits() const
  {
    return test::Circuits(test::denseRows(listInOrder(GetParam().places, first_), GetParam().mesh).B);
  }

  [[nodiscard]] ConstraintSystem system(const std::vector<Index>& order) const
  {
    return makeConstraintSystem(listInOrder(GetParam().places, order), GetParam().mesh, solverMesh_,
                                SurfaceLocator(GetParam().mesh, triangulation_), "list");
  }

  /// Calls `check(order)` for the list in every order.
  template <class Check>
  void inEveryOrder(Check&& check) const
  {
    std::vector<Index> order = first_;
    do {
      SCOPED_TRACE(testing::PrintToString(order));
      check(order);
    } while (std::next_permutation(order.begin(), order.end()) && !HasFailure());
  }
};

TEST_P(Dependencies, AreThoseOfTheDefinitionInEveryOrder)
{
  const test::Circuits circuits = this->circuits();
  const Index n = solverMesh_.unknownCount();
  inEveryOrder([&](const std::vector<Index>& order) {
    const std::vector<RowTerms> rows = rowsOf(system(order));
    const std::vector<Dependency> expected = circuits.dependenciesInOrder(order);
    expectSame(findDependencies(rows, n), expected);
    expectSame(bySolverOfComponents(sequentialDependencies, rows, n), expected);
    expectSame(bySolverOfComponents(sparseDependencies, rows, n), expected);
  });
}

/// Shifts of random displacements, about `shareOfWrong` of the rows off by another vector each.
Eigen::MatrixX3d shiftsOff(test::Random& random, const Eigen::MatrixXd& B, double shareOfWrong)
{
  Eigen::MatrixX3d u(B.cols(), 3);
  for (Index v = 0; v < u.rows(); ++v) u.row(v) = test::randomVector(random, 1);
  Eigen::MatrixX3d shifts = B * u;
  for (Index r = 0; r < shifts.rows(); ++r)
    if (random.uniform(0, 1) < shareOfWrong) shifts.row(r) += test::randomVector(random, 0.1);
  return shifts;
}

TEST_P(Dependencies, AreJudgedByTheirGapsInEveryOrder)
{
  test::Random random(11);
  const Eigen::MatrixXd B = test::denseRows(listInOrder(GetParam().places, first_), GetParam().mesh).B;
  const test::Circuits circuits = this->circuits();
  const Eigen::MatrixX3d shifts = shiftsOff(random, B, 0.3);
  inEveryOrder([&](const std::vector<Index>& order) {
    ConstraintSystem system = this->system(order);
    for (std::size_t r = 0; r < order.size(); ++r) {
      system.rows[r].shift = shifts.row(order[r]);
      system.rows[r].target += system.rows[r].shift;
    }
    const EliminatedConstraints eliminated = eliminate(system, solverMesh_);
    const Diagnosis diagnosis = diagnose(eliminated, system, solverMesh_);
    const std::vector<Dependency> expected = circuits.dependenciesInOrder(order);
    ASSERT_EQ(diagnosis.dependent.size(), expected.size());
    std::vector<RowStatus> status(order.size(), RowStatus::Independent);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      Vector3 gap = shifts.row(order[expected[k].row]);
      for (const Term& term : expected[k].terms) gap -= term.coefficient * shifts.row(order[term.index]).transpose();
      status[expected[k].row] = gap.norm() > 1e-6 ? RowStatus::Conflicting : RowStatus::Redundant;
      EXPECT_LT((diagnosis.dependent[k].gap - gap).norm(), 1e-14 * sizeOf(expected[k]));
    }
    EXPECT_EQ(diagnosis.status, status);
    EXPECT_EQ(diagnosis.hasConflicts(), std::count(status.begin(), status.end(), RowStatus::Conflicting) > 0);
  });
}

TEST_P(Dependencies, LeaveIndependentRowsThatSpanTheSame)
{
  const std::vector<RowTerms> rows = rowsOf(system(first_));
  const std::vector<Dependency> dependencies = findDependencies(rows, solverMesh_.unknownCount());
  const std::vector<Index> independent = independentRows(dependencies, rows.size());
  EXPECT_EQ(independent.size() + dependencies.size(), rows.size());
  for (const Dependency& dependency : dependencies)
    for (const Term& term : dependency.terms)
      EXPECT_TRUE(std::binary_search(independent.begin(), independent.end(), term.index));
}

INSTANTIATE_TEST_SUITE_P(Cases, Dependencies, testing::ValuesIn(dependentPoints()),
                         [](const testing::TestParamInfo<DependentPoints>& what) { return what.param.name; });

TEST(FindDependencies, OfNothingIsNothing)
{
  EXPECT_TRUE(findDependencies({}, 5).empty());
  EXPECT_TRUE(independentRows({}, 0).empty());
}

TEST(FindDependencies, DoesNotTakeNearPointsForOne)
{
  // A billionth of an edge apart: two rows, not a repetition.
  const std::vector<RowTerms> rows{{{0, 0.5}, {1, 0.5}}, {{0, 0.5 + 1e-9}, {1, 0.5 - 1e-9}}};
  EXPECT_TRUE(findDependencies(rows, 2).empty());
}

}  // namespace
}  // namespace holdfast

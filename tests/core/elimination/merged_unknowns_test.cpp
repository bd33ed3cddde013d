#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <holdfast/elimination/elimination.h>
#include <holdfast/elimination/find_dependencies.h>

#include "support/circuits.h"
#include "support/dense_svd.h"
#include "support/random.h"

namespace holdfast {
namespace {

RowTerms differenceTerms(Index from, Index to)
{
  return from < to ? RowTerms{{from, -1}, {to, 1}} : RowTerms{{to, 1}, {from, -1}};
}

Eigen::MatrixXd denseOf(const std::vector<RowTerms>& rows, Index unknownCount)
{
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(static_cast<Index>(rows.size()), unknownCount);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const Term& term : rows[r]) B(static_cast<Index>(r), term.index) = term.coefficient;
  return B;
}

/// Pins, differences, points between two and three unknowns and differences of such points, over few unknowns, in any
/// order: with shares of eighths, dependent ones depend exactly.
std::vector<RowTerms> randomRows(test::Random& random, int count, Index unknownCount)
{
  std::vector<RowTerms> rows;
  while (static_cast<int>(rows.size()) < count) {
    std::vector<Index> u(static_cast<std::size_t>(unknownCount));
    std::iota(u.begin(), u.end(), Index{0});
    for (std::size_t k = u.size() - 1; k > 0; --k) std::swap(u[k], u[random.integer(0, static_cast<Index>(k))]);
    const double t = static_cast<double>(random.integer(1, 7)) / 8;
    switch (random.integer(0, 5)) {
      case 0:
        rows.push_back({{u[0], 1}});
        break;
      case 1:
        rows.push_back({{u[0], t}, {u[1], 1 - t}});
        break;
      case 2:
        rows.push_back({{u[0], t / 2}, {u[1], t / 2}, {u[2], 1 - t}});
        break;
      case 3:
        rows.push_back({{u[0], t}, {u[1], 1 - t}, {u[2], -1}});
        break;
      default:
        rows.push_back(differenceTerms(u[0], u[1]));
    }
    std::sort(rows.back().begin(), rows.back().end(), [](const Term& x, const Term& y) { return x.index < y.index; });
  }
  return rows;
}

TEST(Bodies, CircuitsThroughThemAreThoseOfAllSubsets)
{
  constexpr Index kUnknowns = 6;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const std::vector<RowTerms> rows = randomRows(random, 8, kUnknowns);
    std::vector<Index> order(rows.size());
    std::iota(order.begin(), order.end(), Index{0});
    const std::vector<Dependency> expected = test::Circuits(denseOf(rows, kUnknowns)).dependenciesInOrder(order);
    const std::vector<Dependency> found = findDependencies(rows, kUnknowns);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].row, expected[k].row);
      ASSERT_EQ(found[k].terms.size(), expected[k].terms.size());
      for (std::size_t p = 0; p < found[k].terms.size(); ++p) {
        EXPECT_EQ(found[k].terms[p].index, expected[k].terms[p].index);
        EXPECT_NEAR(found[k].terms[p].coefficient, expected[k].terms[p].coefficient, 1e-12);
      }
    }
  }
}

/// Random rows, eliminated.
struct EliminatedRows {
  std::vector<RowTerms> rows;
  std::vector<Index> independent;
  Elimination elimination;
  Eigen::MatrixXd B;  // independent rows
};

constexpr Index kManyUnknowns = 40;

EliminatedRows randomEliminatedRows(std::uint32_t seed)
{
  test::Random random(seed);
  std::vector<RowTerms> rows = randomRows(random, 30, kManyUnknowns);
  std::vector<Index> independent = independentRows(findDependencies(rows, kManyUnknowns), rows.size());
  Elimination elimination(rows, independent, kManyUnknowns, std::vector<bool>(kManyUnknowns, false));
  std::vector<RowTerms> some;
  for (const Index row : independent) some.push_back(rows[row]);
  Eigen::MatrixXd B = denseOf(some, kManyUnknowns);
  return {std::move(rows), std::move(independent), std::move(elimination), std::move(B)};
}

TEST(Bodies, AreEliminatedToWhatTheRowsLeaveFree)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const EliminatedRows problem = randomEliminatedRows(seed);
    const Eigen::MatrixXd Q2 = problem.elimination.Q2();
    EXPECT_EQ(Q2.cols(), kManyUnknowns - problem.B.rows()) << seed;
    EXPECT_LT((problem.B * Q2).cwiseAbs().maxCoeff(), 1e-13) << seed;
    EXPECT_EQ(Eigen::FullPivLU<Eigen::MatrixXd>(Q2).rank(), Q2.cols()) << seed;

    const Columns3 d = Columns3::Random(static_cast<Index>(problem.rows.size()), 3);
    Columns3 missed = problem.B * problem.elimination.particular(d);
    for (std::size_t k = 0; k < problem.independent.size(); ++k) missed.row(k) -= d.row(problem.independent[k]);
    EXPECT_LT(missed.cwiseAbs().maxCoeff(), 1e-12) << seed;
  }
}

TEST(Bodies, MultipliersAreFoundThroughThem)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const EliminatedRows problem = randomEliminatedRows(seed);
    const Columns3 expected = Columns3::Random(problem.B.rows(), 3);
    const Columns3 found = problem.elimination.multipliers(problem.B.transpose() * expected);
    for (std::size_t k = 0; k < problem.independent.size(); ++k)
      EXPECT_LT((found.row(problem.independent[k]) - expected.row(k)).norm(), 1e-11) << seed;
  }
}

TEST(Bodies, OfTenThousandUnknownsHaveOneColumn)
{
  constexpr Index kCount = 10000;
  std::vector<RowTerms> rows;
  for (Index u = 1; u < kCount; ++u) rows.push_back(differenceTerms(0, u));
  rows.push_back({{5, 0.5}, {kCount, 0.5}});
  const std::vector<Dependency> dependencies = findDependencies(rows, kCount + 1);
  EXPECT_TRUE(dependencies.empty());
  const Elimination elimination(rows, independentRows(dependencies, rows.size()), kCount + 1,
                                std::vector<bool>(kCount + 1, false));
  EXPECT_EQ(elimination.Q2().cols(), 1);
  EXPECT_EQ(elimination.Q2().nonZeros(), kCount + 1);
}

TEST(Bodies, AmplificationsAreTheColumnsOfThePseudoInverse)
{
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const EliminatedRows problem = randomEliminatedRows(seed);
    const Eigen::MatrixXd inverse =
        test::leastSquares(problem.B, Eigen::MatrixXd::Identity(problem.B.rows(), problem.B.rows()));
    const std::vector<double> found = problem.elimination.sensitivities();
    for (std::size_t k = 0; k < problem.independent.size(); ++k) {
      const double expected = inverse.col(static_cast<Index>(k)).norm();
      EXPECT_NEAR(found[problem.independent[k]], expected, 1e-9 * expected) << "seed " << seed << ", row " << k;
    }
  }
}

TEST(Bodies, AllOfABodyMovesWithAPinOfIt)
{
  constexpr Index kCount = 10000;
  std::vector<RowTerms> rows;
  for (Index u = 1; u < kCount; ++u) rows.push_back(differenceTerms(0, u));
  rows.push_back({{5, 1}});
  const Elimination elimination(rows, independentRows({}, rows.size()), kCount, std::vector<bool>(kCount, false));
  const std::vector<double> found = elimination.sensitivities();
  EXPECT_NEAR(found.back(), std::sqrt(static_cast<double>(kCount)), 1e-9);
  EXPECT_NEAR(found[0], 1, 1e-12) << "another unknown alone";
  EXPECT_NEAR(found[4], std::sqrt(static_cast<double>(kCount - 1)), 1e-9) << "all but the pinned one";
}

TEST(Bodies, NearlyEqualPointsAmplifyByTheInverseOfTheirDistance)
{
  for (const double apart : {1e-3, 1e-6, 1e-9}) {
    const std::vector<RowTerms> rows{{{0, 0.3}, {1, 0.7}}, {{0, 0.3 + apart}, {1, 0.7 - apart}}, {{2, 1}}};
    const Elimination elimination(rows, {0, 1, 2}, 3, std::vector<bool>(3, false));
    const std::vector<double> found = elimination.sensitivities();
    // The inverse of [0.3, 0.7; 0.3 + a, 0.7 - a] is [0.7 - a, -0.7; -0.3 - a, 0.3] / -a.
    EXPECT_NEAR(found[0] * apart, std::hypot(0.7 - apart, 0.3 + apart), 1e-6);
    EXPECT_NEAR(found[1] * apart, std::hypot(0.7, 0.3), 1e-6);
    EXPECT_EQ(found[2], 1);
  }
}

}  // namespace
}  // namespace holdfast

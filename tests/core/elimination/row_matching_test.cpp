#include <algorithm>
#include <numeric>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <holdfast/elimination/row_matching.h>

#include "support/random.h"

namespace holdfast {
namespace {

RowTerms randomRow(test::Random& random, Index unknowns)
{
  RowTerms row;
  const Index first = random.integer(0, unknowns - 3);
  for (Index k = 0; k < 3; ++k)
    if (random.uniform(0, 1) < 0.8) row.push_back({first + k, random.uniform(0.1, 1)});
  if (row.empty()) row.push_back({first, 1});
  return row;
}

std::vector<Index> firstRows(std::size_t count)
{
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  return order;
}

Eigen::MatrixXd denseRows(const std::vector<RowTerms>& rows, const std::vector<Index>& some, Index unknowns)
{
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(static_cast<Index>(some.size()), unknowns);
  for (std::size_t k = 0; k < some.size(); ++k)
    for (const Term& term : rows[some[k]]) B(static_cast<Index>(k), term.index) = term.coefficient;
  return B;
}

Index rankOf(const std::vector<RowTerms>& rows, const std::vector<Index>& some, Index unknowns)
{
  return Eigen::FullPivLU<Eigen::MatrixXd>(denseRows(rows, some, unknowns)).rank();
}

TEST(RowMatching, LeavesOutTheRowsThatDoNotRaiseTheRankOfRandomOnes)
{
  constexpr Index kRandomUnknowns = 12;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    test::Random random(seed);
    std::vector<RowTerms> rows;
    for (int k = 0; k < 16; ++k) rows.push_back(randomRow(random, kRandomUnknowns));
    std::vector<Index> expected;
    for (const Index row : firstRows(rows.size())) {
      expected.push_back(row);
      if (rankOf(rows, expected, kRandomUnknowns) < static_cast<Index>(expected.size())) expected.pop_back();
    }
    EXPECT_EQ(matchedRows(rows, firstRows(rows.size()), kRandomUnknowns), expected);
  }
}

TEST(RowMatching, TakesTheRowsInTheOrderThatIsGiven)
{
  const std::vector<RowTerms> rows{{{0, 1}}, {{0, 0.5}, {1, 0.5}}, {{1, 1}}};
  EXPECT_EQ(matchedRows(rows, {0, 1, 2}, 2), (std::vector<Index>{0, 1}));
  EXPECT_EQ(matchedRows(rows, {2, 1, 0}, 2), (std::vector<Index>{2, 1}));
  EXPECT_EQ(matchedRows(rows, {2}, 2), (std::vector<Index>{2}));
}

TEST(RowMatching, HandsUnknownsOnAlongAChain)
{
  constexpr Index kChain = 1000;
  std::vector<RowTerms> rows;
  for (Index k = 0; k < kChain; ++k) rows.push_back({{k, 0.5}, {k + 1, 0.5}});
  rows.push_back({{0, 1}});
  rows.push_back({{kChain, 1}});
  EXPECT_EQ(matchedRows(rows, firstRows(rows.size()), kChain + 1), firstRows(rows.size() - 1));
}

TEST(RowMatching, OfNothingIsNothing)
{
  EXPECT_TRUE(matchedRows({}, {}, 3).empty());
  EXPECT_TRUE(matchedRows({{}}, {0}, 3).empty()) << "a row that names no unknown";
}

TEST(FreeUnknowns, AreThoseThatMoveWhereTheRowsAreMetWithZero)
{
  constexpr Index kRandomUnknowns = 16;
  bool areSomeDetermined = false;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    test::Random random(seed);
    std::vector<RowTerms> all;
    for (int k = 0; k < 13; ++k) all.push_back(randomRow(random, kRandomUnknowns));
    std::vector<RowTerms> rows;
    for (const Index row : matchedRows(all, firstRows(all.size()), kRandomUnknowns)) rows.push_back(all[row]);
    const Eigen::MatrixXd B = denseRows(rows, firstRows(rows.size()), kRandomUnknowns);
    const Eigen::MatrixXd kernel = Eigen::FullPivLU<Eigen::MatrixXd>(B).kernel();
    const std::vector<bool> isFree = freeUnknowns(rows, kRandomUnknowns);
    for (Index u = 0; u < kRandomUnknowns; ++u) {
      EXPECT_EQ(isFree[u], kernel.row(u).cwiseAbs().maxCoeff() > 1e-9) << "seed " << seed << ", unknown " << u;
      areSomeDetermined = areSomeDetermined || !isFree[u];
    }
  }
  EXPECT_TRUE(areSomeDetermined);
}

}  // namespace
}  // namespace holdfast

#include <algorithm>
#include <iterator>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <holdfast/elimination/find_dependencies.h>
#include <holdfast/elimination/own_unknowns.h>

#include "support/random.h"

namespace holdfast {
namespace {

constexpr Index kUnknowns = 60;

/// Rows of three neighbours in a circle, `count` of them, in which the smallest weight is at least `least`.
std::vector<RowTerms> randomRows(test::Random& random, Index count, double least)
{
  std::vector<RowTerms> rows;
  for (Index r = 0; r < count; ++r) {
    const Index first = random.integer(0, kUnknowns - 1);
    RowTerms row;
    for (Index k = 0; k < 3; ++k) row.push_back({(first + k) % kUnknowns, random.uniform(least, 1)});
    std::ranges::sort(row, {}, &Term::index);
    rows.push_back(std::move(row));
  }
  return rows;
}

bool names(const RowTerms& row, Index unknown)
{
  return std::ranges::find(row, unknown, &Term::index) != row.end();
}

/// Calls `check(rows)` for few and many rows, some of them with weights near zero.
template <class Check>
void forEachSetOfRows(const Check& check)
{
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    check(randomRows(random, 1 + seed, seed % 3 == 0 ? 1e-9 : 0.1));
  }
}

TEST(OwnUnknowns, AreNamedByNoRowBehindAndByNoneThatIsNotListed)
{
  bool isAnyLeft = false;
  forEachSetOfRows([&](const std::vector<RowTerms>& rows) {
    std::vector<bool> isPassed(rows.size(), false);
    const std::vector<OwnUnknown> found = ownUnknowns(rows, kUnknowns);
    for (const auto& [row, unknown] : found) {
      EXPECT_TRUE(names(rows[row], unknown));
      isPassed[row] = true;
      for (std::size_t other = 0; other < rows.size(); ++other) {
        EXPECT_FALSE(!isPassed[other] && names(rows[other], unknown)) << other;
      }
    }
    isAnyLeft = isAnyLeft || found.size() < rows.size();
  });
  EXPECT_TRUE(isAnyLeft);
}

/// How far the own unknowns of these rows move, all together, to meet one of them with 1 and the others with 0: the
/// most of all rows.
double mostMoved(const std::vector<RowTerms>& rows, const std::vector<OwnUnknown>& found)
{
  const auto count = static_cast<Index>(found.size());
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(count, count);  // these rows at their own unknowns
  for (Index r = 0; r < count; ++r)
    for (Index k = 0; k < count; ++k)
      for (const Term& term : rows[found[r].row])
        if (term.index == found[k].unknown) square(r, k) = term.coefficient;
  return count == 0 ? 0 : square.inverse().cwiseAbs().colwise().sum().maxCoeff();
}

TEST(OwnUnknowns, MoveNoFurtherThanPromisedToMeetOneRow)
{
  forEachSetOfRows(
      [](const std::vector<RowTerms>& rows) { EXPECT_LE(mostMoved(rows, ownUnknowns(rows, kUnknowns)), kMostMoved); });
}

TEST(OwnUnknowns, OfAChainMoveNoFurtherThanPromisedFromEitherEnd)
{
  // Each row has a small coefficient at its first unknown: from there on the own unknowns before it move 1000 times as
  // far, from the other end a thousandth.
  std::vector<RowTerms> rows;
  for (Index r = 0; r < 8; ++r) rows.push_back({{r, 1e-3}, {r + 1, 1}});
  const std::vector<OwnUnknown> found = ownUnknowns(rows, 9);
  EXPECT_EQ(found.size(), rows.size()) << "by their last unknowns";
  EXPECT_LE(mostMoved(rows, found), kMostMoved);
}

TEST(OwnUnknowns, ThatPullOnOneUnknownCountTogether)
{
  // Each of the first three moves by half of what is promised where unknown 3 moves by 1.
  const std::vector<RowTerms> rows{{{0, 2e-2}, {3, 1}}, {{1, 2e-2}, {3, 1}}, {{2, 2e-2}, {3, 1}},
                                   {{3, 1}, {4, 1}},    {{4, 1}, {5, 1}},    {{4, 1}, {5, 0.5}}};
  const std::vector<OwnUnknown> found = ownUnknowns(rows, 6);
  EXPECT_EQ(found.size(), 3U);
  EXPECT_LE(mostMoved(rows, found), kMostMoved);
}

TEST(OwnUnknowns, ThatPullOnOneUnknownAreListedWhereTheyMoveLittle)
{
  const std::vector<RowTerms> rows{{{0, 2e-1}, {3, 1}}, {{1, 2e-1}, {3, 1}}, {{2, 2e-1}, {3, 1}},
                                   {{3, 1}, {4, 1}},    {{4, 1}, {5, 1}},    {{4, 1}, {5, 0.5}}};
  const std::vector<OwnUnknown> found = ownUnknowns(rows, 6);
  EXPECT_GE(found.size(), 4U);
  EXPECT_LE(mostMoved(rows, found), kMostMoved);
}

TEST(OwnUnknowns, RowsThatHaveOneAreInNoCircuit)
{
  forEachSetOfRows([](std::vector<RowTerms> rows) {
    rows.push_back(rows[rows.size() / 2]);  // a circuit of two
    const std::vector<Dependency> found = findDependencies(rows, kUnknowns);
    std::vector<Dependency> expected;
    for (const RowComponent& component : connectedRows(rows, kUnknowns))
      std::ranges::move(sequentialDependencies(rows, component), std::back_inserter(expected));
    std::ranges::sort(expected, {}, &Dependency::row);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k].row, expected[k].row);
    for (const auto& [row, unknown] : ownUnknowns(rows, kUnknowns))
      for (const Dependency& dependency : found)
        EXPECT_TRUE(dependency.row != row && !names(dependency.terms, row)) << row;
  });
}

TEST(SubstitutedRows, AreMetByTheBasisAndTheKeptOnesAreAllOthers)
{
  bool isAnyKept = false;
  forEachSetOfRows([&](const std::vector<RowTerms>& rows) {
    const SubstitutedRows result = substituted(rows, kUnknowns);
    const Eigen::MatrixXd left = Eigen::MatrixXd(constraintMatrix(rows, kUnknowns)) * result.basis;
    for (Index r = 0; r < left.rows(); ++r)
      EXPECT_TRUE(std::ranges::binary_search(result.kept, r) || left.row(r).cwiseAbs().maxCoeff() < 1e-14) << r;
    EXPECT_EQ(result.basis.cols(), kUnknowns - (left.rows() - static_cast<Index>(result.kept.size())));
    EXPECT_EQ(Eigen::MatrixXd(result.basis).colPivHouseholderQr().rank(), result.basis.cols());
    EXPECT_LE(Eigen::MatrixXd(result.basis).cwiseAbs().maxCoeff(), kLargestShare);
    isAnyKept = isAnyKept || !result.kept.empty();
  });
  EXPECT_TRUE(isAnyKept);
}

TEST(SubstitutedRows, MayHoldAnUnknownWhereItIs)
{
  // What a pin leaves of a row: x_1 = 0, and then 2 x_0 + x_2 = 0.
  const SubstitutedRows result = substituted({{{1, 0.5}}, {{0, 1}, {1, 1}, {2, 0.5}}}, 3);
  EXPECT_TRUE(result.kept.empty());
  EXPECT_EQ(result.basis.cols(), 1);
  EXPECT_EQ(Eigen::MatrixXd(result.basis).row(1).norm(), 0);
}

}  // namespace
}  // namespace holdfast

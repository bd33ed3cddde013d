#include <algorithm>
#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include <holdfast/elimination/find_dependencies.h>
#include <holdfast/elimination/large_component.h>
#include <holdfast/elimination/row_matching.h>

#include "support/law_meshes.h"
#include "support/random.h"

namespace holdfast {
namespace {

enum class FaceOrder { Random, FaceByFace };

/// Points at random in faces of a plate, as rows over its vertices.
std::vector<RowTerms> pointsOnPlate(const Mesh& plate, double rowsPerVertex, FaceOrder order, std::uint32_t seed)
{
  test::Random random(seed);
  const auto count = static_cast<Index>(rowsPerVertex * static_cast<double>(plate.vertexCount()));
  std::vector<RowTerms> rows;
  for (Index k = 0; k < count; ++k) {
    const Index face =
        order == FaceOrder::Random ? random.integer(0, plate.faces.size() - 1) : k * plate.faces.size() / count;
    std::array<double, 3> weights{};
    for (double& weight : weights) weight = random.uniform(1e-3, 1);
    const double sum = weights[0] + weights[1] + weights[2];
    RowTerms& row = rows.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) row.push_back({plate.faces[face][c], weights[c] / sum});
    std::ranges::sort(row, {}, &Term::index);
  }
  return rows;
}

std::vector<Index> everyRow(const std::vector<RowTerms>& rows)
{
  std::vector<Index> result(rows.size());
  std::iota(result.begin(), result.end(), Index{0});
  return result;
}

/// |b - sum a_k b_k| / |(1, a)|, and every term a row that stands.
void expectCircuit(const Dependency& dependency, const std::vector<RowTerms>& rows,
                   const std::vector<Index>& independent, Index unknowns)
{
  Eigen::VectorXd left = Eigen::VectorXd::Zero(unknowns);
  double squares = 1;
  for (const Term& term : rows[dependency.row]) left[term.index] += term.coefficient;
  for (const auto& [row, coefficient] : dependency.terms) {
    EXPECT_TRUE(std::ranges::binary_search(independent, row));
    squares += coefficient * coefficient;
    for (const Term& term : rows[row]) left[term.index] -= coefficient * term.coefficient;
  }
  EXPECT_LT(left.norm() / std::sqrt(squares), 1e-9);
}

void expectCircuits(const std::vector<Dependency>& found, const std::vector<RowTerms>& rows, Index unknowns)
{
  const std::vector<Index> independent = independentRows(found, rows.size());
  for (const Dependency& dependency : found) expectCircuit(dependency, rows, independent, unknowns);
}

/// As many rows stand as any order has by counting, but for those that nearly depend on others, which are named.
void expectRankBut(const std::vector<Dependency>& found, std::size_t rowCount, std::size_t byCounting)
{
  const std::size_t standing = rowCount - found.size();
  const auto undecided =
      static_cast<std::size_t>(std::ranges::count_if(found, [](const Dependency& d) { return d.isUndecided(); }));
  EXPECT_LE(standing, byCounting);
  EXPECT_GE(standing + undecided, byCounting);
  EXPECT_LE(undecided, rowCount / 100);
}

constexpr std::array kRowsPerVertex{0.8, 0.95, 1.1, 2.0, 3.0};

TEST(CrowdedPatches, KeepTheRankOfRowsAtRandomInTheirOrder)
{
  const Mesh plate = test::plate(40, 40);
  const Index n = plate.vertexCount();
  for (const double rowsPerVertex : kRowsPerVertex)
    for (std::uint32_t seed = 0; seed < 2; ++seed) {
      SCOPED_TRACE(rowsPerVertex);
      const std::vector<RowTerms> rows = pointsOnPlate(plate, rowsPerVertex, FaceOrder::Random, seed);
      const std::vector<Dependency> found = findDependencies(rows, n);
      const std::vector<Index> byCounting = matchedRows(rows, everyRow(rows), n);
      const std::vector<Index> independent = independentRows(found, rows.size());
      ASSERT_EQ(independent.size(), byCounting.size());
      std::vector<Index> moved;
      std::ranges::set_difference(independent, byCounting, std::back_inserter(moved));
      EXPECT_LE(moved.size(), 2U) << "rows that nearly depend on others wait";
      expectCircuits(found, rows, n);
    }
}

TEST(CrowdedPatches, KeepTheRankOfRowsThatAreListedFaceByFace)
{
  // Circuits of the earliest basis grow to 1e80: no order of the digits of a double holds that.
  const Mesh plate = test::plate(40, 40);
  const Index n = plate.vertexCount();
  for (const double rowsPerVertex : kRowsPerVertex) {
    SCOPED_TRACE(rowsPerVertex);
    const std::vector<RowTerms> rows = pointsOnPlate(plate, rowsPerVertex, FaceOrder::FaceByFace, 5);
    const std::vector<Dependency> found = findDependencies(rows, n);
    const std::vector<Index> byCounting = matchedRows(rows, everyRow(rows), n);
    EXPECT_EQ(rows.size() - found.size(), byCounting.size());
    expectCircuits(found, rows, n);
  }
}

TEST(CrowdedPatches, OfThousandsOfDependentRowsHaveTheirCircuits)
{
  const Mesh plate = test::plate(50, 50);
  const std::vector<RowTerms> rows = pointsOnPlate(plate, 3, FaceOrder::Random, 4);
  const std::vector<Dependency> found = findDependencies(rows, plate.vertexCount());
  ASSERT_GT(found.size(), 4000U) << "fewer are found by one decomposition";
  expectRankBut(found, rows.size(), matchedRows(rows, everyRow(rows), plate.vertexCount()).size());
  expectCircuits(found, rows, plate.vertexCount());
}

TEST(CrowdedPatches, HaveSmallCircuitsWhereRowsAreListedAtRandom)
{
  const Mesh plate = test::plate(60, 60);
  const std::vector<RowTerms> rows = pointsOnPlate(plate, 1.1, FaceOrder::Random, 3);
  std::size_t terms = 0;
  const std::vector<Dependency> found = findDependencies(rows, plate.vertexCount());
  for (const Dependency& dependency : found) terms += dependency.terms.size();
  ASSERT_GT(found.size(), 300U);
  EXPECT_LT(terms, 60 * found.size());
}

TEST(CrowdedPatches, AreJudgedAsByDenseElimination)
{
  const Mesh plate = test::plate(19, 19);
  for (const double rowsPerVertex : kRowsPerVertex)
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
      const std::vector<RowTerms> rows = pointsOnPlate(plate, rowsPerVertex, FaceOrder::Random, seed);
      for (const RowComponent& component : connectedRows(rows, plate.vertexCount())) {
        const std::vector<Dependency> sparse = sparseDependencies(rows, component);
        const std::vector<Dependency> dense = sequentialDependencies(rows, component);
        ASSERT_EQ(sparse.size(), dense.size());
        for (std::size_t k = 0; k < dense.size(); ++k) EXPECT_EQ(sparse[k].row, dense[k].row);
      }
    }
}

TEST(CrowdedPatches, LeaveOutRepeatedPointsWhereverTheyAre)
{
  const Mesh plate = test::plate(40, 40);
  std::vector<RowTerms> rows = pointsOnPlate(plate, 0.6, FaceOrder::Random, 8);
  const std::size_t before = findDependencies(rows, plate.vertexCount()).size();
  const std::vector<RowTerms> once = rows;
  rows.insert(rows.end(), once.begin(), once.end());
  EXPECT_EQ(findDependencies(rows, plate.vertexCount()).size(), before + once.size());
}

}  // namespace
}  // namespace holdfast

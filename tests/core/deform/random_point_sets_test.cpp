#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using LongDoubleVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongDoubleMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// Rows of length 1 as Q R by Gram-Schmidt, twice over. Shares no code with the product.
class LongSpan {
 public:
  explicit LongSpan(Index unknowns) : Q_(unknowns, unknowns), R_(LongDoubleMatrix::Zero(unknowns, unknowns)) {}

  /// How far the row is from a combination of those taken. Takes it where that is more than `tolerance`.
  long double take(LongDoubleVector row, long double tolerance)
  {
    row.normalize();
    LongDoubleVector shares = LongDoubleVector::Zero(count_);
    for (int pass = 0; pass < 2; ++pass) {
      const LongDoubleVector more = Q_.leftCols(count_).transpose() * row;
      row -= Q_.leftCols(count_) * more;
      shares += more;
    }
    const long double left = row.norm();
    const LongDoubleVector coefficients = R_.topLeftCorner(count_, count_).triangularView<Eigen::Upper>().solve(shares);
    const long double distance = left / std::sqrt(1 + coefficients.squaredNorm());
    if (distance <= tolerance) return distance;
    Q_.col(count_) = row / left;
    R_.col(count_).head(count_) = shares;
    R_(count_, count_) = left;
    ++count_;
    return distance;
  }

 private:
  LongDoubleMatrix Q_;
  LongDoubleMatrix R_;
  Index count_ = 0;
};

/// A weight from 1e-3 to 1, all alike or all sizes alike.
double randomWeight(test::Random& random, bool isOfAnySize)
{
  return isOfAnySize ? std::pow(10, random.uniform(-3, 0)) : random.uniform(1e-3, 1);
}

struct RandomPointSet {
  std::vector<AtFace> places;
  ConstraintList list;
};

/// 100 to 200 points in random faces, off their places in `target` by up to `noise`.
RandomPointSet randomPointSet(test::Random& random, const Mesh& mesh, const Mesh& target, double noise)
{
  RandomPointSet set;
  const bool isOfAnySize = random.integer(0, 1) == 1;
  std::vector<Constraint> constraints;
  for (long k = random.integer(100, 200); k > 0; --k) {
    const Index face = random.integer(0, mesh.faces.size() - 1);
    std::vector<double> weights(3);
    for (double& weight : weights) weight = randomWeight(random, isOfAnySize);
    const double sum = weights[0] + weights[1] + weights[2];
    for (double& weight : weights) weight /= sum;
    weights[2] = 1 - weights[0] - weights[1];
    Vector3 place = test::randomVector(random, noise);
    for (std::size_t c = 0; c < 3; ++c) place += weights[c] * target.positions.row(target.faces[face][c]).transpose();
    set.places.push_back({face, weights});
    constraints.push_back(test::moveTo(set.places.back(), place));
  }
  set.list = test::listOf(std::move(constraints));
  return set;
}

LongDoubleVector longRowOf(const AtFace& place, const Mesh& mesh)
{
  LongDoubleVector row = LongDoubleVector::Zero(mesh.vertexCount());
  for (std::size_t c = 0; c < 3; ++c) row[mesh.faces[place.face][c]] += place.weights[c];
  return row;
}

// Below this a set hangs on the rounding of its rows, whatever decomposes it: it is judged by its answer alone.
constexpr double kClearDistance = 1e-10;

std::vector<double> distancesInLongDouble(const RandomPointSet& set, const Mesh& mesh)
{
  LongSpan span(mesh.vertexCount());
  std::vector<double> result;
  for (const AtFace& place : set.places)
    result.push_back(static_cast<double>(span.take(longRowOf(place, mesh), kRankTolerance)));
  return result;
}

bool isClear(double distance)
{
  return distance < kRoundingDistance || distance > kClearDistance;
}

/// Tells whether the set is clear enough to be compared.
bool expectVerdictsOfLongDoubles(const RandomPointSet& set, const Mesh& mesh, const Model& model)
{
  const std::vector<double> distances = distancesInLongDouble(set, mesh);
  if (!std::ranges::all_of(distances, isClear)) return false;
  const ConstraintSystem system = makeConstraintSystem(set.list, model.mesh, model.solverMesh, model.locator(), "list");
  const EliminatedConstraints eliminated = eliminate(system, model.solverMesh);
  std::vector<Index> expected;
  for (std::size_t r = 0; r < distances.size(); ++r)
    if (distances[r] > kClearDistance) expected.push_back(static_cast<Index>(r));
  EXPECT_EQ(independentRows(eliminated.dependencies, distances.size()), expected);
  return true;
}

/// Every point is met, or follows from others, or is left out by name.
void expectAnAnswer(const RandomPointSet& set, const Model& model)
{
  NoProgress progress;
  const DeformResult result = deform(model, set.list, "list", {}, progress);
  EXPECT_NE(result.report.solve.status, SolveStatus::Failed) << result.report.solve.message;
  bool isUndecided = false;
  for (const DependentRow& row : result.details->diagnosis.dependent)
    isUndecided = isUndecided || row.dependency.isUndecided();
  EXPECT_EQ(test::findingOf(result.report, "undecided_constraints") != nullptr, isUndecided);
}

/// Sets of points that agree, and that are off by a little and by much.
void checkSets(std::uint32_t first, std::uint32_t count)
{
  const Mesh mesh = test::icosphere(2);
  ASSERT_EQ(mesh.vertexCount(), 162);
  const Mesh target = test::transformed(mesh, Eigen::Affine3d(Eigen::AngleAxisd(0.3, Vector3(1, 2, 3).normalized())));
  const Model model = makeModel(mesh, "mesh");
  constexpr std::array kNoises{0.0, 4e-4, 1e-2, 0.1};
  std::uint32_t compared = 0;
  for (std::uint32_t seed = first; seed < first + count; ++seed) {
    test::Random random(seed);
    const RandomPointSet set = randomPointSet(random, mesh, target, kNoises[seed % kNoises.size()]);
    if (expectVerdictsOfLongDoubles(set, mesh, model)) ++compared;
    expectAnAnswer(set, model);
  }
  EXPECT_GT(compared, count * 3 / 4);
}

TEST(RandomPointSets, AreJudgedAsByLongDoublesAndAnswered)
{
  checkSets(0, 60);
}

TEST(RandomPointSets, AreJudgedAsByLongDoublesAndAnsweredFiveThousandTimes)
{
  checkSets(1000, 5000);
}

}  // namespace
}  // namespace holdfast

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/elimination/circuit_patches.h>

#include "support/law_meshes.h"
#include "support/random.h"

namespace holdfast {
namespace {

/// A row for each vertex of a plate, every 97th of which is no longer in the basis, and two for points of each face.
class ThinnedPlate : public testing::Test {
 protected:
  void SetUp() override
  {
    const Mesh mesh = test::plate(50, 50);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      rows_.push_back({{v, 1}});
      if (!isOut(v)) basis_.push_back(v);
    }
    test::Random random(7);
    for (int copy = 0; copy < 2; ++copy)
      for (Index f = 0; f < mesh.faces.size(); ++f) {
        const double a = random.uniform(0.05, 0.9);
        const double b = random.uniform(0.02, 0.95 - a);
        const auto corners = mesh.faces[f];
        others_.push_back(static_cast<Index>(rows_.size()));
        RowTerms row{{corners[0], a}, {corners[1], b}, {corners[2], 1 - a - b}};
        std::ranges::sort(row, {}, &Term::index);
        rows_.push_back(std::move(row));
      }
    unknowns_.resize(static_cast<std::size_t>(mesh.vertexCount()));
    std::iota(unknowns_.begin(), unknowns_.end(), Index{0});
  }

  static bool isOut(Index vertex) { return vertex % 97 == 0; }

  std::vector<RowTerms> rows_;
  std::vector<Index> basis_;
  std::vector<Index> others_;
  std::vector<Index> unknowns_;
};

TEST_F(ThinnedPlate, RowsThatNeedWhatIsOutGetTheNearestCombinationAndItsDistance)
{
  const std::vector<Dependency> found = circuitsByPatches(rows_, basis_, others_, unknowns_, BasisKind::Thinned);
  ASSERT_EQ(found.size(), others_.size());
  Index open = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const RowTerms& row = rows_[others_[k]];
    double out = 0;
    double length = 0;
    RowTerms standing;
    for (const Term& term : row) {
      length = std::hypot(length, term.coefficient);
      if (isOut(term.index))
        out = term.coefficient;
      else
        standing.push_back(term);
    }
    double size = length;
    for (const Term& term : standing) size = std::hypot(size, term.coefficient);
    EXPECT_EQ(found[k].row, others_[k]);
    EXPECT_NEAR(found[k].distance, out / size, 1e-15);
    EXPECT_EQ(found[k].isUndecided(), out > 0);
    ASSERT_EQ(found[k].terms.size(), standing.size());
    for (std::size_t t = 0; t < standing.size(); ++t) {
      EXPECT_EQ(found[k].terms[t].index, standing[t].index);
      EXPECT_NEAR(found[k].terms[t].coefficient, standing[t].coefficient, 1e-14);
    }
    open += found[k].isUndecided();
  }
  EXPECT_GT(open, 100);
}

}  // namespace
}  // namespace holdfast

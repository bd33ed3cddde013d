#include <gtest/gtest.h>

#include <holdfast/surface/surface_point.h>

namespace holdfast {
namespace {

TEST(SurfacePoint, SortsTermsAndAddsUpRepeatedVertices)
{
  EXPECT_EQ(canonical({{9, 0.25}, {2, 0.5}, {9, 0.25}}), (SurfacePoint{{{2, 0.5}, {9, 0.5}}}));
}

TEST(SurfacePoint, WithVanishingWeightsBecomesAPointOfAnEdgeOrAVertex)
{
  EXPECT_EQ(canonical({{1, 0.5}, {2, 0.5}, {3, 0}}), (SurfacePoint{{{1, 0.5}, {2, 0.5}}}));
  EXPECT_EQ(canonical({{1, 0}, {2, 1 - 1e-15}, {3, 1e-15}}), (SurfacePoint{{{2, 1}}}));
  EXPECT_EQ(canonical({{4, 0.1}, {4, 0.2}, {4, 0.7}}), (SurfacePoint{{{4, 1}}}));
  EXPECT_EQ(canonical({{4, -1e-15}, {5, 1}}), (SurfacePoint{{{5, 1}}}));
}

TEST(SurfacePoint, KeepsWeightsThatCanBeTold)
{
  EXPECT_EQ(canonical({{1, 1 - 1e-9}, {2, 1e-9}}).terms.size(), 2U);
}

TEST(SurfacePoint, LiesAtTheWeightedMeanOfItsVertices)
{
  Positions positions(3, 3);
  positions << 0, 0, 0, 4, 0, 0, 0, 8, 2;
  EXPECT_EQ(positionOf({{{0, 0.25}, {1, 0.25}, {2, 0.5}}}, positions), Vector3(1, 4, 1));
}

TEST(SurfacePoint, DifferenceNamesEachVertexOnce)
{
  EXPECT_EQ(difference({{{1, 0.25}, {4, 0.75}}}, {{{2, 0.5}, {4, 0.5}}}),
            (std::vector<Term>{{1, 0.25}, {2, -0.5}, {4, 0.25}}));
  EXPECT_EQ(difference({{{1, 0.5}, {3, 0.5}}}, {{{2, 0.5}, {3, 0.5}}}), (std::vector<Term>{{1, 0.5}, {2, -0.5}}));
}

TEST(SurfacePoint, DifferenceFromItselfIsEmpty)
{
  EXPECT_TRUE(difference({{{1, 0.25}, {4, 0.75}}}, {{{1, 0.25}, {4, 0.75}}}).empty());
  EXPECT_TRUE(difference({{{1, 0.1}, {4, 0.9}}}, {{{1, 0.1 + 1e-16}, {4, 0.9 - 1e-16}}}).empty());
  EXPECT_TRUE(difference({{{1, 1 - 2e-14}, {2, 1e-14}, {3, 1e-14}}}, {{{1, 1}}}).empty())
      << "one term that rounding has left over is no point";
}

TEST(SurfacePoint, MidpointTakesHalfOfBoth)
{
  EXPECT_EQ(midpoint({{{1, 1}}}, {{{2, 0.5}, {1, 0.5}}}), (SurfacePoint{{{1, 0.75}, {2, 0.25}}}));
  EXPECT_EQ(midpoint({{{1, 1}}}, {{{1, 1}}}), (SurfacePoint{{{1, 1}}}));
}

}  // namespace
}  // namespace holdfast

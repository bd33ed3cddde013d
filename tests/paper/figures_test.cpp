// What docs/paper.md says of the figures, as orderings and bounds.

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "paper/paper_test.h"

namespace holdfast::paper {
namespace {

using testing::AllOf;
using testing::Ge;
using testing::Gt;
using testing::Le;
using testing::Lt;

/// What is promised of hard constraints, as a share of the diagonal.
constexpr double kPromise = 1e-12;

using PaperFigure = PaperTest;

TEST_F(PaperFigure, OneDrawsTheAnglesAndTheAreaOfTheCode)
{
  const Section section = sectionOf(cotangentDefinition);
  const auto& numbers = section.numbers;
  EXPECT_NEAR(numbers.at("cell area"), numbers.at("literal area"), 1e-14);
  EXPECT_NEAR(numbers.at("mixed area"), numbers.at("literal area"), 1e-14);
  EXPECT_LT(numbers.at("difference from L"), 1e-14);
  EXPECT_LT(numbers.at("obtuse literal area"), 0);
  EXPECT_THAT(numbers.at("obtuse mixed area"), AllOf(Gt(0), Lt(numbers.at("obtuse triangles"))));
}

TEST_F(PaperFigure, TwoIsNearlySymmetricWithCotangentWeightsAlone)
{
  const Section section = sectionOf(unsymmetricSubdivision);
  EXPECT_LT(section.numbers.at("cotangent rms"), 0.1 * section.numbers.at("uniform rms"));
  EXPECT_LT(section.numbers.at("cotangent largest"), 0.5 * section.numbers.at("uniform largest"));
}

TEST_F(PaperFigure, ThreeIsNearerToTheEvenMeshWithCotangentWeights)
{
  const Section section = sectionOf(badlyShapedTriangles);
  EXPECT_LT(section.numbers.at("cotangent"), 0.75 * section.numbers.at("uniform"));
  EXPECT_LE(section.numbers.at("cotangent"), section.numbers.at("cotangent-paper"));
}

TEST_F(PaperFigure, FourAndFiveKeepNormalsOnTheSurfaceWhereTheyAreRotated)
{
  const Section section = sectionOf(rotatedNormals);
  EXPECT_GT(section.numbers.at("none angle"), 30);
  EXPECT_LT(section.numbers.at("rotated angle"), 5);
  EXPECT_LT(section.numbers.at("rotated edges"), 0.25 * section.numbers.at("none edges"));
  EXPECT_EQ(section.numbers.at("program and library differ"), 0) << "pictures show what the program has written";
}

TEST_F(PaperFigure, SixHasNoRotationOutsideTheGivenOnes)
{
  const Section section = sectionOf(rotationSpheres);
  for (const std::string count : {"two", "three", "four"}) {
    EXPECT_THAT(section.numbers.at(count + " least weight"), AllOf(Ge(-1e-14), Lt(0.1))) << count;
    EXPECT_LT(section.numbers.at(count + " off span"), 1e-14) << count;
  }
}

TEST_F(PaperFigure, SevenKeepsTheEyesWhereTheyAreRigidRegions)
{
  const Section section = sectionOf(rigidEyes);
  for (const std::string eye : {"left eye", "right eye"}) {
    EXPECT_GT(section.numbers.at(eye + " without"), 0.02);
    EXPECT_LT(section.numbers.at(eye + " rigid"), 1e-13);
  }
}

TEST_F(PaperFigure, EightKeepsTheDistance)
{
  const Section section = sectionOf(keptDistance);
  const double rest = section.numbers.at("rest");
  EXPECT_GT(std::abs(section.numbers.at("free") - rest), 0.1 * rest);
  EXPECT_LT(std::abs(section.numbers.at("kept") - rest), kPromise * rest);
}

TEST_F(PaperFigure, NineMeetsHardConstraintsWithAnyWeights)
{
  const Section section = sectionOf(solversOnBadTriangles);
  for (const std::string weights : {"uniform", "cotangent", "cotangent-paper"}) {
    EXPECT_LE(section.numbers.at(weights + " hard"), kPromise) << weights;
    EXPECT_GT(section.numbers.at(weights + " soft"), 1e6 * kPromise) << weights;
  }
  EXPECT_GT(section.numbers.at("cotangent-paper soft"), 10 * section.numbers.at("cotangent soft"));
  EXPECT_GT(section.numbers.at("cotangent soft"), 10 * section.numbers.at("uniform soft"));
}

TEST_F(PaperFigure, TenMeetsTheConstraintsOfEveryModel)
{
  const Section section = sectionOf(deformedModels);
  for (const std::string model : {"bracket", "bar", "head", "plate"})
    EXPECT_LE(section.numbers.at(model + " residual"), kPromise) << model;
}

TEST_F(PaperFigure, ElevenFindsTheConflictAndItsResolution)
{
  const Section section = sectionOf(conflictingPoints);
  const auto& numbers = section.numbers;
  EXPECT_EQ(numbers.at("conflict exit code"), 4);
  EXPECT_NEAR(numbers.at("conflict height"), 10, 1e-10);
  EXPECT_NEAR(numbers.at("gap"), 20, 1e-10);
  EXPECT_NEAR(numbers.at("compromise height"), 20, 0.1) << "halfway";
  EXPECT_EQ(numbers.at("resolution exit code"), 0);
  EXPECT_NEAR(numbers.at("resolution height"), 10, 1e-10);
}

TEST_F(PaperFigure, TwelveTakesNoLargerAFactorWithHardConstraints)
{
  const Section section = costsOfMeshes(bench(), {"10"});
  EXPECT_THAT(section.numbers.at("10k factor"), AllOf(Gt(0.5), Le(1)));
  for (const std::string step : {"set-up", "decomposition", "set-up and decomposition", "solution"})
    EXPECT_GT(section.numbers.at("10k " + step), 0) << step;
  EXPECT_GT(std::filesystem::file_size(bench().picture("figure_12.svg")), 500);
}

}  // namespace
}  // namespace holdfast::paper

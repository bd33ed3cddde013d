#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deformer.h>
#include <holdfast/document/mirrored.h>
#include <holdfast/words/error.h>

#include "support/meshes.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

/// A sphere, which is its own mirror image.
class MirroredOnSphere : public testing::Test {
 protected:
  [[nodiscard]] Positions deformed(const ConstraintList& list)
  {
    NoProgress progress;
    const DeformResult result = Deformer(model, DeformOptions()).deform(list, "list", progress);
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    return result.positions;
  }

  [[nodiscard]] ConstraintList copied(const ConstraintList& list, const MirrorPlane& plane) const
  {
    std::vector<Index> all;
    for (Index k = 0; k < static_cast<Index>(list.constraints.size()); ++k) all.push_back(k);
    return mirrored(list, all, plane, *model);
  }

  [[nodiscard]] Index vertexAt(const Vector3& place) const
  {
    Index nearest = 0;
    (model->mesh.positions.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return nearest;
  }

  [[nodiscard]] std::vector<Index> around(const Vector3& place, double radius) const
  {
    std::vector<Index> found;
    for (Index v = 0; v < model->mesh.vertexCount(); ++v)
      if ((Vector3(model->mesh.positions.row(v)) - place).norm() < radius) found.push_back(v);
    return found;
  }

  /// The deformation under the copies is the mirror image of that under the list.
  void expectMirrored(const ConstraintList& list)
  {
    const Vector3 across(-1, 1, 1);
    const Positions before = deformed(list);
    const Positions after = deformed(copied(list, {Vector3::Zero(), Vector3::UnitX()}));
    ASSERT_GT((before - model->mesh.positions).cwiseAbs().maxCoeff(), 0.05) << "something moves";
    for (Index v = 0; v < before.rows(); ++v) {
      const Index other = vertexAt(across.cwiseProduct(Vector3(model->mesh.positions.row(v))));
      EXPECT_LT((Vector3(after.row(other)) - across.cwiseProduct(Vector3(before.row(v)))).norm(), 1e-9) << v;
    }
  }

  const Constraint base{"base", true, FixedConstraint{{InHalfSpace{{0.1, 0, -0.7}, {0.2, 0, -1}}}}};
  std::shared_ptr<const Model> model = std::make_shared<const Model>(makeModel(test::icosphere(2), "sphere"));
};

TEST_F(MirroredOnSphere, PointsAndVectors)
{
  const Index face = 17;
  expectMirrored({"",
                  {base,
                   {"A", true, PointConstraint{AtVertex{vertexAt({1, 0, 0})}, Target{Vector3(1.3, 0.2, 0.1)}}},
                   {"B", true, PointConstraint{AtFace{face, {0.2, 0.3, 0.5}}, Move{Vector3(0.1, -0.2, 0.05)}}},
                   {"C", true,
                    RelativeConstraint{AtVertex{vertexAt({0.5, 0.5, 0.7})}, AtVertex{vertexAt({0.6, -0.5, 0.6})},
                                       Vector3(0.1, 1.2, -0.1)}}}});
}

TEST_F(MirroredOnSphere, RegionsOfAllShapes)
{
  const Vector3 side = Vector3(0.9, 0.1, 0.3).normalized();
  expectMirrored({"",
                  {base,
                   {"ids", true, HandleConstraint{{VertexIds{around({0, 0, 1}, 0.4)}}, {}, Vector3(0.1, 0.2, 0.3), {}}},
                   {"ball", true, RigidConstraint{{InSphere{side, 0.4}}}},
                   {"box", true,
                    RigidConstraint{{AllOf{
                        {{InBox{{-0.9, -1, -0.3}, {-0.5, 1, 0.4}}},
                         {NotIn{std::make_shared<Selection>(Selection{InHalfSpace{{0, 0.5, 0}, {0, 1, 0}}})}}}}}}}}});
}

TEST_F(MirroredOnSphere, RotationsTurnTheOtherWay)
{
  const Selection top{VertexIds{around({0.2, 0, 1}, 0.5)}};
  const Selection side{VertexIds{around({1, 0, 0}, 0.3)}};
  expectMirrored(
      {"",
       {base,
        {"axis", true,
         HandleConstraint{top, AxisRotation{Vector3(0.3, 0.2, 1), 50, Vector3(0.1, 0, 0)}, Vector3(0.1, 0, 0.1), {}}},
        {"frames", true,
         HandleConstraint{side,
                          FrameMotion{{{}, Vector3::UnitX(), Vector3::UnitY()},
                                      {Vector3(1.1, 0.1, 0), Vector3(1, 0.4, 0.1), Vector3::UnitZ()},
                                      0},
                          Vector3(0, 0.1, 0),
                          {}}}}});
}

TEST_F(MirroredOnSphere, SingleVerticesKeepTheirOrder)
{
  const std::vector<Index> ids{vertexAt({1, 0, 0}), vertexAt({0.8, 0.5, 0}), vertexAt({0.8, 0, 0.5})};
  std::vector<Vector3> targets;
  for (const Index v : ids) targets.emplace_back(1.2 * Vector3(model->mesh.positions.row(v)));
  expectMirrored({"", {base, {"each", true, HandleConstraint{{VertexIds{ids}}, VertexTargets{targets}, {}, {}}}}});
}

TEST_F(MirroredOnSphere, TwiceIsTheListAgainAndNamesSayWhatTheyAre)
{
  const MirrorPlane plane{{0.1, 0, 0}, Vector3(1, 2, 2) / 3};
  const ConstraintList list{"mm", {{"A", false, PointConstraint{AtNear{{1, 0, 0}}, Target{Vector3(2, 3, 4)}}}}};
  const ConstraintList once = copied(list, plane);
  EXPECT_EQ(once.constraints.front().name, "A mirrored");
  EXPECT_FALSE(once.constraints.front().isEnabled);
  const ConstraintList twice = copied(once, plane);
  EXPECT_LT(
      (std::get<Target>(std::get<PointConstraint>(twice.constraints.front().what).to).place - Vector3(2, 3, 4)).norm(),
      1e-12);
}

TEST_F(MirroredOnSphere, WhatHasNothingBeyondThePlaneIsRefusedByName)
{
  const ConstraintList list{"", {{"cap", true, FixedConstraint{{VertexIds{around({1, 0, 0}, 0.4)}}}}}};
  try {
    static_cast<void>(copied(list, {Vector3(5, 0, 0), Vector3::UnitX()}));
    FAIL() << "there is nothing at x = 9";
  } catch (const InputError& error) {
    EXPECT_THAT(error.reason(), HasSubstr("\"cap\" cannot be mirrored"));
  }
}

}  // namespace
}  // namespace holdfast

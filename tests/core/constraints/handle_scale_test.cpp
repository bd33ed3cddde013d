// Handles that are made larger or smaller before they move.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraints/handle_drag.h>
#include <holdfast/document/handle_restated.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::HasSubstr;
using Motion = decltype(HandleConstraint::motion);

const Vector3 kFactors(2, 1, 0.5);

/// The last row of a plate is a handle, and its first row is fixed.
class ScaleOfHandle : public testing::Test {
 protected:
  const Model model = makeModel(test::plate(5, 4), "plate");
  const VertexIds last{{24, 25, 26, 27, 28, 29}};

  [[nodiscard]] HandleConstraint scaled(Motion motion, const Vector3& factors = kFactors) const
  {
    return {{last}, std::move(motion), {0.1, 0.2, 0.3}, {}, factors};
  }

  [[nodiscard]] HandleSetting settingOf(const HandleConstraint& handle) const
  {
    const ConstraintList list = test::listOf({test::hold({0, 1, 2, 3, 4, 5}), {"", true, handle}});
    return settingsOf(model, list, std::array{Index{1}}, "list").front();
  }

  [[nodiscard]] Positions placesOf(const HandleConstraint& handle) const
  {
    return placeHandle(handle, settingOf(handle)).places;
  }

  /// The places of a handle that is turned by `R`, and scaled about `center` along `axes`.
  [[nodiscard]] Positions expected(const Eigen::Matrix3d& R, const Vector3& center, const Eigen::Matrix3d& axes) const
  {
    Positions places = model.mesh.positions(last.ids, Eigen::all);
    for (Index k = 0; k < places.rows(); ++k) {
      const Vector3 along = axes.transpose() * (places.row(k).transpose() - center);
      places.row(k) = (R * axes * kFactors.cwiseProduct(along) + center + Vector3(0.1, 0.2, 0.3)).transpose();
    }
    return places;
  }

  static void expectNear(const Positions& a, const Positions& b) { EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-13); }
};

TEST_F(ScaleOfHandle, IsAboutThePointAboutWhichItTurns)
{
  const Positions rest = model.mesh.positions(last.ids, Eigen::all);
  const Vector3 own = rest.colwise().mean();
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  const Vector3 axis(1, -2, 3);
  expectNear(placesOf(scaled({})), expected(I, own, I));
  expectNear(placesOf(scaled(AxisRotation{axis, 50, std::nullopt})), expected(rotationMatrix(axis, 50), own, I));
  expectNear(placesOf(scaled(AxisRotation{axis, 50, Vector3(4, 5, 6)})),
             expected(rotationMatrix(axis, 50), {4, 5, 6}, I));
  const Frame from{std::nullopt, {1, 2, 0}, {0, 1, 1}};
  expectNear(placesOf(scaled(FrameMotion{from, from, 0})), expected(I, own, axesOf(from)));
}

TEST_F(ScaleOfHandle, KeepsTheBitsAlongAxesOfFactorOne)
{
  HandleConstraint handle = scaled({});
  handle.translate.setZero();
  const Positions places = placesOf(handle);
  const Positions rest = model.mesh.positions(last.ids, Eigen::all);
  EXPECT_EQ(places.col(1), rest.col(1));
  EXPECT_NE(places.col(0), rest.col(0));
  handle.scale.setOnes();
  EXPECT_EQ(placesOf(handle), rest);
}

TEST_F(ScaleOfHandle, LeavesItsRotationAsItIs)
{
  const HandleConstraint handle = scaled(AxisRotation{{1, -2, 3}, 400, std::nullopt});
  HandleConstraint unscaled = handle;
  unscaled.scale.setOnes();
  EXPECT_EQ(placeHandle(handle, settingOf(handle)).q, placeHandle(unscaled, settingOf(unscaled)).q);
}

TEST_F(ScaleOfHandle, IsMetByTheSurface)
{
  const HandleConstraint handle = scaled(RotationAboutFixed{});
  const DeformResult result =
      test::deformed(model.mesh, test::listOf({test::hold({0, 1, 2, 3, 4, 5}), {"", true, handle}}), {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_EQ(Positions(result.positions(last.ids, Eigen::all)), placesOf(handle));
}

TEST_F(ScaleOfHandle, GoesWithADrag)
{
  const RigidIncrement increment{{1, 2, -1}, 35, {3, 1, 4}, {-0.5, 0, 1}};
  const Eigen::Matrix3d R = rotationMatrix(increment.axis, increment.degrees);
  for (const Vector3& factors : {kFactors, Vector3(3, 3, 3)})
    for (const Motion& motion :
         {Motion(), Motion(AxisRotation{{0, 1, 0}, 20, Vector3(1, 2, 3)}), Motion(FrameMotion()),
          Motion(RotationAboutFixed()), Motion(FrameMotion{{std::nullopt, {1, 2, 0}, {0, 1, 1}}, {}, 0})}) {
      SCOPED_TRACE(motion.index());
      const HandleConstraint handle = scaled(motion, factors);
      const HandleConstraint after = composed(handle, increment, settingOf(handle));
      Positions moved = placesOf(handle);
      for (Index k = 0; k < moved.rows(); ++k)
        moved.row(k) =
            (R * (moved.row(k).transpose() - increment.pivot) + increment.pivot + increment.translation).transpose();
      expectNear(placesOf(after), moved);
    }
}

TEST_F(ScaleOfHandle, StaysWhenItsMotionIsStatedInAnotherWay)
{
  for (const Motion& motion :
       {Motion(), Motion(AxisRotation{{0, 1, 0}, 20, Vector3(1, 2, 3)}), Motion(RotationAboutFixed())})
    for (const Vector3& factors : {kFactors, Vector3(3, 3, 3)}) {
      const HandleConstraint handle = scaled(motion, factors);
      expectNear(placesOf(byFrames(handle, settingOf(handle))), placesOf(handle));
      expectNear(placesOf(byTargets(handle, settingOf(handle))), placesOf(handle));
    }
}

TEST_F(ScaleOfHandle, ThatMakesNoSenseIsRefused)
{
  EXPECT_THAT(validateHandle(scaled({}, {1, 0, 1}))->reason, HasSubstr("must be above 0, this is 0"));
  EXPECT_THAT(validateHandle(scaled({}, {1, 1, -2}))->reason, HasSubstr("must be above 0, this is -2"));
  const auto error = validateHandle(scaled(VertexTargets{std::vector<Vector3>(6, Vector3(1, 2, 3))}));
  EXPECT_EQ(error->key, ".scale");
  EXPECT_THAT(error->reason, HasSubstr("have targets of their own"));
}

TEST(ScaleInFiles, IsANumberOrThree)
{
  const auto parsed = [](const std::string& scale) {
    const std::string handle = R"({"type": "handle", "select": {"vertices": [1]}, "scale": )" + scale + "}";
    const ConstraintList list = parseConstraintsJson(
        R"({"format": "holdfast-constraints", "version": 2, "constraints": [)" + handle + "]}", "f.json");
    return std::pair(std::get<HandleConstraint>(list.constraints.front().what).scale, constraintsToJson(list));
  };
  EXPECT_EQ(parsed("1.5").first, Vector3(1.5, 1.5, 1.5));
  EXPECT_THAT(parsed("1.5").second, HasSubstr("\"scale\": 1.5"));
  EXPECT_EQ(parsed("[1, 2, 0.5]").first, Vector3(1, 2, 0.5));
  EXPECT_THAT(parsed("[1, 2, 0.5]").second, HasSubstr("\"version\": 2"));
  EXPECT_THAT(parsed("1").second, HasSubstr("\"version\": 1"));
  try {
    parsed("[1, 0, 1]");
    FAIL() << "it is refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().element, "constraints[0].scale");
  }
}

}  // namespace
}  // namespace holdfast


#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/document/handle_restated.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

using Motion = decltype(HandleConstraint::motion);

/// A slender bar away from the origin, held at one end, with a handle at the other.
class RestatedHandle : public testing::Test {
 protected:
  const Model model = makeModel(test::moved(test::quadBox({1, 1.5, 6}, 3), {30, -20, 10}), "bar");
  // Not ascending: entries are in the order of this list.
  const VertexIds top{{model.mesh.vertexCount() - 1, 40, 41, 36, 50}};

  [[nodiscard]] ConstraintList listWith(const HandleConstraint& handle) const
  {
    return {"", {{"base", true, FixedConstraint{{VertexIds{{0, 1, 2, 3}}}}}, {"top", false, handle}}};
  }
  [[nodiscard]] HandleSetting settingOf(const HandleConstraint& handle) const
  {
    return settingsOf(model, listWith(handle), std::array{Index{1}}, "list").front();
  }
  [[nodiscard]] HandleConstraint handleThat(Motion motion) const
  {
    return {{top}, std::move(motion), {0.5, -0.25, 1}, {}};
  }

  /// A motion of every kind, the last of them of vertices that all go their own way.
  [[nodiscard]] std::vector<Motion> motions() const
  {
    VertexTargets targets;
    for (const Index v : top.ids) targets.places.emplace_back(2 * model.mesh.positions.row(v).transpose());
    return {std::monostate{},
            AxisRotation{{0, 0, 1}, 90, {}},
            AxisRotation{{1, 2, 3}, 77, Vector3(1, 2, 3)},
            AxisRotation{{-1, 0, 0}, 180, {}},
            AxisRotation{{3, -1, 1}, 270, {}},
            AxisRotation{{3, -1, 1}, -1000, Vector3(30, -20, 12)},
            RotationAboutFixed{},
            FrameMotion{{{}, {1, 1, 0}, {0, 1, 1}}, {Vector3(30, -20, 9), {0, 2, 0}, {0, 0, 1}}, 1},
            targets};
  }

  void expectSamePicture(const HandleConstraint& before, const HandleConstraint& after) const
  {
    const HandleSetting setting = settingOf(before);
    const HandlePlacement a = placeHandle(before, setting);
    const HandlePlacement b = placeHandle(after, setting);
    EXPECT_LT((a.places - b.places).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((a.q - b.q).cwiseAbs().maxCoeff(), 1e-11);
  }
};

TEST_F(RestatedHandle, ByFramesGoesAndTurnsAsBefore)
{
  const auto all = motions();
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    SCOPED_TRACE(k);
    const HandleConstraint before = handleThat(all[k]);
    const HandleConstraint after = byFrames(before, settingOf(before));
    EXPECT_TRUE(std::holds_alternative<FrameMotion>(after.motion));
    EXPECT_EQ(after.translate, before.translate);
    expectSamePicture(before, after);
  }
}

TEST_F(RestatedHandle, ByFramesBeginsWithItsOwnAxesAtRest)
{
  const HandleConstraint before = handleThat(AxisRotation{{0, 1, 0}, 30, {}});
  const HandleSetting setting = settingOf(before);
  const auto frames = std::get<FrameMotion>(byFrames(before, setting).motion);
  EXPECT_LT((axesOf(frames.from) - principalAxes(setting.rest)).norm(), 1e-15);
  EXPECT_FALSE(frames.from.origin) << "its centroid";
  EXPECT_FALSE(frames.to.origin) << "where it is from: it turns about that";
}

TEST_F(RestatedHandle, ByFramesOfWholeTurnsIsRefused)
{
  for (const double degrees : {360.0, -720.0, 360.01, 1e300}) {
    const HandleConstraint handle = handleThat(AxisRotation{{0, 0, 1}, degrees, {}});
    try {
      (void)byFrames(handle, settingOf(handle));
      ADD_FAILURE() << degrees;
    } catch (const InputError& error) {
      EXPECT_THAT(error.reason(), HasSubstr("let it turn about an axis")) << degrees;
    }
  }
}

TEST_F(RestatedHandle, ByFramesOfTargetsIsTheRigidMotionThatFitsBest)
{
  const HandleConstraint before = handleThat(motions().back());
  const HandleSetting setting = settingOf(before);
  const auto place = [&](const HandleConstraint& handle) { return placeHandle(handle, setting); };
  const HandleConstraint after = byFrames(before, setting);
  EXPECT_LT((place(before).places.colwise().mean() - place(after).places.colwise().mean()).norm(), 1e-12);
  EXPECT_LT((place(before).q - place(after).q).norm(), 1e-12);
}

TEST_F(RestatedHandle, ByTargetsGoesAndTurnsAsBefore)
{
  for (const Motion& motion : motions()) {
    SCOPED_TRACE(motion.index());
    const HandleConstraint before = handleThat(motion);
    const HandleConstraint after = byTargets(before, settingOf(before));
    const auto& targets = std::get<VertexTargets>(after.motion);
    EXPECT_EQ(targets.places.size(), top.ids.size());
    expectSamePicture(before, after);
  }
  const HandleConstraint rotated = handleThat(AxisRotation{{0, 0, 1}, 270, {}});
  EXPECT_EQ(byTargets(rotated, settingOf(rotated)).rotations.size(), top.ids.size()) << "places alone say a quarter";
}

TEST_F(RestatedHandle, WithRotationsGivesEachThatOfTheMotion)
{
  for (const Motion& motion : motions()) {
    SCOPED_TRACE(motion.index());
    const HandleConstraint before = handleThat(motion);
    const HandleConstraint after = withRotations(before, settingOf(before));
    EXPECT_EQ(after.rotations.size(), top.ids.size());
    EXPECT_EQ(after.motion.index(), before.motion.index());
    expectSamePicture(before, after);
  }
}

TEST_F(RestatedHandle, EntriesForEachVertexNeedAListOfThem)
{
  HandleConstraint handle = handleThat(AxisRotation{});
  handle.select.what = InHalfSpace{{30, -20, 12}, {0, 0, 1}};
  for (const auto restate : {&byTargets, &withRotations}) try {
      (void)restate(handle, settingOf(handle));
      ADD_FAILURE();
    } catch (const InputError& error) {
      EXPECT_THAT(error.reason(), HasSubstr("select by \"vertices\""));
    }
  EXPECT_NO_THROW((void)byFrames(handle, settingOf(handle)));
}

TEST_F(RestatedHandle, TooFewVerticesSayNoTargets)
{
  HandleConstraint handle = handleThat(AxisRotation{});
  handle.select.what = VertexIds{{7, 3}};
  EXPECT_THROW((void)byTargets(handle, settingOf(handle)), InputError);
}

TEST_F(RestatedHandle, TurnsAboutWhatIsFixedOnlyWhereSomethingIs)
{
  const HandleConstraint handle = handleThat(RotationAboutFixed{});
  ConstraintList list = listWith(handle);
  EXPECT_TRUE(settingsOf(model, list, std::array{Index{1}}, "list").front().surroundings.fixedCenter);
  list.constraints[0].isEnabled = false;
  try {
    (void)byFrames(handle, settingsOf(model, list, std::array{Index{1}}, "list").front());
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("list: constraints[1].turn: nothing is fixed"));
  }
}

}  // namespace
}  // namespace holdfast

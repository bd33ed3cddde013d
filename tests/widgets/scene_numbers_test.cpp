#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <holdfast/deform/deform.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/color/coloring.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/scene/scene_contents.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

DeformResult deformed(const Model& model, const ConstraintList& list, SolverKind solver = SolverKind::Hard)
{
  NoProgress progress;
  DeformOptions options;
  options.solver.kind = solver;
  return deform(model, list, "constraints", options, progress);
}

/// One vertex of a grid stays, one is lifted; the third asks for the second's place once more, `gap` above it.
ConstraintList threePoints(double gap)
{
  return test::listOf(
      {test::hold({0}), test::moveBy(AtVertex{24}, {0, 0, 1}), test::moveBy(AtVertex{24}, {0, 0, 1 + gap})});
}

TEST(Coloring, DisplacementIsALengthFromZeroToTheLargest)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const DeformResult deformation = deformed(model, threePoints(0));
  const auto coloring = coloringOf(model, deformation, ColorBy::Displacement, "mm");
  ASSERT_TRUE(coloring);
  EXPECT_EQ(coloring->values[0], 0);
  EXPECT_EQ(coloring->values[24], 1);
  EXPECT_EQ(coloring->scale.low, 0);
  EXPECT_EQ(coloring->scale.high, *std::max_element(coloring->values.begin(), coloring->values.end()));
  EXPECT_EQ(coloring->scale.title, "displacement\n[mm]");
}

TEST(Coloring, ResidualsAreLogarithmicWithThePromiseMarked)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const auto coloring = coloringOf(model, deformed(model, threePoints(0)), ColorBy::ConstraintResidual, "");
  ASSERT_TRUE(coloring);
  EXPECT_EQ(coloring->scale.scaling, Scaling::Logarithmic);
  ASSERT_TRUE(coloring->scale.promise);
  EXPECT_NEAR(*coloring->scale.promise, 1e-12 * std::sqrt(32), 1e-18);
  EXPECT_LT(coloring->scale.low, *coloring->scale.promise);
  EXPECT_GT(coloring->scale.high, *coloring->scale.promise);
  EXPECT_TRUE(std::isnan(coloring->values[12]));
  EXPECT_EQ(coloring->values[24], 0);
}

TEST(Coloring, GapsOfConflictsAreInsideTheScale)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const auto coloring = coloringOf(model, deformed(model, threePoints(0.25)), ColorBy::ConstraintResidual, "");
  EXPECT_EQ(coloring->values[24], 0.25);
  EXPECT_GE(coloring->scale.high, 0.25);
}

/// One end of a sheet stays, the other makes `degrees` about its length.
ConstraintList twist(double degrees)
{
  const FixedConstraint end{{VertexIds{{0, 1, 2}}}};
  const HandleConstraint rotated{
      {VertexIds{{24, 25, 26}}}, AxisRotation{Vector3::UnitY(), degrees, {}}, Vector3::Zero(), {}};
  return {"", {{"end", true, end}, {"turned", true, rotated}}};
}

TEST(Coloring, AnglesAreTwiceTheLogsInDegreesAndNotWrapped)
{
  const Model model = makeModel(test::grid(2, 8), "sheet");
  const DeformResult deformation = deformed(model, twist(450));
  const auto rotation = coloringOf(model, deformation, ColorBy::Rotation, "mm");
  const auto angle = coloringOf(model, deformation, ColorBy::Angle, "mm");
  ASSERT_TRUE(rotation && angle);
  EXPECT_EQ(rotation->scale.title, "rotation |q|\n[rad]");
  EXPECT_EQ(angle->scale.title, "rotation angle\n[degrees]");
  EXPECT_EQ(angle->values[0], 0);
  EXPECT_NEAR(angle->values[26], 450, 1e-12);
  EXPECT_NEAR(angle->scale.high, 450, 1e-12);
  for (std::size_t v = 0; v < angle->values.size(); ++v)
    EXPECT_NEAR(angle->values[v], 360 / std::numbers::pi * rotation->values[v], 1e-12) << v;
}

TEST(Coloring, ForcesAreLogarithmicAndWhereConstraintsAre)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const auto coloring = coloringOf(model, deformed(model, threePoints(0)), ColorBy::Force, "mm");
  ASSERT_TRUE(coloring);
  EXPECT_EQ(coloring->scale.title, "force");
  EXPECT_EQ(coloring->scale.scaling, Scaling::Logarithmic);
  EXPECT_TRUE(std::isnan(coloring->values[12]));
  EXPECT_GT(coloring->values[24], 0);
  EXPECT_LE(coloring->values[24], coloring->scale.high);
  EXPECT_GT(10 * coloring->values[24], coloring->scale.high);
  EXPECT_NEAR(coloring->scale.high / coloring->scale.low, 1e4, 1e-9) << "four decades";
}

TEST(Coloring, TheScaleOfDetailEndsWhere99PercentOfTheFreeVerticesDo)
{
  const Model model = makeModel(test::grid(30, 30), "grid");
  const auto coloring = coloringOf(model, deformed(model, threePoints(0)), ColorBy::Detail, "");
  ASSERT_TRUE(coloring);
  Index above = 0;
  Index free = 0;
  for (Index v = 0; v < model.mesh.vertexCount(); ++v) {
    if (v == 0 || v == 24) continue;
    ++free;
    above += coloring->values[v] > coloring->scale.high ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(above) / static_cast<double>(free), 0.01, 0.002);
}

TEST(Coloring, ForcesOfSoftConstraintsAreNotKnown)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const auto coloring = coloringOf(model, deformed(model, threePoints(0), SolverKind::Soft), ColorBy::Force, "mm");
  for (const double value : coloring->values) EXPECT_TRUE(std::isnan(value));
}

TEST(Coloring, NamesAndValuesBelongTogether)
{
  EXPECT_EQ(colorByNamed("none"), ColorBy::None);
  EXPECT_EQ(colorByNamed("constraint-residual"), ColorBy::ConstraintResidual);
  EXPECT_EQ(colorByNamed("rotation"), ColorBy::Rotation);
  EXPECT_EQ(colorByNamed("angle"), ColorBy::Angle);
  EXPECT_EQ(colorByNamed("displacement"), ColorBy::Displacement);
  EXPECT_EQ(colorByNamed("detail"), ColorBy::Detail);
  EXPECT_EQ(colorByNamed("force"), ColorBy::Force);
  EXPECT_EQ(colorByNamed("Detail"), std::nullopt);
  EXPECT_EQ(colorByNamed(""), std::nullopt);
}

TEST(Coloring, ComponentsHaveZeroInTheMiddle)
{
  const Model model = makeModel(test::box({1, 2, 3}, 2), "box");
  DeformResult moved = deform(model, test::listOf({test::hold({0})}));
  moved.positions.rowwise() += Eigen::RowVector3d(0, -3, 1);
  const auto y = coloringOf(model, moved, ColorBy::DisplacementY, "mm");
  EXPECT_EQ(y->scale.title, "displacement y\n[mm]");
  EXPECT_EQ(y->scale.low, -3);
  EXPECT_EQ(y->scale.high, 3);
  for (const double value : y->values) EXPECT_DOUBLE_EQ(value, -3);
}

TEST(Coloring, AlongTheNormalOutwardsIsAboveZero)
{
  const Model model = makeModel(test::icosphere(3), "sphere");
  DeformResult grown = deform(model, test::listOf({test::hold({0})}));
  grown.positions *= 1.5;
  const auto coloring = coloringOf(model, grown, ColorBy::DisplacementNormal, "");
  for (const double value : coloring->values) EXPECT_NEAR(value, 0.5, 0.005);
}

TEST(Coloring, ChangesOfAreaAndLengthArePercent)
{
  const Model model = makeModel(test::icosphere(2), "sphere");
  DeformResult grown = deform(model, test::listOf({test::hold({0})}));
  grown.positions *= 1.1;
  const auto values = [&](ColorBy field) { return coloringOf(model, grown, field, "mm")->values; };
  for (const double value : values(ColorBy::AreaChange)) EXPECT_NEAR(value, 21, 1e-9);
  for (const double value : values(ColorBy::EdgeChange)) EXPECT_NEAR(value, 10, 1e-9);
}

TEST(Coloring, SignedFieldsAreWhiteAtZeroByThemselves)
{
  const Model model = makeModel(test::icosphere(2), "sphere");
  DeformResult grown = deform(model, test::listOf({test::hold({0})}));
  grown.positions *= 1.1;
  for (const ColorBy field : {ColorBy::DisplacementX, ColorBy::DisplacementNormal, ColorBy::AreaChange})
    EXPECT_TRUE(isTwoSided(coloringOf(model, grown, field, "")->scale.map));
  for (const ColorBy field : {ColorBy::Displacement, ColorBy::Angle, ColorBy::Detail})
    EXPECT_FALSE(isTwoSided(coloringOf(model, grown, field, "")->scale.map));
  const Coloring powers = withRange(*coloringOf(model, grown, ColorBy::AreaChange, ""), LogarithmicRange{3});
  EXPECT_FALSE(isTwoSided(powers.scale.map)) << "powers of ten are on one side of 0";
}

/// A box whose top is twice as large as at rest: its sides lean.
struct GrownBox {
  Model model = makeModel(test::box({2, 2, 2}, 4), "box");
  DeformResult grown = deform(model, test::listOf({test::hold({0})}));
  ShadedSurface shaded = cutAtSharpEdges(model);
  CutSurface cut = cutSurfaceOf(shaded);

  GrownBox()
  {
    grown.positions = model.mesh.positions;
    for (Index v = 0; v < grown.positions.rows(); ++v)
      if (grown.positions(v, 2) == 2) grown.positions.row(v).head<2>() *= 2;
  }

  [[nodiscard]] bool isOn(Index triangle, double height) const
  {
    return std::ranges::all_of(model.triangulation.triangles[triangle],
                               [&](Index v) { return model.mesh.positions(v, 2) == height; });
  }

  /// The values of all points of the top, and of the bottom.
  [[nodiscard]] std::vector<double> valuesAt(double height, ColorBy field) const
  {
    const std::vector<double> values = pointValuesOf(model, grown, field, cut);
    std::vector<double> found;
    for (Index t = 0; t < shaded.triangles.size(); ++t)
      if (isOn(t, height))
        for (const Index point : shaded.triangles[t]) found.push_back(values[point]);
    return found;
  }
};

TEST(Coloring, ChangesAreCrispAtSharpEdges)
{
  const GrownBox box;
  for (const double value : box.valuesAt(2, ColorBy::AreaChange)) EXPECT_NEAR(value, 300, 1e-9);
  for (const double value : box.valuesAt(2, ColorBy::EdgeChange)) EXPECT_NEAR(value, 100, 1e-9);
  for (const double value : box.valuesAt(0, ColorBy::AreaChange)) EXPECT_EQ(value, 0);
  EXPECT_FALSE(box.valuesAt(2, ColorBy::AreaChange).empty());
}

TEST(Coloring, WaysAlongNormalsAreCrispAtSharpEdges)
{
  GrownBox box;
  box.grown.positions = box.model.mesh.positions;
  box.grown.positions.col(2).array() += 0.5;
  for (const double value : box.valuesAt(2, ColorBy::DisplacementNormal)) EXPECT_NEAR(value, 0.5, 1e-12);
  for (const double value : box.valuesAt(0, ColorBy::DisplacementNormal)) EXPECT_NEAR(value, -0.5, 1e-12);
}

TEST(Coloring, FieldsOfVerticesHaveNoValuesOfCorners)
{
  const GrownBox box;
  for (const ColorBy field : {ColorBy::Displacement, ColorBy::Angle, ColorBy::Detail, ColorBy::DisplacementX})
    EXPECT_TRUE(pointValuesOf(box.model, box.grown, field, box.cut).empty());
}

TEST(Coloring, TheValueInsideAFaceIsThatOfItsCorners)
{
  const GrownBox box;
  const std::vector<double> values = pointValuesOf(box.model, box.grown, ColorBy::AreaChange, box.cut);
  for (Index t = 0; t < box.shaded.triangles.size(); ++t) {
    if (!box.isOn(t, 2)) continue;
    const Index face = box.model.triangulation.faceOf[t];
    const std::size_t corners = box.model.mesh.faces[face].size();
    const AtFace middle{face, std::vector<double>(corners, 1.0 / static_cast<double>(corners))};
    EXPECT_NEAR(valueInFace(values, middle, box.model, box.cut), 300, 1e-9) << face;
  }
}

TEST(Coloring, EveryNameIsDescribed)
{
  const std::string document = test::bytesOf(test::sourceFolder() + "/docs/formats.md");
  for (const std::string_view name : colorByNames())
    EXPECT_NE(document.find("| `" + std::string(name) + "`"), std::string::npos) << name;
}

TEST(ConstraintMarks, OfDifferencesLieWhereTheyAct)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const RelativeConstraint apart{AtVertex{24}, AtVertex{0}, Vector3(5, 4, 0)};
  const RelativeConstraint further{AtVertex{24}, AtVertex{0}, Vector3(5, 4, 2)};
  const ConstraintList list = {"",
                               {{"hold", true, FixedConstraint{{VertexIds{{0}}}}},
                                {"body", true, RigidConstraint{{VertexIds{{11, 12}}}}},
                                {"apart", true, apart},
                                {"further", true, further}}};
  const DeformResult deformation = deformed(model, list);
  const auto marks = constraintMarks(model, deformation);
  ASSERT_EQ(marks.size(), 4);
  EXPECT_EQ(marks[1].place, Vector3(deformation.positions.row(12)));
  EXPECT_FALSE(isSinglePoint(marks[1].kind));
  EXPECT_EQ(marks[2].place, Vector3(deformation.positions.row(24)));
  EXPECT_TRUE(isSinglePoint(marks[2].kind));
  EXPECT_EQ(marks[2].status, ConstraintStatus::Met);
  EXPECT_EQ(marks[3].status, ConstraintStatus::Conflicting);
  EXPECT_LE((marks[3].target - Vector3(5, 4, 2)).norm(), 1e-12);
}

TEST(ConstraintMarks, SayHowEachRowFared)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const auto agreeing = constraintMarks(model, deformed(model, threePoints(0)));
  ASSERT_EQ(agreeing.size(), 3);
  EXPECT_EQ(agreeing[0].status, ConstraintStatus::Met);
  EXPECT_FALSE(isSinglePoint(agreeing[0].kind));
  EXPECT_TRUE(isSinglePoint(agreeing[1].kind));
  EXPECT_EQ(agreeing[1].place, Vector3(4, 4, 1));
  EXPECT_EQ(agreeing[2].status, ConstraintStatus::Redundant);

  const auto contradicting = constraintMarks(model, deformed(model, threePoints(0.25)));
  EXPECT_EQ(contradicting[2].status, ConstraintStatus::Conflicting);
  EXPECT_EQ(contradicting[2].target, Vector3(4, 4, 1.25));
}

TEST(ConstraintMarks, OfSoftConstraintsAreMissed)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  ConstraintList list = test::listOf(
      {test::hold({0, 1, 5}), test::moveBy(AtVertex{24}, {0, 0, 1}), test::moveBy(AtVertex{12}, {0, 0, -1})});
  const auto marks = constraintMarks(model, deformed(model, list, SolverKind::Soft));
  EXPECT_EQ(marks.back().status, ConstraintStatus::Missed);
}

/// The largest share of half the picture that a point reaches; 1 is at the border.
double reach(vtkCamera& camera, const Positions& points, double aspect)
{
  const Vector3 eye(camera.GetPosition());
  const Vector3 back = (eye - Vector3(camera.GetFocalPoint())).normalized();
  const Vector3 up(camera.GetViewUp());
  const Vector3 right = up.cross(back);
  const double slope = std::tan(camera.GetViewAngle() / 2 * std::numbers::pi / 180);
  double largest = 0;
  for (Index k = 0; k < points.rows(); ++k) {
    const Vector3 p = points.row(k).transpose() - eye;
    const double depth = -p.dot(back);
    EXPECT_GT(depth, 0);
    largest =
        std::max({largest, std::abs(p.dot(up)) / (depth * slope), std::abs(p.dot(right)) / (depth * slope * aspect)});
  }
  return largest;
}

TEST(DefaultCamera, FitsAnyMeshIntoAnyPicture)
{
  for (const Vector3& size : {Vector3(1, 2, 3), Vector3(100, 1, 1), Vector3(1, 50, 30), Vector3(1e-6, 1e-6, 1e-3)})
    for (const double aspect : {0.3, 1.0, 4.0 / 3, 5.0}) {
      const Mesh mesh = test::box(size, 2);
      vtkNew<vtkCamera> camera;
      fit(*camera, defaultFrame(mesh.positions), mesh.positions, aspect);
      EXPECT_NEAR(reach(*camera, mesh.positions, aspect), 0.88, 1e-6) << size.transpose() << ", aspect " << aspect;
    }
}

TEST(DefaultCamera, FitsAMeshIntoAParallelPictureAndLeavesRoomAtTheRight)
{
  for (const int isParallel : {0, 1})
    for (const Vector3& size : {Vector3(1, 2, 3), Vector3(100, 1, 1), Vector3(1, 1, 100)})
      for (const double aspect : {0.3, 1.0, 5.0}) {
        const Positions points = test::box(size, 2).positions;
        vtkNew<vtkCamera> camera;
        camera->SetParallelProjection(isParallel);
        fit(*camera, defaultFrame(points), points, aspect, {0, 0.2});
        vtkMatrix4x4& view = *camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
        Positions shown(points.rows(), 3);
        for (Index k = 0; k < points.rows(); ++k) {
          const double* place = view.MultiplyDoublePoint(Vector3(points.row(k)).homogeneous().eval().data());
          shown.row(k) = Vector3(place).transpose() / place[3];
        }
        const double left = -1 - shown.col(0).minCoeff();
        const double right = shown.col(0).maxCoeff() - 1;
        const double above = shown.col(1).maxCoeff() - 1;
        EXPECT_LE(left, -0.12 + 1e-9);
        EXPECT_LE(right, -0.4 + 1e-9);
        EXPECT_LE(above, -0.12 + 1e-9);
        EXPECT_NEAR(std::max(left, above), -0.12, 1e-9) << "as large as it fits";
      }
}

TEST(DefaultCamera, OfAModelWhoseYIsUpIsThatOfTheSameModelTurnedUpright)
{
  const Positions lying = test::box({2, 7, 5}, 2).positions;
  Positions standing(lying.rows(), 3);
  for (Index k = 0; k < lying.rows(); ++k) standing.row(k) = upright(UpAxis::Y, Vector3(lying.row(k))).transpose();
  const ViewFrame expected = defaultFrame(lying);
  const ViewFrame frame = defaultFrame(standing, UpAxis::Y);
  EXPECT_EQ(frame.up, upright(UpAxis::Y, expected.up));
  EXPECT_EQ(frame.back, upright(UpAxis::Y, expected.back));
  EXPECT_GT(frame.up.y(), 0.7);
  EXPECT_NEAR(frame.right.cross(frame.up).dot(frame.back), 1, 1e-12);
}

TEST(DefaultCamera, LooksFromAboveAtTheLongerSide)
{
  const ViewFrame wide = defaultFrame(test::box({10, 1, 5}, 1).positions);
  EXPECT_GT(-wide.back.y(), std::abs(wide.back.x()));
  EXPECT_GT(wide.back.z(), 0);
  const ViewFrame deep = defaultFrame(test::box({1, 10, 5}, 1).positions);
  EXPECT_GT(deep.back.x(), std::abs(deep.back.y()));
  EXPECT_NEAR(deep.right.cross(deep.up).dot(deep.back), 1, 1e-12);
}

}  // namespace
}  // namespace holdfast

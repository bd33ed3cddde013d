#include "holdfast/deform/found_shape.h"

#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/law_meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

constexpr RotationSource kFoundSources[] = {RotationSource::Found, RotationSource::FoundSmooth};

DeformOptions finding(RotationSource source, int mostIterations = kMostIterations, Weights weights = Weights::Cotangent)
{
  return {weights, {}, {source, kFoundChange, mostIterations}};
}

/// The ids of vertices whose coordinate is within a range.
std::vector<Index> slice(const Mesh& mesh, int axis, double low, double high)
{
  std::vector<Index> ids;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions(v, axis) >= low && mesh.positions(v, axis) <= high) ids.push_back(v);
  return ids;
}

Mesh bar()
{
  return test::quadBox(Vector3(1, 1, 4), 6);
}

/// One end is held, the other moved across without a word on how it turns.
ConstraintList shearedBar(const Mesh& mesh)
{
  const double low = mesh.positions.col(2).minCoeff();
  const double high = mesh.positions.col(2).maxCoeff();
  HandleConstraint handle;
  handle.select = {VertexIds{slice(mesh, 2, high, high)}};
  handle.translate = Vector3(1.5, 0.3, -0.4);
  ConstraintList list = test::listOf({test::hold(slice(mesh, 2, low, low))});
  list.constraints.push_back({"handle", true, handle});
  return list;
}

Columns3 displacementOf(const Model& model, const DeformResult& result)
{
  Columns3 u(model.solverMesh.unknownCount(), 3);
  for (Index v = 0; v < result.positions.rows(); ++v)
    u.row(model.solverMesh.weld.unknownOf[v]) = result.positions.row(v) - model.mesh.positions.row(v);
  return u;
}

double energyOf(const Model& model, const DeformOptions& options, const DeformResult& result)
{
  const RotationEnergy energy(model.solverMesh, makeOperators(model.solverMesh, options.weights),
                              options.rotations.source);
  UnknownRotations R;
  for (Index i = 0; i < result.rotations.rows(); ++i) R.push_back(rotationExp(Vector3(result.rotations.row(i))));
  return energy.value(displacementOf(model, result), R);
}

/// Stops at the first step that begins so.
class StopAt final : public Progress {
 public:
  explicit StopAt(std::string step) : step_(std::move(step)) {}
  void step(std::string_view description) override
  {
    if (description.starts_with(step_)) throw Cancelled();
  }

 private:
  std::string step_;
};

TEST(FoundShape, EnergyNeverRisesAndConstraintsHoldInEveryIteration)
{
  const Model model = makeModel(bar());
  ConstraintList withRegion = shearedBar(model.mesh);
  withRegion.constraints.push_back(test::rigid(slice(model.mesh, 2, 1.2, 2.5)));
  for (const ConstraintList& list : {shearedBar(model.mesh), withRegion})
    for (const RotationSource source : kFoundSources)
      for (const Weights weights : {Weights::Cotangent, Weights::Uniform}) {
        SCOPED_TRACE(testing::Message() << name(source) << ", " << name(weights) << ", " << list.constraints.size());
        double last = std::numeric_limits<double>::infinity();
        double first = 0;
        for (int count = 1; count <= 30; ++count) {
          const DeformOptions options = finding(source, count, weights);
          const DeformResult result = deform(model, list, "constraints", options);
          ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
          EXPECT_LE(result.report.solve.maxResidualRelative, kPromisedResidual);
          const double energy = energyOf(model, options, result);
          EXPECT_LE(energy, last * (1 + 1e-12)) << count;
          if (count == 1) first = energy;
          last = energy;
        }
        EXPECT_LT(last, 0.9 * first) << "there was something to find";
      }
}

TEST(FoundShape, MovesTheMeshRigidlyWithAllConstraints)
{
  const Eigen::Affine3d motion = Eigen::Translation3d(3, -2, 5) *
                                 Eigen::AngleAxisd(2.5, Vector3(1, 2, 3).normalized()) * Eigen::Affine3d::Identity();
  for (const test::NamedMesh& named : test::lawMeshes()) {
    const Mesh moved = test::transformed(named.mesh, motion);
    std::vector<Constraint> points;
    for (Index v = 0; v < moved.vertexCount(); v += 3)
      points.push_back(test::moveTo(AtVertex{v}, moved.positions.row(v)));
    const Model model = makeModel(named.mesh);
    if (model.solverMesh.componentCount > 1) continue;  // a part may have too few of the points
    for (const RotationSource source : kFoundSources) {
      SCOPED_TRACE(named.name + ", " + std::string(name(source)));
      const DeformResult result = deform(model, test::listOf(points), "constraints", finding(source));
      EXPECT_LE((result.positions - moved.positions).cwiseAbs().maxCoeff(), 1e-12 * model.solverMesh.diagonal);
    }
  }
}

TEST(FoundShape, LeavesTheMeshAtRestBitForBit)
{
  for (const test::NamedMesh& named : test::lawMeshes())
    for (const RotationSource source : kFoundSources) {
      const ConstraintList list = test::listOf({test::hold({0, 1}), test::moveBy(AtVertex{2}, Vector3::Zero())});
      const DeformResult result = test::deformed(named.mesh, list, finding(source));
      EXPECT_EQ(result.positions, named.mesh.positions) << named.name;
      EXPECT_TRUE(result.rotations.isZero(0)) << named.name;
    }
}

TEST(FoundShape, SaysWhyItStops)
{
  const Model model = makeModel(bar());
  const DeformResult converged = deform(model, shearedBar(model.mesh), "constraints", finding(RotationSource::Found));
  ASSERT_TRUE(converged.report.solve.iterations);
  EXPECT_TRUE(converged.report.solve.iterations->isConverged);
  EXPECT_LE(converged.report.solve.iterations->change, kFoundChange);
  EXPECT_GT(converged.report.solve.iterations->count, 3);
  EXPECT_EQ(test::findingOf(converged.report, "rotations_not_converged"), nullptr);

  const DeformResult limited = deform(model, shearedBar(model.mesh), "constraints", finding(RotationSource::Found, 3));
  EXPECT_FALSE(limited.report.solve.iterations->isConverged);
  EXPECT_EQ(limited.report.solve.iterations->count, 3);
  EXPECT_GT(limited.report.solve.iterations->change, kFoundChange);
  EXPECT_NE(test::findingOf(limited.report, "rotations_not_converged"), nullptr);

  Deformer deformer(model, finding(RotationSource::Found));
  StopAt third("finding rotations: iteration 3");
  EXPECT_THROW(static_cast<void>(deformer.deform(shearedBar(model.mesh), "constraints", third)), Cancelled);
  EXPECT_EQ(deformer.deform(shearedBar(model.mesh)).positions, converged.positions) << "as if it had not been called";

  const DeformResult given = deform(model, shearedBar(model.mesh));
  EXPECT_FALSE(given.report.solve.iterations);
}

TEST(FoundShape, KeepsTheRotationsThatAreGiven)
{
  const Mesh mesh = bar();
  ConstraintList list = shearedBar(mesh);
  auto& handle = std::get<HandleConstraint>(list.constraints.back().what);
  handle.motion = AxisRotation{Vector3::UnitZ(), 220, std::nullopt};
  handle.translate.setZero();
  for (const RotationSource source : kFoundSources) {
    const DeformResult result = test::deformed(mesh, list, finding(source));
    const Vector3 given = rotationLog(Vector3::UnitZ(), 220);
    for (const GivenRotation& one : result.details->system.rotations)
      EXPECT_EQ(Vector3(result.rotations.row(one.unknown)), one.constraint == 0 ? Vector3(Vector3::Zero()) : given);
    const std::vector<Index> middle = slice(mesh, 2, 1.9, 2.1);
    double degrees = 0;
    for (const Index v : middle)
      degrees += 2 * result.rotations(v, 2) * 180 / M_PI / static_cast<double>(middle.size());
    EXPECT_NEAR(degrees, 110, 30) << "not 70 the other way";
  }
}

TEST(FoundShape, FindsTheRotationOfRigidRegionsAndOfHandlesThatOnlyMove)
{
  const Model model = makeModel(bar());
  ConstraintList list = shearedBar(model.mesh);
  const std::vector<Index> region = slice(model.mesh, 2, 1.2, 2.5);
  list.constraints.push_back(test::rigid(region));
  const DeformResult given = deform(model, list);
  const DeformResult found = deform(model, list, "constraints", finding(RotationSource::Found));
  const auto& unknownOf = model.solverMesh.weld.unknownOf;
  EXPECT_TRUE(given.rotations.isZero(0));
  EXPECT_GT(angleDegrees(found.rotations.row(unknownOf[region[0]])), 5);
  for (const Index v : region) EXPECT_EQ(found.rotations.row(unknownOf[v]), found.rotations.row(unknownOf[region[0]]));
  // Even with the best rotations for its shape.
  const DeformOptions options = finding(RotationSource::Found);
  const RotationEnergy energy(model.solverMesh, makeOperators(model.solverMesh, options.weights),
                              options.rotations.source);
  const Columns3 u = displacementOf(model, given);
  const FreeRotations free(withStatedRotations(given.details->system), u.rows());
  UnknownRotations R(static_cast<std::size_t>(u.rows()), Eigen::Quaterniond::Identity());
  R = energy.fitted(u, free, std::move(R));
  EXPECT_LT(energyOf(model, options, found), 0.8 * energy.value(u, R));
}

TEST(FoundShape, GoesOnFromTheLastCallWhereThatIsWanted)
{
  const Model model = makeModel(bar());
  const DeformResult whole = deform(model, shearedBar(model.mesh), "constraints", finding(RotationSource::Found));
  Deformer deformer(model, finding(RotationSource::Found));
  DeformResult frame = deformer.deformFrame(shearedBar(model.mesh));
  EXPECT_FALSE(frame.report.solve.iterations->isConverged);
  EXPECT_EQ(test::findingOf(frame.report, "rotations_not_converged"), nullptr) << "it is not at its end";
  int frames = 1;
  for (; frames < 1000 && !frame.report.solve.iterations->isConverged; ++frames)
    frame = deformer.deformFrame(shearedBar(model.mesh));
  EXPECT_GT(frames, 2);
  EXPECT_TRUE(frame.report.solve.iterations->isConverged);
  EXPECT_LE((frame.positions - whole.positions).cwiseAbs().maxCoeff(), 1e-2);
  EXPECT_EQ(deformer.deform(shearedBar(model.mesh)).positions, whole.positions) << "no trace of calls before";
}

TEST(FoundShape, IsSmoothBesideASinglePoint)
{
  const Mesh mesh = test::plate(21, 21);
  const Eigen::RowVector3d size = mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff();
  std::vector<Index> border;
  Index center = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Eigen::RowVector3d p = (mesh.positions.row(v) - mesh.positions.colwise().minCoeff())
                                     .cwiseQuotient(Eigen::RowVector3d(size.x(), size.y(), 1));
    if (p.head<2>().minCoeff() < 0.01 || p.head<2>().maxCoeff() > 0.99) border.push_back(v);
    if ((p.head<2>().array() - 0.5).matrix().norm() < 0.03) center = v;
  }
  const Vector3 lift(0, 0, 0.15 * size.norm());
  const ConstraintList list = test::listOf({test::hold(border), test::moveBy(AtVertex{center}, lift)});
  const auto spike = [&](RotationSource source) {
    const DeformResult result = test::deformed(mesh, list, finding(source));
    double highest = -std::numeric_limits<double>::infinity();
    for (Index v = 0; v < mesh.vertexCount(); ++v)
      if (v != center) highest = std::max(highest, result.positions(v, 2));
    return result.positions(center, 2) - highest;
  };
  EXPECT_LT(spike(RotationSource::FoundSmooth), spike(RotationSource::Found) / 2);
}

}  // namespace
}  // namespace holdfast

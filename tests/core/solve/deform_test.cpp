#include <holdfast/deform/deform.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace holdfast {
namespace {

ConstraintList pinned(std::initializer_list<std::pair<Index, Vector3>> moves)
{
  ConstraintList list;
  for (const auto& [vertex, shift] : moves)
    list.constraints.push_back({"P" + std::to_string(list.constraints.size()), true, Point{AtVertex{vertex}, Move{shift}}});
  return list;
}

TEST(Deform, EqualMovesOfAllPinsMoveTheMeshEqually)
{
  const Model model = makeModel(test::icosphere(3), "sphere");
  const Vector3 shift(0.1, -0.2, 0.3);
  NoProgress progress;
  const Deformation result = deform(model, pinned({{0, shift}, {5, shift}, {9, shift}}), "test", {}, progress);
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LT((result.positions - model.mesh.positions).rowwise().operator-(shift.transpose()).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LE(result.report.solve.maxResidual, 0) << "pins are copied";
}

TEST(Deform, PinsAndPointsAreMetWhenTheyMoveApart)
{
  const Model model = makeModel(test::icosphere(3), "sphere");
  ConstraintList list = pinned({{0, Vector3::Zero()}, {5, Vector3(0.1, 0, 0)}});
  list.constraints.push_back({"face", true, Point{AtFace{77, {0.2, 0.3, 0.5}}, Move{Vector3(0, 0, 0.4)}}});
  list.constraints.push_back({"edge", true, Point{AtEdge{9, model.mesh.faces[0][0], 0.25}, Move{Vector3(0, 0, 0.4)}}});
  list.constraints.back().what = Point{AtEdge{model.mesh.faces[200][0], model.mesh.faces[200][1], 0.25}, Target{Vector3(1, 2, 3)}};
  NoProgress progress;
  for (const Weights weights : {Weights::Cotangent, Weights::CotangentPaper, Weights::Uniform})
    for (const Backend backend : {Backend::Cholmod, Backend::Eigen})
      for (const SolverKind kind : {SolverKind::Hard, SolverKind::Lagrange, SolverKind::Soft}) {
        const Deformation result = deform(model, list, "test", {weights, {kind, backend, 5}}, progress);
        std::cout << name(weights) << " " << name(backend) << " " << name(kind) << ": " << result.report.solve.message << " "
                  << result.report.solve.method << " residual " << result.report.solve.maxResidual << " acc "
                  << result.report.solve.accuracy << " steps " << result.report.solve.refinementSteps << " n "
                  << result.report.solve.unknowns << " nz " << result.report.solve.factorNonzeros << "\n";
      }
}

}  // namespace
}  // namespace holdfast

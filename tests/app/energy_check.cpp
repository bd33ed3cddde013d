#include "app/energy_check.h"

#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/rotation_factorization.h>
#include <holdfast/io/mesh_file.h>

#include "support/plain_constraints.h"
#include "support/plain_selection.h"

namespace holdfast::test {
namespace {

using Json = nlohmann::json;
using Row = std::vector<std::pair<Index, double>>;

/// Takes the part along a row of B out of the gradient.
void projectRow(Columns3& gradient, const Row& row)
{
  Eigen::RowVector3d along = Eigen::RowVector3d::Zero();
  double squared = 0;
  for (const auto& [unknown, weight] : row) {
    along += weight * gradient.row(unknown);
    squared += weight * weight;
  }
  for (const auto& [unknown, weight] : row) gradient.row(unknown) -= weight / squared * along;
}

/// The rotations of all unknowns.
Columns3 rotationsOf(const Model& model, const std::filesystem::path& constraints,
                     std::shared_ptr<const Operators> operators)
{
  const ConstraintSystem system = makeConstraintSystem(readConstraints(constraints), model.mesh, model.solverMesh,
                                                       model.locator(), constraints.string());
  NoProgress progress;
  return RotationFactorization(model.solverMesh, std::move(operators), Backend::Holdfast).solve(system, progress).q;
}

/// The weighted difference of the turned detail and the detail, with lengths in diagonals.
Columns3 askedOfDetail(const Operators& operators, const Columns3& q)
{
  Columns3 f(q.rows(), 3);
  for (Index i = 0; i < f.rows(); ++i) {
    const Vector3 log = q.row(i);
    const Vector3 detail = operators.delta.row(i);
    const Eigen::AngleAxisd turn(2 * log.norm(), log.isZero(0) ? Vector3(Vector3::UnitX()) : log.normalized());
    f.row(i) = operators.rowWeights[i] * (turn * detail - detail);
  }
  return f;
}

}  // namespace

EnergyCheck::EnergyCheck(const std::filesystem::path& rest, const std::filesystem::path& constraints, Weights weights)
    : model_(makeModel(readMesh(rest).mesh, rest.string())),
      rest_(readPlainMesh(rest)),
      constraints_(readPlainConstraints(constraints))
{
  const auto operators = std::make_shared<const Operators>(makeOperators(model_.solverMesh, weights));
  A_ = weightedRows(*operators).matrix();
  f_ = askedOfDetail(*operators, rotationsOf(model_, constraints, operators));
}

FreeGradient EnergyCheck::freeGradient(const PlainMesh& written) const
{
  Columns3 gradient = A_.transpose() * (A_ * displacement(written) - f_);
  project(gradient);
  const double coordinate = 1 + model_.mesh.positions.cwiseAbs().maxCoeff() / model_.solverMesh.diagonal;
  const SparseMatrix magnitudes = A_.cwiseAbs();
  const Eigen::VectorXd coordinates = Eigen::VectorXd::Constant(A_.cols(), coordinate);
  const Eigen::VectorXd entries = magnitudes.transpose() * (magnitudes * coordinates);
  return {gradient.cwiseAbs().maxCoeff(), std::numeric_limits<double>::epsilon() * entries.maxCoeff()};
}

double EnergyCheck::cosineTowards(const PlainMesh& written, const PlainMesh& other) const
{
  const Columns3 u = displacement(written);
  const Columns3 here = A_ * u - f_;
  const Columns3 towards = A_ * (displacement(other) - u);
  const double lengths = here.norm() * towards.norm();
  return lengths > 0 ? here.cwiseProduct(towards).sum() / lengths : 0;
}

Columns3 EnergyCheck::displacement(const PlainMesh& written) const
{
  const SolverMesh& mesh = model_.solverMesh;
  Columns3 u(mesh.unknownCount(), 3);
  for (Index k = 0; k < u.rows(); ++k) {
    const PlainPoint& p = written.positions.at(mesh.weld.firstVertexOf[k]);
    u.row(k) = (Vector3(p[0], p[1], p[2]).transpose() - mesh.rest.row(k)) / mesh.diagonal;
  }
  return u;
}

void EnergyCheck::project(Columns3& gradient) const
{
  for (const Json& constraint : constraints_)
    if (constraint.contains("at"))
      projectPoint(gradient, constraint["at"]);
    else if (constraint.at("type") != "fixed" && constraint.at("type") != "handle")
      throw std::runtime_error("not to be judged: " + constraint.dump());
    else
      for (const long v : selectPlain(constraint.at("select"), rest_))
        gradient.row(model_.solverMesh.weld.unknownOf[v]).setZero();
}

void EnergyCheck::projectPoint(Columns3& gradient, const Json& at) const
{
  const std::vector<int>& unknownOf = model_.solverMesh.weld.unknownOf;
  Row row;
  if (at.contains("vertex")) row = {{unknownOf.at(at["vertex"]), 1}};
  if (at.contains("edge")) {
    const double t = at["t"];
    row = {{unknownOf.at(at["edge"][0]), t}, {unknownOf.at(at["edge"][1]), 1 - t}};
  }
  if (at.contains("face")) {
    const auto corners = model_.mesh.faces[at["face"].get<Index>()];
    for (std::size_t k = 0; k < corners.size(); ++k) row.emplace_back(unknownOf[corners[k]], at["weights"][k]);
  }
  projectRow(gradient, row);
}

}  // namespace holdfast::test

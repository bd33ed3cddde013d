#include "support/dense_operators.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace holdfast::test {
namespace {

using Corners = std::array<Vector3, 3>;

Corners cornersOf(const Mesh& mesh, const Triangle& triangle, double unit)
{
  return {Vector3(mesh.positions.row(triangle[0])) / unit, Vector3(mesh.positions.row(triangle[1])) / unit,
          Vector3(mesh.positions.row(triangle[2])) / unit};
}

double angle(const Corners& p, int k)
{
  const Vector3 u = (p[(k + 1) % 3] - p[k]).normalized();
  const Vector3 v = (p[(k + 2) % 3] - p[k]).normalized();
  return 2 * std::atan2((u - v).norm(), (u + v).norm());
}

double cotangent(const Corners& p, int k)
{
  return std::tan(std::numbers::pi / 2 - angle(p, k));
}

double voronoiArea(const Corners& p, int k)
{
  double sum = 0;
  for (const int other : {(k + 1) % 3, (k + 2) % 3})
    sum += (p[other] - p[k]).squaredNorm() / std::tan(angle(p, 3 - k - other)) / 8;
  return sum;
}

double mixedArea(const Corners& p, int k)
{
  const double area = (p[1] - p[0]).norm() * (p[2] - p[0]).norm() * std::sin(angle(p, 0)) / 2;
  for (int j = 0; j < 3; ++j)
    if (angle(p, j) > std::numbers::pi / 2 + 1e-12) return area / (j == k ? 2 : 4);
  return voronoiArea(p, k);
}

Eigen::VectorXd areas(const Mesh& mesh, const std::vector<Triangle>& triangles, Weights weights, double unit)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(mesh.vertexCount());
  for (const Triangle& triangle : triangles)
    for (int k = 0; k < 3; ++k) {
      const Corners p = cornersOf(mesh, triangle, unit);
      result[triangle[k]] += weights == Weights::Cotangent ? mixedArea(p, k) : voronoiArea(p, k);
    }
  return result;
}

Eigen::MatrixXd denseCotangentL(const Mesh& mesh, const std::vector<Triangle>& triangles, Weights weights, double unit)
{
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(mesh.vertexCount(), mesh.vertexCount());
  for (const Triangle& triangle : triangles)
    for (int k = 0; k < 3; ++k) {
      const Index i = triangle[(k + 1) % 3];
      const Index j = triangle[(k + 2) % 3];
      const double weight = cotangent(cornersOf(mesh, triangle, unit), k);
      L(i, j) -= weight;
      L(j, i) -= weight;
      L(i, i) += weight;
      L(j, j) += weight;
    }
  return (2 * areas(mesh, triangles, weights, unit)).cwiseInverse().asDiagonal() * L;
}

Eigen::MatrixXd denseUniformL(Index n, const std::vector<Triangle>& triangles)
{
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n);
  for (const Triangle& triangle : triangles)
    for (const Index i : triangle)
      for (const Index j : triangle)
        if (i != j) L(i, j) = -1;
  for (Index i = 0; i < n; ++i) {
    L.row(i) /= std::max(1.0, -L.row(i).sum());
    L(i, i) = -L.row(i).sum();
  }
  return L;
}

/// The row of one point, and its place at rest.
struct RowOf {
  const Mesh& mesh;

  Eigen::RowVectorXd operator()(const AtVertex& at) const
  {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(mesh.vertexCount());
    row[at.vertex] = 1;
    return row;
  }
  Eigen::RowVectorXd operator()(const AtEdge& at) const
  {
    return at.t * (*this)(AtVertex{at.i}) + (1 - at.t) * (*this)(AtVertex{at.j});
  }
  Eigen::RowVectorXd operator()(const AtFace& at) const
  {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(mesh.vertexCount());
    for (std::size_t k = 0; k < at.weights.size(); ++k) row[mesh.faces[at.face][k]] += at.weights[k];
    return row;
  }
  Eigen::RowVectorXd operator()(const AtNear& /*at*/) const
  {
    ADD_FAILURE() << "there is no second search for the closest point here";
    return Eigen::RowVectorXd::Zero(mesh.vertexCount());
  }
};

}  // namespace

Eigen::MatrixXd denseL(const Mesh& mesh, const std::vector<Triangle>& triangles, Weights weights, double unit)
{
  if (weights == Weights::Uniform) return denseUniformL(mesh.vertexCount(), triangles);
  return denseCotangentL(mesh, triangles, weights, unit);
}

Eigen::VectorXd denseRowWeights(const Mesh& mesh, const std::vector<Triangle>& triangles, Weights weights, double unit)
{
  if (weights != Weights::Cotangent) return Eigen::VectorXd::Ones(mesh.vertexCount());
  return areas(mesh, triangles, weights, unit).cwiseSqrt();
}

DenseRows denseRows(const ConstraintList& list, const Mesh& mesh)
{
  const auto count = static_cast<Index>(list.constraints.size());
  DenseRows rows{Eigen::MatrixXd(count, mesh.vertexCount()), Eigen::MatrixX3d(count, 3)};
  for (Index c = 0; c < count; ++c) {
    const auto& point = std::get<PointConstraint>(list.constraints[c].what);
    rows.B.row(c) = std::visit(RowOf{mesh}, point.at);
    if (const auto* move = std::get_if<Move>(&point.to))
      rows.shifts.row(c) = move->shift;
    else
      rows.shifts.row(c) = std::get<Target>(point.to).place.transpose() - rows.B.row(c) * mesh.positions;
  }
  return rows;
}

DenseProblem denseProblem(const Mesh& mesh, const ConstraintList& list, Weights weights)
{
  const std::vector<Triangle> triangles = triangulate(mesh).triangles;
  const double unit = (mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff()).norm();
  DenseRows rows = denseRows(list, mesh);
  return {denseRowWeights(mesh, triangles, weights, unit).asDiagonal() * denseL(mesh, triangles, weights, unit),
          std::move(rows.B), std::move(rows.shifts)};
}

}  // namespace holdfast::test

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <holdfast/surface/ray_caster.h>
#include <holdfast/threads/parallel.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"

namespace holdfast {
namespace {

/// What a ray does with one triangle, by solving origin + t direction = a + u (b - a) + v (c - a).
struct PlainHit {
  double t = 0;
  Vector3 weights = Vector3::Zero();

  [[nodiscard]] bool isInside() const { return t > 0 && weights.minCoeff() >= 0; }
  /// Tells whether rounding could decide.
  [[nodiscard]] bool isClose() const { return std::abs(weights.minCoeff()) < 1e-9 || std::abs(t) < 1e-9; }
};

PlainHit plainHit(const Ray& ray, const Positions& positions, const Triangle& triangle)
{
  const Vector3 a = positions.row(triangle[0]);
  Eigen::Matrix3d M;
  M.col(0) = positions.row(triangle[1]).transpose() - a;
  M.col(1) = positions.row(triangle[2]).transpose() - a;
  M.col(2) = -ray.direction;
  const Vector3 uvt = M.fullPivLu().solve(ray.origin - a);
  return {uvt[2], {1 - uvt[0] - uvt[1], uvt[0], uvt[1]}};
}

/// The first hit over all triangles; -1 where there is none, -2 where rounding decides.
Index plainFirst(const Ray& ray, const Positions& positions, const std::vector<Triangle>& triangles)
{
  double least = std::numeric_limits<double>::infinity();
  Index first = -1;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const PlainHit hit = plainHit(ray, positions, triangles[t]);
    if (hit.isClose()) return -2;
    if (!hit.isInside() || hit.t >= least) continue;
    least = hit.t;
    first = static_cast<Index>(t);
  }
  return first;
}

/// Random rays meet what a search through all triangles finds, at the place that the weights say.
void expectPlainHits(const RayCaster& caster, const Positions& positions, const std::vector<Triangle>& triangles,
                     test::Random& random)
{
  int hits = 0;
  for (int k = 0; k < 300; ++k) {
    const Vector3 origin = test::randomVector(random, 6);
    const Vector3 vertex = positions.row(random.integer(0, positions.rows() - 1));
    const Ray ray{origin, vertex + test::randomVector(random, 1) - origin};
    const Index expected = plainFirst(ray, positions, triangles);
    if (expected == -2) continue;
    const std::optional<RayHit> hit = caster.firstHit(ray);
    ASSERT_EQ(hit ? hit->triangle : -1, expected);
    if (!hit) continue;
    ++hits;
    const PlainHit plain = plainHit(ray, positions, triangles[expected]);
    EXPECT_NEAR(hit->t, plain.t, 1e-11 * (1 + plain.t));
    Vector3 place = Vector3::Zero();
    for (int c = 0; c < 3; ++c) {
      EXPECT_GE(hit->weights[c], 0);
      place += hit->weights[c] * positions.row(triangles[expected][c]).transpose();
    }
    EXPECT_NEAR(hit->weights[0] + hit->weights[1] + hit->weights[2], 1, 1e-15);
    EXPECT_NEAR((place - ray.origin - hit->t * ray.direction).norm(), 0, 1e-13 * (1 + hit->t));
  }
  EXPECT_GT(hits, 50);
}

TEST(RayCaster, FirstHitsAreThoseOfASearchThroughAllTriangles)
{
  test::Random random(11);
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const std::vector<Triangle> triangles = triangulate(named.mesh).triangles;
    expectPlainHits(RayCaster(named.mesh.positions, triangles), named.mesh.positions, triangles, random);
  }
}

TEST(RayCaster, HitsFollowTheSurface)
{
  test::Random random(12);
  const Mesh mesh = test::plate(7, 5);
  const std::vector<Triangle> triangles = triangulate(mesh).triangles;
  const RayCaster atRest(mesh.positions, triangles);
  Positions crumpled = mesh.positions;
  for (Index v = 0; v < mesh.vertexCount(); ++v) crumpled.row(v) += test::randomVector(random, 2).transpose();
  const RayCaster moved = atRest.movedTo(std::make_shared<const Positions>(crumpled));
  EXPECT_EQ(moved.positions(), crumpled);
  expectPlainHits(moved, crumpled, triangles, random);
  expectPlainHits(atRest, mesh.positions, triangles, random);
}

TEST(RayCaster, AnswersSeveralThreadsAtOnceAsOneThatWasPrepared)
{
  const Mesh mesh = test::icosphere(4);
  const RayCaster atRest(mesh.positions, triangulate(mesh).triangles);
  const auto stretched = std::make_shared<const Positions>(2 * mesh.positions);
  const RayCaster prepared = atRest.movedTo(stretched);
  prepared.prepare();
  const RayCaster moved = atRest.movedTo(stretched);
  std::vector<std::optional<RayHit>> hits(64);
  const auto ray = [&](Index k) { return Ray{Vector3::Zero(), mesh.positions.row(k).transpose()}; };
  parallelFor(static_cast<Index>(hits.size()), [&](Index k) { hits[k] = moved.firstHit(ray(k)); });
  for (Index k = 0; k < static_cast<Index>(hits.size()); ++k) {
    const std::optional<RayHit> expected = prepared.firstHit(ray(k));
    ASSERT_TRUE(hits[k] && expected) << k;
    EXPECT_NEAR(hits[k]->t, 2, 0.01) << k;
    EXPECT_EQ(hits[k]->triangle, expected->triangle) << k;
    EXPECT_EQ(hits[k]->t, expected->t) << k;
  }
}

TEST(RayCaster, RaysDoNotSlipThroughEdgesAndVertices)
{
  test::Random random(13);
  const Mesh mesh = test::icosphere(3);
  const RayCaster caster(mesh.positions, triangulate(mesh).triangles);
  for (int k = 0; k < 20000; ++k) {
    const auto face = mesh.faces[random.integer(0, mesh.faces.size() - 1)];
    const double share = k % 4 == 0 ? 1 : random.uniform(0, 1);
    const Vector3 onEdge = share * mesh.positions.row(face[0]) + (1 - share) * mesh.positions.row(face[1]);
    const Vector3 origin = test::randomVector(random, 0.5);
    ASSERT_TRUE(caster.firstHit({origin, onEdge - origin})) << "the origin is enclosed by the sphere";
  }
}

TEST(RayCaster, RaysAlongAxesMeetFlatGridsOnTheirLines)
{
  const Mesh mesh = test::grid(8, 8);
  const RayCaster caster(mesh.positions, triangulate(mesh).triangles);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vector3 vertex = mesh.positions.row(v);
    EXPECT_TRUE(caster.firstHit({vertex + Vector3(0, 0, 3), {0, 0, -1}}));
    EXPECT_TRUE(caster.firstHit({vertex - Vector3(0, 0, 3), {0, 0, 1}})) << "from behind";
    EXPECT_FALSE(caster.firstHit({vertex + Vector3(0, 0, 3), {0, 0, 1}})) << "away";
    EXPECT_FALSE(caster.firstHit({vertex + Vector3(0, 0, 3), {1, 0, 0}})) << "beside";
  }
}

TEST(RayCaster, OfTrianglesAtOnePlaceTheFirstIsHit)
{
  Mesh mesh = test::grid(8, 8);
  const Index single = mesh.faces.size();
  for (Index f = 0; f < single; ++f) mesh.faces.add(mesh.faces[f]);
  const RayCaster caster(mesh.positions, triangulate(mesh).triangles);
  test::Random random(14);
  for (int k = 0; k < 200; ++k) {
    const auto hit = caster.firstHit({{random.uniform(0, 8), random.uniform(0, 8), 5}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    EXPECT_LT(hit->triangle, single);
  }
}

TEST(RayCaster, IgnoredTrianglesDoNotBlock)
{
  const Mesh mesh = test::merged(test::grid(1, 1), test::moved(test::grid(1, 1), {0, 0, -1}));
  const RayCaster caster(mesh.positions, triangulate(mesh).triangles);
  const Ray down{{0.6, 0.3, 1}, {0, 0, -1}};
  EXPECT_TRUE(caster.isBlocked(down, 3, {}));
  EXPECT_FALSE(caster.isBlocked(down, 0.9, {}));
  const std::vector<Index> upper{0, 1};
  EXPECT_TRUE(caster.isBlocked(down, 3, upper)) << "by the lower one";
  EXPECT_FALSE(caster.isBlocked(down, 1.9, upper));
  const std::vector<Index> all{0, 1, 2, 3};
  EXPECT_FALSE(caster.isBlocked(down, 3, all));
}

TEST(RayCaster, WhatLiesOutsideOfTheRangeIsNotMet)
{
  const Mesh mesh = test::merged(test::grid(1, 1), test::moved(test::grid(1, 1), {0, 0, -1}));
  const RayCaster caster(mesh.positions, triangulate(mesh).triangles);
  const Ray down{{0.6, 0.3, 1}, {0, 0, -1}};
  EXPECT_EQ(caster.firstHit(down, {0.5, 3})->t, 1);
  EXPECT_EQ(caster.firstHit(down, {1, 1})->t, 1) << "both ends belong to it";
  EXPECT_EQ(caster.firstHit(down, {1.5})->t, 2);
  EXPECT_FALSE(caster.firstHit(down, {1.2, 1.8}));
  EXPECT_FALSE(caster.firstHit(down, {2.5, 0.5}));
  EXPECT_TRUE(caster.isBlocked(down, 3, {}, 1.5));
  EXPECT_FALSE(caster.isBlocked(down, 1.9, {}, 1.5));
}

TEST(RayCaster, WithoutSomeTrianglesMeetsTheOthersAsIfTheyWereAlone)
{
  test::Random random(23);
  int hits = 0;
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const std::vector<Triangle> triangles = triangulate(named.mesh).triangles;
    auto isLeftOut = std::make_shared<std::vector<char>>();
    std::vector<Triangle> others;
    std::vector<Index> numberOf;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      isLeftOut->push_back(random.uniform(0, 1) < 0.5 ? 1 : 0);
      if (isLeftOut->back() != 0) continue;
      others.push_back(triangles[t]);
      numberOf.push_back(static_cast<Index>(t));
    }
    const RayCaster all(named.mesh.positions, triangles);
    const RayCaster some = all.without(isLeftOut).movedTo(std::make_shared<const Positions>(named.mesh.positions));
    const RayCaster alone(named.mesh.positions, others);
    for (int k = 0; k < 100; ++k) {
      const Vector3 origin = test::randomVector(random, 6);
      const Vector3 vertex = named.mesh.positions.row(random.integer(0, named.mesh.vertexCount() - 1));
      const Ray ray{origin, vertex + test::randomVector(random, 0.3) - origin};
      const auto hit = some.firstHit(ray);
      const auto expected = alone.firstHit(ray);
      ASSERT_EQ(hit.has_value(), expected.has_value());
      EXPECT_EQ(some.isBlocked(ray, 2, {}), alone.isBlocked(ray, 2, {}));
      for (const Index t : some.withinReach(ray, {0.1, 0})) EXPECT_FALSE(some.isLeftOut(t));
      if (!hit) continue;
      ++hits;
      EXPECT_EQ(hit->triangle, numberOf[expected->triangle]);
      EXPECT_EQ(hit->t, expected->t);
    }
    EXPECT_EQ(some.cutBy(named.mesh.positions.colwise().mean(), {0.3, 0.5, 0.7}).size(),
              alone.cutBy(named.mesh.positions.colwise().mean(), {0.3, 0.5, 0.7}).size());
    EXPECT_FALSE(some.without(nullptr).isLeftOut(0));
  }
  EXPECT_GT(hits, 100);
}

TEST(RayCaster, NothingWithinReachIsLeftOut)
{
  test::Random random(15);
  std::size_t inReach = 0;
  std::size_t found = 0;
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const std::vector<Triangle> triangles = triangulate(named.mesh).triangles;
    const RayCaster caster(named.mesh.positions, triangles);
    for (int k = 0; k < 100; ++k) {
      const Vector3 origin = test::randomVector(random, 6);
      const Vector3 vertex = named.mesh.positions.row(random.integer(0, named.mesh.vertexCount() - 1));
      const Ray ray{origin, vertex + test::randomVector(random, 0.3) - origin};
      const RayReach reach{k % 2 == 0 ? 0.1 : 0.0, k % 3 == 0 ? 0.0 : 0.02};
      const std::vector<Index> near = caster.withinReach(ray, reach);
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      found += near.size();
      for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int sample = 0; sample < 5; ++sample) {
          const double share = random.uniform(0, 1);
          const Vector3 place = share * named.mesh.positions.row(triangles[t][0]) +
                                (1 - share) * named.mesh.positions.row(triangles[t][1]);
          const double at = (place - ray.origin).dot(ray.direction) / ray.direction.squaredNorm();
          if (at < 0 || (place - ray.origin - at * ray.direction).norm() > reach.radius + reach.slope * at) continue;
          ++inReach;
          ASSERT_TRUE(std::binary_search(near.begin(), near.end(), static_cast<Index>(t)));
        }
    }
  }
  EXPECT_GT(inReach, 100U);
  EXPECT_LT(found, 8000U) << "of 600 times some hundred triangles";
}

TEST(RayCaster, ReachesOfACylinderThroughAFlatGridAreTheSquaresAround)
{
  const Mesh mesh = test::grid(8, 8);
  const RayCaster caster(mesh.positions, triangulate(mesh).triangles);
  EXPECT_EQ(caster.withinReach({{3.5, 3.5, 5}, {0, 0, -1}}, {0.2, 0}).size(), 2U);
  EXPECT_EQ(caster.withinReach({{3.5, 3.5, 5}, {0, 0, -1}}, {0.6, 0}).size(), 18U);
  EXPECT_EQ(caster.withinReach({{3.5, 3.5, 5}, {0, 0, -1}}, {0, 0.12}).size(), 18U) << "0.6 at the grid";
  EXPECT_EQ(caster.withinReach({{3.5, 3.5, 5}, {0, 0, -1}}, {0, 2}).size(), 128U) << "everything";
}

TEST(RayCaster, TrianglesWithoutAreaAreNotHit)
{
  const Mesh needle = test::triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
  const RayCaster caster(needle.positions, {{0, 1, 2}, {0, 0, 1}});
  EXPECT_FALSE(caster.firstHit({{0.5, 0, 1}, {0, 0, -1}}));
  EXPECT_FALSE(RayCaster(needle.positions, {}).firstHit({{0.5, 0, 1}, {0, 0, -1}}));
}

TEST(RayCaster, APlaneCutsAClosedSurfaceInClosedLines)
{
  const Mesh mesh = test::icosphere(4);
  const std::vector<Triangle> triangles = triangulate(mesh).triangles;
  const RayCaster caster(mesh.positions, triangles);
  const Vector3 normal = Vector3(0.3, -0.5, 1.7);
  for (const double height : {0.0, 0.31, -0.9}) {
    const Vector3 origin = height * normal.normalized();
    std::size_t crossed = 0;
    for (const Triangle& triangle : triangles) {
      int above = 0;
      for (const Index v : triangle) above += (Vector3(mesh.positions.row(v)) - origin).dot(normal) >= 0 ? 1 : 0;
      crossed += above % 3 != 0 ? 1 : 0;
    }
    const auto segments = caster.cutBy(origin, normal);
    EXPECT_EQ(segments.size(), crossed);
    double length = 0;
    for (const auto& segment : segments) {
      length += (segment[1] - segment[0]).norm();
      for (const Vector3& end : segment) {
        EXPECT_NEAR((end - origin).dot(normal), 0, 1e-14);
        const auto isHere = [&](const Vector3& place) { return (place - end).norm() < 1e-14; };
        const auto ends = std::count_if(segments.begin(), segments.end(),
                                        [&](const auto& other) { return isHere(other[0]) != isHere(other[1]); });
        EXPECT_EQ(ends, 2) << "the next segment begins where one ends";
      }
    }
    EXPECT_NEAR(length, 2 * std::numbers::pi * std::sqrt(1 - height * height), 0.01);
  }
  EXPECT_TRUE(caster.cutBy(2 * normal, normal).empty());
}

}  // namespace
}  // namespace holdfast

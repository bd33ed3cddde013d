#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <holdfast/geometry/bounding_box.h>
#include <holdfast/widgets/picking/surface_picker.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "widgets/plain_view.h"
#include "widgets/screen_vertices.h"

namespace holdfast {
namespace {

using test::PlainView;
using test::Projection;

constexpr double kSnapOfCut = 8;

/// What is left of triangles when a plane has cut them, as triangles. Vertices keep their ids; those on the plane
/// follow.
struct CutTriangles {
  CutTriangles(const Model& model, const Positions& from, const SectionPlane& plane) : positions(from)
  {
    const std::vector<Triangle>& all = model.triangulation.triangles;
    for (std::size_t t = 0; t < all.size(); ++t) {
      const std::vector<int> corners = cut(all[t], plane);
      for (std::size_t k = 2; k < corners.size(); ++k) {
        triangles.push_back({corners[0], corners[k - 1], corners[k]});
        source.push_back(static_cast<Index>(t));
      }
    }
  }

  Positions positions;
  std::vector<Triangle> triangles;
  std::vector<Index> source;  // the triangle that each was cut from

 private:
  std::vector<int> cut(const Triangle& triangle, const SectionPlane& plane)
  {
    const auto height = [&](Index v) { return (positions.row(v).transpose() - plane.origin).dot(plane.normal); };
    std::vector<int> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangle[k];
      const int b = triangle[(k + 1) % 3];
      const double ha = height(a);
      const double hb = height(b);
      if (ha >= 0) corners.push_back(a);
      if ((ha < 0) == (hb < 0)) continue;
      positions.conservativeResize(positions.rows() + 1, 3);
      positions.bottomRows(1) = (hb * positions.row(a) - ha * positions.row(b)) / (hb - ha);
      corners.push_back(static_cast<int>(positions.rows()) - 1);
    }
    return corners;
  }
};

/// A mesh and a plane through it, seen from somewhere.
struct Cut {
  Cut(const test::NamedMesh& named, Projection projection, test::Random& random)
      : model(makeModel(named.mesh, named.name)), screen(view)
  {
    const Positions& rest = model.mesh.positions;
    const Vector3 middle = rest.colwise().mean().transpose();
    const Vector3 away(random.uniform(0.2, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    view = {middle + 2 * boundingBoxDiagonal(rest) * away.normalized(), middle, projection};
    screen.look(view);
    const Vector3 normal(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    plane = {middle, 3 * normal};
    // Bent, so that a surface which has moved is looked at.
    auto bent = std::make_shared<Positions>(rest);
    bent->col(2) += 0.1 * rest.col(0);
    whole = std::make_shared<const VisibleSurface>(VisibleSurface(model).movedTo(bent));
    kept = std::make_shared<const VisibleSurface>(VisibleSurface(model).withSection(plane).movedTo(bent));
    plain.emplace(model, *bent, plane);
  }

  [[nodiscard]] Index triangleAt(const std::shared_ptr<const VisibleSurface>& surface, const Eigen::Vector2d& pixel)
  {
    const auto pick = SurfacePicker(surface).pick(screen.renderer(), pixel.x(), pixel.y(), PickKind::Face, 0);
    return pick ? pick->triangle : -1;
  }

  Model model;
  PlainView view;
  test::PlainScreen screen;
  SectionPlane plane;
  std::shared_ptr<const VisibleSurface> whole;
  std::shared_ptr<const VisibleSurface> kept;
  std::optional<CutTriangles> plain;
};

template <class Check>
void forEachCut(std::uint32_t seed, Check&& check)
{
  test::Random random(seed);
  for (const test::NamedMesh& named : test::lawMeshes())
    for (const Projection projection : {Projection::Perspective, Projection::Parallel})
      for (int k = 0; k < 3; ++k) {
        SCOPED_TRACE(named.name + (projection == Projection::Parallel ? ", parallel" : ", perspective"));
        Cut cut(named, projection, random);
        check(cut, random);
      }
}

TEST(SectionPlane, FacePicksAreThoseOfASearchThroughTheTrianglesThatAreLeft)
{
  int hits = 0;
  int mistakesWithoutSection = 0;
  forEachCut(71, [&](Cut& cut, test::Random& random) {
    for (int k = 0; k < 60; ++k) {
      const Eigen::Vector2d pixel(static_cast<double>(random.integer(0, cut.view.width - 1)),
                                  static_cast<double>(random.integer(0, cut.view.height - 1)));
      const test::PlainSight sight =
          test::plainSight(cut.view, pixel + Eigen::Vector2d(0.5, 0.5), cut.plain->positions, cut.plain->triangles);
      if (sight.isDoubtful) continue;
      const Index expected = sight.triangle < 0 ? -1 : cut.plain->source[sight.triangle];
      ASSERT_EQ(cut.triangleAt(cut.kept, pixel), expected) << pixel.transpose();
      hits += expected >= 0 ? 1 : 0;
      mistakesWithoutSection += cut.triangleAt(cut.whole, pixel) != expected ? 1 : 0;
    }
  });
  EXPECT_GT(hits, 200);
  EXPECT_GT(mistakesWithoutSection, 100) << "otherwise the search proves nothing";
}

TEST(SectionPlane, SelectedVerticesAreKeptAndHiddenByKeptTrianglesAlone)
{
  const std::vector<DisplayPoint> everything{{-10, -10}, {1000, -10}, {1000, 1000}, {-10, 1000}};
  int cutAway = 0;
  int uncovered = 0;
  forEachCut(72, [&](Cut& cut, test::Random&) {
    const auto select = [&](const std::shared_ptr<const VisibleSurface>& surface, ScreenReach reach) {
      return test::verticesInScreenPolygon(cut.screen.renderer(), surface, everything, reach);
    };
    const auto visible = select(cut.kept, ScreenReach::VisibleOnly);
    const auto through = select(cut.kept, ScreenReach::Through);
    const auto visibleOfWhole = select(cut.whole, ScreenReach::VisibleOnly);
    const auto throughWhole = select(cut.whole, ScreenReach::Through);
    for (const Index v : throughWhole) {
      const Vector3 place = cut.whole->positions().row(v);
      const bool isKept = (place - cut.plane.origin).dot(cut.plane.normal) >= 0;
      EXPECT_EQ(std::binary_search(through.begin(), through.end(), v), isKept) << v;
      cutAway += isKept ? 0 : 1;
      const auto isVisible = test::isPlainlyVisible(cut.view, place, {v}, cut.plain->positions, cut.plain->triangles);
      if (!isVisible) continue;
      EXPECT_EQ(std::binary_search(visible.begin(), visible.end(), v), isKept && *isVisible) << v;
      uncovered += isKept && *isVisible && !std::binary_search(visibleOfWhole.begin(), visibleOfWhole.end(), v) ? 1 : 0;
    }
  });
  EXPECT_GT(cutAway, 100);
  EXPECT_GT(uncovered, 20) << "vertices that only what is cut away has hidden";
}

TEST(SectionPlane, VerticesNearTheCursorAreThoseThatAreKept)
{
  int snapped = 0;
  forEachCut(73, [&](Cut& cut, test::Random&) {
    for (Index v = 0; v < cut.model.mesh.vertexCount(); ++v) {
      const Eigen::Vector2d pixel = cut.view.shown(cut.whole->positions().row(v)).head<2>().array().floor();
      for (const PickKind kind : {PickKind::Nearest, PickKind::Vertex, PickKind::Edge}) {
        const auto pick = SurfacePicker(cut.kept).pick(cut.screen.renderer(), pixel.x(), pixel.y(), kind, kSnapOfCut);
        if (!pick) continue;
        ++snapped;
        EXPECT_GE((pick->place - cut.plane.origin).dot(cut.plane.normal), -1e-12 * cut.model.solverMesh.diagonal);
      }
    }
  });
  EXPECT_GT(snapped, 500);
}

/// Two plates of one square, one in front of the other, and a plane that cuts both along x = 0.1.
struct CutPlates : testing::Test {
  [[nodiscard]] std::optional<SurfacePick> pick(const Vector3& place, PickKind kind,
                                                const std::optional<SectionPlane>& plane)
  {
    const VisibleSurface surface = VisibleSurface(model).withSection(plane);
    const Eigen::Vector2d pixel = view.shown(place).head<2>().array().floor();
    return SurfacePicker(std::make_shared<const VisibleSurface>(surface))
        .pick(screen.renderer(), pixel.x(), pixel.y(), kind, kSnapOfCut);
  }

  const Mesh plate = test::moved(test::grid(1, 1), {-0.5, -0.5, 0});
  Model model = makeModel(test::merged(test::moved(plate, {0, 0, 1}), plate), "plates");
  PlainView view{{0, 0, 9}, {0, 0, 0}, Projection::Parallel};
  test::PlainScreen screen{view};
};

TEST_F(CutPlates, WhatIsCutAwayHidesNothing)
{
  const SectionPlane behind{{0, 0, 0.5}, {0, 0, -1}};
  const SectionPlane before{{0, 0, 0.5}, {0, 0, 1}};
  EXPECT_NEAR(pick({0.2, -0.1, 0}, PickKind::Face, behind)->place.z(), 0, 1e-12);
  EXPECT_NEAR(pick({0.2, -0.1, 0}, PickKind::Face, before)->place.z(), 1, 1e-12);
  EXPECT_EQ(std::get<AtVertex>(pick({0.5, 0.5, 0}, PickKind::Nearest, behind)->location).vertex, 7);
  EXPECT_EQ(std::get<AtVertex>(pick({0.5, 0.5, 0}, PickKind::Nearest, before)->location).vertex, 3);
}

TEST_F(CutPlates, OnThePlaneItselfTheSurfaceIsKept)
{
  const SectionPlane through{{0, 0, 1}, {0, 0, -1}};
  EXPECT_NEAR(pick({0.2, -0.1, 0}, PickKind::Face, through)->place.z(), 1, 1e-12);
  EXPECT_EQ(std::get<AtVertex>(pick({0.5, 0.5, 0}, PickKind::Vertex, through)->location).vertex, 3);
  EXPECT_FALSE(pick({0.5, 0.5, 0}, PickKind::Vertex, SectionPlane{{0, 0, 2}, {0, 0, 1}}));
}

TEST_F(CutPlates, EdgesAreTakenAsFarAsTheyAreKept)
{
  const SectionPlane plane{{0.1, 0, 0}, {1, 0, 0}};
  const auto inside = pick({0.3, -0.5, 1}, PickKind::Edge, plane);
  ASSERT_TRUE(inside);
  EXPECT_NEAR(std::get<AtEdge>(inside->location).t, 0.2, 0.01) << "from the vertices 0 to 1";
  // A little beyond the cut, its end is in reach.
  const auto beyond = pick({0.06, -0.5, 1}, PickKind::Nearest, plane);
  ASSERT_TRUE(beyond);
  EXPECT_NEAR(std::get<AtEdge>(beyond->location).t, 0.4, 1e-12);
  EXPECT_NEAR(beyond->place.x(), 0.1, 1e-12);
  EXPECT_FALSE(pick({-0.3, -0.5, 1}, PickKind::Nearest, plane));
}

TEST_F(CutPlates, AnEdgeThatIsNotCutIsPickedAsWithoutAPlane)
{
  const SectionPlane aside{{-7, 0, 0}, {1, 0, 0}};
  const auto cut = pick({0.123, -0.5, 1}, PickKind::Edge, aside);
  const auto whole = pick({0.123, -0.5, 1}, PickKind::Edge, std::nullopt);
  ASSERT_TRUE(cut && whole);
  EXPECT_EQ(std::get<AtEdge>(cut->location).t, std::get<AtEdge>(whole->location).t) << "bit for bit";
}

TEST_F(CutPlates, TheSectionCanBeTakenAway)
{
  const VisibleSurface whole(model);
  const VisibleSurface cut = whole.withSection(SectionPlane{{0, 0, 0.5}, {0, 0, -1}});
  EXPECT_EQ(cut.section(), (SectionPlane{{0, 0, 0.5}, {0, 0, -1}}));
  EXPECT_TRUE(cut.isSameMesh(whole));
  const Ray down{{0.2, -0.1, 5}, {0, 0, -1}};
  EXPECT_NEAR(cut.firstHit(down)->t, 5, 1e-12);
  EXPECT_NEAR(cut.withSection(std::nullopt).firstHit(down)->t, 4, 1e-12);
}

}  // namespace
}  // namespace holdfast

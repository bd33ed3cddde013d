// The plane that cuts the picture open, as a user meets it.

#include <QAction>
#include <QImage>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <holdfast/widgets/camera/camera_state.h>

#include "dialogs.h"
#include "gestures.h"
#include "support/temporary_folder.h"
#include "window_user.h"

namespace holdfast {
namespace {

using test::PlainSight;

/// How many pixels of two pictures differ.
int differing(const QImage& a, const QImage& b)
{
  if (a.size() != b.size()) return a.width() * a.height();
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return count;
}

/// The bracket with its measured points, from the front and above.
class SectionInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    view.eye = {120, 200, 380};
    view.target = {0, 0, 20};
    look(view);
    viewport().setFocus();
  }

  void cut()
  {
    key(Qt::Key_S, Qt::ShiftModifier);
    ASSERT_TRUE(settle());
    ASSERT_TRUE(viewport().section().has_value());
  }

  [[nodiscard]] const SectionPlane& plane() { return *viewport().section(); }
  [[nodiscard]] const std::vector<Triangle>& triangles() { return editor().model()->triangulation.triangles; }
  [[nodiscard]] QImage picture() { return viewport().grabFramebuffer(); }

  [[nodiscard]] bool isCutAway(const Vector3& place) { return (place - plane().origin).dot(plane().normal) < 0; }
  [[nodiscard]] Vector3 cornerOf(Index triangle, int corner)
  {
    return editor().positions().row(triangles()[triangle][corner]).transpose();
  }
  [[nodiscard]] int cornersCutAway(Index triangle)
  {
    int count = 0;
    for (int corner = 0; corner < 3; ++corner) count += isCutAway(cornerOf(triangle, corner)) ? 1 : 0;
    return count;
  }

  /// The middle of the pixel that shows the middle of a triangle.
  [[nodiscard]] Eigen::Vector2d pixelOf(Index triangle)
  {
    const Vector3 middle = (cornerOf(triangle, 0) + cornerOf(triangle, 1) + cornerOf(triangle, 2)) / 3;
    return view.shown(middle).head<2>().array().floor() + 0.5;
  }

  /// The first triangle on the line of sight of those that are cut away by no more than `mostCorners` corners.
  [[nodiscard]] Index seenAtPixel(const Eigen::Vector2d& pixel, int mostCorners)
  {
    std::vector<Triangle> left;
    std::vector<Index> source;
    for (Index t = 0; t < static_cast<Index>(triangles().size()); ++t) {
      if (cornersCutAway(t) > mostCorners) continue;
      left.push_back(triangles()[t]);
      source.push_back(t);
    }
    const PlainSight sight = test::plainSight(view, pixel, editor().positions(), left);
    if (sight.isDoubtful) return kDoubtful;
    return sight.triangle < 0 ? -1 : source[sight.triangle];
  }

  /// A kept triangle before which something is cut away, and no other is left.
  [[nodiscard]] Index uncoveredTriangle()
  {
    for (Index t = 0; t < static_cast<Index>(triangles().size()); ++t)
      if (cornersCutAway(t) == 0 && seenAtPixel(pixelOf(t), 2) == t && seenAtPixel(pixelOf(t), 3) != t) return t;
    return -1;
  }

  /// A triangle that is cut away and seen without the cut, with nothing else on the line of sight.
  [[nodiscard]] Index removedTriangle()
  {
    for (Index t = 0; t < static_cast<Index>(triangles().size()); ++t)
      if (cornersCutAway(t) == 3 && seenAtPixel(pixelOf(t), 2) == -1 && seenAtPixel(pixelOf(t), 3) == t) return t;
    return -1;
  }

  /// The tip of the plane's arrow, or of its tail.
  [[nodiscard]] QPointF tipOfArrow(double side)
  {
    const Positions& positions = editor().positions();
    const double diagonal = (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).norm();
    return shownAt(plane().origin + side * 0.3 * 1.1 * diagonal * plane().normal);
  }

  /// Tells whether something of the mesh is seen there that is not cut away.
  [[nodiscard]] bool isOverMesh(const QPointF& place)
  {
    return SurfacePicker(viewport().surface())
        .pick(viewport().renderer(), place.x(), viewport().height() - place.y(), PickKind::Face, 0)
        .has_value();
  }

  /// On the plane, which is a little larger than the mesh, near a corner of it where nothing else is.
  [[nodiscard]] QPointF besideTheMesh()
  {
    const Vector3 low = editor().positions().colwise().minCoeff();
    const Vector3 high = editor().positions().colwise().maxCoeff();
    for (const double x : {1.04, -0.04})
      for (const double y : {1.04, -0.04}) {
        Vector3 corner = low + Vector3(x, y, 0).cwiseProduct(high - low);
        corner.z() = plane().origin.z();
        const QPointF place = shownAt(corner);
        if (!isOverMesh(place) && !viewport().legendBox().contains(place)) return place;
      }
    throw std::runtime_error("the mesh covers the plane");
  }

  void dragPlane(const QPointF& from, const QPointF& way)
  {
    test::drag(viewport(), {from, from + way / 3, from + way * 2 / 3, from + way});
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] QImage exported(const std::string& path)
  {
    window.exports().setChooser([&](QWidget*, const FileQuestion&) { return QString::fromStdString(path); });
    const test::DialogAnswer answer("pictureDialog", [](QDialog& dialog) {
      dialog.findChild<QSpinBox*>("width")->setValue(400);
      dialog.findChild<QSpinBox*>("height")->setValue(300);
      test::clickButton(dialog, "export");
    });
    window.exports().exportPicture();
    EXPECT_TRUE(test::waitUntil([&] { return !window.exports().isWriting(); }));
    return QImage(QString::fromStdString(path));
  }

  static constexpr Index kDoubtful = -2;
  test::PlainView view;
};

TEST_F(SectionInWindow, ComesAndGoesByKeyAndByMenu)
{
  const QImage whole = picture();
  cut();
  EXPECT_TRUE(find<QAction>("sectionPlane").isChecked());
  EXPECT_GT(differing(picture(), whole), 10'000);
  key(Qt::Key_S, Qt::ShiftModifier);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(viewport().section());
  EXPECT_EQ(differing(picture(), whole), 0);
  trigger("sectionPlane");
  EXPECT_TRUE(viewport().section());
  trigger("sectionPlane");
  EXPECT_FALSE(viewport().section());
}

TEST_F(SectionInWindow, GoesThroughTheMiddleAndTakesTheHalfBeforeIt)
{
  cut();
  const Positions& positions = editor().positions();
  const Vector3 middle = (positions.colwise().minCoeff() + positions.colwise().maxCoeff()).transpose() / 2;
  EXPECT_LT((plane().origin - middle).norm(), 1e-9 * editor().model()->solverMesh.diagonal);
  EXPECT_EQ(plane().normal, Vector3(0, 0, -1)) << "of all axes that is nearest to the sight";
}

TEST_F(SectionInWindow, WhatLiesBehindTheCutIsPickedThroughThePlane)
{
  trigger("toolPoint");
  test::pressKey(viewport(), Qt::Key_F);
  cut();
  const Index triangle = uncoveredTriangle();
  ASSERT_GE(triangle, 0);
  const auto count = list().constraints.size();
  test::click(viewport(), inWidget(pixelOf(triangle)));
  ASSERT_EQ(list().constraints.size(), count + 1);
  const auto* at = std::get_if<AtFace>(&std::get<PointConstraint>(list().constraints.back().what).at);
  ASSERT_NE(at, nullptr);
  EXPECT_EQ(at->face, editor().model()->triangulation.faceOf[triangle]);
}

TEST_F(SectionInWindow, WhatIsCutAwayIsNotPicked)
{
  trigger("toolPoint");
  test::pressKey(viewport(), Qt::Key_F);
  cut();
  const Index triangle = removedTriangle();
  ASSERT_GE(triangle, 0);
  const auto count = list().constraints.size();
  test::click(viewport(), inWidget(pixelOf(triangle)));
  EXPECT_EQ(list().constraints.size(), count);
  trigger("sectionPlane");
  test::click(viewport(), inWidget(pixelOf(triangle)));
  EXPECT_EQ(list().constraints.size(), count + 1) << "without the plane it is";
}

TEST_F(SectionInWindow, ToolsAndTheCameraReachTheSurfaceBehindThePlane)
{
  cut();
  const Index triangle = uncoveredTriangle();
  ASSERT_GE(triangle, 0);
  const QPointF place = inWidget(pixelOf(triangle));
  const SectionPlane before = plane();
  trigger("toolBrush");
  dragPlane(place, {6, 4});
  EXPECT_FALSE(editor().selectedVertices().empty());
  for (const Index v : editor().selectedVertices())
    EXPECT_FALSE(isCutAway(editor().positions().row(v).transpose())) << v;

  trigger("toolSelect");
  vtkCamera& camera = *viewport().renderer().GetActiveCamera();
  for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton}) {
    const Vector3 eye(camera.GetPosition());
    test::drag(viewport(), {place, place + QPointF(20, 0), place + QPointF(40, 0)}, button);
    ASSERT_TRUE(settle());
    EXPECT_NE(Vector3(camera.GetPosition()), eye);
  }
  EXPECT_EQ(plane(), before);
}

TEST_F(SectionInWindow, ItsArrowTurnsItWhateverToolIsChosen)
{
  const auto state = editor().history().state();
  const Positions positions = editor().positions();
  cut();
  for (const char* tool : {"toolSelect", "toolPoint", "toolBrush", "toolRuler"}) {
    trigger(tool);
    const SectionPlane before = plane();
    const QImage pictureBefore = picture();
    dragPlane(tipOfArrow(-1), {35, 20});
    EXPECT_GT((plane().normal.normalized() - before.normal.normalized()).norm(), 0.05) << tool;
    EXPECT_LT((plane().origin - before.origin).norm(), 1e-9 * editor().model()->solverMesh.diagonal) << tool;
    EXPECT_GT(differing(picture(), pictureBefore), 1000) << tool;
  }
  EXPECT_TRUE(editor().selectedVertices().empty());
  EXPECT_EQ(editor().history().state(), state);
  EXPECT_FALSE(editor().history().canUndo());
  EXPECT_EQ(editor().positions(), positions);
}

TEST_F(SectionInWindow, ItsBallMovesItAndBesideTheMeshItIsPushed)
{
  cut();
  const SectionPlane before = plane();
  trigger("toolBrush");
  ASSERT_TRUE(isOverMesh(shownAt(before.origin))) << "where the brush would paint";
  dragPlane(shownAt(before.origin), {30, 30});
  EXPECT_TRUE(editor().selectedVertices().empty());
  EXPECT_GT((plane().origin - before.origin).norm(), 1);
  EXPECT_EQ(plane().normal, before.normal);

  const SectionPlane moved = plane();
  dragPlane(besideTheMesh(), {0, 40});
  const Vector3 way = plane().origin - moved.origin;
  EXPECT_GT(std::abs(way.dot(moved.normal)), 1);
  EXPECT_LT(way.cross(moved.normal).norm(), 1e-9);
  EXPECT_EQ(plane().normal, moved.normal);
}

TEST_F(SectionInWindow, UndoGoesByIt)
{
  cut();
  const SectionPlane before = plane();
  const auto state = editor().history().state();
  trigger("toolPoint");
  const Index triangle = uncoveredTriangle();
  ASSERT_GE(triangle, 0);
  test::click(viewport(), inWidget(pixelOf(triangle)));
  ASSERT_TRUE(settle());
  ASSERT_NE(editor().history().state(), state);
  trigger("undo");
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().history().state(), state);
  EXPECT_EQ(plane(), before);
}

TEST_F(SectionInWindow, ConstraintsThatAreCutAwayAreNeitherSeenNorSelected)
{
  cut();
  int kept = 0;
  int removed = 0;
  for (const ConstraintMark& mark : viewport().marks()) {
    if (!isSinglePoint(mark.kind)) continue;
    const bool isAlone =
        std::none_of(viewport().marks().begin(), viewport().marks().end(), [&](const ConstraintMark& other) {
          const QPointF way = shownAt(other.place) - shownAt(mark.place);
          return other.constraint != mark.constraint && std::hypot(way.x(), way.y()) < 20;
        });
    if (!isAlone) continue;
    editor().selectConstraints({});
    ASSERT_TRUE(settle());
    test::click(viewport(), shownAt(mark.place));
    const std::vector<Index> expected = isCutAway(mark.place) ? std::vector<Index>{} : std::vector{mark.constraint};
    EXPECT_EQ(editor().selectedConstraints(), expected);
    (isCutAway(mark.place) ? removed : kept) += 1;
  }
  EXPECT_GT(kept, 0);
  EXPECT_GT(removed, 0);
}

TEST_F(SectionInWindow, PicturesThatAreExportedAreCutAsWell)
{
  const test::TemporaryFolder folder;
  const QImage whole = exported((folder.path() / "whole.png").string());
  trigger("sectionPlane");
  const QImage opened = exported((folder.path() / "cut.png").string());
  EXPECT_EQ(whole.size(), QSize(400, 300));
  EXPECT_GT(differing(whole, opened), 2000);
}

TEST_F(SectionInWindow, CutsTheNextDocumentThroughItsOwnMiddle)
{
  cut();
  dragPlane(tipOfArrow(-1), {35, 20});
  open("bar.obj");
  ASSERT_TRUE(viewport().section().has_value());
  EXPECT_TRUE(find<QAction>("sectionPlane").isChecked());
  const Positions& positions = editor().positions();
  const Vector3 middle = (positions.colwise().minCoeff() + positions.colwise().maxCoeff()).transpose() / 2;
  EXPECT_LT((plane().origin - middle).norm(), 1e-9 * editor().model()->solverMesh.diagonal);
  EXPECT_EQ(plane().normal.cwiseAbs().maxCoeff(), 1) << "along an axis again";
  EXPECT_EQ(viewport().surface()->section(), viewport().section());
  trigger("sectionPlane");
  EXPECT_FALSE(viewport().surface()->section());
}

}  // namespace
}  // namespace holdfast

// From where the window looks at a mesh: show all, the previous view, what is up, and keys beside typed numbers.

#include <QAction>
#include <QApplication>
#include <QWheelEvent>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <numeric>

#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/camera/camera_state.h>

#include "files_window.h"
#include "gestures.h"
#include "support/meshes.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"
#include "window_user.h"

namespace holdfast {
namespace {

class ViewsInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    viewport().setFocus();
  }

  [[nodiscard]] Camera camera() { return cameraOf(*viewport().renderer().GetActiveCamera()); }
  [[nodiscard]] Vector3 sight() { return (camera().focalPoint - camera().position).normalized(); }

  void turn()
  {
    test::drag(viewport(), {{100, 100}, {150, 120}, {223, 145}}, Qt::RightButton);
    ASSERT_TRUE(settle());
  }

  void press(Qt::Key code, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    key(code, modifiers);
    ASSERT_TRUE(settle());
  }

  /// The part of the viewport that the mesh covers.
  [[nodiscard]] QRectF covered()
  {
    QRectF box;
    for (Index v = 0; v < editor().positions().rows(); ++v) {
      const QPointF place = shownAt(editor().positions().row(v).transpose());
      box = v == 0 ? QRectF(place, place) : box.united(QRectF(place, QSizeF(1e-9, 1e-9)));
    }
    return box;
  }

  /// Small enough for the picture, clear of the legend and the axes at its right, and no smaller than that.
  void expectFits()
  {
    const QRectF box = covered();
    const double beside = std::max(139.0, viewport().legendBox().width());
    const QRectF room = QRectF(viewport().rect()).adjusted(0, 0, -beside, 0);
    EXPECT_TRUE(room.contains(box));
    EXPECT_GT(std::max(box.width() / room.width(), box.height() / room.height()), 0.8);
  }
};

TEST_F(ViewsInWindow, ShowAllKeepsTheDirection)
{
  turn();
  const Camera after = camera();
  for (int k = 0; k < 3; ++k) press(Qt::Key_Home);
  EXPECT_TRUE(sight().isApprox((after.focalPoint - after.position).normalized(), 1e-12));
  EXPECT_TRUE(camera().viewUp.isApprox(after.viewUp, 1e-12));
  expectFits();
}

TEST_F(ViewsInWindow, ShowAllFitsInParallelProjectionFromEverySide)
{
  expectFits();
  for (const Qt::Key side : {Qt::Key_7, Qt::Key_1, Qt::Key_9}) {
    press(side, Qt::ControlModifier);
    press(Qt::Key_5, Qt::ControlModifier);
    press(Qt::Key_Home);
    EXPECT_EQ(viewport().isParallelProjection(), side != Qt::Key_1);
    expectFits();
  }
}

TEST_F(ViewsInWindow, TheLegendDoesNotCoverTheMeshThatWasFramed)
{
  press(Qt::Key_Home);
  for (const QSize size : {QSize(1024, 700), QSize(800, 600), QSize(1600, 1000)}) {
    window.resize(size);
    ASSERT_TRUE(settle());
    EXPECT_FALSE(covered().intersects(viewport().legendBox())) << size.width();
  }
  ColorSettings colors = viewport().colors();
  colors.range = FixedRange{-1234567.125, 1234567.125};
  colors.bands = 8;
  viewport().setColors(colors);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(covered().intersects(viewport().legendBox())) << "of longer numbers";
}

TEST_F(ViewsInWindow, ACameraThatWasMovedStaysWhenTheLegendGrows)
{
  turn();
  const Camera before = camera();
  ColorSettings colors = viewport().colors();
  colors.range = FixedRange{-1234567.125, 1234567.125};
  colors.bands = 8;
  viewport().setColors(colors);
  ASSERT_TRUE(settle());
  EXPECT_EQ(camera(), before);
}

TEST_F(ViewsInWindow, ShowAllLeavesRoomForTheLegendAtTheLeft)
{
  openPanel("Colours");
  chooseEntry(find<QComboBox>("legendSide"), 1);
  viewport().setFocus();
  press(Qt::Key_Home);
  const QRectF room = QRectF(viewport().rect()).adjusted(139, 0, -139, 0);
  EXPECT_TRUE(room.contains(covered()));
  EXPECT_FALSE(covered().intersects(viewport().legendBox()));
}

TEST_F(ViewsInWindow, ShowAllShowsAllOfTheGizmo)
{
  open("bar.obj", "bar.twist_90.constraints.json");
  viewport().setFocus();
  press(Qt::Key_1, Qt::ControlModifier);
  editor().selectConstraints({*indexOf(list(), "top")});
  ASSERT_TRUE(settle());
  const auto ring = [this] {
    QRectF box(0, 0, 2 * kGizmoPixels, 2 * kGizmoPixels);
    box.moveCenter(shownAt(window.gizmo().gizmo().GetFrame().center));
    return box;
  };
  const QRectF all = viewport().rect();
  ASSERT_FALSE(all.contains(ring())) << "the handle is at the end of the bar";
  press(Qt::Key_Home);
  EXPECT_TRUE(all.contains(ring()));
  press(Qt::Key_5, Qt::ControlModifier);
  press(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(viewport().isParallelProjection());
  EXPECT_TRUE(all.contains(ring()));
  EXPECT_TRUE(all.contains(covered()));
  EXPECT_GT(covered().united(ring()).height(), 0.8 * viewport().height()) << "no farther than that";
  const Camera before = camera();
  press(Qt::Key_Home);
  EXPECT_LT((camera().position - before.position).norm(), 0.02 * (before.position - before.focalPoint).norm());
}

TEST_F(ViewsInWindow, AnotherDocumentFillsThePictureWhateverWasSelected)
{
  for (const auto& [next, selected] : {std::pair("bar.obj", 1), {"plate_unsymmetric.off", 3}}) {
    open("bracket.obj", "bracket.constraints.json");
    std::vector<Index> some(static_cast<std::size_t>(selected));
    std::iota(some.begin(), some.end(), 0);
    editor().selectConstraints(some);
    ASSERT_TRUE(settle());
    open(next);
    expectFits();
    viewport().setFocus();
    press(Qt::Key_Home);
    expectFits();
  }
}

TEST_F(ViewsInWindow, ShowAllShowsTheMeshThoughTheArrowsAreFarFromIt)
{
  // What contradicts an earlier point moves nothing.
  const double far = 1000 * editor().model()->solverMesh.diagonal;
  ConstraintList edited = list();
  edited.constraints.push_back({"far", true, PointConstraint{AtVertex{0}, Target{Vector3(far, 0, 0)}}});
  edited.constraints.push_back({"here", true, PointConstraint{AtVertex{0}, Move{}}});
  std::rotate(edited.constraints.begin(), edited.constraints.end() - 1, edited.constraints.end());
  editor().edit("add", edited);
  ASSERT_TRUE(settle());
  editor().selectConstraints({*indexOf(list(), "far")});
  ASSERT_TRUE(window.gizmo().widget().GetEnabled());
  ASSERT_GT(window.gizmo().gizmo().GetFrame().center.norm(), far / 2);
  press(Qt::Key_Home);
  expectFits();
}

TEST_F(ViewsInWindow, ShowAllShowsTheMeshBesideAVertexOfNoFace)
{
  for (const double place : {40.0, 1e6, -1e12}) {
    MeshDocument document;
    document.mesh = test::box({1, 1, 2}, 4);
    const Index count = document.mesh.vertexCount();
    document.mesh.positions.conservativeResize(count + 1, Eigen::NoChange);
    document.mesh.positions.row(count).setConstant(place);
    NoProgress quiet;
    editor().open(prepareMesh(std::move(document), "box", quiet), {});
    ASSERT_TRUE(settle());
    for (int k = 0; k < 2; ++k) {
      QRectF box;
      for (Index v = 0; v < count; ++v)
        box = box.united(QRectF(shownAt(editor().positions().row(v).transpose()), QSizeF(1e-9, 1e-9)));
      EXPECT_GT(box.height(), 0.6 * viewport().height());
      const QImage picture = viewport().grab().toImage();
      const QPoint middle = box.center().toPoint();
      EXPECT_NE(picture.pixel(middle), picture.pixel(3, middle.y())) << "it is drawn, too";
      press(Qt::Key_Home);
    }
  }
}

TEST_F(ViewsInWindow, PreviousViewTakesDragsWheelAndKeysBackOneByOne)
{
  std::vector<Camera> views{camera()};
  const auto next = [&] {
    ASSERT_TRUE(settle());
    ASSERT_NE(camera(), views.back());
    views.push_back(camera());
  };
  press(Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(camera(), views.back()) << "there is none before the first";
  turn();
  next();
  // Three notches are one change.
  for (int k = 0; k < 3; ++k) {
    QWheelEvent wheel({300, 300}, viewport().mapToGlobal(QPoint(300, 300)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&viewport(), &wheel);
  }
  next();
  press(Qt::Key_5, Qt::ControlModifier);
  next();
  press(Qt::Key_7, Qt::ControlModifier);
  next();
  for (std::size_t k = views.size() - 1; k-- > 0;) {
    press(Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(camera(), views[k]) << k;
    EXPECT_EQ(find<QAction>("parallelProjection").isChecked(), views[k].isParallel);
  }
  for (std::size_t k = 1; k < views.size(); ++k) {
    press(Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(camera(), views[k]) << k;
  }
  press(Qt::Key_Left, Qt::AltModifier);
  turn();
  const Camera after = camera();
  press(Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(camera(), after) << "another view takes the place of those that were taken back";
}

TEST_F(ViewsInWindow, AnotherDocumentHasNoViewsOfThisOne)
{
  turn();
  open("bar.obj");
  const Camera opened = camera();
  press(Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(camera(), opened);
}

TEST_F(ViewsInWindow, NumbersTypedBesideTheArrowsLeaveTheView)
{
  editor().selectConstraints({*indexOf(list(), "flange east")});
  ASSERT_TRUE(settle());
  const Camera before = camera();
  const auto state = editor().history().state();
  test::moveMouse(viewport(), {30, 30});
  keys("725.13");
  ASSERT_TRUE(settle());
  EXPECT_EQ(camera(), before);
  EXPECT_EQ(editor().history().state(), state);
  // Over the arrow they are the amount.
  test::moveMouse(viewport(), onArrow(2));
  keys("2.5");
  key(Qt::Key_Return);
  EXPECT_NE(editor().history().state(), state);
  EXPECT_EQ(camera(), before);
}

/// A mesh of a format, with coordinates as scans have them.
class UpAxisInWindow : public ViewsInWindow {
 protected:
  void openAs(const char* name, const char* mesh = "head.ply")
  {
    NoProgress quiet;
    MeshDocument document{readMesh(test::dataFolder() + "/" + mesh).mesh, nullptr};
    document.mesh.positions = document.mesh.positions.cast<float>().cast<double>().eval();
    editor().open(prepareMesh(std::move(document), name, quiet), {});
    ASSERT_TRUE(settle());
  }

  /// The same as a file, whose numbers have six decimals.
  void openTextPly(const std::filesystem::path& path)
  {
    const Mesh mesh = readMesh(test::dataFolder() + "/head.ply").mesh;
    std::ofstream file(path);
    file << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertexCount()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.faces.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n"
         << std::fixed << std::setprecision(6);
    for (Index v = 0; v < mesh.vertexCount(); ++v)
      file << mesh.positions(v, 0) << ' ' << mesh.positions(v, 1) << ' ' << mesh.positions(v, 2) << '\n';
    for (Index f = 0; f < mesh.faces.size(); ++f)
      file << "3 " << mesh.faces[f][0] << ' ' << mesh.faces[f][1] << ' ' << mesh.faces[f][2] << '\n';
    file.close();
    NoProgress quiet;
    editor().open(loadMesh(path, quiet), {});
    ASSERT_TRUE(settle());
  }

  /// The same.
  void openText(const std::filesystem::path& path)
  {
    const Mesh mesh = readMesh(test::dataFolder() + "/head.ply").mesh;
    std::ofstream file(path);
    file << std::fixed << std::setprecision(6);
    for (Index v = 0; v < mesh.vertexCount(); ++v)
      file << "v " << mesh.positions(v, 0) << ' ' << mesh.positions(v, 1) << ' ' << mesh.positions(v, 2) << '\n';
    for (Index f = 0; f < mesh.faces.size(); ++f)
      file << "f " << mesh.faces[f][0] + 1 << ' ' << mesh.faces[f][1] + 1 << ' ' << mesh.faces[f][2] + 1 << '\n';
    file.close();
    NoProgress quiet;
    editor().open(loadMesh(path, quiet), {});
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] bool isUp(const Vector3& axis) { return camera().viewUp.dot(axis) > 0.7; }

  test::OwnSettings settings;
};

TEST_F(UpAxisInWindow, ScansStandUpright)
{
  EXPECT_TRUE(isUp(Vector3::UnitZ()));
  EXPECT_FALSE(find<QAction>("upAxisY").isChecked());
  openAs("scan.PLY");
  EXPECT_TRUE(isUp(Vector3::UnitY()));
  EXPECT_TRUE(find<QAction>("upAxisY").isChecked());
  press(Qt::Key_1, Qt::ControlModifier);
  EXPECT_TRUE(sight().isApprox(-Vector3::UnitZ(), 1e-12));
  press(Qt::Key_7, Qt::ControlModifier);
  EXPECT_TRUE(sight().isApprox(-Vector3::UnitY(), 1e-12));
  for (const char* scan : {"scan.obj", "scan.OFF", "scan.vtp"}) {
    openAs(scan);
    EXPECT_TRUE(isUp(Vector3::UnitY())) << scan;
  }
  const test::TemporaryFolder folder;
  openText(folder.path() / "text.obj");
  EXPECT_TRUE(isUp(Vector3::UnitY())) << "nine digits are single precision";
  press(Qt::Key_U, Qt::ControlModifier);
  EXPECT_TRUE(isUp(Vector3::UnitZ())) << "a guess is one key away";
  openTextPly(folder.path() / "text.ply");
  EXPECT_TRUE(isUp(Vector3::UnitY())) << "in every format of text";
}

TEST_F(UpAxisInWindow, WhatIsBuiltOrPrintedStandsOnItsBase)
{
  for (const char* mesh : {"head.ply", "bracket.obj", "bar.obj", "plate_unsymmetric.off", "cube_unwelded.stl"}) {
    open(mesh);
    EXPECT_TRUE(isUp(Vector3::UnitZ())) << mesh;
  }
  openAs("print.stl");
  EXPECT_TRUE(isUp(Vector3::UnitZ())) << "a scan that is printed";
  openAs("part.ply", "bracket.obj");
  EXPECT_TRUE(isUp(Vector3::UnitZ())) << "flat places are no scan's";
}

TEST_F(UpAxisInWindow, IsRememberedForFilesOfTheFormat)
{
  press(Qt::Key_U, Qt::ControlModifier);
  EXPECT_TRUE(isUp(Vector3::UnitY()));
  open("plate_unsymmetric.off");
  EXPECT_TRUE(isUp(Vector3::UnitZ()));
  open("bar.obj");
  EXPECT_TRUE(isUp(Vector3::UnitY()));
  press(Qt::Key_U, Qt::ControlModifier);
  EXPECT_TRUE(isUp(Vector3::UnitZ()));
  open("bracket.obj");
  EXPECT_TRUE(isUp(Vector3::UnitZ()));
}

TEST_F(UpAxisInWindow, IsKeptInTheSession)
{
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "up.holdfast";
  press(Qt::Key_U, Qt::ControlModifier);
  chooseFile(path.string());
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(test::waitUntil([this] { return !window.files().isSaving(); }));
  press(Qt::Key_U, Qt::ControlModifier);
  window.files().open(QString::fromStdString(path.string()));
  ASSERT_TRUE(test::waitUntil([this] { return viewport().upAxis() == UpAxis::Y; }));
  ASSERT_TRUE(settle());
  EXPECT_TRUE(find<QAction>("upAxisY").isChecked());
  press(Qt::Key_7, Qt::ControlModifier);
  EXPECT_TRUE(sight().isApprox(-Vector3::UnitY(), 1e-12));
}

}  // namespace
}  // namespace holdfast

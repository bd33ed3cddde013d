#include <QImage>
#include <QLabel>
#include <QRegion>
#include <algorithm>

#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>
#include <vtkActor2DCollection.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>
#include <holdfast/window/panels/sphere_panel.h>

#include "gestures.h"
#include "support/source_tree.h"
#include "widgets/sphere_place.h"

namespace holdfast {
namespace {

/// The panel beside the plate with three handles that lean.
class SpherePanelOfPlate : public ::testing::Test {
 protected:
  void SetUp() override
  {
    open("plate_unsymmetric.three_handles.constraints.json");
    panel.resize(480, 420);
    ASSERT_TRUE(test::showAndWait(panel));
    ASSERT_TRUE(isShown());
  }

  void open(const std::string& constraints)
  {
    const std::string path = test::dataFolder() + "/plate_unsymmetric.off";
    NoProgress quiet;
    editor.open(loadMesh(path, quiet), {readConstraints(test::dataFolder() + "/" + constraints), {}});
    ASSERT_TRUE(test::waitUntil([&] { return editor.solveState() == SolveState::Current; }));
  }

  [[nodiscard]] bool isShown() const
  {
    return test::waitUntil([&] { return panel.isCurrent(); });
  }

  [[nodiscard]] QVTKOpenGLNativeWidget& view() const { return *panel.findChild<QVTKOpenGLNativeWidget*>("sphereView"); }
  [[nodiscard]] vtkCamera& camera() const
  {
    return *view().renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera();
  }

  /// Returns where a vertex is seen, in the coordinates of the view.
  [[nodiscard]] QPointF placeOf(Index vertex) const
  {
    const double ratio = view().devicePixelRatioF();
    const DisplayPoint place = test::displayPlace(*panel.sphere(), vertex).value();
    return {place.x() / ratio - 0.5, view().height() - place.y() / ratio - 0.5};
  }

  Editor editor;
  SpherePanel panel{editor};
};

TEST_F(SpherePanelOfPlate, TextsAreInTheFontAndTheColorOfTheWindow)
{
  auto& texts = *panel.findChild<QWidget*>("sphereTexts");
  const auto painted = [&] {
    QImage drawn(texts.size(), QImage::Format_ARGB32_Premultiplied);
    drawn.fill(Qt::transparent);
    texts.render(&drawn, QPoint(), QRegion(), {});
    return drawn;
  };
  ASSERT_TRUE(test::waitUntil([&] { return !panel.sphere()->texts().empty(); }));
  EXPECT_EQ(texts.size(), view().size());
  EXPECT_TRUE(std::ranges::any_of(panel.sphere()->texts(), &SphereText::isName));
  const QImage usual = painted();
  constexpr int kNear = 8;
  const QRect clear = usual.rect().adjusted(kNear, kNear, -kNear, -kNear);
  int seen = 0;
  for (const SphereText& text : panel.sphere()->texts()) {
    const double ratio = view().devicePixelRatioF();
    const QPoint place = QPointF(text.place.x() / ratio, view().height() - text.place.y() / ratio).toPoint();
    if (!clear.contains(place)) continue;
    ++seen;
    int ink = 0;
    for (int x = -kNear; x <= kNear; ++x)
      for (int y = -kNear; y <= kNear; ++y) ink += qAlpha(usual.pixel(place + QPoint(x, y))) > 100 ? 1 : 0;
    EXPECT_GT(ink, 3) << text.text;
  }
  EXPECT_GT(seen, 2);
  QFont larger = panel.font();
  larger.setPointSizeF(2 * larger.pointSizeF());
  panel.setFont(larger);
  EXPECT_NE(painted(), usual);
  EXPECT_EQ(panel.sphere()->renderer()->GetActors2D()->GetNumberOfItems(), 0) << "none by VTK as well";
}

TEST_F(SpherePanelOfPlate, AClickPicksTheVertexWhoseRotationIsThere)
{
  std::optional<Index> picked;
  QObject::connect(&panel, &SpherePanel::vertexPicked, &panel, [&](Index vertex) { picked = vertex; });
  const Weld& weld = editor.model()->solverMesh.weld;
  for (const Index vertex : {7, 200, 411}) {
    picked.reset();
    test::click(view(), placeOf(vertex));
    ASSERT_TRUE(picked) << vertex;
    const Columns3& q = editor.deformation()->rotations;
    EXPECT_LT((q.row(weld.unknownOf[*picked]) - q.row(weld.unknownOf[vertex])).norm(), 0.02) << vertex;
  }
}

TEST_F(SpherePanelOfPlate, ADragTurnsTheSphereAndPicksNothing)
{
  bool isPicked = false;
  QObject::connect(&panel, &SpherePanel::vertexPicked, &panel, [&] { isPicked = true; });
  const QPointF from = placeOf(200);
  const Vector3 before(camera().GetPosition());
  ASSERT_TRUE(test::waitUntil([&] { return view().isValid(); }));
  const QImage picture = view().grabFramebuffer();
  test::drag(view(), {from, from + QPointF(30, 0), from + QPointF(60, 10)});
  EXPECT_TRUE(test::waitUntil([&] { return view().grabFramebuffer() != picture; }, std::chrono::seconds(5)));
  EXPECT_GT((Vector3(camera().GetPosition()) - before).norm(), 0.5);
  EXPECT_FALSE(isPicked);
  // What was grabbed follows the hand.
  EXPECT_GT(placeOf(200).x(), from.x() + 10);
}

TEST_F(SpherePanelOfPlate, ThePictureIsOpaque)
{
  const QImage picture = view().grabFramebuffer();
  ASSERT_TRUE(picture.hasAlphaChannel());
  EXPECT_TRUE(test::isOpaque(picture));
}

TEST_F(SpherePanelOfPlate, KeysZoomAndHomeShowsEverythingAgain)
{
  const double before = camera().GetParallelScale();
  test::pressKey(view(), Qt::Key_Plus);
  EXPECT_LT(camera().GetParallelScale(), before);
  test::pressKey(view(), Qt::Key_Left);
  test::pressKey(view(), Qt::Key_Home);
  EXPECT_EQ(camera().GetParallelScale(), before);
}

TEST_F(SpherePanelOfPlate, TheSummarySaysHowMuchIsAskedFor)
{
  EXPECT_TRUE(panel.findChild<QLabel*>("sphereSummary")->text().contains(QStringLiteral("35°")));
}

TEST_F(SpherePanelOfPlate, WordsSayWhatLatitudeAndLongitudeAre)
{
  const auto words = [this] { return panel.findChild<QLabel*>("sphereWords")->text(); };
  EXPECT_TRUE(words().contains("Latitude is the angle")) << words().toStdString();
  EXPECT_TRUE(words().contains("Longitude is the axis"));
  EXPECT_FALSE(words().contains(QStringLiteral("540°"))) << "no rotation is that large";
  ConstraintList list = editor.list();
  for (Constraint& constraint : list.constraints)
    if (auto* handle = std::get_if<HandleConstraint>(&constraint.what))
      handle->motion = AxisRotation{Vector3::UnitX(), 450, {}};
  editor.edit("turn", list);
  ASSERT_TRUE(test::waitUntil([&] { return editor.solveState() == SolveState::Current; }));
  ASSERT_TRUE(isShown());
  EXPECT_TRUE(words().contains(QStringLiteral("540° at the equator"))) << words().toStdString();
}

TEST_F(SpherePanelOfPlate, WithoutARotationTheHintSaysWhatToDo)
{
  const auto* hint = panel.findChild<QLabel*>("sphereHint");
  EXPECT_FALSE(hint->isVisible());
  open("plate_unsymmetric.conflict.constraints.json");
  ASSERT_TRUE(isShown());
  EXPECT_TRUE(hint->isVisible());
  EXPECT_TRUE(hint->text().contains("rotate"));
  editor.close();
  EXPECT_TRUE(hint->isVisible());
  EXPECT_TRUE(hint->text().contains("No mesh"));
}

TEST_F(SpherePanelOfPlate, ColorsOfAnotherMeshAreNotTaken)
{
  panel.setColoring(Coloring{{1, 2, 3}, {}});
  panel.showVertex(Index{1'000'000});
  panel.showVertex(std::nullopt);
  EXPECT_TRUE(hasRotation(panel.sphere()->placed().boundary));
}

TEST_F(SpherePanelOfPlate, HiddenItIsNotKeptUpToDate)
{
  panel.hide();
  const std::size_t before = panel.sphere()->placed().boundary.size();
  ConstraintList fewer = editor.list();
  fewer.constraints.pop_back();
  editor.edit("delete", fewer);
  ASSERT_TRUE(test::waitUntil([&] { return editor.solveState() == SolveState::Current; }));
  EXPECT_EQ(panel.sphere()->placed().boundary.size(), before);
  panel.show();
  ASSERT_TRUE(isShown());
  EXPECT_LT(panel.sphere()->placed().boundary.size(), before);
}

TEST_F(SpherePanelOfPlate, OfManyChangesTheLastIsShown)
{
  ConstraintList turning = editor.list();
  for (int degrees = 1; degrees <= 12; ++degrees) {
    const auto before = editor.deformation();
    for (Constraint& constraint : turning.constraints)
      if (auto* const moved = std::get_if<HandleConstraint>(&constraint.what))
        moved->motion = AxisRotation{{0, 0, 1}, 10.0 * degrees, {}};
    editor.edit("turn", turning);
    ASSERT_TRUE(test::waitUntil([&] { return editor.deformation() != before; }));
  }
  ASSERT_TRUE(test::waitUntil([&] { return editor.solveState() == SolveState::Current; }));
  ASSERT_TRUE(isShown());
  const PlacedRotations& placed = panel.sphere()->placed();
  for (const BoundaryRotation& value : placed.boundary)
    EXPECT_NEAR(angleDegrees(value.q), value.q.isZero(0) ? 0 : 120, 1e-12);
  const auto expected = placeRotations(*editor.model(), *editor.deformation(), nullptr);
  ASSERT_EQ(placed.places.size(), expected->places.size());
  for (std::size_t k = 0; k < placed.places.size(); ++k) EXPECT_EQ(placed.places[k].z(), expected->places[k].z()) << k;
}

TEST_F(SpherePanelOfPlate, AnotherDocumentTakesThePlaceOfWhatIsBeingPlaced)
{
  const std::size_t prescribed = panel.sphere()->placed().boundary.size();
  std::optional<bool> isCurrent;
  QObject::connect(&editor, &Editor::deformed, &panel, [&] { isCurrent = panel.isCurrent(); });
  ConstraintList fewer = editor.list();
  fewer.constraints.pop_back();
  editor.edit("delete", fewer);
  ASSERT_TRUE(test::waitUntil([&] { return isCurrent.has_value(); }));
  EXPECT_FALSE(*isCurrent) << "nobody waits for points";
  editor.close();
  EXPECT_TRUE(panel.isCurrent());
  EXPECT_EQ(panel.sphere(), nullptr);
  open("plate_unsymmetric.three_handles.constraints.json");
  ASSERT_TRUE(isShown());
  EXPECT_EQ(panel.sphere()->placed().boundary.size(), prescribed);
}

}  // namespace
}  // namespace holdfast

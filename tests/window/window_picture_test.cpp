#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QScreen>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <vtkProperty.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/controls/theme.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// The twisted bar, whose foot is fixed and whose top is a handle.
class PictureOfBar : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bar.obj", "bar.twist_90.constraints.json");
  }

  void TearDown() override { apply(Appearance::System); }

  [[nodiscard]] vtkProperty& surface() { return *viewport().contents()->mesh().surface().GetProperty(); }
};

TEST_F(PictureOfBar, AFaceOfARegionSelectsIt)
{
  trigger("viewFront");
  ASSERT_TRUE(settle());
  // Beside the vertices, which are glyphs as well: in a face of the foot.
  const auto& mesh = *editor().model();
  const auto isInFoot = [&](const Triangle& triangle) {
    return std::ranges::all_of(triangle, [&](Index v) { return mesh.mesh.positions(v, 2) <= 5; });
  };
  const auto& triangles = mesh.triangulation.triangles;
  Vector3 place = Vector3::Zero();
  for (const Triangle& triangle : triangles) {
    const Vector3 middle = mesh.mesh.positions(triangle, Eigen::all).colwise().mean();
    if (isInFoot(triangle) && middle.y() < place.y()) place = middle;
  }
  test::click(viewport(), shownAt(place));
  ASSERT_EQ(editor().selectedConstraints().size(), 1U);
  EXPECT_TRUE(std::holds_alternative<FixedConstraint>(list().constraints[editor().selectedConstraints()[0]].what));
}

TEST_F(PictureOfBar, KeysShowEdgesAndSurfaceInTurn)
{
  EXPECT_TRUE(viewport().contents()->mesh().edges().GetVisibility());
  key(Qt::Key_E, Qt::ShiftModifier);
  EXPECT_TRUE(viewport().contents()->mesh().meshEdges().GetVisibility());
  key(Qt::Key_E, Qt::ShiftModifier);
  EXPECT_FALSE(viewport().contents()->mesh().edges().GetVisibility());
  EXPECT_FALSE(viewport().contents()->mesh().meshEdges().GetVisibility());
  EXPECT_EQ(find<QComboBox>("meshEdges").currentText(), "None");
  key(Qt::Key_E, Qt::ShiftModifier);
  EXPECT_EQ(viewport().display().edges, MeshEdges::Sharp);

  EXPECT_EQ(surface().GetRepresentation(), VTK_SURFACE);
  key(Qt::Key_D, Qt::ShiftModifier);
  EXPECT_EQ(surface().GetRepresentation(), VTK_WIREFRAME);
  key(Qt::Key_D, Qt::ShiftModifier);
  EXPECT_EQ(surface().GetRepresentation(), VTK_POINTS);
  EXPECT_EQ(find<QComboBox>("surfaceDisplay").currentText(), "Points");
  key(Qt::Key_D, Qt::ShiftModifier);
  EXPECT_EQ(surface().GetRepresentation(), VTK_SURFACE);
}

TEST_F(PictureOfBar, TheShapeAtRestIsNotWhiteWhereItsLayersOverlap)
{
  open("head.ply", "head.rigid_eyes.constraints.json");
  viewport().setColors({ColorBy::None});
  const auto drawnWith = [this](RestGhost ghost) {
    viewport().setDisplay({ghost, MeshEdges::Sharp, SurfaceDisplay::Shaded, RotationDisplay::Hidden, false});
    EXPECT_TRUE(settle());
    return viewport().grabFramebuffer().convertToFormat(QImage::Format_RGB32);
  };
  const QImage with = drawnWith(RestGhost::Surface);
  const QImage without = drawnWith(RestGhost::Hidden);
  const auto isWhite = [](const QColor& color, int least) {
    return std::min({color.red(), color.green(), color.blue()}) >= least;
  };
  // Six layers of white leave a third of what was there.
  constexpr int kNearlyWhite = 250;
  // Where the mesh ends, smoothing may move its outline by a pixel.
  const auto isAtOutline = [&](int x, int y) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, with.height() - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, with.width() - 1); ++u)
        if (isWhite(without.pixelColor(u, v), kNearlyWhite)) return true;
    return false;
  };
  int changed = 0;
  int whitened = 0;
  for (int y = 0; y < with.height(); ++y)
    for (int x = 0; x < with.width(); ++x) {
      changed += with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
      if (isWhite(with.pixelColor(x, y), 255) && !isWhite(without.pixelColor(x, y), kNearlyWhite) && !isAtOutline(x, y))
        ++whitened;
    }
  EXPECT_GT(changed, 10'000);
  EXPECT_EQ(whitened, 0);
}

TEST_F(PictureOfBar, RoundingIsNoField)
{
  open("head.ply", "head.rigid_eyes.constraints.json");
  const Eigen::VectorXd along = (editor().positions() - editor().model()->mesh.positions).col(1);
  ASSERT_GT(along.cwiseAbs().maxCoeff(), 0) << "nothing is rounded";
  openPanel("Colours");
  chooseEntry(find<QComboBox>("colorField"), static_cast<int>(ColorBy::DisplacementY));
  EXPECT_EQ(viewport().legend().line, "Displacement y: nothing to show");
  chooseEntry(find<QComboBox>("colorField"), static_cast<int>(ColorBy::DisplacementX));
  EXPECT_TRUE(viewport().coloring());
}

TEST_F(PictureOfBar, IsCopiedAsItIsInTheWindow)
{
  QGuiApplication::clipboard()->clear();
  key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  const QImage copied = QGuiApplication::clipboard()->image();
  ASSERT_EQ(copied.size(), viewport().size());
  // The legend, which has the same counts: what is painted alone is in the picture.
  EXPECT_EQ(viewport().legend().counts.size(), 1U);
  EXPECT_EQ(viewport().legend().counts[0].second, 2) << "constraints, not vertices";
  // What covers is the same over any colour. Formats of images differ in how they round, so it is the picture's.
  const auto legendOver = [&](Qt::GlobalColor color) {
    QImage image(copied.size(), QImage::Format_RGB888);
    image.fill(color);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(viewport().font());
    paint(viewport().legend(), painter, image.rect(), paletteOf(Appearance::Light));
    return image;
  };
  const QImage onBlack = legendOver(Qt::black);
  const QImage onWhite = legendOver(Qt::white);
  int painted = 0;
  for (int y = 0; y < copied.height(); ++y)
    for (int x = 0; x < copied.width(); ++x) {
      if (onBlack.pixel(x, y) != onWhite.pixel(x, y)) continue;
      ++painted;
      ASSERT_EQ(copied.pixelColor(x, y), onBlack.pixelColor(x, y)) << x << ", " << y;
    }
  EXPECT_GT(painted, 1000);
}

TEST_F(PictureOfBar, IsSmoothWheneverTheMouseRests)
{
  const auto shown = [this] { return viewport().grabFramebuffer().convertToFormat(QImage::Format_RGB32); };
  const QImage smooth = shown();
  const QPointF place(20, 20);
  test::pressMouse(viewport(), place, Qt::MiddleButton);
  viewport().scheduleRender();
  ASSERT_TRUE(settle());
  EXPECT_NE(shown(), smooth) << "while a button is held";
  test::releaseMouse(viewport(), place, Qt::MiddleButton);
  ASSERT_TRUE(settle());
  EXPECT_EQ(shown(), smooth);
}

TEST_F(PictureOfBar, ADoubleClickOnTheLegendOpensItsSettings)
{
  const QWidget& panel = find<QWidget>("colorPanel");
  ASSERT_FALSE(panel.isVisible());
  test::doubleClick(viewport(), viewport().legendBox().topLeft() - QPointF(20, 20));
  test::doubleClick(viewport(), viewport().legendBox().center());
  ASSERT_TRUE(test::waitUntil([&] { return panel.isVisible() && find<QComboBox>("colorRangeKind").hasFocus(); }));
  EXPECT_EQ(list().constraints.size(), 2U);
}

TEST_F(PictureOfBar, ALeftClickOnTheLegendReachesNothingBehindIt)
{
  const QPointF place = viewport().legendBox().center();
  test::drag(viewport(), {seenAt(editor().positions().colwise().mean().transpose()), place}, Qt::MiddleButton);
  ASSERT_TRUE(settle());
  const auto holdThere = [&] {
    key(Qt::Key_P);
    test::moveMouse(viewport(), place);
    const bool isPreviewed = editor().underCursor().pick.has_value();
    test::click(viewport(), place);
    return isPreviewed;
  };
  EXPECT_FALSE(holdThere());
  EXPECT_EQ(list().constraints.size(), 2U);
  key(Qt::Key_S);
  editor().selectConstraints({1});
  const Camera before = cameraOf(*viewport().renderer().GetActiveCamera());
  test::drag(viewport(), {place, place + QPointF(-40, 20), place + QPointF(-200, 50)});
  test::doubleClick(viewport(), place);
  EXPECT_EQ(editor().selectedConstraints(), std::vector<Index>{1});
  EXPECT_EQ(cameraOf(*viewport().renderer().GetActiveCamera()), before);
  test::drag(viewport(), {place, place + QPointF(-40, 20)}, Qt::RightButton);
  EXPECT_NE(cameraOf(*viewport().renderer().GetActiveCamera()), before) << "other buttons rotate and shift there";

  DisplaySettings settings = viewport().display();
  settings.legend = LegendSide::Hidden;
  viewport().setDisplay(settings);
  editor().selectConstraints({});
  EXPECT_TRUE(holdThere());
  EXPECT_EQ(list().constraints.size(), 3U) << "the surface is there";
}

TEST_F(PictureOfBar, TheLegendHasAsManyColorsAsWanted)
{
  const auto legendColors = [this] {
    key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    const QImage copied = QGuiApplication::clipboard()->image();
    const QRectF box = viewport().legendBox();
    std::set<QRgb> colors;
    // The bar is at the right; beside its frame, and below the title.
    const int x = static_cast<int>(box.right()) - 7;
    for (int y = static_cast<int>(box.bottom()) - 80; y < static_cast<int>(box.bottom()) - 14; ++y)
      colors.insert(copied.pixel(x, y));
    return colors.size();
  };
  EXPECT_GT(legendColors(), 20U);
  openPanel("Colours");
  auto& bands = find<QSpinBox>("colorBands");
  for (int k = 0; k < 2; ++k) test::pressKey(bands, Qt::Key_Up);
  EXPECT_EQ(viewport().coloring()->scale.bands, 3);
  EXPECT_LE(legendColors(), 2U) << "the lower third, and some of the middle one";
  test::pressKey(bands, Qt::Key_Down);
  EXPECT_EQ(viewport().coloring()->scale.bands, 2);
  test::pressKey(bands, Qt::Key_Down);
  EXPECT_EQ(viewport().coloring()->scale.bands, 0) << "smooth again";
}

TEST_F(PictureOfBar, WhatHasChangedOverThePictureIsOnTheScreen)
{
  auto& overlay = find<QWidget>("overlay");
  const auto onScreen = [&] {
    EXPECT_TRUE(settle());
    QCoreApplication::processEvents();
    const QRect place(overlay.mapTo(overlay.window(), QPoint()), overlay.size());
    return overlay.screen()
        ->grabWindow(overlay.window()->winId(), place.x(), place.y(), place.width(), place.height())
        .toImage();
  };
  const auto expectCurrent = [&](const char* what) {
    QImage shown = onScreen();
    overlay.update();
    EXPECT_EQ(shown, onScreen()) << what;
    return shown;
  };
  const QImage displacements = expectCurrent("displacements");
  viewport().setColors({ColorBy::Angle});
  EXPECT_NE(expectCurrent("angles"), displacements);
  viewport().setShownShare(0.5);
  const QImage half = expectCurrent("half of the way");
  viewport().setShownShare(0.25);
  EXPECT_NE(expectCurrent("a quarter of it").copy(0, 0, 300, 40), half.copy(0, 0, 300, 40)) << "the note";
}

TEST_F(PictureOfBar, TheLegendIsWhereItIsWanted)
{
  openPanel("Colours");
  const double middle = viewport().width() / 2.0;
  EXPECT_GT(viewport().legendBox().left(), middle);
  chooseEntry(find<QComboBox>("legendSide"), 1);
  const QRectF box = viewport().legendBox();
  EXPECT_LT(box.right(), middle);
  EXPECT_TRUE(QRectF(viewport().rect()).contains(box));
  const auto ink = [this](const QRectF& area) {
    auto& overlay = find<QWidget>("overlay");
    QImage drawn(overlay.size(), QImage::Format_ARGB32_Premultiplied);
    drawn.fill(Qt::transparent);
    overlay.render(&drawn, QPoint(), QRegion(), {});
    int count = 0;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x)
        count += area.contains(QPointF(x, y)) && qAlpha(drawn.pixel(x, y)) == 255 ? 1 : 0;
    return count;
  };
  EXPECT_GT(ink(box), 1000);
  EXPECT_EQ(ink(QRectF(middle, 0, middle, viewport().height())), 0);
  chooseEntry(find<QComboBox>("legendSide"), 2);
  EXPECT_TRUE(viewport().legendBox().isEmpty());
  EXPECT_EQ(ink(box), 0);
}

TEST_F(PictureOfBar, ButtonsAreReadableInEveryTheme)
{
  for (const Appearance appearance : {Appearance::Light, Appearance::Dark, Appearance::Light}) {
    apply(appearance);
    ASSERT_TRUE(settle());
    auto& button = find<QToolButton>("constraintMenu");
    QImage drawn(button.size(), QImage::Format_RGB32);
    drawn.fill(button.palette().color(QPalette::Window));
    button.render(&drawn, QPoint(), QRegion(), QWidget::DrawChildren);
    double largest = 0;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x)
        largest = std::max(largest, contrast(drawn.pixelColor(x, y), drawn.pixelColor(0, 0)));
    EXPECT_GE(largest, 4.5) << static_cast<int>(appearance);
  }
}

TEST_F(PictureOfBar, TheProgramHasAnIcon)
{
  EXPECT_FALSE(window.windowIcon().isNull());
  EXPECT_FALSE(window.windowIcon().pixmap(64, 64).toImage().isNull());
}

}  // namespace
}  // namespace holdfast

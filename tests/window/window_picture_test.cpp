#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QToolButton>
#include <algorithm>

#include <gtest/gtest.h>
#include <vtkProperty.h>

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

TEST_F(PictureOfBar, IsCopiedAsItIsInTheWindow)
{
  QGuiApplication::clipboard()->clear();
  key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  const QImage copied = QGuiApplication::clipboard()->image();
  ASSERT_EQ(copied.size(), viewport().size());
  // The legend, which has the same counts: what is painted alone is in the picture.
  EXPECT_EQ(viewport().legend().counts.size(), 1U);
  EXPECT_EQ(viewport().legend().counts[0].second, 2) << "constraints, not vertices";
  QImage legend(copied.size(), QImage::Format_ARGB32_Premultiplied);
  legend.fill(Qt::transparent);
  QPainter painter(&legend);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(viewport().font());
  paint(viewport().legend(), painter, legend.rect(), paletteOf(Appearance::Light));
  int painted = 0;
  for (int y = 0; y < legend.height(); ++y)
    for (int x = 0; x < legend.width(); ++x) {
      if (qAlpha(legend.pixel(x, y)) != 255) continue;
      ++painted;
      ASSERT_EQ(copied.pixelColor(x, y), legend.pixelColor(x, y)) << x << ", " << y;
    }
  EXPECT_GT(painted, 1000);
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

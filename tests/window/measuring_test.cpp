// What the window says about the point under the cursor, probes, rulers, the cut and the mesh.

#include <QAction>
#include <QBrush>
#include <QImage>
#include <QLabel>
#include <QTreeWidget>
#include <array>

#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/panels/sphere_panel.h>
#include <holdfast/window/text/number_text.h>
#include <holdfast/window/viewport/viewport_overlay.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

class MeasuringInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    viewport().setFocus();
  }

  [[nodiscard]] QTreeWidget& tree() { return find<QTreeWidget>("measuredTree"); }
  [[nodiscard]] QTreeWidgetItem& item(int row) { return *tree().topLevelItem(row); }

  /// The number beside a name below an item, with all digits.
  [[nodiscard]] static std::optional<double> number(const QTreeWidgetItem& item, const QString& name, int column = 1)
  {
    for (int k = 0; k < item.childCount(); ++k)
      if (item.child(k)->text(0).startsWith(name)) return typedNumber(item.child(k)->toolTip(column));
    return std::nullopt;
  }

  [[nodiscard]] Vector3 restOf(Index v) { return editor().model()->mesh.positions.row(v).transpose(); }
  [[nodiscard]] Vector3 nowOf(Index v) { return editor().positions().row(v).transpose(); }

  void expectProbe(const QTreeWidgetItem& shown, Index vertex)
  {
    EXPECT_TRUE(shown.text(0).endsWith(QString("vertex %1").arg(vertex))) << shown.text(0).toStdString();
    for (int axis = 0; axis < 3; ++axis) {
      const QString name("xyz"[axis]);
      EXPECT_EQ(number(shown, name, 1), nowOf(vertex)[axis]);
      EXPECT_EQ(number(shown, name, 2), restOf(vertex)[axis]);
      EXPECT_EQ(number(shown, name, 3), nowOf(vertex)[axis] - restOf(vertex)[axis]);
    }
    EXPECT_DOUBLE_EQ(number(shown, "displacement").value_or(-1), (nowOf(vertex) - restOf(vertex)).norm());
    const Index unknown = editor().model()->solverMesh.weld.unknownOf[vertex];
    EXPECT_DOUBLE_EQ(number(shown, "rotation |q|").value_or(-1), editor().deformation()->rotations.row(unknown).norm());
    EXPECT_TRUE(number(shown, "detail residual"));
    EXPECT_FALSE(number(shown, "constraint residual")) << "no constraint is there";
  }

  /// The panel, with the values of the newest deformation.
  void openMeasured()
  {
    openPanel("Measured");
    ASSERT_TRUE(test::waitUntil([this] { return item(0).childCount() > 3; }));
  }

  [[nodiscard]] static bool isAccent(const QColor& color)
  {
    const QColor accent = toQColor(kAccentColor);
    constexpr int kNear = 40;
    return std::abs(color.red() - accent.red()) < kNear && std::abs(color.green() - accent.green()) < kNear &&
           std::abs(color.blue() - accent.blue()) < kNear;
  }

  [[nodiscard]] int accentPixels()
  {
    const QImage picture = viewport().grabFramebuffer();
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const QColor color = picture.pixelColor(x, y);
        count += isAccent(color) ? 1 : 0;
      }
    return count;
  }
};

TEST_F(MeasuringInWindow, EveryToolSaysWhatIsUnderTheCursor)
{
  openMeasured();
  openPanel("Rotations");
  const Index vertex = freeVertex();
  const QPointF place = seenAt(vertex);
  for (const char* tool : {"toolSelect", "toolBrush", "toolCurve", "toolRuler", "toolProbe", "toolPoint"}) {
    trigger(tool);
    test::moveMouse(viewport(), place + QPointF(1, 1));
    expectProbe(item(0), vertex);
    test::moveMouse(viewport(), {3, 3});
    EXPECT_EQ(item(0).text(0), "Cursor") << tool;
    EXPECT_FALSE(number(item(0), "displacement")) << tool;
  }
  // While a button is held the cursor says nothing.
  trigger("toolSelect");
  test::moveMouse(viewport(), place, Qt::RightButton);
  EXPECT_FALSE(editor().underCursor().pick);
}

TEST_F(MeasuringInWindow, FieldsOfRotationsHaveTheirAxisAtProbesAndInTheTable)
{
  const Index vertex = freeVertex();
  editor().setMeasurements("probe", {{AtVertex{vertex}}, {}});
  openMeasured();
  ColorSettings colors = viewport().colors();
  colors.field = ColorBy::Angle;
  viewport().setColors(colors);
  ASSERT_TRUE(settle());
  const Weld& weld = editor().model()->solverMesh.weld;
  const Vector3 q = editor().deformation()->rotations.row(weld.unknownOf[vertex]).transpose();
  const auto& overlay = *viewport().findChild<ViewportOverlay*>();
  ASSERT_EQ(overlay.shownProbes().size(), 1U);
  const QString said = overlay.shownProbes()[0].text;
  if (q.isZero(0)) {
    EXPECT_FALSE(said.contains("about")) << said.toStdString();
  } else {
    EXPECT_TRUE(said.endsWith("about " + roundedText(Vector3(q.normalized())))) << said.toStdString();
  }
}

TEST_F(MeasuringInWindow, PlacesHaveTheDecimalsOfTheDocument)
{
  const Index vertex = freeVertex();
  editor().setMeasurements("probe", {{AtVertex{vertex}}, {}});
  openMeasured();
  editor().setDecimals(1);
  const QTreeWidgetItem& probe = item(1);
  EXPECT_EQ(probe.child(0)->text(1), QString::number(nowOf(vertex).x(), 'f', 1));
  EXPECT_EQ(typedNumber(probe.child(0)->toolTip(1)), nowOf(vertex).x()) << "all digits";
}

TEST_F(MeasuringInWindow, TheTableMarksTheConstraintUnderTheCursor)
{
  const Index row = *indexOf(list(), "flange east");
  const auto isMarked = [&](Index k) {
    return table().model()->index(static_cast<int>(k), 1).data(Qt::BackgroundRole).isValid();
  };
  const auto& marks = viewport().marks();
  const auto mark = std::find_if(marks.begin(), marks.end(), [&](const auto& m) { return m.constraint == row; });
  ASSERT_NE(mark, marks.end());
  trigger("toolBrush");
  test::moveMouse(viewport(), seenAt(mark->place));
  for (Index k = 0; k < static_cast<Index>(list().constraints.size()); ++k) EXPECT_EQ(isMarked(k), k == row) << k;
  test::moveMouse(viewport(), {3, 3});
  EXPECT_FALSE(isMarked(row));
}

TEST_F(MeasuringInWindow, ProbesStayAndFollowTheSurface)
{
  openMeasured();
  key(Qt::Key_Q);
  EXPECT_TRUE(find<QAction>("toolProbe").isChecked());
  const auto state = editor().history().state();
  const Index vertex = freeVertex();
  test::click(viewport(), seenAt(vertex));
  test::moveMouse(viewport(), {3, 3});
  ASSERT_EQ(tree().topLevelItemCount(), 2);
  EXPECT_EQ(editor().history().undoName(), "probe 1");
  EXPECT_TRUE(editor().isCurrent()) << "nothing is solved for it";
  trigger("undo");
  EXPECT_EQ(tree().topLevelItemCount(), 1);
  EXPECT_EQ(editor().history().state(), state);
  trigger("redo");
  expectProbe(item(1), vertex);
  trigger("toolSelect");
  // Another deformation has other values.
  const double before = *number(item(1), "displacement");
  editor().selectConstraints({*indexOf(list(), "flange east")});
  ASSERT_TRUE(settle());
  const QPointF from = onArrow(2);
  test::drag(viewport(), {from, from + QPointF(0, -30), from + QPointF(0, -60)});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(test::waitUntil([&] { return number(item(1), "displacement") != before; }));
  expectProbe(item(1), vertex);
  // Delete removes the measurement, not the constraint that is selected.
  const auto constraints = list().constraints.size();
  tree().setFocus();
  tree().setCurrentItem(&item(1));
  key(Qt::Key_Delete);
  EXPECT_EQ(tree().topLevelItemCount(), 1);
  EXPECT_EQ(list().constraints.size(), constraints);
}

TEST_F(MeasuringInWindow, RulersStayWithTheirDifferenceFromRest)
{
  openMeasured();
  const int plain = accentPixels();
  const Index a = freeVertex();
  const Index b = [&] {
    for (Index v = a + 1;; ++v) {
      const DisplayPoint pixel = toDisplay(viewport().renderer(), nowOf(v)).head<2>();
      const auto pick =
          SurfacePicker(viewport().surface())
              .pick(viewport().renderer(), std::floor(pixel.x()), std::floor(pixel.y()), PickKind::Vertex, 4);
      const auto* at = pick ? std::get_if<AtVertex>(&pick->location) : nullptr;
      if (at != nullptr && at->vertex == v && (nowOf(v) - nowOf(a)).norm() > 20) return v;
    }
  }();
  for (const auto& [from, to] : {std::pair(a, b), {b, a}}) {
    // The ends of a ruler that is drawn would be grabbed.
    key(Qt::Key_S);
    key(Qt::Key_D);
    test::click(viewport(), seenAt(from));
    test::click(viewport(), seenAt(to));
  }
  ASSERT_EQ(tree().topLevelItemCount(), 3);
  const double now = (nowOf(a) - nowOf(b)).norm();
  const double rest = (restOf(a) - restOf(b)).norm();
  for (const int row : {1, 2}) {
    EXPECT_DOUBLE_EQ(*typedNumber(item(row).toolTip(1)), now);
    EXPECT_DOUBLE_EQ(*typedNumber(item(row).toolTip(2)), rest);
    EXPECT_NEAR(*typedNumber(item(row).toolTip(3)), now - rest, 1e-12);
    EXPECT_DOUBLE_EQ(*number(item(row), "along x"), (row == 1 ? 1 : -1) * (nowOf(b) - nowOf(a)).x());
  }
  // Escape takes the latest one away; the other one stays in the picture with any tool.
  key(Qt::Key_Escape);
  EXPECT_EQ(tree().topLevelItemCount(), 2);
  key(Qt::Key_S);
  test::moveMouse(viewport(), {3, 3});
  ASSERT_TRUE(settle());
  EXPECT_GT(accentPixels(), plain + 50);
  trigger("removeMeasurements");
  ASSERT_TRUE(settle());
  EXPECT_EQ(tree().topLevelItemCount(), 1);
  EXPECT_EQ(accentPixels(), plain);
  open("bar.obj");
  EXPECT_EQ(tree().topLevelItemCount(), 1);
}

TEST_F(MeasuringInWindow, LabelsStayInsideThePictureAndApart)
{
  const auto& overlay = find<ViewportOverlay>("overlay");
  const Index a = freeVertex();
  const Vector3 far = nowOf(a) + Vector3(0, 0, 40);
  Index b = a;
  for (Index v = 0; v < editor().positions().rows(); ++v)
    if ((nowOf(v) - far).norm() < (nowOf(b) - far).norm()) b = v;
  Measurements measurements;
  for (const Index v : {a, a, b, a}) measurements.probes.emplace_back(AtVertex{v});
  for (const Index v : {b, b}) measurements.rulers.push_back({AtVertex{a}, AtVertex{v}});
  editor().setMeasurements("measurements", measurements);
  const auto labels = [&] {
    std::vector<QRectF> all;
    for (const auto& [box, text] : overlay.rulerLabels()) all.push_back(box);
    for (const auto& probe : overlay.shownProbes()) all.push_back(probe.label);
    return all;
  };
  const QRectF picture = viewport().rect();
  QPointF at = seenAt(a);
  for (const QPointF& corner :
       {at, QPointF(2, 2), picture.bottomRight() - QPointF(3, 3), QPointF(2, picture.height() - 3)}) {
    test::drag(viewport(), {at, (at + corner) / 2, corner}, Qt::MiddleButton);
    ASSERT_TRUE(settle());
    at = corner;
    const std::vector<QRectF> all = labels();
    EXPECT_GE(all.size(), 5U);
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_TRUE(picture.contains(all[k])) << k;
      EXPECT_FALSE(all[k].intersects(viewport().legendBox())) << k;
      for (std::size_t j = 0; j < k; ++j) EXPECT_FALSE(all[j].intersects(all[k])) << j << ' ' << k;
    }
  }
}

TEST_F(MeasuringInWindow, TheSectionPlaneDrawsTheCut)
{
  trigger("sectionPlane");
  ASSERT_TRUE(settle());
  const int withCut = accentPixels();
  viewport().contents()->setCut({});
  viewport().scheduleRender();
  ASSERT_TRUE(settle());
  EXPECT_GT(withCut, accentPixels() + 200);
}

TEST_F(MeasuringInWindow, ThePanelMeshSaysWhatIsOpen)
{
  openPanel("Mesh");
  const QString text = find<QLabel>("meshAbout").text();
  EXPECT_TRUE(text.contains("bracket.obj")) << text.toStdString();
  EXPECT_TRUE(text.contains(countText(11'901) + " vertices, " + countText(23'818) + " faces, 1 part"))
      << text.toStdString();
  EXPECT_TRUE(text.contains("at rest 120 × 60 × 80")) << text.toStdString();
  EXPECT_TRUE(text.contains(" mm")) << text.toStdString();
}

}  // namespace
}  // namespace holdfast

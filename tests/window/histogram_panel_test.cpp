#include <QLabel>
#include <QPixmap>
#include <QToolTip>
#include <algorithm>

#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/window/panels/histogram_panel.h>

#include "gestures.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

class HistogramPanelTest : public ::testing::Test {
 protected:
  void open(const std::string& mesh, const std::string& constraints)
  {
    const std::string path = test::dataFolder() + "/" + mesh;
    NoProgress quiet;
    editor.open(loadMesh(path, quiet), {readConstraints(test::dataFolder() + "/" + constraints), {}});
    ASSERT_TRUE(test::waitUntil([&] { return editor.solveState() == SolveState::Current; }));
  }

  void show()
  {
    panel.resize(520, 560);
    ASSERT_TRUE(test::showAndWait(panel));
  }

  Editor editor;
  HistogramPanel panel{editor};
};

TEST_F(HistogramPanelTest, EveryBarOfAnglesPicksTheVerticesThatItCounts)
{
  open("bar.obj", "bar.twist_90.constraints.json");
  show();
  std::vector<Index> picked;
  QObject::connect(&panel, &HistogramPanel::verticesPicked, &panel,
                   [&](const std::vector<Index>& vertices) { picked = vertices; });
  HistogramView& view = panel.angleView();
  const Weld& weld = editor.model()->solverMesh.weld;
  Index total = 0;
  for (Index bar = 0; bar < static_cast<Index>(view.histogram().counts.size()); ++bar) {
    picked.clear();
    test::click(view, view.middleOf(bar));
    ASSERT_EQ(static_cast<Index>(picked.size()), view.histogram().counts[bar]) << bar;
    total += static_cast<Index>(picked.size());
    for (const Index vertex : picked) {
      const double degrees = angleDegrees(editor.deformation()->rotations.row(weld.unknownOf[vertex]).transpose());
      EXPECT_GE(degrees, view.histogram().edges[bar]);
      EXPECT_LE(degrees, view.histogram().edges[bar + 1]);
    }
  }
  EXPECT_EQ(total, editor.model()->mesh.vertexCount());
}

TEST_F(HistogramPanelTest, BarsBeyondThePromisePickTheConflicts)
{
  open("bracket.obj", "bracket.conflict.constraints.json");
  show();
  std::vector<Index> picked;
  QObject::connect(&panel, &HistogramPanel::constraintsPicked, &panel,
                   [&](const std::vector<Index>& constraints) { picked = constraints; });
  HistogramView& view = panel.residualView();
  std::vector<Index> beyond;
  for (Index bar = binOf(view.histogram(), 1e-11).value(); bar < static_cast<Index>(view.histogram().counts.size());
       ++bar) {
    picked.clear();
    test::click(view, view.middleOf(bar));
    beyond.insert(beyond.end(), picked.begin(), picked.end());
  }
  std::sort(beyond.begin(), beyond.end());
  std::vector<Index> conflicting;
  for (std::size_t k = 0; k < editor.deformation()->report.constraints.size(); ++k)
    if (editor.deformation()->report.constraints[k].status == ConstraintStatus::Conflicting)
      conflicting.push_back(static_cast<Index>(k));
  EXPECT_FALSE(conflicting.empty());
  EXPECT_EQ(beyond, conflicting);
}

TEST_F(HistogramPanelTest, ThePointerIsToldRangeAndCount)
{
  open("bar.obj", "bar.twist_90.constraints.json");
  show();
  HistogramView& view = panel.angleView();
  const Index last = static_cast<Index>(view.histogram().counts.size()) - 1;
  test::moveMouse(view, view.middleOf(last));
  EXPECT_TRUE(QToolTip::text().contains(QString::number(view.histogram().counts[last])))
      << QToolTip::text().toStdString();
  EXPECT_TRUE(QToolTip::text().contains(QStringLiteral("90°"))) << QToolTip::text().toStdString();
}

TEST_F(HistogramPanelTest, BesideTheBarsNothingIsPicked)
{
  open("bar.obj", "bar.twist_90.constraints.json");
  show();
  bool isPicked = false;
  QObject::connect(&panel, &HistogramPanel::verticesPicked, &panel, [&] { isPicked = true; });
  test::click(panel.angleView(), {1, 1});
  EXPECT_FALSE(isPicked);
}

TEST_F(HistogramPanelTest, KeysReachEveryBar)
{
  open("bracket.obj", "bracket.conflict.constraints.json");
  show();
  std::vector<Index> picked;
  QObject::connect(&panel, &HistogramPanel::constraintsPicked, &panel,
                   [&](const std::vector<Index>& constraints) { picked = constraints; });
  QWidget& chart = panel.residualView();
  const std::vector<Index>& counts = panel.residualView().histogram().counts;
  for (const Index count : counts) {
    if (count == 0) continue;
    test::pressKey(chart, Qt::Key_Right);
    test::pressKey(chart, Qt::Key_Return);
    EXPECT_EQ(static_cast<Index>(picked.size()), count);
  }
}

TEST_F(HistogramPanelTest, BarsAreDrawnWhereTheyAreClicked)
{
  open("bracket.obj", "bracket.conflict.constraints.json");
  show();
  HistogramView& view = panel.residualView();
  const auto& counts = view.histogram().counts;
  const Index highest = std::max_element(counts.begin(), counts.end()) - counts.begin();
  const Index empty = std::find(counts.begin(), counts.end(), 0) - counts.begin();
  const auto colorAt = [&](Index bar) {
    const QPixmap grabbed = view.grab();
    const QPointF place = view.middleOf(bar) * grabbed.devicePixelRatioF();
    return grabbed.toImage().pixelColor(place.toPoint());
  };
  const QColor ground = panel.palette().color(QPalette::Base);
  EXPECT_GT(colorAt(highest).saturation(), 80);
  EXPECT_EQ(colorAt(empty).rgb(), ground.rgb());
}

TEST_F(HistogramPanelTest, HintsSayWhatToDo)
{
  show();
  const auto* residuals = panel.findChild<QLabel*>("residualsHint");
  const auto* angles = panel.findChild<QLabel*>("anglesHint");
  EXPECT_TRUE(residuals->text().contains("No mesh"));
  open("bracket.obj", "bracket.constraints.json");
  EXPECT_FALSE(residuals->isVisible());
  EXPECT_TRUE(angles->isVisible());
  EXPECT_TRUE(angles->text().contains("rotate"));
  editor.close();
  EXPECT_TRUE(residuals->isVisible());
}

}  // namespace
}  // namespace holdfast

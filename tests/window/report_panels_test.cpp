#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <gtest/gtest.h>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/panels/panels.h>
#include <holdfast/window/text/number_text.h>

#include "gestures.h"
#include "open_document.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

ConstraintList pinned()
{
  return {"mm",
          {{"P1", true, PointConstraint{AtVertex{0}, Move{}}},
           {"P2", true, PointConstraint{AtVertex{3}, Move{Vector3(0, 0, 1)}}}}};
}

void press(QWidget& widget)
{
  test::click(widget, QPointF(widget.rect().center()));
}

TEST(FindingsPanel, ShowsWhereAFindingOfTheMeshIs)
{
  Editor editor;
  std::vector<Index> shown;
  const std::unique_ptr<QWidget> panel(
      newFindingsPanel(editor, [&](const std::vector<Index>& vertices) { shown = vertices; }));
  ASSERT_TRUE(test::showAndWait(*panel));
  EXPECT_TRUE(panel->findChild<QLabel*>("findingsEmpty")->isVisible());
  const Mesh mesh = test::withVertex(test::icosphere(1), Vector3(5, 5, 5));
  ASSERT_TRUE(test::openMesh(editor, mesh, pinned()));
  for (Card* card : panel->findChildren<Card*>())
    if (card->findChild<QLabel*>("cardTitle")->text() == "Unreferenced vertices")
      press(*card->findChild<QPushButton*>("findingShow"));
  EXPECT_EQ(shown, (std::vector<Index>{mesh.vertexCount() - 1}));
}

TEST(FindingsPanel, FacesAreShownByTheirVertices)
{
  const Mesh mesh = test::grid(2, 2);
  EXPECT_EQ(verticesOf({"needle_faces", 1, "face", {0}, ""}, mesh).size(), 3U);
  EXPECT_EQ(verticesOf({"components", 1, "vertex", {4, 2}, ""}, mesh), (std::vector<Index>{2, 4}));
  EXPECT_TRUE(verticesOf({"unsaid_rotation", 1, "constraint", {0}, ""}, mesh).empty());
}

TEST(FindingsPanel, SelectsTheConstraintsThatAFindingNames)
{
  Editor editor;
  const std::unique_ptr<QWidget> panel(newFindingsPanel(editor, {}));
  ASSERT_TRUE(test::showAndWait(*panel));
  ConstraintList list = pinned();
  list.constraints.push_back({"lone", true, RigidConstraint{{VertexIds{{7}}}}});
  ASSERT_TRUE(test::openMesh(editor, test::icosphere(1), list));
  for (Card* card : panel->findChildren<Card*>())
    if (card->findChild<QLabel*>("cardText")->text().contains("lone"))
      press(*card->findChild<QPushButton*>("findingShow"));
  EXPECT_EQ(editor.selectedConstraints(), (std::vector<Index>{2}));
}

/// A sheet whose middle is pulled over the rim that is held.
ConstraintList pulledOver(const Vector3& pull)
{
  std::vector<Index> rim;
  for (Index v = 0; v < 49; ++v)
    if (v % 7 == 0 || v % 7 == 6 || v / 7 == 0 || v / 7 == 6) rim.push_back(v);
  return test::listOf({test::hold(rim), test::moveBy(AtVertex{24}, pull)});
}

bool hasCard(const QWidget& panel, const QString& title)
{
  for (const Card* card : panel.findChildren<Card*>())
    if (card->isVisibleTo(&panel) && card->findChild<QLabel*>("cardTitle")->text() == title) return true;
  return false;
}

TEST(FindingsPanel, ListsWhatIsDoubtfulAboutTheResultAndShowsWhere)
{
  Editor editor;
  std::vector<Index> shown;
  const std::unique_ptr<QWidget> panel(
      newFindingsPanel(editor, [&](const std::vector<Index>& vertices) { shown = vertices; }));
  ASSERT_TRUE(test::showAndWait(*panel));
  ASSERT_TRUE(test::openMesh(editor, test::grid(6, 6), pulledOver({2.5, 0, 0})));
  ASSERT_TRUE(test::waitUntil([&] { return hasCard(*panel, "Folded faces"); }));
  ASSERT_TRUE(test::waitUntil([&] { return hasCard(*panel, "Inverted faces"); })) << "when it rests";
  EXPECT_EQ(panel->findChild<Card*>()->findChild<QLabel*>("cardTitle")->text(), "Folded faces") << "warnings first";
  for (Card* card : panel->findChildren<Card*>())
    if (card->findChild<QLabel*>("cardTitle")->text() == "Inverted faces")
      press(*card->findChild<QPushButton*>("findingShow"));
  EXPECT_FALSE(shown.empty());
}

TEST(FindingsPanel, LosesTheWarningsOfAResultThatIsFineAgain)
{
  Editor editor;
  const std::unique_ptr<QWidget> panel(newFindingsPanel(editor, {}));
  ASSERT_TRUE(test::showAndWait(*panel));
  ASSERT_TRUE(test::openMesh(editor, test::grid(6, 6), pulledOver({2.5, 0, 0})));
  ASSERT_TRUE(test::waitUntil([&] { return hasCard(*panel, "Folded faces"); }));
  editor.edit("push back", pulledOver({0.2, 0, 0}));
  ASSERT_TRUE(test::waitForCurrent(editor));
  ASSERT_TRUE(test::waitUntil([&] { return !hasCard(*panel, "Folded faces"); }));
  ASSERT_TRUE(test::waitUntil([&] { return editor.report()->result.crossingFaces.has_value(); }));
  EXPECT_EQ(editor.report()->result.status, ResultStatus::Fine);
}

class ReportPanelOfSphere : public ::testing::Test {
 protected:
  void SetUp() override
  {
    ASSERT_TRUE(test::openMesh(editor, test::icosphere(2), pinned()));
    ASSERT_TRUE(test::showAndWait(panel));
  }

  [[nodiscard]] QString value(const char* key) { return panel.findChild<QLabel*>(QString("report") + key)->text(); }
  void choose(const char* name, const char* text)
  {
    QComboBox& box = *panel.findChild<QComboBox*>(name);
    box.setCurrentIndex(box.findText(text));
    Q_EMIT box.activated(box.currentIndex());
  }

  Editor editor;
  std::unique_ptr<QWidget> report{newReportPanel(editor)};
  QWidget& panel = *report;
};

TEST_F(ReportPanelOfSphere, TellsTheSolutionAndCopiesIt)
{
  EXPECT_EQ(value("Status"), "ok");
  EXPECT_EQ(value("Constraints"), "2 met");
  EXPECT_EQ(value("RelativeResidual"), "met ≤ 1e-12 of the diagonal") << "and no other limit";
  EXPECT_TRUE(value("Residual").startsWith("met ≤ ")) << value("Residual").toStdString();
  EXPECT_EQ(typedNumber(panel.findChild<QLabel*>("reportResidual")->toolTip()),
            editor.deformation()->report.solve.maxResidual)
      << "all digits";
  EXPECT_TRUE(value("Accuracy").endsWith("; doubtful above 1e-09, refused above 1e-06"));
  EXPECT_EQ(value("Unknowns"), QString::number(editor.deformation()->report.solve.unknowns));
  press(*panel.findChild<QPushButton*>("reportCopy"));
  EXPECT_TRUE(QApplication::clipboard()->text().contains("Largest residual"));
  EXPECT_TRUE(QApplication::clipboard()->text().contains("cotangent"));
}

TEST_F(ReportPanelOfSphere, TellsWhatIsPromisedFarAway)
{
  ConstraintList list = editor.list();
  list.constraints[1].what = PointConstraint{AtVertex{3}, Target{Vector3(1e9, 0, 0)}};
  editor.edit("move", list);
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_TRUE(value("RelativeResidual").startsWith("met ≤ 1e-12, and up to 5.1"));
}

TEST_F(ReportPanelOfSphere, TellsTheAccuracyOfRotations)
{
  ConstraintList list = editor.list();
  list.constraints[1] = test::handle({3}, AxisRotation{Vector3::UnitX(), 30, {}}, Vector3::Zero());
  editor.edit("turn", list);
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_TRUE(value("RotationAccuracy").endsWith("; doubtful above 1e-09, refused above 1e-06"));
}

TEST_F(ReportPanelOfSphere, ChoosesWeightsAndSolver)
{
  choose("reportWeights", "Uniform");
  EXPECT_EQ(editor.state().options.weights, Weights::Uniform);
  EXPECT_EQ(editor.history().undoName(), "choose weights");
  QLineEdit& softWeight = *panel.findChild<QLineEdit*>("reportSoftWeight");
  EXPECT_FALSE(softWeight.isVisible());
  choose("reportSolver", "Soft: weighted least squares");
  EXPECT_EQ(editor.state().options.solver.kind, SolverKind::Soft);
  EXPECT_TRUE(softWeight.isVisible());
  softWeight.selectAll();
  test::type(softWeight, "12.5");
  test::pressKey(softWeight, Qt::Key_Return);
  EXPECT_EQ(editor.state().options.solver.softWeight, 12.5);
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_EQ(value("Weights"), "uniform");
  EXPECT_TRUE(value("Constraints").contains("missed"));
  while (editor.history().canUndo()) editor.undo();
  EXPECT_EQ(editor.state().options, DeformOptions());
  EXPECT_FALSE(softWeight.isVisible());
}

TEST_F(ReportPanelOfSphere, ChoosesWhereRotationsComeFrom)
{
  choose("reportRotations", "Found: edges keep their length");
  EXPECT_EQ(editor.state().options.rotations.source, RotationSource::Found);
  EXPECT_EQ(editor.history().undoName(), "choose where rotations come from");
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_TRUE(value("RotationIterations").startsWith("iteration "));
  editor.undo();
  EXPECT_EQ(editor.state().options, DeformOptions());
}

TEST_F(ReportPanelOfSphere, SetsWhereTheSearchForRotationsEnds)
{
  QLineEdit& change = *panel.findChild<QLineEdit*>("reportRotationChange");
  EXPECT_FALSE(change.isVisible());
  choose("reportRotations", "Found: edges keep their length");
  ASSERT_TRUE(test::waitForCurrent(editor));
  const int before = editor.deformation()->report.solve.iterations->count;
  EXPECT_TRUE(change.isVisible());
  EXPECT_EQ(change.text(), "1e-05");
  change.selectAll();
  test::type(change, "1e-12");
  test::pressKey(change, Qt::Key_Return);
  EXPECT_EQ(editor.state().options.rotations.change, 1e-12);
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_GT(editor.deformation()->report.solve.iterations->count, before);
  while (editor.history().canUndo()) editor.undo();
  EXPECT_EQ(editor.state().options, DeformOptions());
  EXPECT_FALSE(change.isVisible());
}

TEST_F(ReportPanelOfSphere, ALastChangeThatIsNotPositiveIsRefused)
{
  choose("reportRotations", "Found: smooth at single points");
  QLineEdit& change = *panel.findChild<QLineEdit*>("reportRotationChange");
  change.selectAll();
  test::type(change, "0");
  test::pressKey(change, Qt::Key_Return);
  EXPECT_EQ(editor.state().options.rotations.change, kFoundChange);
  EXPECT_EQ(change.text(), "1e-05");
}

TEST_F(ReportPanelOfSphere, ASoftWeightThatIsNotPositiveIsRefused)
{
  choose("reportSolver", "Soft: weighted least squares");
  QLineEdit& softWeight = *panel.findChild<QLineEdit*>("reportSoftWeight");
  softWeight.selectAll();
  test::type(softWeight, "-1");
  test::pressKey(softWeight, Qt::Key_Return);
  EXPECT_EQ(editor.state().options.solver.softWeight, 5);
  EXPECT_EQ(softWeight.text(), "5");
}

TEST_F(ReportPanelOfSphere, SaysWhenTheReportIsOld)
{
  QLabel& age = *panel.findChild<QLabel*>("reportAge");
  EXPECT_FALSE(age.isVisible());
  ConstraintList list = editor.list();
  list.constraints.pop_back();
  editor.edit("delete", list);
  EXPECT_TRUE(age.isVisible());
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_FALSE(age.isVisible());
}

}  // namespace
}  // namespace holdfast

// The steps of docs/gestures.md, done and counted.

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QPushButton>
#include <functional>
#include <regex>

#include <gtest/gtest.h>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/table/constraint_table_model.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "support/source_tree.h"
#include "window/dialogs.h"
#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

/// How many steps the page gives for a job, here; 0 where it has none.
int stepsOnPage(const std::string& page, int job)
{
  const std::regex row("\n\\| " + std::to_string(job) + R"(\. [^|\n]* \| (\d+): )");
  std::smatch match;
  return std::regex_search(page, match, row) ? std::stoi(match[1]) : 0;
}

class StepsOfJob : public test::JobWindow {
 protected:
  void openMesh(const char* name)
  {
    openFile(sample(name));
    window.files().setChooser(holdfast::chooseFile);
    key(Qt::Key_1, Qt::ControlModifier);
    ASSERT_TRUE(settle());
  }

  void press(Qt::Key pressed, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    ++steps;
    key(pressed, modifiers);
  }
  void write(const char* number)
  {
    ++steps;
    keys(number);
  }
  void pointAt(const QPointF& place)
  {
    ++steps;
    test::moveMouse(viewport(), place);
  }
  void clickAt(const QPointF& place)
  {
    ++steps;
    test::click(viewport(), place);
  }
  void dragAlong(const std::vector<QPointF>& way)
  {
    ++steps;
    test::drag(viewport(), way);
    ASSERT_TRUE(test::waitUntil([this] { return !editor().selectedVertices().empty(); }));
  }
  /// Does something that asks for a file, and types its name into the dialog.
  void nameFile(const std::function<void()>& ask, const std::filesystem::path& file)
  {
    const test::DialogAnswer answer("fileDialog", [&](QDialog& dialog) {
      ++steps;
      auto& name = *dialog.findChild<QLineEdit*>("fileNameEdit");
      name.selectAll();
      test::type(name, file.string().c_str());
      test::pressKey(name, Qt::Key_Return);
    });
    ask();
    ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven(); }));
  }
  void choose(const char* commandOfAMenu)
  {
    ++steps;
    trigger(commandOfAMenu);
  }

  void expectStepsOfPage(int job)
  {
    EXPECT_EQ(stepsOnPage(test::bytesOf(test::sourceFolder() + "/docs/gestures.md"), job), steps);
  }

  int steps = 0;
};

TEST_F(StepsOfJob, OneHoldsAndMovesAVertex)
{
  openMesh("bracket.obj");
  const Index vertex = freeVertex();
  press(Qt::Key_P);
  clickAt(seenAt(vertex));
  press(Qt::Key_X);
  write("2.5");
  press(Qt::Key_Return);
  ASSERT_TRUE(settle());
  EXPECT_EQ(nowOf(vertex), Vector3(restOf(vertex) + Vector3(2.5, 0, 0)));
  expectStepsOfPage(1);
}

TEST_F(StepsOfJob, TwoFixesARegionAndTurnsAnother)
{
  openMesh("head.ply");
  const QPointF neck = seenAt(nearestVertex({0, -12.6, -99}));
  const QPointF crown = seenAt(Vector3(0, 0, editor().positions().col(2).maxCoeff()));
  press(Qt::Key_B);
  dragAlong({neck, neck + QPointF(30, -4)});
  press(Qt::Key_F);
  ASSERT_TRUE(settle());
  press(Qt::Key_M);
  dragAlong({crown + QPointF(-200, -30), crown + QPointF(200, 60)});
  press(Qt::Key_H);
  ASSERT_TRUE(settle());
  pointAt(seenAt(window.gizmo().gizmo().GetFrame().center) + QPointF(kGizmoPixels, 0));
  write("400");
  press(Qt::Key_Return);
  ASSERT_TRUE(settle());
  ASSERT_EQ(list().constraints.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<FixedConstraint>(list().constraints[0].what));
  const auto& turn = std::get<AxisRotation>(std::get<HandleConstraint>(list().constraints[1].what).motion);
  EXPECT_NEAR(std::abs(turn.degrees), 400, 1e-9);
  expectStepsOfPage(2);
}

TEST_F(StepsOfJob, ThreeImportsAndRepairs)
{
  openMesh("bracket.obj");
  const auto measured = folder.file("measured.csv",
                                    "name,x,y,z,target_x,target_y,target_z\n"
                                    "datum,53.5,-19,0,53.5,-19,0\n"
                                    "lost,10,fifty,0,0,0,0\n"
                                    "rim,-15,10,50,-15,9,50.5\n"
                                    "rim again,-15,10,50,-15,9,52.5\n");
  nameFile([this] { press(Qt::Key_I, Qt::ControlModifier); }, measured);
  ASSERT_TRUE(test::waitUntil([] { return test::findDialog("importDialog") != nullptr; }));
  QDialog& dialog = *test::findDialog("importDialog");
  auto& button = *dialog.findChild<QPushButton*>("import");
  ASSERT_TRUE(test::waitUntil([&] { return button.isEnabled(); }));
  ++steps;
  test::clickButton(dialog, "import");
  ASSERT_TRUE(settle());
  ASSERT_EQ(list().constraints.size(), 3u);
  ++steps;
  openPanel("Conflicts");
  ++steps;
  clickOn(*find<Card>("conflict0").findChild<QPushButton*>("conflictAverage"));
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().deformation()->report.solve.status, SolveStatus::Ok);
  EXPECT_EQ(tabOf("Conflicts"), "Conflicts");
  expectStepsOfPage(3);
}

TEST_F(StepsOfJob, FourKeepsAFeatureRigid)
{
  openMesh("head.ply");
  press(Qt::Key_C);
  for (const Vector3& place : {Vector3(43, -76, 25), Vector3(27, -76, 41), Vector3(11, -76, 25), Vector3(27, -76, 9)})
    clickAt(seenAt(nearestVertex(place)));
  press(Qt::Key_Return);
  press(Qt::Key_R);
  ASSERT_EQ(list().constraints.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<RigidConstraint>(list().constraints[0].what));
  expectStepsOfPage(4);
}

TEST_F(StepsOfJob, FiveSavesAndExports)
{
  openMesh("bracket.obj");
  holdVertex(freeVertex());
  viewport().setFocus();
  window.exports().setChooser(holdfast::chooseFile);
  const auto isIdle = [this] { return !window.files().isSaving() && !window.exports().isWriting(); };
  nameFile([this] { press(Qt::Key_S, Qt::ControlModifier); }, path("done.holdfast"));
  ASSERT_TRUE(test::waitUntil(isIdle));
  waitForKeys();
  nameFile([this] { choose("exportMesh"); }, path("done.obj"));
  ASSERT_TRUE(test::waitUntil(isIdle));
  waitForKeys();
  nameFile([this] { choose("exportReport"); }, path("done.json"));
  ASSERT_TRUE(test::waitUntil(isIdle));
  waitForKeys();
  press(Qt::Key_F12);
  ASSERT_TRUE(test::waitUntil(isIdle));
  for (const char* name : {"done.holdfast", "done.obj", "done.json", "bracket.1.png"})
    EXPECT_TRUE(std::filesystem::exists(path(name))) << name;
  expectStepsOfPage(5);
}

TEST_F(StepsOfJob, SixGrowsInvertsAndDeselects)
{
  openMesh("head.ply");
  const Index all = editor().model()->mesh.vertexCount();
  editor().selectVertices({0});
  press(Qt::Key_Plus);
  const Index grown = static_cast<Index>(editor().selectedVertices().size());
  EXPECT_GT(grown, 3);
  press(Qt::Key_I);
  EXPECT_EQ(static_cast<Index>(editor().selectedVertices().size()), all - grown);
  press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(editor().selectedVertices().empty());
  expectStepsOfPage(6);
}

TEST_F(StepsOfJob, SevenLearnsWhatIsWrongWithAFile)
{
  openMesh("bracket.obj");
  const auto broken = folder.file("letters.off", "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n");
  QString said;
  const test::DialogAnswer answer("messageBox", [&](QDialog& box) {
    said = test::textOf(box);
    test::clickButton(box, "OK");
  });
  nameFile([this] { press(Qt::Key_O, Qt::ControlModifier); }, broken);
  ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven(); }));
  EXPECT_TRUE(said.contains("Line: 4") && said.contains("zero")) << said.toStdString();
  expectStepsOfPage(7);
}

TEST_F(StepsOfJob, EightIsJobOneWithoutAMouse)
{
  openMesh("bracket.obj");
  const Index vertex = freeVertex();
  const Vector3 place = restOf(vertex);
  const QString numbers =
      QString("%1,%2,%3").arg(place.x(), 0, 'g', 17).arg(place.y(), 0, 'g', 17).arg(place.z(), 0, 'g', 17);
  QApplication::clipboard()->setText("name,x,y,z,target_x,target_y,target_z\nhere," + numbers + ',' + numbers + '\n');
  while (QApplication::focusWidget() != &table()) press(Qt::Key_Tab);
  press(Qt::Key_V, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  while (table().currentIndex().column() != ConstraintTableModel::X) press(Qt::Key_Right);
  press(Qt::Key_F2);
  ASSERT_NE(qobject_cast<QLineEdit*>(QApplication::focusWidget()), nullptr);
  key(Qt::Key_A, Qt::ControlModifier);
  const double target = place.x() + 2.5;
  write(QByteArray::number(target, 'g', 17).constData());
  press(Qt::Key_Return);
  ASSERT_TRUE(test::waitUntil([this] { return QApplication::focusWidget() == &table(); }));
  ASSERT_TRUE(settle());
  EXPECT_EQ(nowOf(vertex), Vector3(target, place.y(), place.z()));
  expectStepsOfPage(8);
}

TEST(StepsOnPageMustFail, WhereAPageHasNoSuchJob)
{
  EXPECT_EQ(stepsOnPage("\n| 1. Hold | 5: P | x |\n", 1), 5);
  EXPECT_EQ(stepsOnPage("\n| 1. Hold | 5: P | x |\n", 2), 0);
}

}  // namespace
}  // namespace holdfast

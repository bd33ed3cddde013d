#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QSpinBox>
#include <QTimer>
#include <QTreeWidget>
#include <filesystem>
#include <memory>
#include <set>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/window/table/constraint_table_model.h>
#include <holdfast/window/viewport/view_state.h>

#include "dialogs.h"
#include "gestures.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"
#include "window_user.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

/// Every number of a camera that decides the picture.
std::vector<double> numbersOf(Viewport& viewport)
{
  vtkCamera& camera = *viewport.renderer().GetActiveCamera();
  std::vector<double> numbers;
  for (const double* triple : {camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()})
    numbers.insert(numbers.end(), triple, triple + 3);
  numbers.push_back(camera.GetParallelScale());
  numbers.push_back(camera.GetViewAngle());
  numbers.push_back(camera.GetParallelProjection());
  return numbers;
}

/// The bracket, opened from a file in a folder of the test's, with a point held and nothing saved.
class SessionInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    fs::copy_file(test::dataFolder() + "/bracket.obj", mesh());
    window.files().open(QString::fromStdString(mesh().string()));
    ASSERT_TRUE(test::waitUntil([this] { return editor().isOpen(); }));
    ASSERT_TRUE(settle());
    openPanel("Constraints");
    vertex = freeVertex();
    holdVertex(vertex);
    typeInto(0, ConstraintTableModel::Z, "12.3456789012345678");
    ASSERT_TRUE(settle());
  }

  void TearDown() override
  {
    // Of a window that was closed there is nothing to be asked.
    if (editor().isOpen()) editor().markSaved(editor().history().state());
  }

  [[nodiscard]] fs::path mesh() const { return folder.path() / "bracket.obj"; }
  [[nodiscard]] fs::path session() const { return folder.path() / "held.holdfast"; }

  void save()
  {
    chooseFile(session().string());
    key(Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(test::waitUntil([this] { return !window.files().isSaving(); }));
    ASSERT_TRUE(fs::exists(session()));
    ASSERT_FALSE(window.isWindowModified());
  }

  void choose(const char* box, int entry) { chooseEntry(find<QComboBox>(box), entry); }

  /// Turns, shifts and changes all that sessions keep of the view.
  void changeView()
  {
    const QPointF from(100, 100);
    test::drag(viewport(), {from, from + QPointF(50, 20), from + QPointF(123, 45)}, Qt::RightButton);
    test::drag(viewport(), {from, from + QPointF(17, 5)}, Qt::MiddleButton);
    key(Qt::Key_5, Qt::ControlModifier);
    openPanel("Colours");
    choose("colorField", static_cast<int>(ColorBy::Rotation));
    choose("colorMap", 2);
    choose("restGhost", 2);
    choose("meshEdges", 1);
    choose("surfaceDisplay", 1);
    for (const char* box : {"rotationArrows", "constraintGlyphs"}) {
      find<QCheckBox>(box).setFocus();
      key(Qt::Key_Space);
    }
    ASSERT_TRUE(viewport().isParallelProjection());
    ASSERT_EQ(viewport().display(), (DisplaySettings{RestGhost::Surface, MeshEdges::All, SurfaceDisplay::Wireframe,
                                                     RotationDisplay::Arrows, false}));
    ASSERT_TRUE(settle());
  }

  /// Opens the session in a window of its own.
  void openAgain()
  {
    again = std::make_unique<MainWindow>();
    again->resize(window.size());
    ASSERT_TRUE(test::showAndWait(*again));
    again->files().open(QString::fromStdString(session().string()));
    ASSERT_TRUE(test::waitUntil([this] { return again->editor().solveState() == SolveState::Current; }));
  }

  [[nodiscard]] std::string sessionOf(MainWindow& shown)
  {
    SessionFile file = shown.files().emptySessionAt(session());
    file.document = shown.editor().state();
    return sessionToJson(file);
  }

  void expectSameDocument()
  {
    EXPECT_EQ(sessionOf(*again), sessionOf(window));
    EXPECT_EQ(again->editor().state().options, editor().state().options);
    EXPECT_EQ(again->editor().positions(), editor().positions());
    EXPECT_EQ(viewStateOf(again->viewport()), viewStateOf(viewport()));
    EXPECT_EQ(numbersOf(again->viewport()), numbersOf(viewport()));
    EXPECT_EQ(again->viewport().display(), viewport().display());
    EXPECT_EQ(again->viewport().colors().field, viewport().colors().field);
    EXPECT_EQ(again->viewport().colors().map, viewport().colors().map);
  }

  test::TemporaryFolder folder;
  Index vertex = 0;
  std::unique_ptr<MainWindow> again;
};

TEST_F(SessionInWindow, ComesBackAsItWasBitForBit)
{
  changeView();
  openPanel("Solution");
  choose("reportWeights", 2);
  ASSERT_TRUE(settle());
  save();
  window.close();
  EXPECT_FALSE(window.isVisible());
  openAgain();
  expectSameDocument();
  EXPECT_EQ(again->editor().state().options.weights, Weights::Uniform);
  EXPECT_FALSE(again->isWindowModified());
  EXPECT_FALSE(again->editor().history().canUndo());
}

TEST_F(SessionInWindow, RangesOfColoursComeBack)
{
  openPanel("Colours");
  choose("colorRangeKind", 1);
  save();
  openAgain();
  const auto& fixed = std::get<FixedRange>(viewport().colors().range);
  ASSERT_TRUE(std::holds_alternative<FixedRange>(again->viewport().colors().range));
  EXPECT_EQ(std::get<FixedRange>(again->viewport().colors().range).low, fixed.low);
  EXPECT_EQ(std::get<FixedRange>(again->viewport().colors().range).high, fixed.high);
}

TEST_F(SessionInWindow, DecimalsOfLengthsComeBack)
{
  editor().setDecimals(3);
  save();
  openAgain();
  EXPECT_EQ(again->editor().decimals(), 3);
}

TEST_F(SessionInWindow, AMapThatWasNotChosenIsStillThatOfTheField)
{
  save();
  openAgain();
  EXPECT_EQ(again->viewport().colors().map, std::nullopt);
}

TEST_F(SessionInWindow, PowersOfTenComeBack)
{
  openPanel("Colours");
  choose("colorRangeKind", 2);
  for (int k = 0; k < 3; ++k) test::pressKey(find<QWidget>("colorDecades"), Qt::Key_Up);
  ASSERT_EQ(std::get<LogarithmicRange>(viewport().colors().range).decades, 7);
  save();
  openAgain();
  ASSERT_TRUE(std::holds_alternative<LogarithmicRange>(again->viewport().colors().range));
  EXPECT_EQ(std::get<LogarithmicRange>(again->viewport().colors().range).decades, 7);
}

TEST_F(SessionInWindow, HiddenFacesAndTheLooksOfTheLegendComeBack)
{
  openPanel("Colours");
  for (int k = 0; k < 3; ++k) test::pressKey(find<QWidget>("colorBands"), Qt::Key_Up);
  choose("legendSide", 1);
  const auto& faces = editor().model()->mesh.faces;
  std::set<Index> corners(faces[3].begin(), faces[3].end());
  corners.insert(faces[7].begin(), faces[7].end());
  editor().selectVertices({corners.begin(), corners.end()});
  trigger("hideSelection");
  const auto hidden = viewport().hiddenFaces();
  ASSERT_FALSE(hidden.empty());
  save();
  openAgain();
  EXPECT_EQ(again->viewport().hiddenFaces(), hidden);
  EXPECT_EQ(again->viewport().colors().bands, 4);
  EXPECT_EQ(again->findChild<QSpinBox*>("colorBands")->value(), 4);
  EXPECT_EQ(again->viewport().display().legend, LegendSide::Left);
}

TEST_F(SessionInWindow, ControlsShowWhatWasOpened)
{
  changeView();
  save();
  openAgain();
  EXPECT_TRUE(again->findChild<QAction*>("parallelProjection")->isChecked());
  EXPECT_EQ(again->findChild<QComboBox*>("colorField")->currentIndex(), static_cast<int>(ColorBy::Rotation));
  EXPECT_EQ(again->findChild<QComboBox*>("restGhost")->currentIndex(), 2);
  EXPECT_EQ(again->findChild<QComboBox*>("meshEdges")->currentIndex(), 1);
  EXPECT_TRUE(again->findChild<QCheckBox*>("rotationArrows")->isChecked());
  EXPECT_FALSE(again->findChild<QCheckBox*>("constraintGlyphs")->isChecked());
  again->findChild<QAction*>("parallelProjection")->trigger();
  EXPECT_FALSE(again->viewport().isParallelProjection()) << "one press changes it";
}

TEST_F(SessionInWindow, AnotherCameraIsAnotherSession)
{
  save();
  const std::string before = test::bytesOf(session());
  test::drag(viewport(), {QPointF(100, 100), QPointF(110, 100), QPointF(120, 100)}, Qt::RightButton);
  save();
  EXPECT_NE(test::bytesOf(session()), before) << "the comparison can fail";
}

TEST_F(SessionInWindow, CancelKeepsTheWindowOpen)
{
  ASSERT_TRUE(window.isWindowModified());
  answer(QMessageBox::Cancel);
  window.close();
  EXPECT_TRUE(wasAsked());
  EXPECT_TRUE(window.isVisible());
  EXPECT_EQ(list().constraints.size(), 1u);
}

TEST_F(SessionInWindow, DiscardClosesAndSavesNothing)
{
  answer(QMessageBox::Discard);
  window.close();
  EXPECT_TRUE(wasAsked());
  EXPECT_FALSE(window.isVisible());
  EXPECT_FALSE(fs::exists(session()));
}

TEST_F(SessionInWindow, SaveSavesAndCloses)
{
  chooseFile(session().string());
  answer(QMessageBox::Save);
  window.close();
  EXPECT_TRUE(wasAsked());
  EXPECT_FALSE(window.isVisible());
  openAgain();
  expectSameDocument();
}

TEST_F(SessionInWindow, SaveThatIsGivenUpKeepsTheWindowOpen)
{
  chooseFile("");
  answer(QMessageBox::Save);
  window.close();
  EXPECT_TRUE(wasAsked());
  EXPECT_TRUE(window.isVisible());
  EXPECT_TRUE(window.isWindowModified());
}

TEST_F(SessionInWindow, WhatIsSavedIsNotAskedAbout)
{
  save();
  // Were there a question, nobody would answer it: the box is given up by its own Escape.
  answer(QMessageBox::Cancel);
  window.close();
  EXPECT_FALSE(wasAsked());
  EXPECT_FALSE(window.isVisible());
}

TEST_F(SessionInWindow, EscapeOfTheQuestionIsCancel)
{
  QTimer asked;
  QObject::connect(&asked, &QTimer::timeout, &window, [&] {
    if (QWidget* box = QApplication::activeModalWidget()) {
      asked.stop();
      test::pressKey(*box, Qt::Key_Escape);
    }
  });
  asked.start(5);
  window.close();
  EXPECT_FALSE(asked.isActive());
  EXPECT_TRUE(window.isVisible());
}

TEST_F(SessionInWindow, OpeningAnotherFileAsksFirst)
{
  answer(QMessageBox::Cancel);
  window.files().open(QString::fromStdString(mesh().string()));
  EXPECT_TRUE(wasAsked());
  EXPECT_FALSE(window.files().isOpening());
  EXPECT_EQ(list().constraints.size(), 1u);
}

TEST_F(SessionInWindow, MeasurementsAndSavedSelectionsComeBack)
{
  viewport().setFocus();
  // Without arrows, which would take the clicks.
  editor().selectConstraints({});
  key(Qt::Key_Q);
  const QPointF place = seenAt(freeVertex());
  test::click(viewport(), place);
  key(Qt::Key_D);
  test::click(viewport(), place);
  test::click(viewport(), place + QPointF(3, 30));
  ASSERT_EQ(editor().measurements().probes.size(), 1u);
  ASSERT_EQ(editor().measurements().rulers.size(), 1u);
  editor().selectVertices({3, 1, 4});
  trigger("saveSelection");
  EXPECT_TRUE(window.isWindowModified());
  save();
  window.close();
  openAgain();
  expectSameDocument();
  EXPECT_EQ(again->editor().measurements().probes.size(), 1u);
  EXPECT_EQ(again->editor().measurements().rulers.size(), 1u);
  EXPECT_EQ(again->editor().annotations().selections.front().name, "selection 1");
  EXPECT_FALSE(again->isWindowModified());
  const auto* tree = again->findChild<QTreeWidget*>("measuredTree");
  again->findChild<QDockWidget*>("measuredDock")->raise();
  EXPECT_TRUE(test::waitUntil([&] { return tree->topLevelItemCount() == 3; })) << "cursor, probe, ruler";
}

TEST_F(SessionInWindow, MeasurementsElsewhereAreLeftOutAndTold)
{
  SessionFile file = window.files().emptySessionAt(session());
  file.document = editor().state();
  file.document.annotations = std::make_shared<const Annotations>(
      Annotations{{}, {{AtVertex{0}, AtVertex{1'000'000}}, {{AtVertex{0}, AtEdge{0, 9000, 0.5}}}}});
  writeSession(session(), file);
  editor().markSaved(editor().history().state());
  QString said;
  const test::DialogAnswer answer("messageBox", [&](QDialog& box) {
    said = test::textOf(box);
    test::clickButton(box, "OK");
  });
  window.files().open(QString::fromStdString(session().string()));
  ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven(); }));
  EXPECT_TRUE(said.contains("2 probes and rulers")) << said.toStdString();
  EXPECT_EQ(editor().measurements().probes.size(), 1u);
  EXPECT_TRUE(editor().measurements().rulers.empty());
  EXPECT_TRUE(window.isWindowModified()) << "saving would lose them";
}

}  // namespace
}  // namespace holdfast

#include <QLabel>
#include <QPushButton>
#include <memory>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/viewport/viewport_overlay.h>

#include "gestures.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// A box of 21,602 vertices, its foot held, its top moved: large enough that a factorisation can be seen to be under
/// way. What a test does while one is, it does when the worker says so, before anything newer is heard of it: nothing
/// depends on which of the two is faster.
class LargeDocument : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    MeshDocument document;
    document.mesh = test::box({1, 1, 2}, 60);
    NoProgress quiet;
    DocumentState state;
    state.list = test::listOf({test::moveTo(AtVertex{0}, document.mesh.positions.row(0).transpose()),
                               test::moveBy(AtVertex{top(document.mesh)}, {0, 0.2, 0.3})});
    editor().open(prepareMesh(std::move(document), "box", quiet), std::move(state));
    ASSERT_TRUE(settle());
    ASSERT_EQ(editor().solveState(), SolveState::Current);
    ASSERT_GT(editor().model()->mesh.vertexCount(), 20'000);
    before = editor().positions();
  }

  [[nodiscard]] static Index top(const Mesh& mesh)
  {
    Index vertex = 0;
    mesh.positions.rowwise().sum().maxCoeff(&vertex);
    return vertex;
  }

  void add(const std::string& name, decltype(Constraint::what) what)
  {
    editor().edit("add", added(editor().list(), {name, true, std::move(what)}));
  }

  /// A row of vertices is fixed: too much for the factor that is there, so that another one is made.
  void holdMore(Index row)
  {
    std::vector<Index> vertices(80);
    std::iota(vertices.begin(), vertices.end(), 100 * row);
    add("held " + std::to_string(row), FixedConstraint{{VertexIds{std::move(vertices)}}});
  }

  /// Runs `act` when the worker says that it factorises, while nothing that it says later has been handled.
  [[nodiscard]] bool whileFactorising(const std::function<void()>& act)
  {
    bool hasActed = false;
    const auto connection = QObject::connect(&editor(), &Editor::stepChanged, &window, [&] {
      if (hasActed || !editor().step().startsWith("factorising")) return;
      hasActed = true;
      act();
    });
    const bool hasCome = test::waitUntil([&] { return hasActed; });
    QObject::disconnect(connection);
    return hasCome;
  }

  /// Handles whatever the worker still says.
  void hearTheRest()
  {
    holdMore(17);
    ASSERT_TRUE(test::waitUntil([this] { return editor().solveState() == SolveState::Current; }));
    editor().undo();
  }

  [[nodiscard]] QImage note()
  {
    EXPECT_TRUE(settle());
    return viewport().grab(QRect(0, 0, viewport().width() / 2, 60)).toImage();
  }

  Positions before;
};

TEST_F(LargeDocument, APointMoreNeedsNoOtherFactor)
{
  add("held", PointConstraint{AtVertex{3}, Move{Vector3(0, 0.01, 0)}});
  ASSERT_TRUE(settle());
  EXPECT_THAT(editor().deformation()->report.solve.method, testing::HasSubstr("an earlier factor"));
  EXPECT_EQ(editor().deformation()->report.solve.status, SolveStatus::Ok);
  EXPECT_LE(editor().deformation()->report.solve.maxResidualRelative, 1e-14);
}

TEST_F(LargeDocument, EscapeStopsAFactorisation)
{
  holdMore(3);
  ASSERT_TRUE(whileFactorising([this] { key(Qt::Key_Escape); }));
  EXPECT_EQ(editor().solveState(), SolveState::Cancelled);
  EXPECT_EQ(editor().positions(), before);
  EXPECT_EQ(list().constraints.size(), 3u) << "the edit stays";
}

TEST_F(LargeDocument, TheButtonStopsAFactorisation)
{
  auto& stop = find<QPushButton>("statusStop");
  EXPECT_FALSE(stop.isVisible());
  holdMore(3);
  ASSERT_TRUE(whileFactorising([&] {
    EXPECT_TRUE(stop.isVisible());
    clickOn(stop);
  }));
  EXPECT_EQ(editor().solveState(), SolveState::Cancelled);
  EXPECT_EQ(editor().positions(), before);
  EXPECT_FALSE(stop.isVisible());
}

TEST_F(LargeDocument, ThePictureSaysThatItIsOlder)
{
  const QImage current = note();
  holdMore(3);
  ASSERT_TRUE(whileFactorising([this] { key(Qt::Key_Escape); }));
  EXPECT_TRUE(solveStateText(editor()).startsWith("Older")) << solveStateText(editor()).toStdString();
  EXPECT_TRUE(solveStateText(editor()).contains("F5"));
  EXPECT_NE(note(), current) << "a note over the picture";
  key(Qt::Key_F5);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(solveStateText(editor()).isEmpty());
}

TEST_F(LargeDocument, F5SolvesAgainWhatWasStopped)
{
  holdMore(3);
  ASSERT_TRUE(whileFactorising([this] { key(Qt::Key_Escape); }));
  key(Qt::Key_F5);
  EXPECT_EQ(editor().solveState(), SolveState::Solving);
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().solveState(), SolveState::Current);
  EXPECT_EQ(editor().deformedState(), editor().history().state());
  EXPECT_EQ(editor().deformation()->report.constraints.size(), 3u);
  EXPECT_NE(editor().positions(), before);
}

TEST_F(LargeDocument, NothingOfStoppedWorkIsShownLater)
{
  holdMore(3);
  ASSERT_TRUE(whileFactorising([this] { key(Qt::Key_Escape); }));
  int shown = 0;
  QObject::connect(&editor(), &Editor::deformed, &window, [&] {
    ++shown;
    EXPECT_EQ(editor().deformedState(), editor().history().state());
  });
  hearTheRest();
  EXPECT_EQ(shown, 1) << "that of the edit after it";
}

TEST_F(LargeDocument, MayBeClosedDuringAFactorisation)
{
  holdMore(3);
  ASSERT_TRUE(whileFactorising([this] { editor().close(); }));
  EXPECT_FALSE(editor().isOpen());
  EXPECT_EQ(editor().solveState(), SolveState::Nothing);
  EXPECT_EQ(find<QLabel>("statusStage").text(), "");
}

TEST_F(LargeDocument, UndoWhileSolvingShowsAtOnceWhatWas)
{
  holdMore(3);
  ASSERT_TRUE(whileFactorising([this] { key(Qt::Key_Z, Qt::ControlModifier); }));
  EXPECT_EQ(list().constraints.size(), 2u);
  int solved = 0;
  const auto steps =
      QObject::connect(&editor(), &Editor::stepChanged, &window, [&] { solved += editor().step().isEmpty() ? 0 : 1; });
  EXPECT_TRUE(test::waitUntil([this] { return editor().solveState() == SolveState::Current; }));
  QObject::disconnect(steps);
  EXPECT_EQ(editor().positions(), before);
  EXPECT_EQ(solved, 0) << "it was known";
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().deformation()->report.constraints.size(), 3u) << "redo solves it after all";
}

TEST_F(LargeDocument, OfEditsThatFollowOneAnotherTheLastIsShown)
{
  std::vector<std::shared_ptr<const DocumentState>> shown;
  QObject::connect(&editor(), &Editor::deformed, &window, [&] { shown.push_back(editor().deformedState()); });
  QObject::connect(&editor(), &Editor::solveStateChanged, &window, [&] {
    if (editor().solveState() == SolveState::Current) {
      EXPECT_EQ(editor().deformedState(), editor().history().state());
    }
  });
  holdMore(3);
  ASSERT_TRUE(whileFactorising([this] {
    holdMore(5);
    holdMore(7);
  }));
  EXPECT_EQ(editor().solveState(), SolveState::Solving);
  ASSERT_TRUE(settle());
  ASSERT_FALSE(shown.empty());
  EXPECT_EQ(shown.back(), editor().history().state());
  EXPECT_EQ(shown.size(), 1u) << "those that were superseded are never shown";
  NoProgress quiet;
  EXPECT_EQ(editor().positions(), deform(*editor().model(), list(), "box", editor().state().options, quiet).positions);
}

}  // namespace
}  // namespace holdfast

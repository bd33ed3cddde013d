// From a mouse event of a drag to the picture that shows what it has changed.

#include <QEventLoop>
#include <QTimer>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/window/main_window.h>

#include "bench/samples.h"
#include "bench/scenes.h"
#include "bench/window/benchmarks.h"
#include "window/gestures.h"

namespace holdfast::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMovesOfADrag = 120;
// Of a hand that moves.
constexpr int kMillisecondsBetweenMoves = 8;

constexpr int kDragsBefore = 5;

double millisecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void require(bool holds, const char* what)
{
  if (!holds) throw std::runtime_error(std::string("this does not hold in the window: ") + what);
}

/// The window with the handle of a scene selected. Takes down how long each state of a drag takes to be seen.
class DraggedWindow {
 public:
  explicit DraggedWindow(const Mesh& mesh)
  {
    window_.warmUp();
    window_.resize(1270, 1000);
    require(test::showAndWait(window_), "it is shown");
    NoProgress quiet;
    DocumentState state;
    state.list = scene(mesh);
    editor().open(prepareMesh({mesh, nullptr}, "generated", quiet), std::move(state));
    settle();
    editor().selectConstraints({kEnds - 1});
    settle();
    QObject::connect(&editor(), &Editor::stateChanged, &scope_, [this] { asked_[&editor().state()] = sent_; });
    QObject::connect(&editor(), &Editor::deformed, &scope_, [this] { solved(); });
    QObject::connect(&viewport(), &Viewport::rendered, &scope_, [this] { drawn_ = std::exchange(begun_, nullptr); });
    QObject::connect(&viewport(), &Viewport::aboutToRender, &scope_, [this] { begun_ = newest_; });
    QObject::connect(&viewport(), &QOpenGLWidget::frameSwapped, &scope_, [this] { shown(); });
  }

  /// Presses `grip` pixels left of the middle of the gizmo, and moves up and down from there.
  void drag(Samples& samples, const std::string& row, double grip)
  {
    samples_ = &samples;
    row_ = row;
    const QPointF from =
        viewport().toPlace(toDisplay(viewport().renderer(), window_.gizmo().gizmo().GetFrame().center).head<2>()) +
        QPointF(-grip, 0);
    test::moveMouse(viewport(), from);
    test::pressMouse(viewport(), from);
    require(window_.gizmo().isTouched(), "the gizmo is grabbed");
    QEventLoop loop;
    QTimer hand;
    int k = 0;
    QObject::connect(&hand, &QTimer::timeout, &loop, [&] {
      if (++k > kMovesOfADrag) return loop.quit();
      sent_ = Clock::now();
      test::moveMouse(viewport(), from + QPointF(0, 60 * std::sin(2 * std::numbers::pi * k / kMovesOfADrag)),
                      Qt::LeftButton);
    });
    hand.start(kMillisecondsBetweenMoves);
    loop.exec();
    test::releaseMouse(viewport(), from);
    settle();
  }

 private:
  [[nodiscard]] Editor& editor() { return window_.editor(); }
  [[nodiscard]] Viewport& viewport() { return window_.viewport(); }

  void settle()
  {
    require(
        test::waitUntil([&] { return editor().solveState() == SolveState::Current && !viewport().isRenderPending(); }),
        "what is asked for is solved and drawn");
  }

  /// Everything that follows a deformation but drawing has been done.
  void solved()
  {
    newest_ = editor().deformedState().get();
    const auto asked = asked_.find(newest_);
    if (asked != asked_.end()) samples_->add(row_, "ms ours", millisecondsSince(asked->second));
  }

  void shown()
  {
    const auto asked = asked_.find(std::exchange(drawn_, nullptr));
    if (asked == asked_.end()) return;
    samples_->add(row_, "ms picture", millisecondsSince(asked->second));
    asked_.erase(asked);
  }

  MainWindow window_;
  QObject scope_;
  std::map<const DocumentState*, Clock::time_point> asked_;  // when its event was sent
  Clock::time_point sent_;
  const DocumentState* newest_ = nullptr;
  const DocumentState* begun_ = nullptr;  // of the picture that is drawn
  const DocumentState* drawn_ = nullptr;  // of the one that waits for the window
  Samples* samples_ = nullptr;
  std::string row_;
};

}  // namespace

void dragInTheWindow(benchmark::State& state, const Mesh& mesh)
{
  DraggedWindow window(mesh);
  // The order for many results is found beside the first drags, and their factor with it.
  Samples before;
  for (int k = 0; k < kDragsBefore; ++k) window.drag(before, "", kGizmoPixels);
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    window.drag(samples, "moves", 0);
    window.drag(samples, "turns", kGizmoPixels);
  }
  samples.report(state);
}

}  // namespace holdfast::bench

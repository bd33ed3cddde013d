#include "holdfast/window/window/panel_docks.h"

#include <QAction>
#include <QLineEdit>
#include <QTimer>
#include <algorithm>

#include <holdfast/deform/outcomes.h>
#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/panels/panels.h>
#include <holdfast/window/table/constraint_table.h>

namespace holdfast {
namespace {

// The share of the window; the picture has the rest.
constexpr double kPanelShare = 0.42;
constexpr int kLeastPanelWidth = 340;
constexpr int kMostPanelWidth = 680;
constexpr int kLeastPictureWidth = 640;

/// Panels may be so wide: the picture comes first.
int mostPanelWidth(int windowWidth)
{
  return std::clamp(windowWidth - kLeastPictureWidth, kLeastPanelWidth, kMostPanelWidth);
}

/// The vertex that a point under the cursor is nearest to, as its weights say.
Index nearestVertex(const SurfacePick& pick, const Model& model)
{
  if (const auto* vertex = std::get_if<AtVertex>(&pick.location)) return vertex->vertex;
  if (const auto* edge = std::get_if<AtEdge>(&pick.location)) return edge->t >= 0.5 ? edge->i : edge->j;
  const auto& weights = std::get<AtFace>(pick.location).weights;
  const auto largest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  return model.mesh.faces[pick.face][static_cast<std::size_t>(largest)];
}

/// Qt calls a dock behind others visible: its panel would follow every change, and draw pictures that are not seen.
void showWhileInFront(QWidget& panel, const QDockWidget& dock)
{
  // The dock asks for the same room, so that nothing moves from tab to tab.
  QSizePolicy policy = panel.sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  panel.setSizePolicy(policy);
  panel.hide();
  QObject::connect(&dock, &QDockWidget::visibilityChanged, &panel, &QWidget::setVisible);
}

}  // namespace

PanelDocks::PanelDocks(Editor& editor, Viewport& viewport, QMainWindow& window)
    : QObject(&window), editor_(editor), viewport_(viewport), window_(window)
{
  auto* constraints = newConstraintPanel(editor, [this](Index k) { viewport_.frameConstraints({k}); });
  sphere_ = new SpherePanel(editor);
  histograms_ = new HistogramPanel(editor);
  colors_ = new ColorPanel(editor, &window);
  upper_ = {add(tr("Constraints"), "constraintsDock", constraints), add(tr("Colours"), "colorsDock", colors_),
            add(tr("Rotations"), "sphereDock", sphere_), add(tr("Distributions"), "histogramDock", histograms_),
            add(tr("Selections"), "selectionsDock", newSelectionsPanel(editor))};
  const auto showVertices = [this](const std::vector<Index>& vertices) {
    editor_.selectVertices(vertices);
    viewport_.frameVertices(vertices);
  };
  conflicts_ = add(tr("Conflicts"), "conflictsDock", newConflictPanel(editor));
  findings_ = add(tr("Mesh"), "findingsDock", newFindingsPanel(editor, showVertices));
  lower_ = {add(tr("Selected"), "inspectorDock", newInspectorPanel(editor)), conflicts_, findings_,
            add(tr("Measured"), "measuredDock", newMeasuredPanel(editor)),
            add(tr("Solution"), "reportDock", newReportPanel(editor))};
  arrange();
  window_.installEventFilter(this);

  connect(colors_, &ColorPanel::settingsChanged, &viewport_, &Viewport::setColors);
  connect(colors_, &ColorPanel::displaySettingsChanged, &viewport_, &Viewport::setDisplay);
  connect(colors_, &ColorPanel::shownShareChosen, &viewport_, &Viewport::setShownShare);
  connect(&viewport_, &Viewport::shownShareChanged, colors_, &ColorPanel::setShownShare);
  connect(&viewport_, &Viewport::legendDoubleClicked, this, &PanelDocks::showColors);
  connect(&viewport_, &Viewport::coloringChanged, sphere_, &SpherePanel::setColoring);
  connect(&viewport_, &Viewport::coloringChanged, colors_, [this](const std::optional<Coloring>& coloring) {
    colors_->setShownScale(coloring ? std::optional(coloring->scale) : std::nullopt);
  });
  const auto markVertex = [this] {
    const auto& pick = editor_.underCursor().pick;
    const auto& selected = editor_.selectedVertices();
    sphere_->showVertex(pick                   ? std::optional(nearestVertex(*pick, *editor_.model()))
                        : selected.size() == 1 ? std::optional(selected.front())
                                               : std::nullopt);
  };
  connect(sphere_, &SpherePanel::vertexPicked, &editor_, [this](Index vertex) { editor_.selectVertices({vertex}); });
  for (const auto& signal : {&Editor::underCursorChanged, &Editor::vertexSelectionChanged})
    connect(&editor_, signal, sphere_, markVertex);
  connect(histograms_, &HistogramPanel::constraintsPicked, &editor_, &Editor::selectConstraints);
  connect(histograms_, &HistogramPanel::verticesPicked, &editor_,
          [this](const std::vector<Index>& vertices) { editor_.selectVertices(vertices); });
  for (const auto& signal : {&Editor::opened, &Editor::deformed})
    connect(&editor_, signal, this, &PanelDocks::countConflicts);
  for (const auto& signal : {&Editor::opened, &Editor::deformed, &Editor::examined})
    connect(&editor_, signal, this, &PanelDocks::countWarnings);
}

QDockWidget* PanelDocks::add(const QString& title, const QString& objectName, QWidget* panel)
{
  auto* dock = named(new QDockWidget(title, &window_), objectName);
  dock->toggleViewAction()->setToolTip(tr("Show or hide the panel “%1”").arg(title));
  dock->setWidget(panel);
  // Its tab names it already; the menu shows and hides it.
  dock->setTitleBarWidget(new QWidget(dock));
  showWhileInFront(*panel, *dock);
  return dock;
}

void PanelDocks::arrange()
{
  window_.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  window_.addDockWidget(Qt::RightDockWidgetArea, upper_.front());
  window_.splitDockWidget(upper_.front(), lower_.front(), Qt::Vertical);
  for (const auto* stack : {&upper_, &lower_}) {
    for (int k = 1; k < stack->size(); ++k) window_.tabifyDockWidget((*stack)[k - 1], (*stack)[k]);
    stack->front()->raise();
  }
}

void PanelDocks::share(const QSize& size)
{
  const int width =
      std::clamp(static_cast<int>(kPanelShare * size.width()), kLeastPanelWidth, mostPanelWidth(size.width()));
  window_.resizeDocks({upper_.front()}, {width}, Qt::Horizontal);
  window_.resizeDocks({upper_.front(), lower_.front()}, {size.height() / 2, size.height() / 2}, Qt::Vertical);
}

bool PanelDocks::eventFilter(QObject* watched, QEvent* event)
{
  // Once the window has laid itself out.
  if (watched == &window_ && event->type() == QEvent::Resize) QTimer::singleShot(0, this, &PanelDocks::yield);
  return QObject::eventFilter(watched, event);
}

/// Where the window becomes narrower Qt takes the room from the picture alone.
void PanelDocks::yield()
{
  const int most = mostPanelWidth(window_.width());
  const auto isTooWide = [&](QDockWidget* dock) {
    return dock->isVisible() && !dock->isFloating() && dock->width() > most &&
           window_.dockWidgetArea(dock) == Qt::RightDockWidgetArea;
  };
  for (const auto* stack : {&upper_, &lower_}) {
    const auto wide = std::find_if(stack->begin(), stack->end(), isTooWide);
    if (wide != stack->end()) return window_.resizeDocks({*wide}, {most}, Qt::Horizontal);
  }
}

void PanelDocks::fillMenu(QMenu& menu) const
{
  for (const auto* stack : {&upper_, &lower_})
    for (QDockWidget* dock : *stack) menu.addAction(dock->toggleViewAction());
}

void PanelDocks::followViewport()
{
  colors_->setSettings(viewport_.colors());
  colors_->setDisplaySettings(viewport_.display());
}

void PanelDocks::bringToFront(const char* dock)
{
  auto* panel = window_.findChild<QDockWidget*>(dock);
  panel->show();
  panel->raise();
}

void PanelDocks::showWelding()
{
  bringToFront("reportDock");
  auto* line = window_.findChild<QLineEdit*>("reportWeld");
  QTimer::singleShot(0, line, [line] {
    line->setFocus(Qt::ShortcutFocusReason);
    line->selectAll();
  });
}

void PanelDocks::showColors()
{
  bringToFront("colorsDock");
  // The panel is hidden with its tab, and cannot have the keys before.
  QTimer::singleShot(0, colors_, &ColorPanel::focusRange);
}

void PanelDocks::countConflicts()
{
  const auto& deformation = editor_.deformation();
  const Index count = deformation ? countOf(deformation->report, ConstraintStatus::Conflicting) : 0;
  conflicts_->setWindowTitle(count > 0 ? tr("Conflicts (%1)").arg(count) : tr("Conflicts"));
}

void PanelDocks::countWarnings()
{
  if (!editor_.isResultKnown()) return;
  const auto& report = editor_.report();
  const std::size_t count = report ? report->result.warnings.size() : 0;
  findings_->setWindowTitle(count > 0 ? tr("Mesh (%1)").arg(count) : tr("Mesh"));
}

}  // namespace holdfast

#include "holdfast/window/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QTimer>
#include <QToolBar>
#include <algorithm>
#include <array>
#include <functional>

#include <vtkRenderer.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/scene/example_document.h>
#include <holdfast/window/controls/icons.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/files/dropped_files.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/files/import_dialog.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/tools/gizmo_tool.h>
#include <holdfast/window/tools/section_tool.h>
#include <holdfast/window/tools/tool_box.h>
#include <holdfast/window/viewport/view_state.h>
#include <holdfast/window/viewport/viewport.h>
#include <holdfast/window/window/help_dialog.h>
#include <holdfast/window/window/panel_docks.h>
#include <holdfast/window/window/status_line.h>

namespace holdfast {

MainWindow::MainWindow()
    : files_(editor_, this),
      exports_(editor_, this),
      viewport_(new Viewport(editor_, this)),
      gizmo_(new GizmoTool(editor_, *viewport_, this)),
      tools_(new ToolBox(editor_, *viewport_, this)),
      status_(new StatusLine(editor_, this)),
      panels_(new PanelDocks(editor_, *viewport_, *this))
{
  setObjectName("mainWindow");
  setAcceptDrops(true);
  setCentralWidget(viewport_);
  viewport_->setFirstTool(gizmo_);
  setStatusBar(status_);
  makeFileMenu();
  makeEditMenu();
  makeSelectionMenu();
  makeConstraintMenu();
  makeViewMenu();
  makeHelpMenu();
  makeToolBars();
  connectStatus();
  connectFiles();
  updateTitle();
  updateActions();
}

MainWindow::~MainWindow()
{
  // The base class deletes the tools, which end their work then and say that they have changed.
  tools_->disconnect(this);
  gizmo_->disconnect(this);
}

QAction* MainWindow::addAction(QMenu& menu, const QString& name, const QString& text, const QKeySequence& key,
                               const QString& tip, std::function<void()> run, Needs needs)
{
  QAction* action = named(menu.addAction(text), name);
  action->setShortcut(key);
  const QString plain = QString(tip).remove('&');
  action->setToolTip(key.isEmpty() ? plain : QString("%1 (%2)").arg(plain, key.toString(QKeySequence::NativeText)));
  action->setStatusTip(plain);
  connect(action, &QAction::triggered, this, std::move(run));
  if (needs != Needs::Nothing) needs_.emplace_back(action, needs);
  return action;
}

void MainWindow::makeFileMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&File"));
  addAction(menu, "open", tr("&Open…"), QKeySequence::Open, tr("Open a mesh or a session"),
            [this] { files_.openDialog(); });
  QMenu* recent = menu.addMenu(tr("Open &recent"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { files_.fillRecentMenu(*recent); });
  menu.addSeparator();
  addAction(
      menu, "save", tr("&Save"), QKeySequence::Save, tr("Save the mesh's constraints and the view as a session"),
      [this] { files_.saveInBackground(); }, Needs::Document);
  addAction(
      menu, "saveAs", tr("Save &as…"), QKeySequence("Ctrl+Shift+S"), tr("Save as another session"),
      [this] { files_.saveAsInBackground(); }, Needs::Document);
  menu.addSeparator();
  addAction(
      menu, "import", tr("&Import constraints…"), QKeySequence("Ctrl+I"),
      tr("Add measured points (CSV) or constraints (JSON), after a look at where they lie"),
      [this] { importConstraints(editor_, this); }, Needs::Document);
  QMenu& out = *menu.addMenu(tr("&Export"));
  const auto add = [&](const char* name, const QString& text, const QString& tip, void (DocumentExports::*run)()) {
    addAction(
        out, name, text, {}, tip, [this, run] { (exports_.*run)(); }, Needs::Document);
  };
  add("exportMesh", tr("&Mesh…"), tr("The deformed mesh, in any format"), &DocumentExports::exportMesh);
  add("exportFields", tr("&Fields…"), tr("Residuals, rotations and displacements at all vertices, as VTP"),
      &DocumentExports::exportFields);
  add("exportReport", tr("&Report…"), tr("The outcome of each constraint, as JSON or CSV"),
      &DocumentExports::exportReport);
  add("exportConstraints", tr("&Constraints…"), tr("A constraint file for holdfast-batch"),
      &DocumentExports::exportConstraints);
  add("exportPicture", tr("&Picture…"), tr("The picture as you see it, at any size"), &DocumentExports::exportPicture);
  menu.addSeparator();
  addAction(menu, "quit", tr("&Quit"), QKeySequence("Ctrl+Q"), tr("Close the window"), [this] { close(); });
}

void MainWindow::makeHelpMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&Help"));
  addAction(menu, "help", tr("&Ten gestures"), QKeySequence(Qt::Key_F1), tr("The most useful gestures, on one page"),
            [this] { showHelp(this); });
  addAction(menu, "about", tr("&About Holdfast"), {}, tr("The version of the program"), [this] {
    QMessageBox::about(
        this, tr("About Holdfast"),
        tr("<b>Holdfast %1</b><p>Deforms triangle meshes under exact positional constraints, after H. Masuda, "
           "Y. Yoshioka, Y. Furukawa, <i>Interactive mesh deformation using equality-constrained least "
           "squares</i>.</p>")
            .arg(QApplication::applicationVersion()));
  });
}

void MainWindow::connectFiles()
{
  files_.setView([this] { return viewStateOf(*viewport_); });
  connect(&files_, &DocumentFiles::viewOpened, this, [this](const ViewState& view) {
    apply(view, *viewport_);
    panels_->followViewport();
    findChild<QAction*>("parallelProjection")->setChecked(viewport_->isParallelProjection());
  });
  connect(&files_, &DocumentFiles::pathChanged, this, &MainWindow::updateTitle);
  connect(&files_, &DocumentFiles::done, this, [this](const QString& what) { status_->showMessage(what, 6000); });
  exports_.setPictureView([this]() -> PictureView {
    const DisplaySettings display = viewport_->display();
    const auto section = viewport_->section();
    return {cameraOf(*viewport_->renderer().GetActiveCamera()), viewport_->coloring(),
            [display, section](SceneContents& contents) {
              arrange(contents, display);
              contents.setSection(section);
            }};
  });
  connect(&exports_, &DocumentExports::done, this, [this](const QString& what) { status_->showMessage(what, 6000); });
  if (const auto folder = recoveryFolder()) {
    autosave_ = std::make_unique<Autosave>(editor_, files_, *folder, this);
    connect(autosave_.get(), &Autosave::failed, this, [this](const QString& why) { status_->showMessage(why, 12000); });
  }
  connect(viewport_, &Viewport::contextMenuWanted, this, &MainWindow::showContextMenu);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (localFiles(*event->mimeData()).isEmpty()) return;
  // Never a move, which would delete the file at its source.
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

void MainWindow::dropEvent(QDropEvent* event)
{
  event->setDropAction(Qt::CopyAction);
  event->accept();
  // The program that the files come from waits until this returns; questions may take longer.
  QTimer::singleShot(0, this, [this, files = sorted(localFiles(*event->mimeData()))] { take(files); });
}

void MainWindow::take(const DroppedFiles& files)
{
  const QString& path = files.taken;
  const QString name = QFileInfo(path).fileName();
  if (!files.leftAlone.isEmpty())
    status_->showMessage(tr("One file at a time: %1 is taken, %2 more not").arg(name).arg(files.leftAlone.size()),
                         12000);
  if (!files.isList) return files_.open(path);
  if (editor_.isOpen()) return importConstraints(editor_, this, [path](QWidget*, const FileQuestion&) { return path; });
  showProblem(this, tr("“%1” cannot be opened.").arg(name),
              tr("It is a list of constraints. Open the mesh that they belong to, and drop the list on it."));
}

void MainWindow::showContextMenu(const QPoint& place)
{
  QMenu menu(this);
  for (const char* name : {"makeFixed", "makeHandle", "makeRigid", "", "grow", "shrink", "invert", "", "toggleEnabled",
                           "deleteConstraints", "", "frameSelection", "frameAll"})
    if (*name == 0)
      menu.addSeparator();
    else
      menu.addAction(findChild<QAction*>(name));
  menu.exec(viewport_->mapToGlobal(place));
}

void MainWindow::warmUp()
{
  // The OpenGL contexts of the panels share memory with that of the window.
  static_cast<void>(winId());
  const ExampleDocument example = exampleDocument();
  viewport_->warmUp(example);
  panels_->warmUp(example);
}

void MainWindow::showEvent(QShowEvent* event)
{
  QMainWindow::showEvent(event);
  if (event->spontaneous()) return;
  panels_->share(size());
  if (autosave_) QTimer::singleShot(0, this, [this] { autosave_->offerRecovery(); });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  event->setAccepted(files_.maySaveBefore(tr("closing the window")));
}

void MainWindow::makeEditMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
  undo_ = addAction(menu, "undo", tr("&Undo"), QKeySequence::Undo, tr("Take the last edit back"),
                    [this] { editor_.undo(); });
  redo_ = addAction(menu, "redo", tr("&Redo"), QKeySequence("Ctrl+Shift+Z"),
                    tr("Do the edit again that was undone last"), [this] { editor_.redo(); });
  menu.addSeparator();
  addAction(menu, "escape", tr("&Cancel"), QKeySequence(Qt::Key_Escape),
            tr("Take back what is under way: a drag, a curve, solving; or select nothing"), [this] { escape(); });
  addAction(
      menu, "solveAgain", tr("&Solve again"), QKeySequence(Qt::Key_F5), tr("Solve again after it was stopped"),
      [this] { editor_.solve(); }, Needs::Document);
}

void MainWindow::makeSelectionMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&Select"));
  for (QAction* tool : tools_->actions()) {
    menu.addAction(tool);
    needs_.emplace_back(tool, Needs::Document);
  }
  menu.addSeparator();
  const auto vertices = [this] { return editor_.selectedVertices(); };
  const auto regions = [this]() -> VertexRegions& { return *editor_.mesh().regions; };
  addAction(
      menu, "grow", tr("&Grow"), QKeySequence("+"), tr("Select the next ring of vertices, too"),
      [this, vertices, regions] { editor_.selectVertices(regions().grown(vertices())); }, Needs::Vertices);
  addAction(
      menu, "shrink", tr("S&hrink"), QKeySequence("-"), tr("Take the outermost vertices out of the selection"),
      [this, vertices, regions] { editor_.selectVertices(regions().shrunk(vertices())); }, Needs::Vertices);
  addAction(
      menu, "invert", tr("&Invert"), QKeySequence("I"), tr("Select all other vertices"),
      [this, vertices, regions] { editor_.selectVertices(regions().inverted(vertices())); }, Needs::Document);
  addAction(
      menu, "deselect", tr("&Nothing"), QKeySequence("Ctrl+Shift+A"), tr("Deselect all vertices"),
      [this] { editor_.selectVertices({}); }, Needs::Vertices);
}

void MainWindow::makeConstraintMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&Constrain"));
  const auto add = [&](const char* objectName, const QString& text, const char* key, const QString& tip,
                       RegionKind kind) {
    addAction(
        menu, objectName, text, QKeySequence(key), tip, [this, kind] { constrainSelection(editor_, kind); },
        Needs::Vertices);
  };
  add("makeFixed", tr("&Fix the selection"), "F", tr("The selected vertices stay where they are"), RegionKind::Fixed);
  add("makeHandle", tr("Make a &handle of it"), "H", tr("The selected vertices move as you drag them"),
      RegionKind::Handle);
  add("makeRigid", tr("Make a &rigid feature of it"), "R",
      tr("The selected vertices keep their shape wherever the surface takes them"), RegionKind::Rigid);
  menu.addSeparator();
  addAction(
      menu, "toggleEnabled", tr("&Enable or disable"), QKeySequence("E"),
      tr("Switch the selected constraints off, or on again"),
      [this] { toggleConstraints(editor_, Rows(editor_.selectedConstraints())); }, Needs::Constraints);
  addAction(
      menu, "deleteConstraints", tr("&Delete"), QKeySequence(Qt::Key_Delete), tr("Delete the selected constraints"),
      [this] {
        removeConstraints(editor_, Rows(editor_.selectedConstraints()));
        editor_.selectConstraints({});
      },
      Needs::Constraints);
}

void MainWindow::makeViewMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  addAction(
      menu, "frameAll", tr("Show &all"), QKeySequence(Qt::Key_Home), tr("Show the whole mesh"),
      [this] { viewport_->frameAll(); }, Needs::Document);
  addAction(
      menu, "frameSelection", tr("Show the &selection"), QKeySequence("."), tr("Show the selection from near"),
      [this] { frameSelection(); }, Needs::Document);
  menu.addSeparator();
  struct Side {
    const char* objectName;
    QString text;
    const char* key;
    Vector3 direction;
    Vector3 up;
  };
  const std::array sides{Side{"viewFront", tr("From the &front"), "1", Vector3::UnitY(), Vector3::UnitZ()},
                         Side{"viewBack", tr("From &behind"), "Ctrl+1", -Vector3::UnitY(), Vector3::UnitZ()},
                         Side{"viewRight", tr("From the &right"), "3", -Vector3::UnitX(), Vector3::UnitZ()},
                         Side{"viewLeft", tr("From the &left"), "Ctrl+3", Vector3::UnitX(), Vector3::UnitZ()},
                         Side{"viewTop", tr("From a&bove"), "7", -Vector3::UnitZ(), Vector3::UnitY()},
                         Side{"viewBottom", tr("From bel&ow"), "Ctrl+7", Vector3::UnitZ(), -Vector3::UnitY()}};
  for (const Side& side : sides)
    addAction(
        menu, side.objectName, side.text, QKeySequence(side.key), side.text,
        [this, side] { viewport_->lookAlong(side.direction, side.up); }, Needs::Document);
  menu.addSeparator();
  QAction* parallel = addAction(menu, "parallelProjection", tr("&Parallel projection"), QKeySequence("5"),
                                tr("Without perspective"), [] {});
  parallel->setCheckable(true);
  connect(parallel, &QAction::toggled, viewport_, &Viewport::setParallelProjection);

  const auto choices = [&](const QString& title) {
    return [this, &choiceMenu = *menu.addMenu(title), group = new QActionGroup(this)](
               const char* name, const QString& text, const char* key, const QString& tip, std::function<void()> run) {
      QAction* action = addAction(choiceMenu, name, text, QKeySequence(key), tip, std::move(run));
      action->setCheckable(true);
      action->setChecked(group->actions().isEmpty());
      group->addAction(action);
    };
  };
  const auto addAxes = choices(tr("A&xes of the arrows"));
  const QString own = tr("Its &own: a handle's, or across the surface");
  addAxes("axesWorld", tr("Of the &world"), "Shift+W", tr("Of the world"),
          [this] { gizmo_->setAxes(GizmoAxes::World); });
  addAxes("axesOwn", own, "Shift+H", own, [this] { gizmo_->setAxes(GizmoAxes::Own); });
  addAxes("axesView", tr("Of the &view"), "Shift+V", tr("Of the view"), [this] { gizmo_->setAxes(GizmoAxes::View); });
  const auto addRotation = choices(tr("&Turn of a handle that is moved"));
  addRotation("turnAsConstraint", tr("As the &constraint says"), "",
              tr("A handle that is moved turns as its constraint says: not at all, or about what is fixed"),
              [this] { gizmo_->setRotationOfMoves(RotationOfMoves::AsConstraint); });
  addRotation("turnAsSeen", tr("As &seen about what is fixed"), "",
              tr("A handle that is moved turns about the viewing axis, by the angle that it makes on the screen"),
              [this] { gizmo_->setRotationOfMoves(RotationOfMoves::AsSeen); });
  menu.addSeparator();
  QAction* section = addAction(
      menu, "sectionPlane", tr("&Section plane"), QKeySequence("Shift+S"),
      tr("Cut the picture open; the mesh stays whole"), [] {}, Needs::Document);
  section->setCheckable(true);
  connect(section, &QAction::toggled, new SectionTool(editor_, *viewport_, this), &SectionTool::setOn);

  panels_->fillMenu(*menu.addMenu(tr("&Panels")));
  const auto addColors = choices(tr("&Colours of the window"));
  const QString tip = tr("Colours of the window: %1");
  addColors("colorsOfDesktop", tr("As the &desktop"), "", tip.arg(tr("as the desktop")),
            [] { apply(Appearance::System); });
  addColors("colorsLight", tr("&Light"), "", tip.arg(tr("light")), [] { apply(Appearance::Light); });
  addColors("colorsDark", tr("D&ark"), "", tip.arg(tr("dark")), [] { apply(Appearance::Dark); });
}

void MainWindow::makeToolBars()
{
  QToolBar* bar = named(addToolBar(tr("Tools")), "toolBar");
  bar->setMovable(false);
  bar->toggleViewAction()->setToolTip(tr("Show or hide the tools"));
  bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
  for (QAction* tool : tools_->actions()) bar->addAction(tool);
  bar->addSeparator();
  for (const char* name : {"makeFixed", "makeHandle", "makeRigid"}) bar->addAction(findChild<QAction*>(name));
  bar->addSeparator();
  bar->addAction(undo_);
  bar->addAction(redo_);
  bar->addAction(findChild<QAction*>("frameAll"));
  apply(Appearance::System);
}

void MainWindow::changeEvent(QEvent* event)
{
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  viewport_->setDarkBackdrop(isDark(palette()));
  tools_->drawIcons();
  for (const auto& [name, sign] : {std::pair("makeFixed", Sign::Fix),
                                   {"makeHandle", Sign::Handle},
                                   {"makeRigid", Sign::Rigid},
                                   {"undo", Sign::Undo},
                                   {"redo", Sign::Redo},
                                   {"frameAll", Sign::Frame}})
    if (auto* action = findChild<QAction*>(name)) action->setIcon(iconOf(sign, palette()));
}

void MainWindow::connectStatus()
{
  const auto showHint = [this] { status_->setHint(gizmo_->isTouched() ? gizmo_->hint() : tools_->current().hint()); };
  connect(tools_, &ToolBox::hintChanged, this, showHint);
  connect(gizmo_, &Tool::changed, this, showHint);
  showHint();
  connect(viewport_, &Viewport::previewChanged, status_, &StatusLine::setPick);
  for (const auto& signal : {&Editor::opened, &Editor::stateChanged, &Editor::saved}) {
    connect(&editor_, signal, this, &MainWindow::updateTitle);
    connect(&editor_, signal, this, &MainWindow::updateActions);
  }
  for (const auto& signal : {&Editor::vertexSelectionChanged, &Editor::constraintSelectionChanged})
    connect(&editor_, signal, this, &MainWindow::updateActions);
}

void MainWindow::updateTitle()
{
  const QString name = files_.name();
  setWindowTitle(name.isEmpty() ? tr("Holdfast") : tr("%1[*] – Holdfast").arg(name));
  setWindowModified(editor_.isOpen() && !editor_.history().isSaved());
}

void MainWindow::updateActions()
{
  const bool isOpen = editor_.isOpen();
  for (const auto& [action, needs] : needs_)
    action->setEnabled(isOpen && (needs != Needs::Vertices || !editor_.selectedVertices().empty()) &&
                       (needs != Needs::Constraints || !editor_.selectedConstraints().empty()));
  const auto textOf = [](const QString& verb, std::string_view name) {
    return name.empty() ? verb : verb + ' ' + QString::fromUtf8(name.data(), static_cast<int>(name.size()));
  };
  undo_->setEnabled(isOpen && editor_.history().canUndo());
  redo_->setEnabled(isOpen && editor_.history().canRedo());
  undo_->setText(textOf(tr("&Undo"), isOpen ? editor_.history().undoName() : std::string_view()));
  redo_->setText(textOf(tr("&Redo"), isOpen ? editor_.history().redoName() : std::string_view()));
}

void MainWindow::escape()
{
  if (viewport_->cancelGesture()) return;
  if (!editor_.isOpen()) return;
  if (editor_.solveState() == SolveState::Solving) return editor_.cancelSolving();
  if (!editor_.selectedVertices().empty()) return editor_.selectVertices({});
  if (!editor_.selectedConstraints().empty()) return editor_.selectConstraints({});
  tools_->chooseSelect();
}

void MainWindow::frameSelection()
{
  if (!editor_.selectedVertices().empty()) return viewport_->frameVertices(editor_.selectedVertices());
  viewport_->frameConstraints(editor_.selectedConstraints());
}

}  // namespace holdfast

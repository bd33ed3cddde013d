// The menus and the tool bar of the main window.

#include <QActionGroup>
#include <QApplication>
#include <QMenuBar>
#include <QMessageBox>
#include <QTableView>
#include <QToolBar>

#include <holdfast/constraints/mirror_pairs.h>
#include <holdfast/geometry/bounding_box.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/files/recent_files.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/text/number_text.h>
#include <holdfast/window/viewport/view_state.h>
#include <holdfast/window/window/command_dialog.h>
#include <holdfast/window/window/help_dialog.h>
#include <holdfast/window/window/main_window.h>
#include <holdfast/window/window/saved_selection_menu.h>
#include <holdfast/words/error.h>

namespace holdfast {

const MainWindow::Item MainWindow::kSeparator;

QAction* MainWindow::addAction(QMenu& menu, const Item& item)
{
  QAction* action = named(menu.addAction(item.text), item.name);
  action->setShortcut(QKeySequence(item.key));
  const QString tip = QString(item.tip).remove('&');
  const QString key = action->shortcut().toString(QKeySequence::NativeText);
  action->setToolTip(key.isEmpty() ? tip : QString("%1 (%2)").arg(tip, key));
  action->setStatusTip(tip);
  if (item.run) connect(action, &QAction::triggered, this, item.run);
  if (item.needs != Needs::Nothing) needs_.emplace_back(action, item.needs);
  return action;
}

void MainWindow::addChoices(QMenu& menu, const std::vector<Item>& items)
{
  QActionGroup* group = named(new QActionGroup(this), menu.title().remove('&'));
  choices_ << group;
  for (const Item& item : items) {
    QAction* action = addAction(menu, item);
    action->setCheckable(true);
    action->setChecked(group->actions().isEmpty());
    group->addAction(action);
  }
}

QAction* MainWindow::addSwitch(QMenu& menu, const Item& item)
{
  QAction* action = addAction(menu, item);
  action->setCheckable(true);
  return action;
}

void MainWindow::makeFileMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&File"));
  addAction(menu, {"open", tr("&Open…"), "Ctrl+O", tr("Open a mesh or a session"), Needs::Nothing,
                   [this] { files_.openDialog(); }});
  QMenu* recent = menu.addMenu(tr("Open &recent"));
  connect(recent, &QMenu::aboutToShow, this,
          [this, recent] { fillRecentMenu(*recent, [this](const QString& path) { files_.open(path); }); });
  addActions(menu, {kSeparator,
                    {"save", tr("&Save"), "Ctrl+S", tr("Save the mesh's constraints and the view as a session"),
                     Needs::Document, [this] { files_.saveInBackground(); }},
                    {"saveAs", tr("Save &as…"), "Ctrl+Shift+S", tr("Save as another session"), Needs::Document,
                     [this] { files_.saveAsInBackground(); }},
                    {"close", tr("&Close"), "Ctrl+W", tr("Close the document and show the start page"), Needs::Document,
                     [this] { files_.close(); }},
                    kSeparator,
                    {"import", tr("&Import constraints…"), "Ctrl+I",
                     tr("Add measured points (CSV) or constraints (JSON), after a look at where they lie"),
                     Needs::Document, [this] { files_.importDialog(); }}});
  const auto writing = [this](void (DocumentExports::*run)()) { return [this, run] { (exports_.*run)(); }; };
  addActions(
      *menu.addMenu(tr("&Export")),
      {{"exportMesh", tr("&Mesh…"), "", tr("The deformed mesh, in any format"), Needs::Document,
        writing(&DocumentExports::exportMesh)},
       {"exportFields", tr("&Fields…"), "", tr("Residuals, rotations and displacements at all vertices, as VTP"),
        Needs::Document, writing(&DocumentExports::exportFields)},
       {"exportReport", tr("&Report…"), "", tr("The outcome of each constraint, as JSON or CSV"), Needs::Document,
        writing(&DocumentExports::exportReport)},
       {"exportConstraints", tr("&Constraints…"), "", tr("A constraint file for holdfast-batch"), Needs::Document,
        writing(&DocumentExports::exportConstraints)},
       {"exportPicture", tr("&Picture…"), "", tr("The picture as you see it, at any size"), Needs::Document,
        writing(&DocumentExports::exportPicture)},
       {"savePicture", tr("Picture at &once"), "F12",
        tr("Write the picture as you see it, beside the mesh or into the folder of the last export, by a name of its "
           "own"),
        Needs::Document, writing(&DocumentExports::savePicture)},
       {"copyPicture", tr("C&opy the picture"), "Ctrl+Shift+C", tr("Put the picture as you see it into the clipboard"),
        Needs::Document, writing(&DocumentExports::copyPicture)}});
  addActions(
      menu, {kSeparator, {"quit", tr("&Quit"), "Ctrl+Q", tr("Close the window"), Needs::Nothing, [this] { close(); }}});
}

void MainWindow::makeHelpMenu()
{
  const auto commands = [this] {
    const auto* table = findChild<QTableView*>("constraintTable");
    showCommands(commandsOf(menuBar()->actions()) + commandsOf(table->actions(), tr("Table \u203a ")) + gestures(),
                 this);
  };
  const auto about = [this] {
    QMessageBox::about(
        this, tr("About Holdfast"),
        tr("<b>Holdfast %1</b><p>Deforms triangle meshes under exact positional constraints, after H. Masuda, "
           "Y. Yoshioka, Y. Furukawa, <i>Interactive mesh deformation using equality-constrained least "
           "squares</i>.</p>")
            .arg(QApplication::applicationVersion()));
  };
  addActions(*menuBar()->addMenu(tr("&Help")),
             {{"help", tr("&Ten gestures"), "F1", tr("The most useful gestures, on one page"), Needs::Nothing,
               [this] { showHelp(this); }},
              {"commands", tr("&Commands and keys…"), "Ctrl+Shift+P", tr("Find a command, or look up a key"),
               Needs::Nothing, commands},
              {"manual", tr("&Manual"), "Ctrl+F1", tr("How the window is used, all of it"), Needs::Nothing,
               [this] { showManual(this); }},
              {"about", tr("&About Holdfast"), "", tr("The version of the program"), Needs::Nothing, about}});
}

void MainWindow::makeEditMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
  undo_ = addAction(
      menu, {"undo", tr("&Undo"), "Ctrl+Z", tr("Take the last edit back"), Needs::Nothing, [this] { editor_.undo(); }});
  redo_ = addAction(menu, {"redo", tr("&Redo"), "Ctrl+Shift+Z", tr("Do the edit again that was undone last"),
                           Needs::Nothing, [this] { editor_.redo(); }});
  redo_->setShortcuts({redo_->shortcut(), QKeySequence("Ctrl+Y")});
  addActions(menu, {kSeparator,
                    {"escape", tr("&Cancel"), "Esc",
                     tr("Take back what is under way: a drag, a curve, solving; or select nothing"), Needs::Nothing,
                     [this] { escape(); }},
                    {"solveAgain", tr("&Solve again"), "F5", tr("Solve again after it was stopped"), Needs::Document,
                     [this] { editor_.solve(); }},
                    {"weld", tr("&Weld vertices…"), "",
                     tr("Choose how near vertices have to be to one another to be one for the solver"), Needs::Document,
                     [this] { panels_->showWelding(); }},
                    kSeparator,
                    {"preferences", tr("&Preferences…"), "Ctrl+,", tr("Choose what holds for all documents"),
                     Needs::Nothing, [this] { showPreferences(); }},
                    {"resetSettings", tr("Reset all se&ttings"), "",
                     tr("Panels, columns, colours and folders as in a new installation; recent files stay"),
                     Needs::Nothing, [this] { resetSettings(); }}});
}

void MainWindow::makeSelectionMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&Select"));
  for (QAction* tool : tools_->actions()) {
    menu.addAction(tool);
    needs_.emplace_back(tool, Needs::Document);
  }
  using Edit = std::vector<Index> (VertexRegions::*)(std::span<const Index>) const;
  const auto select = [this](Edit edit) {
    return [this, edit] {
      editor_.selectVertices(viewport_->shownAmong((*editor_.mesh().regions.*edit)(editor_.selectedVertices())));
    };
  };
  menu.addAction(tools_->reachesThrough());
  needs_.emplace_back(tools_->reachesThrough(), Needs::Document);
  addActions(menu,
             {kSeparator,
              {"grow", tr("&Grow"), "+", tr("Select the next ring of vertices, too"), Needs::Vertices,
               select(&VertexRegions::grown)},
              {"shrink", tr("S&hrink"), "-", tr("Take the outermost vertices out of the selection"), Needs::Vertices,
               select(&VertexRegions::shrunk)},
              {"invert", tr("&Invert"), "I", tr("Select all other vertices"), Needs::Document,
               select(&VertexRegions::inverted)},
              {"wholeParts", tr("&Whole parts"), "Ctrl+L", tr("Select all of the connected parts of the selection"),
               Needs::Vertices, select(&VertexRegions::connected)},
              {"besidePlane", tr("&Kept by the section plane"), "Ctrl+K",
               tr("Select what the section plane leaves to be seen; I selects the other side"), Needs::Document,
               [this] { selectBesidePlane(); }},
              {"deselect", tr("&None"), "Ctrl+Shift+A", tr("Deselect all vertices"), Needs::Vertices,
               [this] { editor_.selectVertices({}); }},
              kSeparator,
              {"saveSelection", tr("Sa&ve the selection"), "Ctrl+G", tr("Keep the selected vertices under a name"),
               Needs::Vertices, [this] { saveAndNameSelection(editor_, *this); }}});
  menu.addMenu(newSavedSelectionMenu(editor_, *this));
}

void MainWindow::makeConstraintMenu()
{
  const auto constrain = [this](const char* stem, auto what) {
    return [=, this]() mutable {
      what.select = editor_.selection();
      editor_.selectVertices({});
      addConstraint(editor_, stem, what);
    };
  };
  QMenu& menu = *menuBar()->addMenu(tr("&Constrain"));
  addActions(
      menu,
      {{"makeFixed", tr("&Fix the selection"), "F", tr("The selected vertices stay where they are"), Needs::Vertices,
        constrain("fixed ", FixedConstraint{})},
       {"makeHandle", tr("Make a &handle of it"), "H", tr("The selected vertices move as you drag them"),
        Needs::Vertices, constrain("handle ", HandleConstraint{})},
       {"makeRigid", tr("Make a &rigid feature of it"), "R",
        tr("The selected vertices keep their shape wherever the surface takes them"), Needs::Vertices,
        constrain("rigid ", RigidConstraint{})},
       {"makeSlide", tr("Let it &slide in its plane"), "G",
        tr("The selected vertices move in the plane that lies nearest to them"), Needs::Vertices,
        constrain("slide ", SlideConstraint{{}, FittedPlane{}})},
       {"makeOnMesh", tr("Keep it o&n another mesh…"), "Shift+G",
        tr("The selected vertices stay on the surface of a scan or another part, and move along it"), Needs::Vertices,
        [this] { files_.guideMeshDialog({}); }},
       {"makeMirror", tr("Keep it s&ymmetric"), "Shift+M",
        tr("The surface, or what is selected of it, stays its own mirror image: across the section plane, else across "
           "the plane of symmetry that it has"),
        Needs::Document, [this] { keepSymmetric(); }},
       kSeparator,
       {"toggleEnabled", tr("&Enable or disable"), "E", tr("Disable the selected constraints, or enable them again"),
        Needs::Constraints, [this] { toggleConstraints(editor_, Rows(editor_.selectedConstraints())); }},
       {"deleteConstraints", tr("&Delete"), "Del", tr("Delete the selected constraints"), Needs::Constraints, [this] {
          removeConstraints(editor_, Rows(editor_.selectedConstraints()));
          editor_.selectConstraints({});
        }}});
  addMirrors(*menu.addMenu(tr("&Mirrored copy")));
}

void MainWindow::askForSectionPlane()
{
  findChild<QAction*>("sectionPlane")->setChecked(true);
  status_->showDocumentMessage(tr("Place the section plane, and choose this again"), 12000);
}

void MainWindow::selectBesidePlane()
{
  const auto& section = viewport_->section();
  if (!section) return askForSectionPlane();
  std::vector<Index> kept;
  for (Index v = 0; v < editor_.positions().rows(); ++v)
    if (isKept(*section, editor_.positions().row(v))) kept.push_back(v);
  editor_.selectVertices(viewport_->shownAmong(std::move(kept)));
}

void MainWindow::keepSymmetric()
{
  std::optional<MirrorConstraint> mirror;
  const SolverMesh& mesh = editor_.model()->solverMesh;
  if (const auto& section = viewport_->section())
    mirror = MirrorConstraint{section->origin, section->normal, {}, {AllOf{}}, {}};
  else
    mirror = symmetryOf(mesh.rest, kMirrorTolerance * mesh.diagonal);
  if (!mirror)
    return showProblem(
        this, tr("There is no plane of symmetry."),
        tr("Across no plane along the axes, through 0 or through the middle, have most vertices partners. "
           "Lay the section plane where the mirror should be, and try again."));
  if (!editor_.selectedVertices().empty()) mirror->select = editor_.selection();
  editor_.selectVertices({});
  addConstraint(editor_, "mirror ", *mirror);
}

void MainWindow::addMirrors(QMenu& menu)
{
  const auto mirror = [this](const MirrorPlane& plane) {
    try {
      mirrorConstraints(editor_, Rows(editor_.selectedConstraints()), plane);
    } catch (const InputError& error) {
      showProblem(this, tr("There is no mirrored copy."), QString::fromStdString(error.reason()));
    }
  };
  for (const char* const middle : {"", "Middle"})
    for (int axis = 0; axis < 3; ++axis) {
      const QString text = *middle == 0 ? tr("Across &%1 = 0") : tr("Across the middle of the mesh in %1");
      const QString tip =
          tr("Add a mirrored copy of the selected constraints: %1").arg(text.arg(axisText(axis)).remove('&').toLower());
      const auto run = [this, mirror, axis, isMiddle = *middle != 0] {
        MirrorPlane plane{Vector3::Zero(), Vector3::Unit(axis)};
        if (isMiddle) plane.point = boundingBox(editor_.model()->mesh.positions).center();
        mirror(plane);
      };
      addAction(menu, {"", text.arg(axisText(axis)), "", tip, Needs::Constraints, run})
          ->setObjectName("mirror" + axisText(axis).toUpper() + middle);
    }
  addAction(menu, {"mirrorSection", tr("Across the &section plane"), "Ctrl+M",
                   tr("Add a mirrored copy of the selected constraints: across the section plane"), Needs::Constraints,
                   [this, mirror] {
                     const auto& section = viewport_->section();
                     if (section) return mirror({section->origin, section->normal.normalized()});
                     askForSectionPlane();
                   }});
}

void MainWindow::makeViewMenu()
{
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  const auto look = [this](const char* name, const QString& text, const char* key, const Vector3& direction,
                           const Vector3& up) -> Item {
    return {name, text, key, text, Needs::Document, [=, this] {
              viewport_->lookAlong(upright(viewport_->upAxis(), direction), upright(viewport_->upAxis(), up));
            }};
  };
  const auto frameSelection = [this] {
    if (!editor_.selectedVertices().empty()) return viewport_->frameVertices(editor_.selectedVertices());
    viewport_->frameConstraints(editor_.selectedConstraints());
  };
  const Vector3 x = Vector3::UnitX();
  const Vector3 y = Vector3::UnitY();
  const Vector3 z = Vector3::UnitZ();
  addActions(menu, {{"frameAll", tr("Show &all"), "Home", tr("Show the whole mesh, from where you look at it"),
                     Needs::Document, [this] { viewport_->frameAll(); }},
                    {"frameSelection", tr("Show the &selection"), "Shift+F", tr("Show the selection from near"),
                     Needs::Document, frameSelection},
                    {"viewPrevious", tr("Pre&vious view"), "Alt+Left", tr("Take the last change of the view back"),
                     Needs::Document, [this] { viewport_->showPreviousView(); }},
                    {"viewNext", tr("&Next view"), "Alt+Right", tr("Return to the view before “Previous view”"),
                     Needs::Document, [this] { viewport_->showNextView(); }},
                    kSeparator,
                    look("viewFront", tr("From the &front"), "Ctrl+1", y, z),
                    look("viewBack", tr("From &behind"), "Ctrl+2", -y, z),
                    look("viewRight", tr("From the &right"), "Ctrl+3", -x, z),
                    look("viewLeft", tr("From the &left"), "Ctrl+4", x, z),
                    look("viewTop", tr("From a&bove"), "Ctrl+7", -z, y),
                    look("viewBottom", tr("From bel&ow"), "Ctrl+8", z, -y),
                    {"viewCorner", tr("From a corn&er"), "Ctrl+9", tr("From a corner, as when it was opened"),
                     Needs::Document, [this] { viewport_->lookFromCorner(); }},
                    kSeparator});
  QAction* parallel =
      addSwitch(menu, {"parallelProjection", tr("&Parallel projection"), "Ctrl+5", tr("Without perspective")});
  connect(parallel, &QAction::toggled, viewport_, &Viewport::setParallelProjection);
  connect(viewport_, &Viewport::projectionChanged, parallel, &QAction::setChecked);
  QAction* atRest = addSwitch(menu, {"showRest", tr("Shape at &rest"), "O",
                                     tr("Show the shape at rest, and the deformed one again"), Needs::Document});
  connect(atRest, &QAction::triggered, viewport_, [this](bool isOn) { viewport_->setShownShare(isOn ? 0 : 1); });
  connect(viewport_, &Viewport::shownShareChanged, atRest, [atRest](double share) { atRest->setChecked(share == 0); });
  QAction* yIsUp = addSwitch(
      menu, {"upAxisY", tr("&Y is up"), "Ctrl+U",
             tr("Which axis of the mesh is up, Y or Z; remembered for files of its format"), Needs::Document});
  connect(yIsUp, &QAction::triggered, this, [this](bool isOn) {
    viewport_->setUpAxis(isOn ? UpAxis::Y : UpAxis::Z);
    rememberUpAxis(editor_.mesh(), viewport_->upAxis());
    viewport_->lookFromCorner();
  });
  connect(viewport_, &Viewport::upAxisChanged, yIsUp, [yIsUp](UpAxis axis) { yIsUp->setChecked(axis == UpAxis::Y); });

  const auto next = [this](auto DisplaySettings::*what, int count) {
    return [this, what, count] {
      DisplaySettings display = viewport_->display();
      using Kind = std::remove_reference_t<decltype(display.*what)>;
      display.*what = static_cast<Kind>((static_cast<int>(display.*what) + 1) % count);
      viewport_->setDisplay(display);
      panels_->followViewport();
    };
  };
  addActions(menu, {{"nextEdges", tr("&Edges: sharp, all or none"), "Shift+E",
                     tr("Show the sharp edges of the mesh, all, or none, in turn"), Needs::Document,
                     next(&DisplaySettings::edges, 3)},
                    {"nextSurface", tr("Surface: s&haded, wireframe or points"), "Shift+D",
                     tr("Show the surface shaded, as a wireframe, or as points, in turn"), Needs::Document,
                     next(&DisplaySettings::surface, 3)}});
  const auto along = [this](GizmoAxes axes) { return [this, axes] { gizmo_->setAxes(axes); }; };
  const QString own = tr("Of the &constraint: those of a handle, or across the surface at a point");
  addChoices(
      *menu.addMenu(tr("A&xes of the arrows")),
      {{"axesWorld", tr("Of the &world"), "Shift+W", tr("Of the world"), Needs::Nothing, along(GizmoAxes::World)},
       {"axesOwn", own, "Shift+H", own, Needs::Nothing, along(GizmoAxes::Own)},
       {"axesView", tr("Of the &view"), "Shift+V", tr("Of the view"), Needs::Nothing, along(GizmoAxes::View)}});
  const auto rotate = [this](RotationOfMoves turn) { return [this, turn] { gizmo_->setRotationOfMoves(turn); }; };
  addChoices(*menu.addMenu(tr("R&otation of a handle that is moved")),
             {{"turnAsConstraint", tr("As the &constraint says"), "",
               tr("A handle that is moved rotates as its constraint says: not at all, or about what is fixed"),
               Needs::Nothing, rotate(RotationOfMoves::AsConstraint)},
              {"turnAsSeen", tr("As &seen about what is fixed"), "",
               tr("A handle that is moved rotates about the viewing axis, by the angle that it makes on the screen"),
               Needs::Nothing, rotate(RotationOfMoves::AsSeen)}});
  const auto isDone = [this](bool isSomethingHidden) {
    if (!isSomethingHidden)
      status_->showDocumentMessage(tr("Nothing is hidden: select some whole faces, not all that are shown"), 12000);
    return isSomethingHidden;
  };
  addActions(menu, {kSeparator,
                    {"isolate", tr("&Isolate the selection"), "Shift+I",
                     tr("Show only the faces of the selection, with their constraints"), Needs::Vertices,
                     [this, isDone] { isDone(viewport_->isolate(editor_.selectedVertices())); }},
                    {"hideSelection", tr("Hi&de the selection"), "Ctrl+H",
                     tr("Hide the faces of the selection; they cannot be picked then"), Needs::Vertices,
                     [this, isDone] {
                       if (isDone(viewport_->hide(editor_.selectedVertices()))) editor_.selectVertices({});
                     }},
                    {"showHidden", tr("Show what is hidd&en"), "Ctrl+Shift+H", tr("Show all faces again"),
                     Needs::Nothing, [this] { viewport_->showHidden(); }}});
  QAction* showHidden = findChild<QAction*>("showHidden");
  showHidden->setEnabled(false);
  connect(viewport_, &Viewport::hiddenChanged, showHidden, &QAction::setEnabled);
  menu.addSeparator();
  newSectionTool(editor_, *viewport_,
                 *addSwitch(menu, {"sectionPlane", tr("&Section plane"), "Shift+S",
                                   tr("Cut the picture open; the mesh stays whole"), Needs::Document}),
                 this);
  newMirrorTool(editor_, *viewport_, this);

  addAction(menu, {"removeMeasurements", tr("Remove all &measurements"), "", tr("Remove all probes and rulers"),
                   Needs::Measurements, [this] { editor_.setMeasurements(tr("remove all measurements"), {}); }});

  panels_->fillMenu(*menu.addMenu(tr("&Panels")));
  const auto colors = [this](const char* name, const QString& text, const QString& spoken,
                             Appearance appearance) -> Item {
    const QString tip = tr("Colours of the window: %1").arg(spoken);
    return {name, text, "", tip, Needs::Nothing, [appearance] { apply(appearance); }};
  };
  addChoices(*menu.addMenu(tr("&Colours of the window")),
             {colors("colorsOfDesktop", tr("As the &desktop"), tr("as the desktop"), Appearance::System),
              colors("colorsLight", tr("&Light"), tr("light"), Appearance::Light),
              colors("colorsDark", tr("D&ark"), tr("dark"), Appearance::Dark)});
}

void MainWindow::makeToolBars()
{
  QToolBar* bar = named(addToolBar(tr("Tools")), "toolBar");
  bar->setMovable(false);
  bar->toggleViewAction()->setToolTip(tr("Show or hide the tools"));
  bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
  for (QAction* tool : tools_->actions()) bar->addAction(tool);
  bar->addAction(tools_->reachesThrough());
  bar->addSeparator();
  for (const char* name : {"makeFixed", "makeHandle", "makeRigid"}) bar->addAction(findChild<QAction*>(name));
  bar->addSeparator();
  bar->addAction(undo_);
  bar->addAction(redo_);
  bar->addAction(findChild<QAction*>("frameAll"));
  apply(Appearance::System);
}

}  // namespace holdfast

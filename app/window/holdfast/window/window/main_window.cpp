#include "holdfast/window/window/main_window.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMimeData>
#include <QTableView>
#include <QUrl>
#include <algorithm>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/controls/icons.h>
#include <holdfast/window/controls/open_dialog.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/controls/wheel_guard.h>
#include <holdfast/window/files/recent_files.h>
#include <holdfast/window/files/start_page.h>
#include <holdfast/window/viewport/view_state.h>
#include <holdfast/window/window/preferences_dialog.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

/// The paths of those that lie on this computer; none where something else is dragged.
QStringList localFiles(const QMimeData& data)
{
  QStringList paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  return paths;
}

// Longer than it takes to draw most pictures.
constexpr int kPictureDelay = 500;

/// Sets what every document has: how it is coloured and what is shown beside it.
QVariant settingOf(const ViewState& view)
{
  SessionFile session;
  session.mesh.path = "none";
  session.view = view;
  session.view.camera.reset();
  session.view.range.reset();
  session.view.hiddenFaces.reset();
  return QByteArray::fromStdString(sessionToJson(session));
}

/// Of constraints or points.
bool isListFile(const QString& path)
{
  const auto endsWith = [&](std::string_view end) {
    return path.endsWith(QLatin1String(end.data(), static_cast<int>(end.size())), Qt::CaseInsensitive);
  };
  return endsWith(".json") || std::ranges::any_of(kPointListExtensions, endsWith);
}

}  // namespace

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
  setWindowIcon(programIcon());
  setAcceptDrops(true);
  QApplication::instance()->installEventFilter(this);
  QApplication::instance()->installEventFilter(new WheelGuard(this));
  setCentralWidget(viewport_);
  viewport_->setFirstTool(gizmo_);
  new StartPage(editor_, files_, viewport_);
  setStatusBar(status_);
  makeFileMenu();
  makeEditMenu();
  makeSelectionMenu();
  makeConstraintMenu();
  makeViewMenu();
  makeHelpMenu();
  makeToolBars();
  drawIcons();
  connectStatus();
  connectFiles();
  updateTitle();
  updateActions();
}

MainWindow::~MainWindow()
{
  hide();  // what is being typed is taken while the document is there
  // The base class deletes the tools, which end their work then and say that they have changed.
  tools_->disconnect(this);
  gizmo_->disconnect(this);
  viewport_->setTool(nullptr);  // it ends while the editor that it tells is there
}

void MainWindow::connectFiles()
{
  files_.setView([this] { return viewStateOf(*viewport_); });
  connect(&files_, &DocumentFiles::viewOpened, this, [this](const ViewState& view) {
    apply(view, *viewport_);
    panels_->followViewport();
  });
  connect(&files_, &DocumentFiles::pathChanged, this, &MainWindow::updateTitle);
  pictureDelay_.setSingleShot(true);
  pictureDelay_.setInterval(kPictureDelay);
  connect(&pictureDelay_, &QTimer::timeout, this, &MainWindow::keepPicture);
  connect(&files_, &DocumentFiles::pathChanged, &pictureDelay_, qOverload<>(&QTimer::start));
  connect(&files_, &DocumentFiles::done, this,
          [this](const QString& what) { status_->showDocumentMessage(what, 6000); });
  exports_.setPictureView([this]() -> PictureView {
    const DisplaySettings display = viewport_->display();
    const auto surface = viewport_->surface();
    return {cameraOf(*viewport_->renderer().GetActiveCamera()),
            viewport_->coloring(),
            [display, surface, hidden = viewport_->hidden()](SceneContents& contents) {
              arrange(contents, display);
              if (hidden) contents.setHidden(*hidden);
              contents.setSection(surface->section());
              contents.setCut(surface->cut());
            },
            [legend = viewport_->legend(), font = viewport_->font()](QPainter& painter, const QRectF& area) {
              painter.setFont(font);
              paint(legend, painter, area, paletteOf(Appearance::Light));
            },
            viewport_->size(),
            viewport_->pixelRatio()};
  });
  connect(&exports_, &DocumentExports::done, this,
          [this](const QString& what) { status_->showDocumentMessage(what, 6000); });
  if (const auto folder = recoveryFolder()) {
    autosave_ = std::make_unique<Autosave>(editor_, files_, *folder, this);
    connect(autosave_.get(), &Autosave::failed, this,
            [this](const QString& why) { status_->showDocumentMessage(why, 12000); });
  }
  connect(viewport_, &Viewport::contextMenuWanted, this, &MainWindow::showContextMenu);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (localFiles(*event->mimeData()).isEmpty() || isDialogOpen()) return;
  // Never a move, which would delete the file at its source.
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

void MainWindow::dropEvent(QDropEvent* event)
{
  event->setDropAction(Qt::CopyAction);
  event->accept();
  // The program that the files come from waits until this returns; questions may take longer.
  QTimer::singleShot(0, this, [this, paths = localFiles(*event->mimeData())] {
    whenNoDialogIsOpen(*this, [this, paths] { take(paths); });
  });
}

/// One document is open at a time, and a list belongs to it: takes the first document, else the first list.
void MainWindow::take(const QStringList& paths)
{
  const auto document = std::find_if_not(paths.begin(), paths.end(), isListFile);
  const QString& path = document == paths.end() ? paths.front() : *document;
  const QString name = QFileInfo(path).fileName();
  if (paths.size() > 1)
    status_->showMessage(tr("One file at a time: %1 is opened, %2 more are not").arg(name).arg(paths.size() - 1),
                         12000);
  if (!isListFile(path)) return files_.open(path);
  if (editor_.isOpen()) return files_.importConstraints(path);
  showProblem(this, tr("“%1” cannot be opened.").arg(name),
              tr("It is a list of constraints. Open the mesh that they belong to, and drop the list on it."));
}

void MainWindow::showContextMenu(const QPoint& place)
{
  QMenu menu(this);
  for (const char* name :
       {"makeFixed", "makeHandle", "makeRigid", "", "grow", "shrink", "invert", "", "toggleEnabled",
        "deleteConstraints", "", "isolate", "hideSelection", "showHidden", "", "frameSelection", "frameAll"})
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

/// Of all objects of the program.
bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
  // An open list would hide, and leave Escape to the window as well.
  const bool isForList = event->type() == QEvent::ShortcutOverride && QApplication::activePopupWidget() != nullptr &&
                         static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
  if (isForList) {
    event->accept();
    return true;
  }
  // A dialog gives the keys back, also where no window manager does so.
  if (event->type() == QEvent::Hide && qobject_cast<QDialog*>(watched) != nullptr &&
      static_cast<QWidget*>(watched)->isModal())
    QTimer::singleShot(0, this, [this] {
      if (isVisible() && QApplication::activeModalWidget() == nullptr) activateWindow();
    });
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::showEvent(QShowEvent* event)
{
  QMainWindow::showEvent(event);
  if (event->spontaneous()) return;
  panels_->share(size());
  if (remembered_) rememberLayout();
  if (!autosave_) return;
  QTimer::singleShot(0, this, [this] { whenNoDialogIsOpen(*this, [this] { autosave_->offerRecovery(); }); });
}

void MainWindow::remember()
{
  remembered_.emplace();
  remembered_->add(
      "geometry", [this] { return saveGeometry(); },
      [this](const QVariant& last) { restoreGeometry(last.toByteArray()); });
  for (QActionGroup* group : choices_)
    remembered_->add(
        group->actions().front()->objectName(), [group] { return group->checkedAction()->objectName(); },
        [this, group](const QVariant& last) {
          auto* action = findChild<QAction*>(last.toString());
          if (group->actions().contains(action)) action->trigger();
        });
  rememberSwitch(*tools_->reachesThrough());
  remembered_->add(
      "unit", [this] { return unit_; }, [this](const QVariant& last) { setUnit(last.toString()); });
  remembered_->add(
      "view", [this] { return settingOf(viewStateOf(*viewport_)); },
      [this](const QVariant& last) {
        try {
          apply(parseSession(last.toByteArray().toStdString(), "settings").view, *viewport_);
          panels_->followViewport();
        } catch (const InputError&) {
          // Of another version: the view stays as it is.
        }
      });
}

void MainWindow::rememberSwitch(QAction& action)
{
  remembered_->add(
      action.objectName(), [&action] { return action.isChecked(); },
      [&action](const QVariant& last) { action.setChecked(last.toBool()); });
}

/// Sizes of panels are those of a window that is shown.
void MainWindow::rememberLayout()
{
  auto* titles = findChild<QTableView*>("constraintTable")->horizontalHeader();
  // Qt takes no state of other columns.
  remembered_->add(
      QString("columns%1").arg(titles->count()), [titles] { return titles->saveState(); },
      [titles](const QVariant& last) { titles->restoreState(last.toByteArray()); });
  // After that state, which hides columns without telling their switches.
  for (QAction* column : titles->actions()) rememberSwitch(*column);
  remembered_->add(
      "panels", [this] { return saveState(); }, [this](const QVariant& last) { restoreState(last.toByteArray()); });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  event->setAccepted(files_.maySaveBefore(tr("closing the window")));
  if (event->isAccepted() && remembered_) remembered_->save();
}

void MainWindow::setUnit(const QString& unit)
{
  unit_ = unit;
  files_.setUnit(unit);
}

void MainWindow::showPreferences()
{
  const auto setUnitOfAll = [this](const QString& unit) {
    setUnit(unit);
    if (!editor_.isOpen() || editor_.list().units == unit.toStdString()) return;
    ConstraintList list = editor_.list();
    list.units = unit.toStdString();
    editor_.edit(tr("unit of length"), std::move(list));
  };
  newPreferencesDialog({choices_, editor_.isOpen() ? QString::fromStdString(editor_.list().units) : unit_, setUnitOfAll,
                        editor_.decimals(), [this](std::optional<int> decimals) { editor_.setDecimals(decimals); },
                        findChild<QAction*>("resetSettings")},
                       this)
      ->open();
}

void MainWindow::resetSettings()
{
  forgetSettings();
  if (remembered_) remembered_->reset();
}

void MainWindow::keepPicture()
{
  if (!editor_.isOpen() || !isVisible()) return;
  if (editor_.solveState() == SolveState::Solving || viewport_->isRenderPending()) return pictureDelay_.start();
  const auto& session = files_.sessionPath();
  QImage picture = viewport_->grabFramebuffer();
  // Without the axes in the corner.
  picture = picture.copy(0, 0, picture.width() * 4 / 5, picture.height());
  keepRecentPicture(textOf(session.empty() ? editor_.mesh().path : session), picture);
}

void MainWindow::changeEvent(QEvent* event)
{
  QMainWindow::changeEvent(event);
  const QWidget* focus = focusWidget();
  const bool isLost = focus == nullptr || !focus->isVisible() || !focus->isEnabled();
  if (event->type() == QEvent::ActivationChange && isActiveWindow() && isLost) viewport_->setFocus();
  if (event->type() != QEvent::PaletteChange) return;
  viewport_->setDarkBackdrop(isDark(palette()));
  drawIcons();
}

void MainWindow::drawIcons()
{
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
  const auto showHint = [this] {
    status_->setHint(!editor_.isOpen()     ? tr("Open or drop a mesh or a session, or choose an example")
                     : gizmo_->isTouched() ? gizmo_->hint()
                                           : tools_->current().hint());
  };
  connect(tools_, &ToolBox::hintChanged, this, showHint);
  connect(gizmo_, &Tool::changed, this, showHint);
  connect(&editor_, &Editor::opened, this, showHint);
  showHint();
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
  // Qt sets the title again each time, which every move of a drag would wait for.
  if (const bool isModified = editor_.isOpen() && !editor_.history().isSaved(); isModified != isWindowModified())
    setWindowModified(isModified);
}

void MainWindow::updateActions()
{
  const bool isOpen = editor_.isOpen();
  const auto& [probes, rulers] = editor_.measurements();
  const bool isMeasured = !probes.empty() || !rulers.empty();
  for (const auto& [action, needs] : needs_)
    action->setEnabled(isOpen && (needs != Needs::Vertices || !editor_.selectedVertices().empty()) &&
                       (needs != Needs::Constraints || !editor_.selectedConstraints().empty()) &&
                       (needs != Needs::Measurements || isMeasured));
  const auto textOf = [](const QString& verb, std::string_view name) {
    return name.empty() ? verb : verb + ' ' + toText(name);
  };
  undo_->setEnabled(isOpen && editor_.history().canUndo());
  redo_->setEnabled(isOpen && editor_.history().canRedo());
  undo_->setText(textOf(tr("&Undo"), isOpen ? editor_.history().undoName() : std::string_view()));
  redo_->setText(textOf(tr("&Redo"), isOpen ? editor_.history().redoName() : std::string_view()));
}

void MainWindow::escape()
{
  if (viewport_->takeBack()) return;
  if (!editor_.isOpen()) return;
  if (editor_.solveState() == SolveState::Solving) return editor_.cancelSolving();
  if (!editor_.selectedVertices().empty()) return editor_.selectVertices({});
  if (!editor_.selectedConstraints().empty()) return editor_.selectConstraints({});
  tools_->chooseSelect();
}

}  // namespace holdfast

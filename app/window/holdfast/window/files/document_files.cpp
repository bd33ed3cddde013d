#include "holdfast/window/files/document_files.h"

#include <QDialog>
#include <QDir>
#include <QFileInfo>
#include <utility>

#include <fmt/format.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/surface/guide_surface.h>
#include <holdfast/window/controls/open_dialog.h>
#include <holdfast/window/files/import_dialog.h>
#include <holdfast/window/files/progress_dialog.h>
#include <holdfast/window/files/recent_files.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;

bool isSessionFile(const fs::path& path)
{
  return textOf(path.extension()).compare(".holdfast", Qt::CaseInsensitive) == 0;
}

}  // namespace

DocumentFiles::DocumentFiles(Editor& editor, QWidget* window) : QObject(window), editor_(editor), window_(window)
{
  connect(&job_, &BackgroundJob::failed, this, [this](const std::exception_ptr& error) {
    whenNoDialogIsOpen(*this, [this, error, what = failure_] { showProblem(window_, what, error); });
  });
  connect(&job_, &BackgroundJob::ended, this, [this] {
    if (editor_.isOpen() && !editor_.hasItsMesh()) editor_.cancelSolving();  // goes on with the mesh, if that comes
  });
  connect(&saving_, &BackgroundJob::failed, this, [this](const std::exception_ptr& error) {
    saveNext_.reset();
    whenNoDialogIsOpen(*this, [this, error, name = textOf(savingPath_.filename())] {
      showProblem(window_, tr("“%1” cannot be saved.").arg(name), error);
    });
  });
  connect(&editor_, &Editor::opened, this, [this] {
    if (!editor_.isOpen()) setPath({});
  });
  connect(&editor_, &Editor::meshWanted, this, &DocumentFiles::weld);
  connect(&editor_, &Editor::guideMeshWanted, this, &DocumentFiles::guideMeshDialog);
}

void DocumentFiles::open(const QString& path)
{
  const QString absolute = QFileInfo(path).absoluteFilePath();
  if (!QFileInfo::exists(absolute)) {
    removeRecentFile(absolute);
    return showProblem(window_, tr("“%1” cannot be opened.").arg(QFileInfo(path).fileName()),
                       tr("File not found: %1\n%2").arg(QDir::toNativeSeparators(absolute), formatsText()));
  }
  Opening opening;
  opening.path = absolute.toStdString();
  opening.unit = unit_;
  if (isSessionFile(opening.path)) opening.sessionPath = opening.path;
  begin(std::move(opening));
}

void DocumentFiles::openDialog()
{
  QStringList filters = meshFilters();
  const QString sessions = "*.holdfast";
  QString all = filters.front();
  all.replace(all.indexOf('('), 1, '(' + sessions + ' ');
  filters.front() = all.replace(0, all.indexOf('('), tr("Meshes and sessions "));
  filters.insert(1, tr("Sessions (%1)").arg(sessions));
  const QString path = askForFile(tr("Open a mesh or a session"), inLastFolder("open", suggestedPath()), filters);
  rememberFolder("open", path);
  if (!path.isEmpty()) open(path);
}

void DocumentFiles::openExample(const Example& example)
{
  Opening opening;
  opening.path = example.mesh.toStdString();
  opening.constraints = example.constraints.toStdString();
  begin(std::move(opening));
}

void DocumentFiles::close()
{
  job_.cancel();
  if (maySaveBefore(tr("closing it"))) editor_.close();
}

void DocumentFiles::recover(const Recoverable& copy, std::function<void()> whenOpen)
{
  Opening opening;
  opening.path = copy.path;
  opening.sessionPath = copy.original;
  opening.isUnsaved = true;
  opening.whenOpen = std::move(whenOpen);
  begin(std::move(opening));
}

void DocumentFiles::begin(Opening opening)
{
  job_.cancel();
  givenUp_.reset();
  if (mayReplaceDocument()) find(std::make_shared<Opening>(std::move(opening)));
}

void DocumentFiles::find(const std::shared_ptr<Opening>& opening)
{
  const QString name = textOf(opening->path.filename());
  failure_ = tr("“%1” cannot be opened.").arg(name);
  job_.start([this, opening](Progress& progress) {
    opening->read(progress);
    // Both may ask the user.
    return [this, opening] {
      whenNoDialogIsOpen(*this,
                         [this, opening] { opening->mesh.model != nullptr ? adopt(*opening) : askAboutMesh(opening); });
    };
  });
  showProgress(job_, window_, tr("Opening %1").arg(name));
}

void DocumentFiles::weld(double tolerance)
{
  failure_ = tr("The mesh cannot be welded.");
  job_.start(
      [this, tolerance, path = editor_.mesh().path, document = editor_.mesh().document](Progress& progress) mutable {
        auto mesh = std::make_shared<LoadedMesh>(prepareMesh(std::move(document), path, progress, tolerance));
        return [this, mesh] {
          const fs::path session = sessionPath_;
          const std::string checksum = meshChecksum_;
          const ViewState view = view_();
          editor_.remodel(std::move(*mesh));
          meshChecksum_ = checksum;
          setPath(session);
          Q_EMIT viewOpened(view);
        };
      });
  showProgress(job_, window_, tr("Welding vertices"));
}

void DocumentFiles::Opening::read(Progress& progress)
{
  if (!session) {
    progress.step(fmt::format("reading {}", path.filename().string()));
    session = isSessionFile(path) ? readSession(path) : SessionFile{};
    if (!constraints.empty()) session->document.list = readConstraints(constraints);
    if (!isSessionFile(path) && session->document.list.units.empty()) session->document.list.units = unit;
  }
  progress.step("looking for the mesh");
  resolved = isSessionFile(path) ? resolveMesh(*session, path) : ResolvedMesh{path, MeshState::Same, ""};
  if (resolved.state != MeshState::Same) return;
  mesh = loadMesh(resolved.path, progress, session->document.options.weldTolerance);
  keepMeasurements();
  progress.step("remembering which mesh it is");
  meshChecksum = checksumOfFile(resolved.path);
}

void DocumentFiles::Opening::keepMeasurements()
{
  const Annotations& read = *session->document.annotations;
  Annotations kept{read.selections, onMesh(read.measurements, mesh.model->locator())};
  const auto countOf = [](const Annotations& all) {
    return all.measurements.probes.size() + all.measurements.rulers.size();
  };
  lostMeasurements = countOf(read) - countOf(kept);
  if (lostMeasurements == 0) return;
  isUnsaved = true;
  session->document.annotations = std::make_shared<const Annotations>(std::move(kept));
}

void DocumentFiles::askAboutMesh(const std::shared_ptr<Opening>& opening)
{
  const ResolvedMesh& mesh = opening->resolved;
  switch (askAboutSessionMesh(window_, textOf(opening->path.filename()), mesh)) {
    case MeshAnswer::Cancel:
      return;
    case MeshAnswer::UseAllTheSame:
      opening->session->mesh = {mesh.path.string(), "", ""};
      break;
    case MeshAnswer::Locate: {
      const QString path = askForFile(tr("Locate the mesh"), textOf(mesh.path.parent_path()), meshFilters());
      if (path.isEmpty()) return;
      opening->session->mesh.path = opening->session->mesh.absolutePath =
          QFileInfo(path).absoluteFilePath().toStdString();
      break;
    }
  }
  opening->isUnsaved = true;
  find(opening);
}

void DocumentFiles::adopt(Opening& opening)
{
  // The document that is open may have been edited while this one was read.
  if (!mayReplaceDocument()) return;
  givenUp_.reset();
  meshChecksum_ = opening.meshChecksum;
  sessionPath_ = opening.sessionPath;
  editor_.open(std::move(opening.mesh), std::move(opening.session->document));
  if (opening.isUnsaved) editor_.markUnsaved();
  setPath(opening.sessionPath);
  if (opening.constraints.empty())
    addRecentFile(textOf(opening.sessionPath.empty() ? editor_.mesh().path : opening.sessionPath));
  Q_EMIT viewOpened(opening.session->view);
  if (opening.lostMeasurements > 0)
    showProblem(
        window_, tr("Measurements are left out."),
        tr("%1 name places that the mesh does not have. The file still has them until you save.")
            .arg(countText(static_cast<Index>(opening.lostMeasurements), "1 probe or ruler", "%1 probes and rulers")));
  opening.whenOpen();
}

void DocumentFiles::setPath(const fs::path& path)
{
  sessionPath_ = path;
  if (!editor_.isOpen()) meshChecksum_.clear();
  const fs::path& shown = path.empty() && editor_.isOpen() ? editor_.mesh().path : path;
  window_->setWindowFilePath(textOf(shown));
  Q_EMIT pathChanged();
}

bool DocumentFiles::mayReplaceDocument()
{
  if (editor_.isOpen() && editor_.history().state() == givenUp_) return true;
  if (!maySaveBefore(tr("opening another file"))) return false;
  if (editor_.isOpen()) givenUp_ = editor_.history().state();
  return true;
}

void DocumentFiles::importDialog()
{
  const QString path =
      askForFile(tr("Import constraints"), inLastFolder("import", textOf(editor_.mesh().path.parent_path())),
                 {tr("Constraints and points (*.json *.holdfast *.csv *.tsv *.txt *.asc *.xyz)"),
                  tr("Constraints (*.json)"), tr("Points (*.csv *.tsv *.txt *.asc *.xyz)")});
  rememberFolder("import", path);
  if (!path.isEmpty()) importConstraints(path);
}

void DocumentFiles::guideMeshDialog(const std::vector<Index>& rows)
{
  const QString path = askForFile(tr("Choose the mesh to stay on"),
                                  inLastFolder("guide", textOf(editor_.mesh().path.parent_path())), meshFilters());
  rememberFolder("guide", path);
  if (path.isEmpty()) return;
  const QString name = QFileInfo(path).fileName();
  failure_ = tr("“%1” cannot be read.").arg(name);
  job_.start([this, rows, state = editor_.history().state(),
              file = QFileInfo(path).absoluteFilePath().toStdString()](Progress& progress) {
    progress.step(fmt::format("reading {}", file));
    const OnMesh on{file, std::make_shared<const GuideSurface>(readMesh(file).mesh, file)};
    return [this, rows, state, on] {
      if (editor_.history().state() == state) return keepOnMesh(editor_, rows, on);
      Q_EMIT done(tr("The constraints have changed meanwhile: choose the mesh again"));
    };
  });
  showProgress(job_, window_, tr("Reading %1").arg(name));
}

void DocumentFiles::importConstraints(const QString& path)
{
  QDialog* dialog = newImportDialog(editor_, path.toStdString(), window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

bool DocumentFiles::save()
{
  while (isSaving()) saving_.wait();
  const fs::path path = sessionPath_.empty() ? askWhereToSave() : sessionPath_;
  if (path.empty()) return false;
  beginSaving(path);
  saving_.wait();
  return wasSaved_;
}

fs::path DocumentFiles::askWhereToSave()
{
  const QString suggestion =
      ownFolderBeside(suggestedPath()) + '/' + QFileInfo(name()).completeBaseName() + ".holdfast";
  const QString path = chooser_(window_, {FileQuestion::Purpose::Write,
                                          tr("Save the session"),
                                          sessionPath_.empty() ? inLastFolder("save", suggestion) : suggestion,
                                          {tr("Sessions (*.holdfast)")}});
  rememberFolder("save", path);
  return path.isEmpty() ? std::string() : QFileInfo(path).absoluteFilePath().toStdString();
}

void DocumentFiles::beginSaving(const fs::path& path)
{
  if (path.empty()) return;
  // One after the other, so that the newest stays.
  if (isSaving()) {
    saveNext_ = path;
    return;
  }
  savingPath_ = path;
  wasSaved_ = false;
  saving_.start([this, path, session = emptySessionAt(path), model = editor_.model(),
                 state = editor_.history().state()](Progress&) mutable {
    session.document = *state;
    writeSession(path, session);
    return [this, model, state] { saved(model, state); };
  });
}

void DocumentFiles::saved(const std::shared_ptr<const Model>& model, const std::shared_ptr<const DocumentState>& state)
{
  wasSaved_ = true;
  addRecentFile(textOf(savingPath_));
  if (editor_.isOpen() && editor_.model() == model) {
    setPath(savingPath_);
    editor_.markSaved(state);
  }
  Q_EMIT done(tr("saved %1").arg(textOf(savingPath_.filename())));
  if (const auto next = std::exchange(saveNext_, std::nullopt); next && editor_.isOpen()) beginSaving(*next);
}

bool DocumentFiles::maySaveBefore(const QString& action)
{
  while (isSaving()) {
    saving_.wait();
    if (!isSaving() && !wasSaved_) return false;
  }
  if (!editor_.isOpen() || editor_.history().isSaved()) return true;
  const auto answer = askToSave(window_, name(), action);
  return answer == QMessageBox::Save ? save() : answer == QMessageBox::Discard;
}

QString DocumentFiles::name() const
{
  if (!editor_.isOpen()) return {};
  return textOf((sessionPath_.empty() ? editor_.mesh().path : sessionPath_).filename());
}

QString DocumentFiles::suggestedPath() const
{
  if (!sessionPath_.empty()) return textOf(sessionPath_);
  if (editor_.isOpen()) return textOf(editor_.mesh().path);
  const QStringList recent = recentFiles();
  return recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.front()).path();
}

}  // namespace holdfast

#include "holdfast/window/files/document_files.h"

#include <QDir>
#include <QFileInfo>
#include <QWidget>
#include <utility>

#include <fmt/format.h>

#include <holdfast/document/session_mesh.h>
#include <holdfast/window/files/file_messages.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;

fs::path pathOf(const QString& text)
{
  return text.toStdString();
}

}  // namespace

/// A mesh or a session as the files say it.
struct FoundDocument {
  SessionFile session;
  ResolvedMesh resolved;           ///< where the mesh is, and whether it is the session's
  std::optional<LoadedMesh> mesh;  ///< read if it is the session's
  std::string meshChecksum;        ///< of what was read
};

namespace {

bool isSessionFile(const fs::path& path)
{
  return textOf(path.extension()).compare(".holdfast", Qt::CaseInsensitive) == 0;
}

/// Reads the mesh of a session whose reference to it may have been corrected. Throws what `loadMesh` and `progress`
/// throw.
FoundDocument findMesh(SessionFile session, const fs::path& sessionPath, Progress& progress)
{
  FoundDocument found;
  found.session = std::move(session);
  progress.step("looking for the mesh");
  found.resolved = resolveMesh(found.session, sessionPath);
  if (found.resolved.state != MeshState::Same) return found;
  found.mesh = loadMesh(found.resolved.path, progress);
  progress.step("remembering which mesh it is");
  found.meshChecksum = checksumOfFile(found.resolved.path);
  return found;
}

/// Reads a session and its mesh, or a mesh as a document without constraints.
FoundDocument findDocument(const fs::path& path, Progress& progress)
{
  progress.step(fmt::format("reading {}", path.filename().string()));
  if (isSessionFile(path)) return findMesh(readSession(path), path, progress);
  FoundDocument found;
  found.mesh = loadMesh(path, progress);
  found.resolved = {path, MeshState::Same, ""};
  progress.step("remembering which mesh it is");
  found.meshChecksum = checksumOfFile(path);
  return found;
}

}  // namespace

struct DocumentFiles::OpenRequest {
  fs::path path;                       // what is read
  fs::path sessionPath;                // what it is saved to; empty for a mesh
  std::optional<SessionFile> session;  // read already, with what the user has said of its mesh
  bool isUnsaved = false;              // it differs from what is in the file at `sessionPath`
  std::function<void()> whenOpen = [] {};
};

DocumentFiles::DocumentFiles(Editor& editor, QWidget* window)
    : QObject(window), editor_(editor), window_(window), sheet_(job_, window)
{
  connect(&job_, &BackgroundJob::failed, this, [this](const std::exception_ptr& error) {
    showProblem(window_, tr("“%1” cannot be opened.").arg(opening_), error);
  });
  connect(&saving_, &BackgroundJob::failed, this, [this](const std::exception_ptr& error) {
    saveNext_.reset();
    showProblem(window_, tr("“%1” cannot be saved.").arg(textOf(savingPath_.filename())), error);
  });
  connect(&recent_, &RecentFiles::chosen, this, &DocumentFiles::open);
  connect(&editor_, &Editor::opened, this, [this] {
    if (!editor_.isOpen()) setPath({});
  });
}

DocumentFiles::~DocumentFiles() = default;

// Opening

void DocumentFiles::open(const QString& path)
{
  const QString absolute = QFileInfo(path).absoluteFilePath();
  if (!QFileInfo::exists(absolute)) {
    recent_.remove(absolute);
    return showProblem(window_, tr("“%1” cannot be opened.").arg(QFileInfo(path).fileName()),
                       tr("There is no such file any more: %1").arg(QDir::toNativeSeparators(absolute)));
  }
  job_.cancel();
  givenUp_.reset();
  if (!mayReplaceDocument()) return;
  OpenRequest request;
  request.path = pathOf(absolute);
  if (isSessionFile(request.path)) request.sessionPath = request.path;
  find(std::move(request));
}

void DocumentFiles::openDialog()
{
  QStringList filters = meshFilters();
  const QString sessions = "*.holdfast";
  QString all = filters.front();
  all.replace(all.indexOf('('), 1, '(' + sessions + ' ');
  filters.front() = all.replace(0, all.indexOf('('), tr("Meshes and sessions "));
  filters.insert(1, tr("Sessions (%1)").arg(sessions));
  const QString path =
      chooser_(window_, {FileQuestion::Purpose::Read, tr("Open a mesh or a session"), suggestedPath(), filters});
  if (!path.isEmpty()) open(path);
}

void DocumentFiles::recover(const Recoverable& copy, std::function<void()> whenOpen)
{
  job_.cancel();
  givenUp_.reset();
  if (!mayReplaceDocument()) return;
  OpenRequest request;
  request.path = copy.path;
  request.sessionPath = copy.original;
  request.isUnsaved = true;
  request.whenOpen = std::move(whenOpen);
  find(std::move(request));
}

void DocumentFiles::find(OpenRequest request)
{
  opening_ = QFileInfo(textOf(request.path)).fileName();
  sheet_.setTitle(tr("Opening %1").arg(opening_));
  job_.start([this, request](Progress& progress) {
    auto document = std::make_shared<FoundDocument>(request.session ? findMesh(*request.session, request.path, progress)
                                                                    : findDocument(request.path, progress));
    return [this, request, document] { found(request, document); };
  });
}

void DocumentFiles::found(OpenRequest request, std::shared_ptr<FoundDocument> document)
{
  if (document->mesh) return adopt(request, *document);
  askAboutMesh(std::move(request), *document);
}

void DocumentFiles::askAboutMesh(OpenRequest request, const FoundDocument& document)
{
  request.session = document.session;
  const QString explanation = QString::fromStdString(document.resolved.message);
  const bool isMissing = document.resolved.state == MeshState::Missing;
  switch (isMissing ? askAboutMissingMesh(window_, opening_, explanation)
                    : askAboutChangedMesh(window_, opening_, explanation)) {
    case MeshAnswer::Cancel:
      return;
    case MeshAnswer::UseAllTheSame:
      request.session->mesh = {document.resolved.path.string(), "", ""};
      break;
    case MeshAnswer::Locate: {
      const QString folder = QFileInfo(textOf(document.resolved.path)).path();
      const QString path =
          chooser_(window_, {FileQuestion::Purpose::Read, tr("Where is the mesh?"), folder, meshFilters()});
      if (path.isEmpty()) return;
      request.session->mesh.path = request.session->mesh.absolutePath =
          QFileInfo(path).absoluteFilePath().toStdString();
      break;
    }
  }
  request.isUnsaved = true;
  find(std::move(request));
}

void DocumentFiles::adopt(const OpenRequest& request, FoundDocument& document)
{
  // The document that is open may have been edited while this one was read.
  if (!mayReplaceDocument()) return;
  givenUp_.reset();
  meshChecksum_ = document.meshChecksum;
  sessionPath_ = request.sessionPath;
  editor_.open(std::move(*document.mesh), std::move(document.session.document));
  if (request.isUnsaved) editor_.markUnsaved();
  setPath(request.sessionPath);
  recent_.add(textOf(request.sessionPath.empty() ? editor_.mesh().path : request.sessionPath));
  Q_EMIT viewOpened(document.session.view);
  request.whenOpen();
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

// Saving

bool DocumentFiles::save()
{
  while (isSaving()) saving_.wait();
  const fs::path path = sessionPath_.empty() ? askWhereToSave() : sessionPath_;
  if (path.empty()) return false;
  beginSaving(path);
  saving_.wait();
  return wasSaved_;
}

void DocumentFiles::saveInBackground()
{
  if (sessionPath_.empty()) return saveAsInBackground();
  beginSaving(sessionPath_);
}

void DocumentFiles::saveAsInBackground()
{
  if (const fs::path path = askWhereToSave(); !path.empty()) beginSaving(path);
}

fs::path DocumentFiles::askWhereToSave()
{
  const QString suggestion =
      QFileInfo(suggestedPath()).path() + '/' + QFileInfo(name()).completeBaseName() + ".holdfast";
  QString path = chooser_(
      window_, {FileQuestion::Purpose::Write, tr("Save the session"), suggestion, {tr("Sessions (*.holdfast)")}});
  return path.isEmpty() ? fs::path() : pathOf(QFileInfo(path).absoluteFilePath());
}

void DocumentFiles::beginSaving(const fs::path& path)
{
  // One after the other, so that the newest stays.
  if (isSaving()) {
    saveNext_ = path;
    return;
  }
  savingPath_ = path;
  wasSaved_ = false;
  saving_.start(
      [this, path, session = sessionAt(path), model = editor_.model(), state = editor_.history().state()](Progress&) {
        writeSession(path, session);
        return [this, model, state] { saved(model, state); };
      });
}

void DocumentFiles::saved(const std::shared_ptr<const Model>& model, const std::shared_ptr<const DocumentState>& state)
{
  wasSaved_ = true;
  recent_.add(textOf(savingPath_));
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
  switch (askToSave(window_, name(), action)) {
    case SaveAnswer::Save:
      return save();
    case SaveAnswer::Discard:
      return true;
    case SaveAnswer::Cancel:
      break;
  }
  return false;
}

QString DocumentFiles::name() const
{
  if (!editor_.isOpen()) return {};
  return textOf((sessionPath_.empty() ? editor_.mesh().path : sessionPath_).filename());
}

SessionFile DocumentFiles::sessionAt(const fs::path& path) const
{
  SessionFile session = emptySessionAt(path);
  session.document = editor_.state();
  return session;
}

SessionFile DocumentFiles::emptySessionAt(const fs::path& path) const
{
  return {referenceTo(editor_.mesh().path, path, meshChecksum_), {}, view_ ? view_() : ViewState{}, ""};
}

QString DocumentFiles::suggestedPath() const
{
  if (!sessionPath_.empty()) return textOf(sessionPath_);
  if (editor_.isOpen()) return textOf(editor_.mesh().path);
  const QStringList recent = recent_.paths();
  return recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.front()).path();
}

}  // namespace holdfast

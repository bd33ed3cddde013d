#include "holdfast/window/files/document_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QWidget>
#include <future>
#include <utility>

#include <holdfast/base/error.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/files/found_document.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;

fs::path pathOf(const QString& text)
{
  return text.toStdString();
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
  connect(&job_, &BackgroundJob::failed, this, &DocumentFiles::showFailure);
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

void DocumentFiles::showFailure(const std::exception_ptr& error)
{
  const QString headline = tr("“%1” cannot be opened.").arg(opening_);
  try {
    std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    showProblem(window_, headline, tr("There is not enough memory for it; close other documents and programs."));
  } catch (const std::exception& problem) {
    showProblem(window_, headline, problem);
  }
}

bool DocumentFiles::mayReplaceDocument()
{
  if (editor_.isOpen() && editor_.history().state() == givenUp_) return true;
  if (!maySaveBefore(tr("opening another file"))) return false;
  if (editor_.isOpen()) givenUp_ = editor_.history().state();
  return true;
}

// Saving

/// Waits for the disk when it is destroyed: what was begun is on it then.
struct DocumentFiles::Saving {
  fs::path path;
  std::shared_ptr<const Model> model;
  std::shared_ptr<const DocumentState> state;
  std::future<std::exception_ptr> failure;
};

bool DocumentFiles::save()
{
  while (saving_) finishSaving();
  const fs::path path = sessionPath_.empty() ? askWhereToSave() : sessionPath_;
  if (path.empty()) return false;
  beginSaving(path);
  return finishSaving();
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
  // One after the other: the newest is to stay.
  if (saving_) {
    saveNext_ = path;
    return;
  }
  saving_ = std::make_shared<Saving>(Saving{path, editor_.model(), editor_.history().state(), {}});
  saving_->failure =
      std::async(std::launch::async,
                 [this, path, session = sessionAt(path), weak = std::weak_ptr(saving_)]() -> std::exception_ptr {
                   std::exception_ptr failure;
                   try {
                     writeSession(path, session);
                   } catch (...) {
                     failure = std::current_exception();
                   }
                   calls_.post([this, weak] {
                     if (saving_ && saving_ == weak.lock()) finishSaving();
                   });
                   return failure;
                 });
}

/// Waits for what is being saved, and tells how it went: true as well where nothing is.
bool DocumentFiles::finishSaving()
{
  const std::shared_ptr<Saving> ended = std::exchange(saving_, nullptr);
  if (!ended) return true;
  const QString file = textOf(ended->path.filename());
  if (const std::exception_ptr failure = ended->failure.get()) {
    saveNext_.reset();
    try {
      std::rethrow_exception(failure);
    } catch (const std::exception& error) {
      showProblem(window_, tr("“%1” cannot be saved.").arg(file), error);
    }
    return false;
  }
  recent_.add(textOf(ended->path));
  if (editor_.isOpen() && editor_.model() == ended->model) {
    setPath(ended->path);
    editor_.markSaved(ended->state);
  }
  Q_EMIT done(tr("saved %1").arg(file));
  if (const auto next = std::exchange(saveNext_, std::nullopt); next && editor_.isOpen()) beginSaving(*next);
  return true;
}

bool DocumentFiles::maySaveBefore(const QString& action)
{
  while (saving_)
    if (!finishSaving()) return false;
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

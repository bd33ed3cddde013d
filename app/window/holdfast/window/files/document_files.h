#pragma once
/// \file
/// Opening and saving: which files the document comes from and goes to, and what the user is asked about them.

#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include <holdfast/document/recovery.h>
#include <holdfast/document/session_file.h>
#include <holdfast/window/files/file_chooser.h>
#include <holdfast/window/files/progress_sheet.h>
#include <holdfast/window/files/recent_files.h>
#include <holdfast/window/model/background_job.h>
#include <holdfast/window/model/editor.h>
#include <holdfast/window/model/posted_calls.h>

class QMenu;
class QWidget;

namespace holdfast {

struct FoundDocument;

/// The files of the editor's document. Everything that fails is told in a box over `window`, and leaves the document as
/// it was.
class DocumentFiles : public QObject {
  Q_OBJECT

 public:
  DocumentFiles(Editor& editor, QWidget* window);
  ~DocumentFiles() override;

  /// In the place of `chooseFile`, for a program that drives the window.
  void setChooser(FileChooser chooser) { chooser_ = std::move(chooser); }
  /// What sessions keep of the view. Without it they say nothing of it.
  void setView(std::function<ViewState()> view) { view_ = std::move(view); }

  /// Reads a mesh or a session (`.holdfast`) on a thread of its own. The document that is open stays, and can be worked
  /// on, until the new one is ready; unsaved changes are asked about before. A session whose mesh is missing or has
  /// changed is asked about. Gives up what is being opened.
  void open(const QString& path);
  void openDialog();
  /// Opens a copy that a crash has left, as unsaved work on what it is a copy of. `whenOpen` is called when it is.
  void recover(const Recoverable& copy, std::function<void()> whenOpen);
  [[nodiscard]] bool isOpening() const noexcept { return job_.isRunning(); }

  /// False where nothing was saved: it failed, or the user thought better of it. There is an open document.
  bool save();
  /// As `save` and to another session, on a thread of its own: nobody waits for the disk. What is edited meanwhile is
  /// not in the file, and unsaved. Asked for once more meanwhile, it is done once more. `done` tells when it is.
  void saveInBackground();
  void saveAsInBackground();
  [[nodiscard]] bool isSaving() const noexcept { return saving_ != nullptr; }

  /// Asks about unsaved changes where there are any, and saves them if told to. `action` is what comes next: "closing
  /// the window". False where it must not.
  [[nodiscard]] bool maySaveBefore(const QString& action);

  /// Of the session that is open; empty where the document was never saved.
  [[nodiscard]] const std::filesystem::path& sessionPath() const noexcept { return sessionPath_; }
  /// Of the session, or of the mesh where there is none; empty without a document.
  [[nodiscard]] QString name() const;
  /// The document as a session at `path` says it. There is an open document.
  [[nodiscard]] SessionFile sessionAt(const std::filesystem::path& path) const;
  /// The same without constraints and options, which take time to copy where they are many.
  [[nodiscard]] SessionFile emptySessionAt(const std::filesystem::path& path) const;

  [[nodiscard]] RecentFiles& recentFiles() noexcept { return recent_; }
  void fillRecentMenu(QMenu& menu) { recent_.fill(menu); }

 Q_SIGNALS:
  /// The view that the file has, after `Editor::opened`. Empty for a mesh.
  void viewOpened(const ViewState& view);
  /// `sessionPath` or `name` is another.
  void pathChanged();
  /// For the status line: "saved bracket.holdfast".
  void done(const QString& what);

 private:
  struct OpenRequest;  // what is to be opened
  struct Saving;       // what is being written

  void openSession(OpenRequest request);
  void find(OpenRequest request);
  void found(OpenRequest request, std::shared_ptr<FoundDocument> document);
  void askAboutMesh(OpenRequest request, const FoundDocument& document);
  void locateMesh(OpenRequest request);
  void adopt(const OpenRequest& request, FoundDocument& document);
  void setPath(const std::filesystem::path& path);
  void showFailure(const std::exception_ptr& error);
  [[nodiscard]] bool mayReplaceDocument();
  [[nodiscard]] std::filesystem::path askWhereToSave();
  void beginSaving(const std::filesystem::path& path);
  bool finishSaving();
  [[nodiscard]] QString suggestedPath() const;

  Editor& editor_;
  QWidget* window_;
  FileChooser chooser_ = chooseFile;
  std::function<ViewState()> view_;
  BackgroundJob job_;
  ProgressSheet sheet_;
  RecentFiles recent_;
  std::filesystem::path sessionPath_;
  std::string meshChecksum_;                       // of the mesh as it was read
  QString opening_;                                // the file, for messages
  std::shared_ptr<const DocumentState> givenUp_;   // the unsaved state that the user has agreed to lose
  std::optional<std::filesystem::path> saveNext_;  // asked for while something was being saved
  PostedCalls calls_;                              // by the thread that writes; outlives it
  std::shared_ptr<Saving> saving_;                 // null when nothing is written
};

}  // namespace holdfast

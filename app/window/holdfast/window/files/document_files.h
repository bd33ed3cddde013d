#pragma once
/// Opens, imports and saves the files of the document, and asks the user about them.

#include <QWidget>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include <holdfast/document/recovery.h>
#include <holdfast/document/session_file.h>
#include <holdfast/window/files/bundled_files.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/model/background_job.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Opens and saves the editor's document. A box over `window` reports each failure, which leaves the document as it
/// was.
class DocumentFiles : public QObject {
  Q_OBJECT

 public:
  DocumentFiles(Editor& editor, QWidget* window);

  /// Sets the unit of lengths in meshes that are opened. Meshes do not name a unit themselves.
  void setUnit(const QString& unit) { unit_ = unit.toStdString(); }
  /// Replaces `chooseFile`, for a program that drives the window.
  void setChooser(FileChooser chooser) { chooser_ = std::move(chooser); }
  /// Sets the function that returns what sessions keep of the view. By default they keep nothing.
  void setView(std::function<ViewState()> view) { view_ = std::move(view); }

  /// Reads a mesh or a session (`.holdfast`) on a thread of its own. It asks about unsaved changes first, and gives up
  /// a file that is being opened. It also asks about the mesh of a session if that is missing or has changed.
  void open(const QString& path);
  void openDialog();
  /// Opens an example as a document that was never saved.
  void openExample(const Example& example);
  /// Opens a copy that a crash has left, as unsaved work on the document that it is a copy of. It calls `whenOpen` when
  /// the copy is open.
  void recover(const Recoverable& copy, std::function<void()> whenOpen);
  /// Closes the document. It asks before about unsaved changes.
  void close();
  [[nodiscard]] bool isOpening() const noexcept { return job_.isRunning(); }

  void importConstraints(const QString& path);
  void importDialog();
  /// Asks for a mesh, reads it on a thread of its own, and keeps the constraints of `rows` on it (`keepOnMesh`).
  void guideMeshDialog(const std::vector<Index>& rows);

  /// Saves the document. Returns false if nothing was saved, because of an error or because the user did not want it. A
  /// document is open.
  bool save();
  /// Saves on a thread of its own. Edits made meanwhile stay unsaved. A request during a save is done after it.
  void saveInBackground() { beginSaving(sessionPath_.empty() ? askWhereToSave() : sessionPath_); }
  void saveAsInBackground() { beginSaving(askWhereToSave()); }
  [[nodiscard]] bool isSaving() const noexcept { return saving_.isRunning(); }

  /// Asks about unsaved changes, if any, and saves them if the user wants. `action` says what comes next: "closing the
  /// window". Returns false if that may not come.
  [[nodiscard]] bool maySaveBefore(const QString& action);

  /// Returns the file of the session; empty if the document was never saved.
  [[nodiscard]] const std::filesystem::path& sessionPath() const noexcept { return sessionPath_; }
  /// Returns the file name of the session, or of the mesh if there is no session. It is empty without a document.
  [[nodiscard]] QString name() const;
  /// Returns the open document as a session at `path`, without constraints and options: copying many of them takes
  /// time.
  [[nodiscard]] SessionFile emptySessionAt(const std::filesystem::path& path) const
  {
    return {referenceTo(editor_.mesh().path, path, meshChecksum_), {}, view_(), ""};
  }

 Q_SIGNALS:
  /// A file was opened. `view` is the view that the file has; it is empty for a mesh. The signal comes after
  /// `Editor::opened`.
  void viewOpened(const ViewState& view);
  void pathChanged();
  void done(const QString& what);

 private:
  /// Holds what is being opened, and what the files say of it.
  struct Opening {
    std::filesystem::path path;         // what is read
    std::filesystem::path sessionPath;  // what it is saved to; empty for a mesh
    std::filesystem::path constraints;  // of an example; else empty
    std::string unit;
    bool isUnsaved = false;  // it differs from what is in the file at `sessionPath`
    std::function<void()> whenOpen = [] {};
    std::optional<SessionFile> session;  // read, perhaps with what the user has said of its mesh
    ResolvedMesh resolved;               // where the mesh is, and whether it is the session's
    LoadedMesh mesh;                     // if it is
    std::string meshChecksum;
    std::size_t lostMeasurements = 0;  // whose places the mesh does not have

    void read(Progress& progress);
    void keepMeasurements();
  };

  void begin(Opening opening);
  void weld(double tolerance);
  void find(const std::shared_ptr<Opening>& opening);
  void askAboutMesh(const std::shared_ptr<Opening>& opening);
  void adopt(Opening& opening);
  void setPath(const std::filesystem::path& path);
  [[nodiscard]] bool mayReplaceDocument();
  [[nodiscard]] QString askForFile(const QString& title, const QString& suggestion, const QStringList& filters)
  {
    return chooser_(window_, {FileQuestion::Purpose::Read, title, suggestion, filters});
  }
  [[nodiscard]] std::filesystem::path askWhereToSave();
  void beginSaving(const std::filesystem::path& path);
  void saved(const std::shared_ptr<const Model>& model, const std::shared_ptr<const DocumentState>& state);
  [[nodiscard]] QString suggestedPath() const;

  Editor& editor_;
  QWidget* window_;
  FileChooser chooser_ = chooseFile;
  std::string unit_;
  std::function<ViewState()> view_ = [] { return ViewState{}; };
  BackgroundJob job_;
  std::filesystem::path sessionPath_;
  std::string meshChecksum_;                       // of the mesh as it was read
  QString failure_;                                // what to say where the job fails
  std::shared_ptr<const DocumentState> givenUp_;   // the unsaved state that the user has agreed to lose
  std::filesystem::path savingPath_;               // of the latest save
  bool wasSaved_ = false;                          // by it
  std::optional<std::filesystem::path> saveNext_;  // requested during a save
  BackgroundJob saving_;                           // last: waits for the disk when it is destroyed
};

}  // namespace holdfast

#pragma once
/// Asks the user for files, and tells the user about them. Boxes say what is wrong, where, and what to do.

#include <QMessageBox>
#include <exception>
#include <filesystem>
#include <functional>

#include <holdfast/document/session_file.h>

namespace holdfast {

struct FileQuestion {
  enum class Purpose { Read, Write };
  Purpose purpose = Purpose::Read;
  QString title;
  QString suggestion;   ///< a folder, or a file in it
  QStringList filters;  ///< "Sessions (*.holdfast)": a name without an ending gets the first one's
};

/// Returns the path that the user chose; an empty one if the user chose none. Programs that drive the window replace
/// `chooseFile` by it.
using FileChooser = std::function<QString(QWidget* window, const FileQuestion& question)>;

/// Asks with the dialog of the desktop, or with Qt's own where the desktop has none. A file is only overwritten after a
/// question.
[[nodiscard]] QString chooseFile(QWidget* window, const FileQuestion& question);

/// Returns "Meshes (*.obj *.ply ...)" and one filter for each format that is known.
[[nodiscard]] QStringList meshFilters();
/// Returns a sentence with the extensions of all that can be opened.
[[nodiscard]] QString formatsText();

[[nodiscard]] QString textOf(const std::filesystem::path& path);

/// Shows a box about a failure. `headline` says what failed. File, line, place and reason come from `error`.
void showProblem(QWidget* window, const QString& headline, const std::exception_ptr& error);
void showProblem(QWidget* window, const QString& headline, const QString& reason);

/// Shows a box after a success. `headline` says what was done. The notes are what the user should know about it.
void showNotes(QWidget* window, const QString& headline, const QStringList& notes);

/// Asks about unsaved changes of the document `name`, before `action`. Returns `Save`, `Discard` or `Cancel`.
[[nodiscard]] QMessageBox::StandardButton askToSave(QWidget* window, const QString& name, const QString& action);

/// Asks a question with the buttons `goOn` and Cancel. Returns false for Cancel, which Escape and Enter choose, too.
[[nodiscard]] bool askToGoOn(QWidget* window, const QString& headline, const QString& explanation, const QString& goOn);

enum class MeshAnswer { Locate, UseAllTheSame, Cancel };

/// Asks what to do about the mesh of `session`, which is missing or has changed. A missing mesh cannot be used.
[[nodiscard]] MeshAnswer askAboutSessionMesh(QWidget* window, const QString& session, const ResolvedMesh& mesh);

}  // namespace holdfast

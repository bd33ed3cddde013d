#pragma once
/// How the user is asked for files, and told about them: boxes say what is wrong, where, and what to do.

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

/// Returns the path that the user chose, empty where none. Programs that drive the window replace `chooseFile` by it.
using FileChooser = std::function<QString(QWidget* window, const FileQuestion& question)>;

/// Asks with Qt's dialog, that of the desktop where there is one. A file is only overwritten after a question.
[[nodiscard]] QString chooseFile(QWidget* window, const FileQuestion& question);

/// "Meshes (*.obj *.ply ...)" and one filter for each format that is known.
[[nodiscard]] QStringList meshFilters();
/// A sentence with the extensions of all that can be opened.
[[nodiscard]] QString formatsText();

[[nodiscard]] QString textOf(const std::filesystem::path& path);

/// `headline` says what failed; file, line, place and reason come from `error`.
void showProblem(QWidget* window, const QString& headline, const std::exception_ptr& error);
void showProblem(QWidget* window, const QString& headline, const QString& reason);

/// `headline` says what was done; the notes are what the user should know about it.
void showNotes(QWidget* window, const QString& headline, const QStringList& notes);

/// `Save`, `Discard` or `Cancel`: about unsaved changes of the document `name`, before `action`.
[[nodiscard]] QMessageBox::StandardButton askToSave(QWidget* window, const QString& name, const QString& action);

/// A question with the button `goOn` and Cancel. False for Cancel, which Escape and Enter choose too.
[[nodiscard]] bool askToGoOn(QWidget* window, const QString& headline, const QString& explanation, const QString& goOn);

enum class MeshAnswer { Locate, UseAllTheSame, Cancel };

/// What to do about the mesh of `session`, which is missing or has changed. A missing one cannot be used.
[[nodiscard]] MeshAnswer askAboutSessionMesh(QWidget* window, const QString& session, const ResolvedMesh& mesh);

}  // namespace holdfast

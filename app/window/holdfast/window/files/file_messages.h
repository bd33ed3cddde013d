#pragma once
/// \file
/// Messages and questions about files, in boxes that say what is wrong, where, and what to do.

#include <QString>
#include <QStringList>
#include <exception>
#include <filesystem>

class QWidget;

namespace holdfast {

[[nodiscard]] QString textOf(const std::filesystem::path& path);

/// `headline` says what failed; file, line, place and reason come from `error`.
void showProblem(QWidget* window, const QString& headline, const std::exception_ptr& error);
void showProblem(QWidget* window, const QString& headline, const QString& reason);

/// `headline` says what was done; the notes are what the user should know about it.
void showNotes(QWidget* window, const QString& headline, const QStringList& notes);

enum class SaveAnswer { Save, Discard, Cancel };

/// Whether unsaved changes of the document called `name` are to be saved before `action` ("closing the window").
[[nodiscard]] SaveAnswer askToSave(QWidget* window, const QString& name, const QString& action);

/// A question with the button `goOn` and Cancel. False for Cancel, which Escape and Enter choose too.
[[nodiscard]] bool askToGoOn(QWidget* window, const QString& headline, const QString& explanation, const QString& goOn);

enum class MeshAnswer { Locate, UseAllTheSame, Cancel };

/// What to do about the mesh of `session`; `explanation` says what is wrong with it. A missing one cannot be used.
[[nodiscard]] MeshAnswer askAboutMissingMesh(QWidget* window, const QString& session, const QString& explanation);
[[nodiscard]] MeshAnswer askAboutChangedMesh(QWidget* window, const QString& session, const QString& explanation);

}  // namespace holdfast

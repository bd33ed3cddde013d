#pragma once
/// \file
/// What the user is told and asked about files, in boxes that say what is wrong, where, and what to do.

#include <QString>
#include <QStringList>
#include <exception>
#include <filesystem>

class QWidget;

namespace holdfast {

[[nodiscard]] QString textOf(const std::filesystem::path& path);

/// `headline` says what did not work; the file, the line, the place in it and the reason are those of `error`.
void showProblem(QWidget* window, const QString& headline, const std::exception& error);
void showProblem(QWidget* window, const QString& headline, const QString& reason);

/// Tells what was done, and what the user should know of it.
void showNotes(QWidget* window, const QString& headline, const QStringList& notes);

enum class SaveAnswer { Save, Discard, Cancel };

/// Whether unsaved changes of the document called `name` are to be saved before `action` ("closing the window").
[[nodiscard]] SaveAnswer askToSave(QWidget* window, const QString& name, const QString& action);

/// A question with one way on, by a button that says it, and Cancel. False for Cancel, which Escape and Enter choose
/// too.
[[nodiscard]] bool askToGoOn(QWidget* window, const QString& headline, const QString& explanation, const QString& goOn);

enum class MeshAnswer { Locate, UseAllTheSame, Cancel };

/// What to do about the mesh of `session`, of which `explanation` says what is wrong. One that is missing cannot be
/// used.
[[nodiscard]] MeshAnswer askAboutMissingMesh(QWidget* window, const QString& session, const QString& explanation);
[[nodiscard]] MeshAnswer askAboutChangedMesh(QWidget* window, const QString& session, const QString& explanation);

}  // namespace holdfast

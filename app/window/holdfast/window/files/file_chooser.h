#pragma once
/// \file
/// How the user is asked for a file.

#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace holdfast {

/// What is asked for.
struct FileQuestion {
  enum class Purpose { Read, Write };
  Purpose purpose = Purpose::Read;
  QString title;
  QString suggestion;  ///< a folder, or a file in it
  QStringList
      filters;  ///< "Sessions (*.holdfast)"; the first pattern of the chosen one is what a name without an ending gets
};

/// Returns the path that the user chose, empty where none. Every dialog for files goes through one of these: a program
/// that drives the window puts its own in the place of `chooseFile`.
using FileChooser = std::function<QString(QWidget* window, const FileQuestion& question)>;

/// Asks with Qt's dialog, that of the desktop where there is one. A file is only overwritten after a question.
[[nodiscard]] QString chooseFile(QWidget* window, const FileQuestion& question);

/// "Meshes (*.obj *.ply ...)" and one filter for each format that is known.
[[nodiscard]] QStringList meshFilters();

}  // namespace holdfast

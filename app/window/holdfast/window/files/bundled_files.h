#pragma once
/// Finds what is installed beside the program: the sample meshes and the manual.

#include <QString>
#include <vector>

namespace holdfast {

/// Returns where a file such as "data/bracket.obj" or "docs/window.md" lies beside this program, installed or built.
/// The result is empty if the file is nowhere.
[[nodiscard]] QString bundledFile(const QString& path);

/// Returns the folder of `file`, where files of the user's own may lie beside it. If `file` is bundled with the
/// program, or its folder cannot be written to, it returns the folder of the user's documents.
[[nodiscard]] QString ownFolderBeside(const QString& file);

/// A sample. All its paths are absolute.
struct Example {
  QString title;
  QString mesh;
  QString constraints;
  QString picture;
};

/// Returns the samples whose mesh and constraints are there.
[[nodiscard]] std::vector<Example> examples();

}  // namespace holdfast

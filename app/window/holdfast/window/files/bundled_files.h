#pragma once
/// What is installed beside the program: the sample meshes and the manual.

#include <QString>
#include <vector>

namespace holdfast {

/// Of "data/bracket.obj" or "docs/window.md": where it lies beside this program, installed or built; empty if nowhere.
[[nodiscard]] QString bundledFile(const QString& path);

/// The folder of `file`, where files of the user's own may lie beside it; that of the user's documents instead where
/// `file` is bundled with the program, or its folder cannot be written to.
[[nodiscard]] QString ownFolderBeside(const QString& file);

/// A sample, all of it by absolute paths.
struct Example {
  QString title;
  QString mesh;
  QString constraints;
  QString picture;
};

/// Those that are there.
[[nodiscard]] std::vector<Example> examples();

}  // namespace holdfast

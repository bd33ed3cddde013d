#pragma once
/// Messages call vertices and faces by their places in the file, and by the labels that the file gives them.

#include <string>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Returns " (labelled 100234)" for the vertex or face `id` of a file with these labels. Returns nothing where `labels`
/// is empty.
[[nodiscard]] std::string labelText(const std::vector<Index>& labels, Index id);

/// Returns what a message says of a vertex of `mesh`: "vertex 16", or "vertex 16 (labelled 100234)" where the file has
/// labels.
[[nodiscard]] std::string vertexText(const Mesh& mesh, Index vertex);

/// Returns what a message says of a face of `mesh`: "face 7", or "face 7 (labelled 20115)".
[[nodiscard]] std::string faceText(const Mesh& mesh, Index face);

}  // namespace holdfast

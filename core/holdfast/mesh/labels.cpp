#include "holdfast/mesh/labels.h"

#include <fmt/format.h>

namespace holdfast {

std::string labelText(const std::vector<Index>& labels, Index id)
{
  return labels.empty() ? "" : fmt::format(" (labelled {})", labels[id]);
}

std::string vertexText(const Mesh& mesh, Index vertex)
{
  return fmt::format("vertex {}{}", vertex, labelText(mesh.labels.vertices, vertex));
}

std::string faceText(const Mesh& mesh, Index face)
{
  return fmt::format("face {}{}", face, labelText(mesh.labels.faces, face));
}

}  // namespace holdfast

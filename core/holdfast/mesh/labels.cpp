#include "holdfast/mesh/labels.h"

#include <fmt/format.h>

namespace holdfast {
namespace {

std::string text(const char* what, Index id, const std::vector<Index>& labels)
{
  return labels.empty() ? fmt::format("{} {}", what, id) : fmt::format("{} {} (labelled {})", what, id, labels[id]);
}

}  // namespace

std::string vertexText(const Mesh& mesh, Index vertex)
{
  return text("vertex", vertex, mesh.labels.vertices);
}

std::string faceText(const Mesh& mesh, Index face)
{
  return text("face", face, mesh.labels.faces);
}

}  // namespace holdfast

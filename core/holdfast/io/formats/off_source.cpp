#include "holdfast/io/formats/off_source.h"

#include <cassert>
#include <utility>

#include <holdfast/io/formats/splice_writer.h>
#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

class OffSource final : public MeshSource {
 public:
  OffSource(std::string bytes, OffLayout layout, Mesh rest)
      : bytes_(std::move(bytes)), layout_(std::move(layout)), rest_(std::move(rest))
  {
  }

  [[nodiscard]] std::string extension() const override { return ".off"; }
  [[nodiscard]] std::vector<std::string> extras() const override { return layout_.extras; }
  [[nodiscard]] Serialized withPositions(const Positions& positions) const override;

 private:
  [[nodiscard]] NormalUpdate normals(const Positions& positions) const;
  [[nodiscard]] std::size_t normalColumn(std::size_t columns) const;

  std::string bytes_;
  OffLayout layout_;
  Mesh rest_;
};

std::vector<std::string_view> tokensOfLine(TextCursor& cursor)
{
  std::vector<std::string_view> tokens;
  for (std::string_view token = cursor.token(); !token.empty(); token = cursor.token()) tokens.push_back(token);
  return tokens;
}

NormalUpdate OffSource::normals(const Positions& positions) const
{
  if (!layout_.form.hasNormals) return {{}, std::vector<bool>(positions.rows(), false), {}};
  return updateNormals(rest_.faces, cornerVertices(rest_.faces), positions.rows(), rest_.positions, positions);
}

std::size_t OffSource::normalColumn(std::size_t columns) const
{
  if (!layout_.form.isColorBeforeNormal) return 3;
  return 6 + (columns - static_cast<std::size_t>(layout_.form.leastColumns()));
}

Serialized OffSource::withPositions(const Positions& positions) const
{
  assert(positions.rows() == rest_.vertexCount());
  const NormalUpdate update = normals(positions);
  TextCursor cursor(bytes_, {}, kOffDialect);
  cursor.seek(layout_.vertexOffset, 1);
  SpliceWriter writer(bytes_);
  for (Index v = 0; v < positions.rows() && cursor.findToken(); ++v) {
    const std::vector<std::string_view> tokens = tokensOfLine(cursor);
    for (std::size_t k = 0; k < 3; ++k)
      if (!hasSameBits(rest_.positions(v, k), positions(v, k)))
        writer.replace(tokens[k], NumberText(positions(v, k)).view());
    if (!update.isNew[v]) continue;
    const std::size_t first = normalColumn(tokens.size());
    for (std::size_t k = 0; k < 3; ++k) writer.replace(tokens[first + k], NumberText(update.normals(v, k)).view());
  }
  return {std::move(writer).finish(), update.notes};
}

}  // namespace

std::shared_ptr<const MeshSource> makeOffSource(std::string bytes, OffLayout layout, Mesh rest)
{
  return std::make_shared<const OffSource>(std::move(bytes), std::move(layout), std::move(rest));
}

}  // namespace holdfast

#include "holdfast/io/formats/text_source.h"

#include <cassert>
#include <utility>

#include <holdfast/io/formats/splice_writer.h>
#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

class TextSource final : public MeshSource {
 public:
  TextSource(std::string bytes, TextLayout layout, Mesh rest)
      : bytes_(std::move(bytes)), layout_(std::move(layout)), rest_(std::move(rest))
  {
  }

  [[nodiscard]] std::string extension() const override { return layout_.extension; }
  [[nodiscard]] std::vector<std::string> extras() const override { return layout_.extras; }
  [[nodiscard]] Serialized withPositions(const Positions& positions) const override;

 private:
  std::string bytes_;
  TextLayout layout_;
  Mesh rest_;
};

/// Replaces the numbers from `offset` on whose bits differ between two rows; `nullptr` as `before`: all of them.
void replaceRow(SpliceWriter& writer, TextCursor& cursor, std::size_t offset, const double* before, const double* after)
{
  cursor.seek(offset, 1);
  for (int k = 0; k < 3; ++k) {
    static_cast<void>(cursor.findToken());
    const std::string_view token = cursor.token();
    if (before == nullptr || !hasSameBits(before[k], after[k])) writer.replace(token, NumberText(after[k]).view());
  }
}

Serialized TextSource::withPositions(const Positions& positions) const
{
  assert(positions.rows() == rest_.vertexCount());
  const auto normalCount = static_cast<Index>(layout_.normalOffsets.size());
  const NormalUpdate update =
      updateNormals(rest_.faces, layout_.normalOfCorner, normalCount, rest_.positions, positions);
  TextCursor cursor(bytes_, {}, layout_.dialect);
  SpliceWriter writer(bytes_);
  // Vertices and normals may alternate in the file; the writer goes from front to back.
  Index v = 0;
  Index n = 0;
  while (v < positions.rows() || n < normalCount) {
    const bool isVertexNext =
        n == normalCount || (v < positions.rows() && layout_.vertexOffsets[v] < layout_.normalOffsets[n]);
    if (isVertexNext) {
      replaceRow(writer, cursor, layout_.vertexOffsets[v], rest_.positions.row(v).data(), positions.row(v).data());
      ++v;
    } else {
      if (update.isNew[n]) replaceRow(writer, cursor, layout_.normalOffsets[n], nullptr, update.normals.row(n).data());
      ++n;
    }
  }
  return {std::move(writer).finish(), update.notes};
}

}  // namespace

std::shared_ptr<const MeshSource> makeTextSource(std::string bytes, TextLayout layout, Mesh rest)
{
  return std::make_shared<const TextSource>(std::move(bytes), std::move(layout), std::move(rest));
}

}  // namespace holdfast

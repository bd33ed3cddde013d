#include "holdfast/io/formats/stl_source.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <holdfast/io/formats/splice_writer.h>
#include <holdfast/io/formats/stl_format.h>
#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/io/text/text_cursor.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

/// The new normals of facets with a moved corner, one a facet.
NormalUpdate facetNormals(const Positions& before, const Positions& after)
{
  Polygons facets;
  std::vector<Index> facetOfCorner;
  facets.reserve(before.rows() / 3, before.rows());
  for (Index f = 0; 3 * f < before.rows(); ++f) {
    facets.add({3 * f, 3 * f + 1, 3 * f + 2});
    facetOfCorner.insert(facetOfCorner.end(), 3, f);
  }
  return updateNormals(facets, facetOfCorner, facets.size(), before, after);
}

class BinaryStlSource final : public MeshSource {
 public:
  BinaryStlSource(std::string bytes, Positions rest) : bytes_(std::move(bytes)), rest_(std::move(rest)) {}

  [[nodiscard]] std::string extension() const override { return ".stl"; }
  [[nodiscard]] std::vector<std::string> extras() const override;
  [[nodiscard]] Serialized withPositions(const Positions& positions) const override;

 private:
  std::string bytes_;
  Positions rest_;
};

std::vector<std::string> BinaryStlSource::extras() const
{
  for (std::size_t at = kStlFacetsOffset; at < bytes_.size(); at += kStlFacetBytes)
    if (bytes_[at + kStlAttributesOffset] != 0 || bytes_[at + kStlAttributesOffset + 1] != 0)
      return {"facet normals", "facet attributes"};
  return {"facet normals"};
}

Serialized BinaryStlSource::withPositions(const Positions& positions) const
{
  assert(positions.rows() == rest_.rows());
  const std::string rounding = stlRounding(positions).note();
  const std::vector<bool> moved = movedVertices(rest_, positions);
  NormalUpdate update = facetNormals(rest_, positions);
  std::string bytes = bytes_;
  for (Index f = 0; 3 * f < positions.rows(); ++f) {
    const std::size_t facet = kStlFacetsOffset + kStlFacetBytes * f;
    if (update.isNew[f]) bytes.replace(facet, kStlVectorBytes, stlBytes(update.normals.row(f)));
    for (Index k = 0; k < 3; ++k)
      if (moved[3 * f + k])
        bytes.replace(facet + kStlVectorBytes * (k + 1), kStlVectorBytes, stlBytes(positions.row(3 * f + k)));
  }
  if (!rounding.empty()) update.notes.push_back(rounding);
  return {std::move(bytes), std::move(update.notes), true};
}

class TextStlSource final : public MeshSource {
 public:
  TextStlSource(std::string bytes, std::vector<std::size_t> vertexOffsets, std::vector<std::size_t> normalOffsets,
                Positions rest)
      : bytes_(std::move(bytes)),
        vertexOffsets_(std::move(vertexOffsets)),
        normalOffsets_(std::move(normalOffsets)),
        rest_(std::move(rest))
  {
  }

  [[nodiscard]] std::string extension() const override { return ".stl"; }
  [[nodiscard]] std::vector<std::string> extras() const override { return {"facet normals", "names of solids"}; }
  [[nodiscard]] Serialized withPositions(const Positions& positions) const override;

 private:
  std::string bytes_;
  std::vector<std::size_t> vertexOffsets_;
  std::vector<std::size_t> normalOffsets_;
  Positions rest_;
};

std::array<std::string_view, 3> threeTokens(TextCursor& cursor, std::size_t offset)
{
  cursor.seek(offset, 1);
  std::array<std::string_view, 3> tokens;
  for (std::string_view& token : tokens)
    if (cursor.findToken()) token = cursor.token();
  return tokens;
}

Serialized TextStlSource::withPositions(const Positions& positions) const
{
  assert(positions.rows() == rest_.rows());
  const NormalUpdate update = facetNormals(rest_, positions);
  TextCursor cursor(bytes_, {});
  SpliceWriter writer(bytes_);
  for (Index v = 0; v < positions.rows(); ++v) {
    if (v % 3 == 0 && update.isNew[v / 3]) {
      const auto tokens = threeTokens(cursor, normalOffsets_[v / 3]);
      for (Index k = 0; k < 3; ++k) writer.replace(tokens[k], NumberText(update.normals(v / 3, k)).view());
    }
    const auto tokens = threeTokens(cursor, vertexOffsets_[v]);
    for (Index k = 0; k < 3; ++k)
      if (!hasSameBits(rest_(v, k), positions(v, k))) writer.replace(tokens[k], NumberText(positions(v, k)).view());
  }
  return {std::move(writer).finish(), update.notes, false};
}

}  // namespace

std::shared_ptr<const MeshSource> makeBinaryStlSource(std::string bytes, Positions rest)
{
  return std::make_shared<const BinaryStlSource>(std::move(bytes), std::move(rest));
}

std::shared_ptr<const MeshSource> makeTextStlSource(std::string bytes, std::vector<std::size_t> vertexOffsets,
                                                    std::vector<std::size_t> normalOffsets, Positions rest)
{
  return std::make_shared<const TextStlSource>(std::move(bytes), std::move(vertexOffsets), std::move(normalOffsets),
                                               std::move(rest));
}

}  // namespace holdfast

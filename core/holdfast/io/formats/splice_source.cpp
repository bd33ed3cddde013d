#include <algorithm>
#include <cassert>

#include <holdfast/base/printable.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>

#include "holdfast/io/formats/formats.h"

namespace holdfast {
namespace {

bool hasSameRow(const Positions& a, const Positions& b, Index v)
{
  return hasSameBits(a(v, 0), b(v, 0)) && hasSameBits(a(v, 1), b(v, 1)) && hasSameBits(a(v, 2), b(v, 2));
}

/// For each normal, whether a face that uses it has a moved vertex.
std::vector<bool> affectedNormals(const Mesh& rest, const FileLayout& layout, const Positions& after)
{
  std::vector<bool> isAffected(layout.normalCount, false);
  auto normal = layout.normalOfCorner.begin();
  for (Index f = 0; f < rest.faces.size(); ++f) {
    const auto polygon = rest.faces[f];
    const bool hasMoved = std::ranges::any_of(polygon, [&](Index v) { return !hasSameRow(rest.positions, after, v); });
    for (std::size_t k = 0; k < polygon.size(); ++k, ++normal)
      if (hasMoved && *normal >= 0) isAffected[*normal] = true;
  }
  return isAffected;
}

/// New values for stored normals.
struct NormalUpdate {
  Positions normals;               // one row a stored normal; meaningful where `isNew`
  std::vector<bool> isNew;         // the others keep the value in the file
  std::vector<std::string> notes;  // how many were recomputed, and how many could not be
};

/// Area-weighted normals, for those with a moved vertex in one of the faces that use them. Where the area around a
/// normal vanishes, it keeps its old value.
NormalUpdate updateNormals(const Mesh& rest, const FileLayout& layout, const Positions& after)
{
  NormalUpdate update{areaWeightedNormals(after, rest.faces, layout.normalOfCorner, layout.normalCount),
                      affectedNormals(rest, layout, after),
                      {}};
  Index recomputed = 0;
  Index kept = 0;
  for (Index n = 0; n < layout.normalCount; ++n) {
    if (!update.isNew[n]) continue;
    update.isNew[n] = !update.normals.row(n).isZero(0);
    ++(update.isNew[n] ? recomputed : kept);
  }
  if (recomputed > 0) update.notes.push_back(counted(recomputed, "normal") + " recomputed");
  if (kept > 0)
    update.notes.push_back(counted(kept, "normal") + " kept from before: the faces around have no area now");
  return update;
}

class SpliceSource final : public MeshSource {
 public:
  SpliceSource(std::string bytes, FileLayout layout) : bytes_(std::move(bytes)), layout_(std::move(layout)) {}

  [[nodiscard]] std::string extension() const override { return layout_.extension; }
  [[nodiscard]] bool isText() const override { return !layout_.byteOrder; }
  [[nodiscard]] std::vector<std::string> extras() const override { return layout_.extras; }

  [[nodiscard]] Serialized withPositions(const Mesh& rest, const Positions& positions) const override
  {
    assert(positions.rows() == rest.vertexCount());
    const bool isSinglePrecision = layout_.noteRounding != nullptr;
    Index v = 0;
    while (v < positions.rows() && hasSameRow(rest.positions, positions, v)) ++v;
    if (v == positions.rows()) return {bytes_, {}, isSinglePrecision};
    NormalUpdate update;
    if (layout_.normalCount > 0) update = updateNormals(rest, layout_, positions);
    update.notes.insert(update.notes.end(), layout_.notesOfMotion.begin(), layout_.notesOfMotion.end());
    if (isSinglePrecision) layout_.noteRounding(positions, update.notes);
    return {spliced(rest.positions, positions, update), std::move(update.notes), isSinglePrecision};
  }

 private:
  [[nodiscard]] std::string spliced(const Positions& rest, const Positions& positions, const NormalUpdate& update) const
  {
    TextCursor cursor(bytes_, {}, layout_.dialect);
    std::string result;
    result.reserve(bytes_.size());
    std::size_t copied = 0;
    const auto replace = [&](std::string_view part, std::string_view replacement) {
      const auto first = static_cast<std::size_t>(part.data() - bytes_.data());
      result.append(bytes_, copied, first - copied).append(replacement);
      copied = first + part.size();
    };
    for (const std::size_t offset : layout_.typeWords) {
      cursor.seek(offset, 1);
      replace(cursor.token(), "double");
    }
    for (const auto& [offset, first] : layout_.numbers) {
      cursor.seek(offset, 1);
      for (Index k = 0; k < (layout_.areTogether ? 3 : 1); ++k) {
        const Index number = first < 0 ? -1 - first + k : first + k;
        const NumberType type = (first < 0 ? layout_.normalTypes : layout_.coordinateTypes)[number % 3];
        const std::string_view part = next(cursor, type);
        if (first < 0) {
          if (update.isNew[number / 3]) replace(part, bytesOf(update.normals.data()[number], type));
        } else if (isReplaced(type, rest.data()[number], positions.data()[number])) {
          replace(part, bytesOf(positions.data()[number], writtenType()));
        }
      }
    }
    return result.append(bytes_, copied);
  }

  /// The part of the file that says the number at the cursor.
  [[nodiscard]] std::string_view next(TextCursor& cursor, NumberType type) const
  {
    if (!layout_.byteOrder) {
      static_cast<void>(cursor.findToken());
      return cursor.token();
    }
    const std::string_view part = std::string_view(bytes_).substr(cursor.offset(), sizeOf(type));
    cursor.seek(cursor.offset() + part.size(), 1);
    return part;
  }

  /// In binary files coordinates that become double take other bytes, moved or not.
  [[nodiscard]] bool isReplaced(NumberType type, double before, double after) const
  {
    return (layout_.byteOrder && type != writtenType()) || !hasSameBits(before, after);
  }

  /// Of coordinates.
  [[nodiscard]] NumberType writtenType() const
  {
    return layout_.noteRounding != nullptr ? NumberType::kFloat : NumberType::kDouble;
  }

  [[nodiscard]] std::string bytesOf(double value, NumberType type) const
  {
    const auto written = [&](auto number) {
      return layout_.byteOrder ? toBytes(number, *layout_.byteOrder) : std::string(NumberText(number).view());
    };
    return type == NumberType::kFloat ? written(static_cast<float>(value)) : written(value);
  }

  std::string bytes_;
  FileLayout layout_;
};

}  // namespace

MeshDocument makeDocument(std::string bytes, FileLayout layout, Mesh mesh)
{
  return {std::move(mesh), std::make_shared<const SpliceSource>(std::move(bytes), std::move(layout))};
}

}  // namespace holdfast

#include "holdfast/io/formats/splice_source.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <holdfast/base/counted.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

/// Copies some bytes from front to back, with parts of them replaced.
class SpliceWriter {
 public:
  explicit SpliceWriter(std::string_view original) : original_(original) { result_.reserve(original.size()); }

  /// `part` is a view into the original, behind all parts replaced before.
  void replace(std::string_view part, std::string_view replacement)
  {
    const auto first = static_cast<std::size_t>(part.data() - original_.data());
    assert(first >= copied_ && first + part.size() <= original_.size());
    result_.append(original_, copied_, first - copied_);
    result_.append(replacement);
    copied_ = first + part.size();
  }

  [[nodiscard]] std::string finish() &&
  {
    result_.append(original_, copied_);
    return std::move(result_);
  }

 private:
  std::string_view original_;
  std::string result_;
  std::size_t copied_ = 0;
};

bool hasSameRow(const Positions& a, const Positions& b, Index v)
{
  return hasSameBits(a(v, 0), b(v, 0)) && hasSameBits(a(v, 1), b(v, 1)) && hasSameBits(a(v, 2), b(v, 2));
}

/// For each normal, whether a face that uses it has a moved vertex.
std::vector<bool> affectedNormals(const Polygons& faces, std::span<const Index> normalOfCorner, Index count,
                                  const Positions& before, const Positions& after)
{
  std::vector<bool> isAffected(count, false);
  std::size_t corner = 0;
  for (Index f = 0; f < faces.size(); ++f) {
    const auto polygon = faces[f];
    const bool hasMoved =
        std::any_of(polygon.begin(), polygon.end(), [&](Index v) { return !hasSameRow(before, after, v); });
    for (std::size_t k = 0; k < polygon.size(); ++k, ++corner)
      if (hasMoved && normalOfCorner[corner] >= 0) isAffected[normalOfCorner[corner]] = true;
  }
  return isAffected;
}

template <class Number>
std::string written(Number number, Encoding encoding)
{
  if (encoding == Encoding::kText) return std::string(NumberText(number).view());
  return toBytes(number, byteOrder(encoding));
}

class SpliceSource final : public MeshSource {
 public:
  SpliceSource(std::string bytes, FileLayout layout, Mesh rest)
      : bytes_(std::move(bytes)), layout_(std::move(layout)), rest_(std::move(rest))
  {
  }

  [[nodiscard]] std::string extension() const override { return layout_.extension; }
  [[nodiscard]] std::vector<std::string> extras() const override { return layout_.extras; }

  [[nodiscard]] Serialized withPositions(const Positions& positions) const override
  {
    assert(positions.rows() == rest_.vertexCount());
    const bool isSinglePrecision = layout_.noteRounding != nullptr;
    Index v = 0;
    while (v < positions.rows() && hasSameRow(rest_.positions, positions, v)) ++v;
    if (v == positions.rows()) return {bytes_, {}, isSinglePrecision};
    NormalUpdate update;
    if (layout_.normalCount > 0)
      update = updateNormals(rest_.faces, layout_.normalOfCorner, layout_.normalCount, rest_.positions, positions);
    update.notes.insert(update.notes.end(), layout_.notesOfMotion.begin(), layout_.notesOfMotion.end());
    if (isSinglePrecision) layout_.noteRounding(positions, update.notes);
    return {spliced(positions, update), std::move(update.notes), isSinglePrecision};
  }

 private:
  [[nodiscard]] std::string spliced(const Positions& positions, const NormalUpdate& update) const
  {
    TextCursor cursor(bytes_, {}, layout_.dialect);
    SpliceWriter writer(bytes_);
    for (const std::size_t offset : layout_.typeWords) {
      cursor.seek(offset, 1);
      writer.replace(cursor.token(), "double");
    }
    for (const auto& [offset, first] : layout_.numbers) {
      cursor.seek(offset, 1);
      for (Index k = 0; k < (layout_.areTogether ? 3 : 1); ++k) {
        const Index number = first < 0 ? -1 - first + k : first + k;
        const NumberType type = (first < 0 ? layout_.normalTypes : layout_.coordinateTypes)[number % 3];
        const std::string_view part = next(cursor, type);
        if (first < 0) {
          if (update.isNew[number / 3]) writer.replace(part, bytesOf(update.normals.data()[number], type));
        } else if (isReplaced(type, rest_.positions.data()[number], positions.data()[number])) {
          writer.replace(part, bytesOf(positions.data()[number], writtenType()));
        }
      }
    }
    return std::move(writer).finish();
  }

  /// The part of the file that says the number at the cursor.
  [[nodiscard]] std::string_view next(TextCursor& cursor, NumberType type) const
  {
    if (layout_.encoding == Encoding::kText) {
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
    return (layout_.encoding != Encoding::kText && type != writtenType()) || !hasSameBits(before, after);
  }

  /// Of coordinates.
  [[nodiscard]] NumberType writtenType() const
  {
    return layout_.noteRounding != nullptr ? NumberType::kFloat : NumberType::kDouble;
  }

  [[nodiscard]] std::string bytesOf(double value, NumberType type) const
  {
    return type == NumberType::kFloat ? written(static_cast<float>(value), layout_.encoding)
                                      : written(value, layout_.encoding);
  }

  std::string bytes_;
  FileLayout layout_;
  Mesh rest_;
};

}  // namespace

ByteOrder byteOrder(Encoding encoding)
{
  return encoding == Encoding::kBigEndian ? ByteOrder::kBig : ByteOrder::kLittle;
}

std::size_t sizeOf(NumberType type)
{
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

bool isInteger(NumberType type)
{
  return type < NumberType::kFloat;
}

MeshDocument makeDocument(std::string bytes, FileLayout layout, Mesh mesh)
{
  auto source = std::make_shared<const SpliceSource>(std::move(bytes), std::move(layout), mesh);
  return {std::move(mesh), std::move(source)};
}

NormalUpdate updateNormals(const Polygons& faces, std::span<const Index> normalOfCorner, Index count,
                           const Positions& before, const Positions& after)
{
  NormalUpdate update{areaWeightedNormals(after, faces, normalOfCorner, count),
                      affectedNormals(faces, normalOfCorner, count, before, after),
                      {}};
  Index recomputed = 0;
  Index kept = 0;
  for (Index n = 0; n < count; ++n) {
    if (!update.isNew[n]) continue;
    update.isNew[n] = !update.normals.row(n).isZero(0);
    ++(update.isNew[n] ? recomputed : kept);
  }
  if (recomputed > 0) update.notes.push_back(counted(recomputed, "normal") + " recomputed");
  if (kept > 0)
    update.notes.push_back(counted(kept, "normal") + " kept from before: the faces around have no area now");
  return update;
}

}  // namespace holdfast

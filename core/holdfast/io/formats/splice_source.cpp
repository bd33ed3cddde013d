#include <algorithm>
#include <cassert>

#include <holdfast/io/formats/added_normals.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/formats/text_edit.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/numbers/same_bits.h>

namespace holdfast {
namespace {

class SpliceSource final : public MeshSource {
 public:
  SpliceSource(std::string bytes, FileLayout layout) : bytes_(std::move(bytes)), layout_(std::move(layout)) {}

  [[nodiscard]] std::string extension() const override { return layout_.extension; }
  [[nodiscard]] bool isText() const override { return !layout_.byteOrder; }
  [[nodiscard]] std::vector<std::string> extras() const override { return layout_.extras; }

  [[nodiscard]] Serialized withPositions(const Mesh& rest, const Positions& positions) const override
  {
    assert(positions.rows() == rest.vertexCount());
    Index v = 0;
    while (v < positions.rows() && hasSameRow(rest.positions, positions, v)) ++v;
    if (v == positions.rows()) return {bytes_, {}};
    NormalUpdate update = updateNormals(rest, layout_, positions);
    update.notes.insert(update.notes.end(), layout_.notesOfMotion.begin(), layout_.notesOfMotion.end());
    std::optional<Positions> stored;
    if (layout_.stored != nullptr) stored = layout_.stored(positions, update.notes);
    return {spliced(rest.positions, stored ? *stored : positions, update), std::move(update.notes), std::move(stored)};
  }

 private:
  [[nodiscard]] std::string spliced(const Positions& rest, const Positions& positions, const NormalUpdate& update) const
  {
    TextCursor cursor(bytes_, {}, layout_.dialect);
    Splicer splicer(bytes_);
    const std::vector<TextEdit> edits = editsOfReferences(bytes_, layout_, update);
    auto edit = edits.begin();
    const auto replace = [&](std::string_view part, std::string_view replacement) {
      const auto offset = static_cast<std::size_t>(part.data() - bytes_.data());
      for (; edit != edits.end() && edit->offset < offset; ++edit)
        splicer.replace(edit->offset, edit->size, edit->replacement);
      splicer.replace(offset, part.size(), replacement);
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
    for (; edit != edits.end(); ++edit) splicer.replace(edit->offset, edit->size, edit->replacement);
    return splicer.finish();
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
    return layout_.byteOrder && layout_.stored != nullptr ? NumberType::Float : NumberType::Double;
  }

  [[nodiscard]] std::string bytesOf(double value, NumberType type) const
  {
    const auto written = [&](auto number) {
      return layout_.byteOrder ? toBytes(number, *layout_.byteOrder) : std::string(NumberText(number).view());
    };
    return type == NumberType::Float ? written(static_cast<float>(value)) : written(value);
  }

  std::string bytes_;
  FileLayout layout_;
};

}  // namespace

MeshDocument makeDocument(std::string bytes, FileLayout layout, Mesh mesh)
{
  std::vector<std::string> remarks = std::move(layout.remarks);
  auto source = std::make_shared<const SpliceSource>(std::move(bytes), std::move(layout));
  return {std::move(mesh), std::move(source), std::move(remarks)};
}

}  // namespace holdfast

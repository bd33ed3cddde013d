#include "holdfast/io/formats/vtp_source.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

constexpr std::string_view kVtpBlanks = " \t\r\n";

std::string wordOf(double value, VtpReal type)
{
  return std::string((type == VtpReal::Float64 ? NumberText(value) : NumberText(static_cast<float>(value))).view());
}

/// Whether `word` is read as `value`.
bool says(std::string_view word, double value, VtpReal type)
{
  const double read = parseNumber<double>(word).value;
  return type == VtpReal::Float64 ? hasSameBits(read, value)
                                  : hasSameBits(static_cast<float>(read), static_cast<float>(value));
}

/// The text with other numbers in the places of its own. Words that say the same stay as they are.
std::string withNumbers(std::string_view text, std::span<const double> values, VtpReal type)
{
  Splicer splicer(text);
  std::size_t end = 0;
  for (const double value : values) {
    const std::size_t begin = text.find_first_not_of(kVtpBlanks, end);
    end = std::min(text.find_first_of(kVtpBlanks, begin), text.size());
    if (!says(text.substr(begin, end - begin), value, type)) splicer.replace(begin, end - begin, wordOf(value, type));
  }
  return splicer.finish();
}

std::string numbersAsText(std::span<const double> values, VtpReal type)
{
  std::string text;
  for (const double value : values) text.append(text.empty() ? "" : " ").append(wordOf(value, type));
  return text;
}

bool isBlank(std::string_view text)
{
  return text.find_first_not_of(kVtpBlanks) == std::string_view::npos;
}

/// Edits of a file that give arrays other numbers.
class VtpEditor {
 public:
  explicit VtpEditor(const VtpFile& file) : file_(file) {}

  /// `values` are vectors, as many as the array has.
  void replace(const XmlElement& array, std::span<const double> values, VtpReal type)
  {
    if (type == VtpReal::Float64 && array.attribute("type") != "Float64") set(array, "type", "Float64");
    setRanges(array, values);
    const std::string_view format = formatOf(array);
    if (format == "ascii")
      replaceNumbers(array, values, type);
    else if (format == "binary")
      replaceText(array, newBlock(VtpBlock(blockText(array), true, file_.encoding), true, values, type));
    else
      newBlocks_.emplace(&array, newBlock(appendedBlock(array, file_), file_.isAppendedBase64, values, type));
  }

  [[nodiscard]] std::string finish()
  {
    if (!newBlocks_.empty()) moveBlocks();
    std::ranges::stable_sort(edits_, {}, &TextEdit::offset);
    Splicer splicer(file_.bytes);
    for (const TextEdit& edit : edits_) splicer.replace(edit.offset, edit.size, edit.replacement);
    return splicer.finish();
  }

 private:
  /// The block of an array in appended data.
  struct Block {
    const XmlElement* array;
    std::size_t begin;
    std::size_t end;
  };

  void set(const XmlElement& element, std::string_view name, std::string value)
  {
    edits_.push_back(attributeEdit(element, file_.bytes, name, std::move(value)));
  }

  /// Programs state the least and the largest length of the vectors beside them.
  void setRanges(const XmlElement& array, std::span<const double> values)
  {
    double least = std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t k = 0; k + 2 < values.size(); k += 3) {
      const double length = std::hypot(values[k], values[k + 1], values[k + 2]);
      least = std::min(least, length);
      largest = std::max(largest, length);
    }
    const std::array range{wordOf(std::min(least, largest), VtpReal::Float64), wordOf(largest, VtpReal::Float64)};
    if (array.attribute("RangeMin")) set(array, "RangeMin", range[0]);
    if (array.attribute("RangeMax")) set(array, "RangeMax", range[1]);
    for (const XmlElement& key : array.children)
      if (const auto name = key.attribute("name"); name == "L2_NORM_RANGE" || name == "L2_NORM_FINITE_RANGE")
        for (std::size_t k = 0; k < std::min<std::size_t>(2, key.children.size()); ++k)
          replaceText(key.children[k], range[k]);
  }

  /// Words stay in their places where one run of text has all numbers.
  void replaceNumbers(const XmlElement& array, std::span<const double> values, VtpReal type)
  {
    const auto hasWords = [&](const XmlText& text) { return !isBlank(text.in(file_.bytes)); };
    const auto text = std::ranges::find_if(array.texts, hasWords);
    if (text == array.texts.end()) return;
    if (text->resolved.empty() && std::none_of(text + 1, array.texts.end(), hasWords))
      edits_.push_back({text->place, text->size, withNumbers(text->in(file_.bytes), values, type)});
    else
      replaceText(array, numbersAsText(values, type));
  }

  /// Blanks around the text stay.
  void replaceText(const XmlElement& element, std::string replacement)
  {
    for (const XmlText& text : element.texts) {
      const std::string_view words = text.in(file_.bytes);
      if (isBlank(words)) continue;
      const std::size_t begin = text.resolved.empty() ? words.find_first_not_of(kVtpBlanks) : 0;
      const std::size_t end = text.resolved.empty() ? words.find_last_not_of(kVtpBlanks) + 1 : text.size;
      edits_.push_back({text.place + begin, end - begin, std::exchange(replacement, {})});
    }
  }

  [[nodiscard]] std::string blockText(const XmlElement& array)
  {
    const std::string text = array.text(file_.bytes);
    return text.substr(text.find_first_not_of(kVtpBlanks));
  }

  [[nodiscard]] std::string newBlock(const VtpBlock& old, bool isBase64, std::span<const double> values, VtpReal type)
  {
    return toVtpBlock(toVtpData(values, type, file_.encoding.order), isBase64, file_.encoding, old.partSize());
  }

  void addBlocks(const XmlElement& element, std::vector<Block>& blocks) const
  {
    if (formatOf(element) == "appended" && element.attribute("offset")) {
      // Nothing may be known of an array that the mesh does not need.
      try {
        const auto begin = static_cast<std::size_t>(wholeAttribute(element, "offset", 0));
        blocks.push_back({&element, begin, begin});
        blocks.back().end += appendedBlock(element, file_).size();
      } catch (const VtpFault&) {
      }
    }
    for (const XmlElement& child : element.children) addBlocks(child, blocks);
  }

  /// Replaces blocks of appended data, and states where those behind them begin now. A block that another array has
  /// too stays, and the new one goes behind all others.
  void moveBlocks()
  {
    std::vector<Block> blocks;
    addBlocks(file_.root, blocks);
    std::ranges::stable_sort(blocks, {}, &Block::begin);
    std::size_t lastEnd = 0;
    for (const Block& block : blocks) lastEnd = std::max(lastEnd, std::min(block.end, file_.appended().size()));
    std::size_t added = 0;  // bytes before the block, those that are gone taken away
    std::size_t endSoFar = 0;
    std::vector<const Block*> last;
    for (auto block = blocks.begin(); block != blocks.end(); ++block) {
      const auto found = newBlocks_.find(block->array);
      const bool isShared = endSoFar > block->begin || (block + 1 != blocks.end() && (block + 1)->begin < block->end);
      endSoFar = std::max(endSoFar, block->end);
      if (found != newBlocks_.end() && isShared) {
        last.push_back(&*block);
        continue;
      }
      setOffset(*block, block->begin + added);
      if (found == newBlocks_.end()) continue;
      edits_.push_back({file_.appendedPlace + block->begin, block->end - block->begin, found->second});
      added += found->second.size() - (block->end - block->begin);
    }
    for (const Block* const block : last) {
      setOffset(*block, lastEnd + added);
      const std::string& bytes = newBlocks_.at(block->array);
      edits_.push_back({file_.appendedPlace + lastEnd, 0, bytes});
      added += bytes.size();
    }
  }

  void setOffset(const Block& block, std::size_t offset)
  {
    if (offset != block.begin) set(*block.array, "offset", fmt::format("{}", offset));
  }

  const VtpFile& file_;
  std::vector<TextEdit> edits_;
  std::map<const XmlElement*, std::string> newBlocks_;  // of arrays in appended data
};

/// What normals, of faces or of points, are normal to before and after a deformation, and whether they are out of date.
struct NormalSides {
  explicit NormalSides(Index count) : rest(Positions::Zero(count, 3)), moved(rest), isOutdated(count, 0) {}

  Positions rest;
  Positions moved;
  std::vector<char> isOutdated;
};

NormalSides sidesOfFaces(const Mesh& rest, const Positions& positions)
{
  NormalSides sides(rest.faces.size());
  for (Index f = 0; f < rest.faces.size(); ++f) {
    const auto corners = rest.faces[f];
    sides.rest.row(f) = areaVector(rest.positions, corners);
    sides.moved.row(f) = areaVector(positions, corners);
    sides.isOutdated[f] =
        std::ranges::any_of(corners, [&](Index v) { return !hasSameRow(rest.positions, positions, v); });
  }
  return sides;
}

NormalSides sidesOfPoints(const Mesh& rest, const NormalSides& faces)
{
  NormalSides sides(rest.vertexCount());
  for (Index f = 0; f < rest.faces.size(); ++f)
    for (const Index v : rest.faces[f]) {
      sides.rest.row(v) += faces.rest.row(f);
      sides.moved.row(v) += faces.moved.row(f);
      if (faces.isOutdated[f] != 0) sides.isOutdated[v] = 1;
    }
  return sides;
}

class VtpSource final : public MeshSource {
 public:
  VtpSource(VtpFile file, std::vector<VtpPiece> pieces, std::vector<std::string> notesOfMotion)
      : file_(std::move(file)), pieces_(std::move(pieces)), notesOfMotion_(std::move(notesOfMotion))
  {
  }

  [[nodiscard]] std::string extension() const override { return ".vtp"; }

  [[nodiscard]] bool isText() const override
  {
    return std::ranges::all_of(
        pieces_, [](const VtpPiece& piece) { return piece.points == nullptr || formatOf(*piece.points) == "ascii"; });
  }

  [[nodiscard]] std::vector<std::string> extras() const override
  {
    std::vector<std::string> names;
    std::set<std::string> known;
    const auto add = [&](const XmlElement& parent, const char* fields) {
      const XmlElement* const element = parent.child(fields);
      if (element == nullptr) return;
      for (const XmlElement& array : element->children)
        if (std::string name = fmt::format("array \"{}\"", array.attribute("Name").value_or(""));
            known.insert(name).second)
          names.push_back(std::move(name));
    };
    const XmlElement& surface = *file_.root.child("PolyData");
    for (const char* const fields : {"PointData", "CellData"})
      for (const XmlElement& piece : surface.children) add(piece, fields);
    add(surface, "FieldData");
    return names;
  }

  [[nodiscard]] Serialized withPositions(const Mesh& rest, const Positions& positions) const override
  {
    assert(positions.rows() == rest.vertexCount());
    Index v = 0;
    while (v < positions.rows() && hasSameRow(rest.positions, positions, v)) ++v;
    if (v == positions.rows()) return {file_.bytes, {}};
    try {
      VtpEditor editor(file_);
      for (const VtpPiece& piece : pieces_)
        if (piece.points != nullptr)
          editor.replace(*piece.points,
                         {positions.data() + 3 * piece.firstPoint, static_cast<std::size_t>(3 * piece.pointCount)},
                         VtpReal::Float64);
      std::vector<std::string> notes = refreshNormals(editor, rest, positions);
      notes.insert(notes.end(), notesOfMotion_.begin(), notesOfMotion_.end());
      return {editor.finish(), std::move(notes)};
    } catch (const VtpFault& fault) {
      throw OutputError(extension(), fault.what());
    }
  }

 private:
  [[nodiscard]] std::vector<std::string> refreshNormals(VtpEditor& editor, const Mesh& rest,
                                                        const Positions& positions) const
  {
    const bool hasPoints = std::ranges::any_of(pieces_, [](const VtpPiece& p) { return p.pointNormals != nullptr; });
    const bool hasCells = std::ranges::any_of(pieces_, [](const VtpPiece& p) { return p.cellNormals != nullptr; });
    if (!hasPoints && !hasCells) return {};
    const NormalSides faces = sidesOfFaces(rest, positions);
    const NormalSides points = hasPoints ? sidesOfPoints(rest, faces) : NormalSides(0);
    Index ofPoints = 0;
    Index ofFaces = 0;
    for (const VtpPiece& piece : pieces_) {
      if (piece.pointNormals != nullptr)
        ofPoints += refresh(editor, *piece.pointNormals, points, {piece.firstPoint, piece.pointCount, 0});
      // A strip has one normal for all its triangles, which says little: it stays.
      if (piece.cellNormals != nullptr)
        ofFaces +=
            refresh(editor, *piece.cellNormals, faces, {piece.firstFace, piece.polygonCount, piece.firstPolygon});
    }
    std::vector<std::string> notes;
    if (ofPoints > 0) notes.push_back(fmt::format("{} normals of points recomputed", ofPoints));
    if (ofFaces > 0) notes.push_back(fmt::format("{} normals of faces recomputed", ofFaces));
    return notes;
  }

  /// Which sides the normals of an array belong to, and the first tuple of these.
  struct Range {
    Index firstSide;
    Index count;
    Index firstTuple;
  };

  /// Returns how many normals changed. Each new one lies on the side of the stored one.
  [[nodiscard]] Index refresh(VtpEditor& editor, const XmlElement& array, const NormalSides& sides,
                              const Range& range) const
  {
    const auto outdated = std::span(sides.isOutdated).subspan(range.firstSide, range.count);
    const Index count = std::ranges::count(outdated, 1);
    if (count == 0) return 0;
    std::vector<double> normals = VtpArrayReader(file_).read(array, std::nullopt).doubles();
    for (Index k = 0; k < range.count; ++k) {
      if (outdated[k] == 0) continue;
      Eigen::Map<Vector3> normal(&normals[3 * (range.firstTuple + k)]);
      const double side = normal.dot(sides.rest.row(range.firstSide + k)) < 0 ? -1 : 1;
      normal = side * unitOrZero(sides.moved.row(range.firstSide + k));
    }
    editor.replace(array, normals, array.attribute("type") == "Float64" ? VtpReal::Float64 : VtpReal::Float32);
    return count;
  }

  VtpFile file_;
  std::vector<VtpPiece> pieces_;
  std::vector<std::string> notesOfMotion_;
};

}  // namespace

std::shared_ptr<const MeshSource> makeVtpSource(VtpFile file, std::vector<VtpPiece> pieces,
                                                std::vector<std::string> notesOfMotion)
{
  return std::make_shared<const VtpSource>(std::move(file), std::move(pieces), std::move(notesOfMotion));
}

}  // namespace holdfast

#include <array>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/text_source.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

// The shortest lines there are, "0 0 0" and "3 0 0 0" with a line end: what a count in the header must have room for.
constexpr std::size_t kLeastVertexBytes = 6;
constexpr std::size_t kLeastFaceBytes = 8;

// '#' begins a comment.
constexpr TextDialect kOffDialect{'#', std::nullopt};

/// What the line of a vertex has behind its position.
struct OffVertexForm {
  bool hasNormals = false;
  bool hasColors = false;   ///< three or four numbers
  bool hasTexture = false;  ///< two numbers
  bool isColorBeforeNormal = false;

  /// The fewest numbers on the line of a vertex; with colours there may be one more.
  [[nodiscard]] Index leastColumns() const noexcept
  {
    return 3 + (hasNormals ? 3 : 0) + (hasColors ? 3 : 0) + (hasTexture ? 2 : 0);
  }
};

class OffReader {
 public:
  OffReader(std::string_view text, std::string file) : cursor_(text, std::move(file), kOffDialect) {}

  void read();
  [[nodiscard]] Mesh takeMesh() && { return std::move(mesh_); }
  [[nodiscard]] TextLayout takeLayout() && { return std::move(layout_); }

 private:
  void readKeyword();
  void readCounts();
  void readVertex(Index v);
  void readFace(Index f);
  void readFaceColor();
  void expectRoom(Index count, std::size_t leastBytes, std::string_view what) const;
  void expectLine(std::string_view what, Index id, Index count);
  [[nodiscard]] std::vector<std::string> extras() const;

  TextCursor cursor_;
  Mesh mesh_;
  TextLayout layout_{".off", kOffDialect, {}, {}, {}, {}};
  OffVertexForm form_;
  Index faceCount_ = 0;
  bool hasFaceColors_ = false;
  std::vector<Index> polygon_;
  std::vector<std::size_t> offsets_;  // on the line of a vertex: behind z, and behind each number after it
};

/// The form that the keyword's letters before "OFF" call for; nothing where it is no such keyword.
std::optional<OffVertexForm> vertexForm(std::string_view keyword)
{
  if (!keyword.ends_with("OFF")) return std::nullopt;
  keyword.remove_suffix(3);
  OffVertexForm form;
  while (!keyword.empty()) {
    if (keyword.starts_with("ST")) {
      form.hasTexture = true;
      keyword.remove_prefix(1);
    } else if (keyword[0] == 'C') {
      form.hasColors = true;
      // The format's order is "CN", normal first; "NC" comes from MeshLab, which writes the colour first.
      form.isColorBeforeNormal = form.hasNormals;
    } else if (keyword[0] == 'N') {
      form.hasNormals = true;
    } else {
      return std::nullopt;
    }
    keyword.remove_prefix(1);
  }
  return form;
}

void OffReader::read()
{
  readKeyword();
  readCounts();
  for (Index v = 0; v < mesh_.vertexCount(); ++v) readVertex(v);
  for (Index f = 0; f < faceCount_; ++f) readFace(f);
  if (cursor_.findToken())
    cursor_.fail(
        fmt::format("there is more text behind the last of the {} faces: correct the counts in the header, "
                    "or remove what follows",
                    faceCount_));
  layout_.normalOfCorner = form_.hasNormals
                               ? cornerVertices(mesh_.faces)
                               : std::vector<Index>(static_cast<std::size_t>(mesh_.faces.cornerCount()), -1);
  layout_.extras = extras();
}

void OffReader::readKeyword()
{
  const std::string_view keyword = cursor_.findToken() ? cursor_.token() : std::string_view{};
  const std::optional<OffVertexForm> form = vertexForm(keyword);
  if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
    cursor_.fail(
        fmt::format("{} holds points that are not three-dimensional: convert it to OFF", quotedToken(keyword)));
  if (!form)
    cursor_.fail(
        fmt::format("the file begins with {}: an OFF file begins with OFF (or COFF, NOFF, CNOFF, STOFF, ...) "
                    "and a blank or line end; is it another format?",
                    quotedToken(keyword)));
  form_ = *form;
}

void OffReader::readCounts()
{
  if (!cursor_.findToken()) cursor_.fail("the file ends before the counts of vertices and faces: export it again");
  const std::string_view first = cursor_.token();
  if (first == "BINARY") cursor_.fail("binary OFF is not read: export the mesh as text");
  const Index vertexCount = integerOf(first, "the count of vertices", cursor_);
  faceCount_ = cursor_.integer("the count of faces");
  const std::string_view edges = cursor_.token();
  if (!edges.empty()) static_cast<void>(integerOf(edges, "the count of edges", cursor_));
  cursor_.expectLineEnd("the header has the counts of vertices, faces and edges");
  if (vertexCount <= 0) cursor_.fail("the mesh has no vertices: export it again");
  if (faceCount_ <= 0) cursor_.fail("the mesh has no faces: export it as a polygon mesh, not as points");
  expectRoom(vertexCount, kLeastVertexBytes, "vertices");
  expectRoom(faceCount_, kLeastFaceBytes, "faces");
  mesh_.positions.resize(vertexCount, 3);
  mesh_.faces.reserve(faceCount_, 3 * faceCount_);
}

void OffReader::expectRoom(Index count, std::size_t leastBytes, std::string_view what) const
{
  // The last line may lack its line end.
  if (static_cast<std::size_t>(count) > (cursor_.remaining() + 1) / leastBytes)
    cursor_.fail(
        fmt::format("the header promises {} {}, but only {} bytes follow: the file is truncated or the count "
                    "is wrong",
                    count, what, cursor_.remaining()));
}

void OffReader::expectLine(std::string_view what, Index id, Index count)
{
  if (!cursor_.findToken())
    cursor_.fail(fmt::format("the file ends after {} of {} {}: it is truncated, or the count in the header is wrong",
                             id, count, what));
}

void OffReader::readVertex(Index v)
{
  expectLine("vertices", v, mesh_.vertexCount());
  layout_.vertexOffsets.push_back(cursor_.offset());
  for (Index k = 0; k < 3; ++k) mesh_.positions(v, k) = cursor_.number(kCoordinateNames[k]);
  offsets_.assign(1, cursor_.offset());
  for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token()) {
    static_cast<void>(numberOf(token, "a value behind the coordinates", cursor_));
    offsets_.push_back(cursor_.offset());
  }
  const Index columns = 2 + static_cast<Index>(offsets_.size());
  const Index least = form_.leastColumns();
  const Index most = least + (form_.hasColors ? 1 : 0);
  if (columns < least || columns > most)
    cursor_.fail(
        fmt::format("vertex {} has {} numbers, and by the header's first word it needs {}{}: correct the "
                    "line or the word (C: colour, N: normal, ST: texture coordinates before OFF)",
                    v, columns, least, most > least ? fmt::format(" or {}", most) : ""));
  if (form_.hasNormals) layout_.normalOffsets.push_back(offsets_[form_.isColorBeforeNormal ? 3 + columns - least : 0]);
}

void OffReader::readFace(Index f)
{
  expectLine("faces", f, faceCount_);
  const Index corners = cursor_.integer("the count of corners");
  if (corners < 3) cursor_.fail(fmt::format("face {} has {} corners: it needs three or more; remove it", f, corners));
  polygon_.clear();
  for (Index k = 0; k < corners; ++k) {
    const Index vertex = cursor_.integer("a corner of the face");
    if (vertex < 0 || vertex >= mesh_.vertexCount())
      cursor_.fail(fmt::format("vertex {} of face {} does not exist: the file has {} vertices, numbered from 0", vertex,
                               f, mesh_.vertexCount()));
    polygon_.push_back(vertex);
  }
  mesh_.faces.add(polygon_);
  readFaceColor();
}

void OffReader::readFaceColor()
{
  int values = 0;
  for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token(), ++values)
    static_cast<void>(numberOf(token, "the colour of the face", cursor_));
  // Nothing, a place in a colour map, r g b, or r g b a.
  if (values == 2 || values > 4)
    cursor_.fail(
        fmt::format("{} numbers stand behind the corners: a colour has one, three or four; does the count of "
                    "corners at the beginning of the line fit?",
                    values));
  hasFaceColors_ = hasFaceColors_ || values > 0;
}

std::vector<std::string> OffReader::extras() const
{
  std::vector<std::string> names;
  if (form_.hasNormals) names.emplace_back("normals");
  if (form_.hasColors) names.emplace_back("vertex colours");
  if (form_.hasTexture) names.emplace_back("texture coordinates");
  if (hasFaceColors_) names.emplace_back("face colours");
  return names;
}

}  // namespace

MeshDocument readOff(std::string bytes, const std::string& file)
{
  OffReader reader(bytes, file);
  reader.read();
  Mesh mesh = std::move(reader).takeMesh();
  TextLayout layout = std::move(reader).takeLayout();
  return {mesh, makeTextSource(std::move(bytes), std::move(layout), mesh)};
}

}  // namespace holdfast

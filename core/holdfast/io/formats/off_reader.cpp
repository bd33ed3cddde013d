#include <holdfast/io/formats/formats.h>
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

class OffReader {
 public:
  OffReader(std::string bytes, const std::string& file) : bytes_(std::move(bytes)), cursor_(bytes_, file, kOffDialect)
  {
  }

  MeshDocument read()
  {
    readKeyword();
    readCounts();
    for (Index v = 0; v < mesh_.vertexCount(); ++v) readVertex(v);
    for (Index f = 0; f < faceCount_; ++f) readFace(f);
    if (cursor_.findToken())
      cursor_.fail(
          "there is more text behind the last of the {} faces: correct the counts in the header, or remove what "
          "follows",
          faceCount_);
    if (form_.hasNormals) {
      layout_.extras.emplace_back("normals");
      layout_.normalOfCorner.assign(mesh_.faces.corners().begin(), mesh_.faces.corners().end());
      layout_.normalCount = mesh_.vertexCount();
    }
    if (form_.hasColors) layout_.extras.emplace_back("vertex colours");
    if (form_.hasTexture) layout_.extras.emplace_back("texture coordinates");
    if (hasFaceColors_) layout_.extras.emplace_back("face colours");
    return makeDocument(std::move(bytes_), std::move(layout_), std::move(mesh_));
  }

 private:
  void readKeyword()
  {
    const std::string_view keyword = cursor_.findToken() ? cursor_.token() : std::string_view{};
    const std::optional<OffVertexForm> form = vertexForm(keyword);
    if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
      cursor_.fail("{} holds points that are not three-dimensional: convert it to OFF", quotedToken(keyword));
    if (!form)
      cursor_.fail(
          "the file begins with {}: an OFF file begins with OFF (or COFF, NOFF, CNOFF, STOFF, ...) and a blank or line "
          "end; is it another format?",
          quotedToken(keyword));
    form_ = *form;
  }

  void readCounts()
  {
    if (!cursor_.findToken()) cursor_.fail("the file ends before the counts of vertices and faces: export it again");
    const std::string_view first = cursor_.token();
    if (first == "BINARY") cursor_.fail("binary OFF is not read: export the mesh as text");
    const Index vertexCount = cursor_.integerOf(first, "the count of vertices");
    faceCount_ = cursor_.integer("the count of faces");
    const std::string_view edges = cursor_.token();
    if (!edges.empty()) static_cast<void>(cursor_.integerOf(edges, "the count of edges"));
    cursor_.expectLineEnd("the header has the counts of vertices, faces and edges");
    if (vertexCount <= 0) cursor_.fail("the mesh has no vertices: export it again");
    if (faceCount_ <= 0) cursor_.fail("the mesh has no faces: export it as a polygon mesh, not as points");
    expectRoom(vertexCount, kLeastVertexBytes, "vertices");
    expectRoom(faceCount_, kLeastFaceBytes, "faces");
    mesh_.positions.resize(vertexCount, 3);
    mesh_.faces.reserve(faceCount_, 3 * faceCount_);
  }

  void expectRoom(Index count, std::size_t leastBytes, std::string_view what) const
  {
    // The last line may lack its line end.
    if (static_cast<std::size_t>(count) > (cursor_.remaining() + 1) / leastBytes)
      cursor_.fail("the header promises {} {}, but only {} bytes follow: the file is truncated or the count is wrong",
                   count, what, cursor_.remaining());
  }

  void expectLine(std::string_view what, Index id, Index count)
  {
    if (!cursor_.findToken())
      cursor_.fail("the file ends after {} of {} {}: it is truncated, or the count in the header is wrong", id, count,
                   what);
  }

  void readVertex(Index v)
  {
    expectLine("vertices", v, mesh_.vertexCount());
    layout_.numbers.push_back({cursor_.offset(), 3 * v});
    for (Index k = 0; k < 3; ++k) mesh_.positions(v, k) = cursor_.number(kCoordinateNames[k]);
    offsets_.assign(1, cursor_.offset());
    for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token()) {
      static_cast<void>(cursor_.numberOf(token, "a value behind the coordinates"));
      offsets_.push_back(cursor_.offset());
    }
    const Index columns = 2 + static_cast<Index>(offsets_.size());
    const Index least = form_.leastColumns();
    const Index most = least + (form_.hasColors ? 1 : 0);
    if (columns < least || columns > most)
      cursor_.fail(
          "vertex {} has {} numbers, and by the header's first word it needs {}{}: correct the line or the word (C: "
          "colour, N: normal, ST: texture coordinates before OFF)",
          v, columns, least, most > least ? fmt::format(" or {}", most) : "");
    if (form_.hasNormals)
      layout_.numbers.push_back({offsets_[form_.isColorBeforeNormal ? 3 + columns - least : 0], normalNumber(v)});
  }

  void readFace(Index f)
  {
    expectLine("faces", f, faceCount_);
    const Index corners = cursor_.integer("the count of corners");
    if (corners < 3) cursor_.fail("face {} has {} corners: it needs three or more; remove it", f, corners);
    polygon_.clear();
    for (Index k = 0; k < corners; ++k) {
      const Index vertex = cursor_.integer("a corner of the face");
      if (vertex < 0 || vertex >= mesh_.vertexCount())
        cursor_.fail("vertex {} of face {} does not exist: the file has {} vertices, numbered from 0", vertex, f,
                     mesh_.vertexCount());
      polygon_.push_back(vertex);
    }
    mesh_.faces.add(polygon_);
    const Index color = cursor_.skipNumbers("the colour of the face");
    // Nothing, a place in a colour map, r g b, or r g b a.
    if (color == 2 || color > 4)
      cursor_.fail(
          "{} numbers stand behind the corners: a colour has one, three or four; does the count of corners at the "
          "beginning of the line fit?",
          color);
    hasFaceColors_ = hasFaceColors_ || color > 0;
  }

  std::string bytes_;
  TextCursor cursor_;
  Mesh mesh_;
  FileLayout layout_{".off", kOffDialect, {}};
  OffVertexForm form_;
  Index faceCount_ = 0;
  bool hasFaceColors_ = false;
  std::vector<Index> polygon_;
  std::vector<std::size_t> offsets_;  // on the line of a vertex: behind z, and behind each number after it
};

}  // namespace

MeshDocument readOff(std::string bytes, const std::string& file)
{
  return OffReader(std::move(bytes), file).read();
}

}  // namespace holdfast

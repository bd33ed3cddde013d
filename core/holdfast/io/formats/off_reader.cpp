#include <algorithm>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/text/encoding.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/words/lower_case.h>

namespace holdfast {
namespace {

// The shortest lines there are, "0 0 0" and "0" with a line end: what a count in the header must have room for.
constexpr std::size_t kLeastVertexBytes = 6;
constexpr std::size_t kLeastFaceBytes = 2;
constexpr std::size_t kLeastCornerBytes = 2;

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

bool isNumber(std::string_view token)
{
  return parseNumber<double>(token).fault != NumberFault::NotANumber;
}

/// "noff" as "NOFF". What has letters of both cases stays: "nOFF" is another form.
std::string withoutLowerCase(std::string_view keyword)
{
  std::string result(keyword);
  if (lowerCase(result) == result)
    std::ranges::transform(result, result.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c; });
  return result;
}

/// The first word of a file: its keyword, and what is glued to it or stands in its place.
struct OffBeginning {
  std::string keyword;
  std::string_view count;  // of vertices; empty where the next token is that
};

/// "OFF8" is a keyword and a count; the keyword may be left out.
OffBeginning beginningOf(std::string_view word)
{
  if (parseNumber<Index>(word).fault == NumberFault::None) return {"OFF", word};
  const std::size_t digits = word.find_last_not_of("0123456789") + 1;
  return {withoutLowerCase(word.substr(0, digits)), word.substr(digits)};
}

class OffReader {
 public:
  OffReader(std::string bytes, const std::string& file)
      : bytes_(std::move(bytes)), cursor_(withoutPadding(bytes_), file, kOffDialect)
  {
    refuseWideText(bytes_, file);
  }

  MeshDocument read()
  {
    readCounts(readKeyword());
    for (Index v = 0; v < mesh_.vertexCount(); ++v) readVertex(v);
    for (Index f = 0; f < faceCount_; ++f) readFace(f);
    readEnd();
    if (form_.hasNormals) {
      layout_.extras.emplace_back("normals");
      layout_.normalOfCorner.assign(mesh_.faces.corners().begin(), mesh_.faces.corners().end());
      layout_.normalCount = mesh_.vertexCount();
    }
    if (form_.hasColors || unannounced_.value_or(0) > 0) layout_.extras.emplace_back("vertex colours");
    if (form_.hasTexture) layout_.extras.emplace_back("texture coordinates");
    if (hasFaceColors_) layout_.extras.emplace_back("face colours");
    return makeDocument(std::move(bytes_), std::move(layout_), std::move(mesh_));
  }

 private:
  /// Returns the count of vertices where it was read too.
  std::string_view readKeyword()
  {
    const std::string_view word = cursor_.findToken() ? cursor_.token() : std::string_view{};
    const auto [keyword, count] = beginningOf(word);
    const std::optional<OffVertexForm> form = vertexForm(keyword);
    if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
      cursor_.fail("{} holds points that are not three-dimensional: convert it to OFF", quotedToken(keyword));
    if (!form)
      cursor_.fail(
          "the file begins with {}: an OFF file begins with OFF (or COFF, NOFF, CNOFF, STOFF, ...) and a blank or line "
          "end; is it another format?",
          quotedToken(word));
    form_ = *form;
    return count;
  }

  void readCounts(std::string_view first)
  {
    if (first.empty()) {
      if (!cursor_.findToken()) cursor_.fail("the file ends before the counts of vertices and faces: export it again");
      first = cursor_.token();
    }
    if (first == "BINARY") cursor_.fail("binary OFF is not read: export the mesh as text");
    const Index vertexCount = cursor_.integerOf(first, "the count of vertices");
    faceCount_ = cursor_.integer("the count of faces");
    const std::string_view edges = cursor_.token();
    if (!edges.empty()) edgeCount_ = cursor_.integerOf(edges, "the count of edges");
    cursor_.expectLineEnd("the header has the counts of vertices, faces and edges");
    if (vertexCount <= 0) cursor_.fail("the mesh has no vertices: export it again");
    if (faceCount_ <= 0) cursor_.fail("the mesh has no faces: export it as a polygon mesh, not as points");
    expectRoom(vertexCount, kLeastVertexBytes, "vertices");
    expectRoom(faceCount_, kLeastFaceBytes, "faces");
    mesh_.positions.resize(vertexCount, 3);
    mesh_.faces.reserve(faceCount_,
                        std::min(3 * faceCount_, static_cast<Index>(cursor_.remaining() / kLeastCornerBytes)));
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
      cursor_.expectNumber(token, "a value behind the coordinates");
      offsets_.push_back(cursor_.offset());
    }
    const Index columns = 2 + static_cast<Index>(offsets_.size());
    const Index least = form_.leastColumns();
    const Index most = least + (form_.hasColors ? 1 : 0);
    if (columns < least || (columns > most && form_.isColorBeforeNormal))
      cursor_.fail(
          "vertex {} has {} numbers, and by the header's first word it needs {}{}: correct the line or the word (C: "
          "colour, N: normal, ST: texture coordinates before OFF)",
          v, columns, least, most > least ? fmt::format(" or {}", most) : "");
    expectAsManyAsBefore(v, std::max<Index>(columns - most, 0));
    if (form_.hasNormals)
      layout_.numbers.push_back({offsets_[form_.isColorBeforeNormal ? 3 + columns - least : 0], normalNumber(v)});
  }

  /// Colours are common without the C before OFF: `extra` numbers behind the announced ones, the same for all vertices.
  void expectAsManyAsBefore(Index v, Index extra)
  {
    if (!unannounced_) unannounced_ = extra;
    if (*unannounced_ != extra)
      cursor_.fail(
          "vertex {} has {} numbers more than the header's first word calls for, the vertices before it have {}: "
          "complete the line, or remove what is too much",
          v, extra, *unannounced_);
  }

  void readFace(Index f)
  {
    expectLine("faces", f, faceCount_);
    const Index corners = cursor_.integer("the count of corners");
    if (corners < 0) cursor_.fail("face {} has {} corners: correct the count", f, corners);
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

  /// The header may count edges, which follow as lines of two corners.
  void readEnd()
  {
    for (; cursor_.findToken(); --edgeCount_) {
      const std::string_view token = cursor_.token();
      if (!isNumber(token)) {
        layout_.remarks.push_back(
            fmt::format("text follows the last face, from line {} on; the file keeps it, and nothing of it is read",
                        cursor_.line()));
        return;
      }
      if (edgeCount_ <= 0 || token != "2")
        cursor_.fail(
            "there is more text behind the last of the {} faces: correct the counts in the header, or remove what "
            "follows",
            faceCount_);
      cursor_.skipLine();
    }
  }

  std::string bytes_;
  TextCursor cursor_;
  Mesh mesh_;
  FileLayout layout_{".off", kOffDialect, {}};
  OffVertexForm form_;
  Index faceCount_ = 0;
  Index edgeCount_ = 0;
  std::optional<Index> unannounced_;  // numbers that vertices have besides those that `form_` calls for
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

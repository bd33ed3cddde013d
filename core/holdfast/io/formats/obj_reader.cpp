#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/text_source.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

/// Statements that are kept as text, by what they are for.
struct KeptStatements {
  std::string_view purpose;  // for `MeshSource::extras`
  std::string_view keywords;
};

constexpr std::array kKeptStatements{
    KeptStatements{"groups", " g "},
    KeptStatements{"objects", " o "},
    KeptStatements{"smoothing groups", " s mg "},
    KeptStatements{"materials", " usemtl mtllib usemap maplib "},
    KeptStatements{"lines", " l "},
    KeptStatements{"points", " p "},
    KeptStatements{"free-form curves and surfaces",
                   " vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con "},
    KeptStatements{"rendering attributes", " bevel c_interp d_interp lod shadow_obj trace_obj ctech stech "},
};

// '#' begins a comment, '\\' at the end of a line continues it.
constexpr TextDialect kObjDialect{'#', '\\'};

/// The three lists that a corner of a face refers to.
enum class ObjList { kVertex, kTexture, kNormal };

constexpr std::array<std::string_view, 3> kListNames{"vertex", "texture coordinate", "normal"};
constexpr std::array<std::string_view, 3> kListKeywords{"v", "vt", "vn"};

/// A reference to an entry that had not been read yet: whether it exists shows at the end of the file.
struct ForwardReference {
  ObjList list;
  Index id;
  Index line;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, std::string file) : file_(file), cursor_(text, std::move(file), kObjDialect) {}

  void read();
  [[nodiscard]] Mesh mesh() &&;
  [[nodiscard]] TextLayout layout() &&;

 private:
  void readStatement();
  void readVertex();
  void readTextureCoordinate();
  void readNormal();
  void readFace();
  void readCorner(std::string_view token);
  void keepStatement(std::string_view keyword);
  Index resolve(ObjList list, std::string_view token);
  void checkForwardReferences() const;
  [[nodiscard]] Index count(ObjList list) const;

  std::string file_;
  TextCursor cursor_;
  std::vector<double> coordinates_;
  Polygons faces_;
  TextLayout layout_{".obj", kObjDialect, {}, {}, {}, {}};
  Index textureCount_ = 0;
  bool hasColors_ = false;
  std::set<std::string_view> keptPurposes_;
  std::vector<ForwardReference> forward_;
  std::vector<Index> polygon_;
};

void ObjReader::read()
{
  while (cursor_.findToken()) readStatement();
  checkForwardReferences();
  if (layout_.vertexOffsets.empty())
    throw InputError({file_, 0, {}}, "the mesh has no vertices: an OBJ file needs 'v' lines; export the mesh again");
  if (faces_.isEmpty())
    throw InputError({file_, 0, {}}, "the mesh has no faces: an OBJ file needs 'f' lines; export it as a polygon mesh");
}

void ObjReader::readStatement()
{
  const std::string_view keyword = cursor_.token();
  if (keyword == "v")
    readVertex();
  else if (keyword == "f" || keyword == "fo")
    readFace();
  else if (keyword == "vn")
    readNormal();
  else if (keyword == "vt")
    readTextureCoordinate();
  else
    keepStatement(keyword);
}

void ObjReader::readVertex()
{
  layout_.vertexOffsets.push_back(cursor_.offset());
  for (const std::string_view name : kCoordinateNames) coordinates_.push_back(cursor_.number(name));
  int extra = 0;
  for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token(), ++extra)
    static_cast<void>(numberOf(token, "a value behind the coordinates", cursor_));
  // x y z, then w, or r g b, or w r g b (also read as r g b a).
  if (extra != 0 && extra != 1 && extra != 3 && extra != 4)
    cursor_.fail(
        fmt::format("the vertex has {} numbers: write x y z, and behind them at most w and a colour r g b", extra + 3));
  hasColors_ = hasColors_ || extra >= 3;
}

void ObjReader::readTextureCoordinate()
{
  static_cast<void>(cursor_.number("texture coordinate u"));
  for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token())
    static_cast<void>(numberOf(token, "a texture coordinate", cursor_));
  ++textureCount_;
}

void ObjReader::readNormal()
{
  layout_.normalOffsets.push_back(cursor_.offset());
  for (int k = 0; k < 3; ++k) static_cast<void>(cursor_.number("a component of the normal"));
  cursor_.expectLineEnd("a normal has three numbers");
}

void ObjReader::readFace()
{
  polygon_.clear();
  for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token()) readCorner(token);
  if (polygon_.size() < 3)
    cursor_.fail(fmt::format("the face has {} corner{}: it needs three or more, or write 'l' or 'p'", polygon_.size(),
                             polygon_.size() == 1 ? "" : "s"));
  faces_.add(polygon_);
}

void ObjReader::readCorner(std::string_view token)
{
  const std::size_t first = token.find('/');
  polygon_.push_back(resolve(ObjList::kVertex, token.substr(0, first)));
  Index normal = -1;
  if (first != std::string_view::npos) {
    const std::string_view behind = token.substr(first + 1);
    const std::size_t second = behind.find('/');
    const std::string_view texture = behind.substr(0, second);
    if (!texture.empty()) resolve(ObjList::kTexture, texture);
    if (second != std::string_view::npos && second + 1 < behind.size())
      normal = resolve(ObjList::kNormal, behind.substr(second + 1));
  }
  layout_.normalOfCorner.push_back(normal);
}

Index ObjReader::resolve(ObjList list, std::string_view token)
{
  const std::string_view name = kListNames[static_cast<std::size_t>(list)];
  const Index number = token.empty() ? 0 : integerOf(token, name, cursor_);
  if (token.empty()) cursor_.fail("a corner without a vertex: write v, v/vt, v//vn or v/vt/vn");
  if (number == 0) cursor_.fail(fmt::format("{} 0 does not exist: OBJ counts from 1 (and back from -1)", name));
  if (number < 0) {
    if (number < -count(list))
      cursor_.fail(fmt::format("{} {} does not exist: only {} stand above this line", name, number, count(list)));
    return count(list) + number;
  }
  if (number > count(list)) forward_.push_back({list, number - 1, cursor_.line()});
  return number - 1;
}

void ObjReader::checkForwardReferences() const
{
  for (const auto& [list, id, line] : forward_) {
    if (id < count(list)) continue;
    const auto which = static_cast<std::size_t>(list);
    throw InputError({file_, line, {}},
                     fmt::format("{} {} does not exist: the file has {} '{}' lines; correct the face or add what it "
                                 "refers to",
                                 kListNames[which], id + 1, count(list), kListKeywords[which]));
  }
}

Index ObjReader::count(ObjList list) const
{
  if (list == ObjList::kVertex) return static_cast<Index>(layout_.vertexOffsets.size());
  return list == ObjList::kTexture ? textureCount_ : static_cast<Index>(layout_.normalOffsets.size());
}

void ObjReader::keepStatement(std::string_view keyword)
{
  const auto kept = std::find_if(kKeptStatements.begin(), kKeptStatements.end(), [&](const KeptStatements& statements) {
    return statements.keywords.find(fmt::format(" {} ", keyword)) != std::string::npos;
  });
  if (kept == kKeptStatements.end())
    cursor_.fail(
        fmt::format("{} is not an OBJ statement: correct it, or make the line a comment with #", quotedToken(keyword)));
  keptPurposes_.insert(kept->purpose);
  cursor_.skipLine();
}

Mesh ObjReader::mesh() &&
{
  const auto vertices = static_cast<Index>(layout_.vertexOffsets.size());
  return {Eigen::Map<const Positions>(coordinates_.data(), vertices, 3), std::move(faces_)};
}

TextLayout ObjReader::layout() &&
{
  if (textureCount_ > 0) layout_.extras.emplace_back("texture coordinates");
  if (!layout_.normalOffsets.empty()) layout_.extras.emplace_back("normals");
  if (hasColors_) layout_.extras.emplace_back("vertex colours");
  layout_.extras.insert(layout_.extras.end(), keptPurposes_.begin(), keptPurposes_.end());
  return std::move(layout_);
}

}  // namespace

MeshDocument readObj(std::string bytes, const std::string& file)
{
  ObjReader reader(bytes, file);
  reader.read();
  Mesh mesh = std::move(reader).mesh();
  TextLayout layout = std::move(reader).layout();
  return {mesh, makeTextSource(std::move(bytes), std::move(layout), mesh)};
}

}  // namespace holdfast

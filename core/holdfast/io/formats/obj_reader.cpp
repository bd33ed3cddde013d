#include <algorithm>
#include <set>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/obj_statements.h>
#include <holdfast/io/text/encoding.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

/// The three lists that a corner of a face refers to.
enum class ObjList { Vertex, Texture, Normal };

constexpr std::array<std::string_view, 3> kListNames{"vertex", "texture coordinate", "normal"};
constexpr std::array<std::string_view, 3> kListKeywords{"v", "vt", "vn"};

/// A reference to an entry that had not been read yet: whether it exists shows at the end of the file.
struct ForwardReference {
  ObjList list;
  Index id;
  Index line;
  std::size_t corner;  // among those of all faces
};

/// Something that occurs in several lines, for a remark.
struct Occurrences {
  Index count = 0;
  Index line = 0;  // the first
  std::string example;

  void add(Index where, std::string_view what)
  {
    if (count++ > 0) return;
    line = where;
    example = quotedToken(what);
  }
};

class ObjReader {
 public:
  ObjReader(std::string bytes, const std::string& file)
      : bytes_(std::move(bytes)), file_(file), cursor_(withoutPadding(bytes_), file, kObjDialect)
  {
    refuseWideText(bytes_, file);
  }

  MeshDocument read()
  {
    while (cursor_.findToken()) readStatement();
    checkForwardReferences();
    if (coordinates_.empty())
      throw InputError({file_, 0, {}},
                       "the mesh has no vertices: an OBJ file needs 'v' lines; export the mesh again" + unknownHint());
    if (faces_.isEmpty())
      throw InputError(
          {file_, 0, {}},
          "the mesh has no faces: an OBJ file needs 'f' lines; export it as a polygon mesh" + unknownHint());
    remark();
    layout_.referencesIn = normalReferencesOfObj;
    if (textureCount_ > 0) layout_.extras.emplace_back("texture coordinates");
    if (layout_.normalCount > 0) layout_.extras.emplace_back("normals");
    if (hasColors_) layout_.extras.emplace_back("vertex colours");
    layout_.extras.insert(layout_.extras.end(), keptPurposes_.begin(), keptPurposes_.end());
    if (unknown_.count > 0) layout_.extras.emplace_back("statements that OBJ does not have");
    Mesh mesh{Eigen::Map<const Positions>(coordinates_.data(), count(ObjList::Vertex), 3), std::move(faces_)};
    return makeDocument(std::move(bytes_), std::move(layout_), std::move(mesh));
  }

 private:
  void readStatement()
  {
    const std::string_view keyword = cursor_.token();
    if (keyword == "v")
      readVertex();
    else if (isObjFace(keyword))
      readFace();
    else if (keyword == "vn")
      readNormal();
    else if (keyword == "vt")
      readTextureCoordinate();
    else
      keepStatement(keyword);
  }

  void readVertex()
  {
    layout_.numbers.push_back({cursor_.offset(), static_cast<Index>(coordinates_.size())});
    for (const std::string_view name : kCoordinateNames) coordinates_.push_back(cursor_.number(name));
    const Index extra = cursor_.skipNumbers("a value behind the coordinates");
    // x y z, then w, or r g b, or w r g b (also read as r g b a).
    if (extra != 0 && extra != 1 && extra != 3 && extra != 4)
      cursor_.fail("the vertex has {} numbers: write x y z, and behind them at most w and a colour r g b", extra + 3);
    hasColors_ = hasColors_ || extra >= 3;
  }

  void readTextureCoordinate()
  {
    cursor_.expectNumber(cursor_.token(), "texture coordinate u");
    cursor_.skipNumbers("a texture coordinate");
    ++textureCount_;
  }

  void readNormal()
  {
    layout_.numbers.push_back({cursor_.offset(), normalNumber(layout_.normalCount++)});
    for (int k = 0; k < 3; ++k) cursor_.expectNumber(cursor_.token(), "a component of the normal");
    cursor_.expectLineEnd("a normal has three numbers");
  }

  void readFace()
  {
    polygon_.clear();
    for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token()) readCorner(token);
    faces_.add(polygon_);
  }

  void readCorner(std::string_view token)
  {
    const std::size_t first = token.find('/');
    polygon_.push_back(resolve(ObjList::Vertex, token.substr(0, first)));
    Index normal = -1;
    if (first != std::string_view::npos) {
      const std::string_view behind = token.substr(first + 1);
      const std::size_t second = behind.find('/');
      const std::string_view texture = behind.substr(0, second);
      if (!texture.empty()) static_cast<void>(resolveOrMiss(ObjList::Texture, texture));
      if (second != std::string_view::npos && second + 1 < behind.size())
        normal = resolveOrMiss(ObjList::Normal, behind.substr(second + 1));
    }
    layout_.normalOfCorner.push_back(static_cast<int>(normal));
  }

  Index resolve(ObjList list, std::string_view token)
  {
    const std::string_view name = kListNames[static_cast<std::size_t>(list)];
    if (token.empty()) cursor_.fail("a corner without a vertex: write v, v/vt, v//vn or v/vt/vn");
    const Index number = cursor_.integerOf(token, name);
    if (number == 0) cursor_.fail("{} 0 does not exist: OBJ counts from 1 (and back from -1)", name);
    if (number < -count(list))
      cursor_.fail("{} {} does not exist: only {} stand above this line", name, number, count(list));
    return resolved(list, number);
  }

  /// -1 where the file has no such entry: faces need their vertices only.
  Index resolveOrMiss(ObjList list, std::string_view token)
  {
    const Index number = cursor_.integerOf(token, kListNames[static_cast<std::size_t>(list)]);
    if (number != 0 && number >= -count(list)) return resolved(list, number);
    missing_[static_cast<std::size_t>(list)].add(cursor_.line(), token);
    return -1;
  }

  Index resolved(ObjList list, Index number)
  {
    if (number < 0) return count(list) + number;
    if (number > count(list)) forward_.push_back({list, number - 1, cursor_.line(), layout_.normalOfCorner.size()});
    return number - 1;
  }

  void checkForwardReferences()
  {
    for (const auto& [list, id, line, corner] : forward_) {
      if (id < count(list)) continue;
      const auto which = static_cast<std::size_t>(list);
      if (list == ObjList::Vertex)
        throw InputError(
            {file_, line, {}},
            fmt::format("{} {} does not exist: the file has {} '{}' lines; correct the face or add what it refers to",
                        kListNames[which], id + 1, count(list), kListKeywords[which]));
      if (list == ObjList::Normal) layout_.normalOfCorner[corner] = -1;
      missing_[which].add(line, std::to_string(id + 1));
    }
  }

  void remark()
  {
    for (const ObjList list : {ObjList::Texture, ObjList::Normal}) {
      const auto which = static_cast<std::size_t>(list);
      const auto& [missed, line, example] = missing_[which];
      if (missed > 0)
        layout_.remarks.push_back(fmt::format(
            "{} to a {} that the file does not have (the first is {} in line {}; there are {} '{}' lines); "
            "they are kept as they are",
            counted(missed, "reference"), kListNames[which], example, line, count(list), kListKeywords[which]));
    }
    if (unknown_.count > 0)
      layout_.remarks.push_back(
          fmt::format("{} that OBJ does not have (the first is {} in line {}); the file keeps "
                      "them, and nothing of them is read",
                      counted(unknown_.count, "statement"), unknown_.example, unknown_.line));
  }

  /// Where there is no mesh: what may be the reason.
  [[nodiscard]] std::string unknownHint() const
  {
    if (unknown_.count == 0) return {};
    return fmt::format("; line {} begins with {}, which OBJ does not have: is it another format?", unknown_.line,
                       unknown_.example);
  }

  [[nodiscard]] Index count(ObjList list) const
  {
    if (list == ObjList::Vertex) return static_cast<Index>(coordinates_.size() / 3);
    return list == ObjList::Texture ? textureCount_ : layout_.normalCount;
  }

  void keepStatement(std::string_view keyword)
  {
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' '; };
    if (std::ranges::any_of(keyword, isControl))
      cursor_.fail("{} is not an OBJ statement: the file is no text, or it is damaged; export it again",
                   quotedToken(keyword));
    if (const std::string_view purpose = purposeOfObjStatement(keyword); !purpose.empty())
      keptPurposes_.insert(purpose);
    else
      unknown_.add(cursor_.line(), keyword);
    skipObjStatement(cursor_, keyword);
  }

  std::string bytes_;
  std::string file_;
  TextCursor cursor_;
  std::vector<double> coordinates_;
  Polygons faces_;
  FileLayout layout_{".obj", kObjDialect, {}};
  Index textureCount_ = 0;
  bool hasColors_ = false;
  std::set<std::string_view> keptPurposes_;
  std::vector<ForwardReference> forward_;
  std::array<Occurrences, 3> missing_;  // references to what the file does not have, by list
  Occurrences unknown_;                 // statements
  std::vector<Index> polygon_;
};

}  // namespace

MeshDocument readObj(std::string bytes, const std::string& file)
{
  return ObjReader(std::move(bytes), file).read();
}

}  // namespace holdfast

#include "holdfast/io/formats/obj_statements.h"

#include <algorithm>
#include <array>

namespace holdfast {
namespace {

struct KeptStatements {
  std::string_view purpose;
  std::string_view keywords;  // a blank before and behind each
};

constexpr std::array<KeptStatements, 8> kKeptStatements{
    {{"groups", " g "},
     {"objects", " o "},
     {"smoothing groups", " s mg "},
     {"materials", " usemtl mtllib usemap maplib "},
     {"lines", " l "},
     {"points", " p "},
     {"free-form curves and surfaces", " vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con "},
     {"rendering attributes", " bevel c_interp d_interp lod shadow_obj trace_obj ctech stech "}}};

// Behind these and behind statements that are not known stand names.
constexpr std::string_view kNumbered = " s mg l p vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp con ";

bool isIn(std::string_view keywords, std::string_view keyword)
{
  return keywords.find(fmt::format(" {} ", keyword)) != std::string_view::npos;
}

/// The part of a corner like "1/2/3" behind its second slash.
std::string_view normalPart(std::string_view corner)
{
  const std::size_t first = corner.find('/');
  const std::size_t second = first == std::string_view::npos ? first : corner.find('/', first + 1);
  return second == std::string_view::npos ? std::string_view() : corner.substr(second + 1);
}

}  // namespace

std::string_view purposeOfObjStatement(std::string_view keyword)
{
  const auto* const kept =
      std::ranges::find_if(kKeptStatements, [&](const KeptStatements& some) { return isIn(some.keywords, keyword); });
  return kept == kKeptStatements.end() ? std::string_view() : kept->purpose;
}

void skipObjStatement(TextCursor& cursor, std::string_view keyword)
{
  cursor.skipLine(isIn(kNumbered, keyword) ? GluedBackslash::Continues : GluedBackslash::EndsAName);
}

std::vector<NormalReference> normalReferencesOfObj(std::string_view bytes)
{
  std::vector<NormalReference> references;
  Index normals = 0;
  TextCursor cursor(withoutPadding(bytes), {}, kObjDialect);
  while (cursor.findToken()) {
    const std::string_view keyword = cursor.token();
    if (keyword == "v" || keyword == "vn" || keyword == "vt") {
      normals += keyword == "vn" ? 1 : 0;
      cursor.skipLine();
    } else if (isObjFace(keyword)) {
      for (std::string_view corner = cursor.token(); !corner.empty(); corner = cursor.token()) {
        const std::string_view part = normalPart(corner);
        const std::size_t offset = part.empty() ? 0 : static_cast<std::size_t>(part.data() - bytes.data());
        references.push_back({offset, part.size(), part.starts_with('-'), normals});
      }
    } else {
      skipObjStatement(cursor, keyword);
    }
  }
  return references;
}

}  // namespace holdfast

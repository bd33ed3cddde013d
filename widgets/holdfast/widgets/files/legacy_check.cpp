#include "holdfast/widgets/files/legacy_check.h"

#include <algorithm>
#include <array>

#include <holdfast/widgets/files/legacy_cursor.h>

namespace holdfast {
namespace {

/// Follows the grammar of a legacy file (VTK File Formats, "Simple Legacy Formats"; 5.1 adds offsets).
class LegacyCheck {
 public:
  LegacyCheck(std::string_view bytes, const std::string& file) : cursor_(bytes, file) {}

  void run()
  {
    readHeader();
    while (!cursor_.isAtEnd()) readSection();
  }

 private:
  void readHeader();
  void readVersion(std::string_view text);
  void readSection();
  void readCells();
  void readAttribute(const std::string& keyword);
  void readScalars();
  void readFields();
  void readMetadata();

  LegacyCursor cursor_;
  bool hasOffsets_ = false;  // cells as offsets and connectivity
  Index tupleCount_ = 0;     // of the attributes that are being read: points or cells
};

void LegacyCheck::readHeader()
{
  constexpr std::string_view kMagic = "# vtk DataFile Version ";
  constexpr std::size_t kLongestTitle = 255;
  const std::string_view first = cursor_.line();
  if (!first.starts_with(kMagic))
    cursor_.fail("this is no legacy file of VTK's; the first line must say '# vtk DataFile Version 3.0'");
  readVersion(first.substr(kMagic.size()));
  if (cursor_.line().size() > kLongestTitle) cursor_.fail("the title is longer than 255 characters; shorten it");
  const std::string encoding = cursor_.word();
  if (encoding == "binary")
    cursor_.setBinary();
  else if (encoding != "ascii")
    cursor_.fail("'" + encoding + "' where ASCII or BINARY must stand");
  cursor_.requireWord("dataset");
  if (const std::string kind = cursor_.word(); kind != "polydata")
    cursor_.fail("the file holds '" + kind + "'; extract its surface as POLYDATA first");
}

void LegacyCheck::readVersion(std::string_view text)
{
  // Blanks may follow. 5.0 was never released, and VTK takes its cells for those of 4.
  const std::string_view version = text.substr(0, text.find_last_not_of(" \t") + 1);
  constexpr std::array<std::string_view, 8> kKnown{"1.0", "2.0", "3.0", "3.1", "4.0", "4.1", "4.2", "5.1"};
  if (std::find(kKnown.begin(), kKnown.end(), version) == kKnown.end())
    cursor_.fail("version '" + std::string(version) + "' is not known; known are 1.0 to 4.2 and 5.1");
  hasOffsets_ = version == "5.1";
}

void LegacyCheck::readSection()
{
  const std::string keyword = cursor_.word();
  if (keyword == "points") {
    const Index count = cursor_.count();
    cursor_.skipNumbers(cursor_.product(3, count), cursor_.word());
    readMetadata();
  } else if (keyword == "vertices" || keyword == "lines" || keyword == "polygons" || keyword == "triangle_strips") {
    readCells();
  } else if (keyword == "point_data" || keyword == "cell_data") {
    tupleCount_ = cursor_.count();
  } else {
    readAttribute(keyword);
  }
}

void LegacyCheck::readCells()
{
  const Index first = cursor_.count();
  const Index second = cursor_.count();
  if (!hasOffsets_) {
    cursor_.skipCells(first, second);
  } else {
    if (first < 1) cursor_.fail("cells need one offset at least");
    cursor_.requireWord("offsets");
    cursor_.skipNumbers(first, cursor_.word());
    cursor_.requireWord("connectivity");
    cursor_.skipNumbers(second, cursor_.word());
  }
  readMetadata();
}

void LegacyCheck::readAttribute(const std::string& keyword)
{
  if (keyword == "field") return readFields();
  if (keyword == "metadata") return cursor_.skipParagraph();
  if (keyword == "scalars") return readScalars();
  const std::string colors = cursor_.isBinary() ? "unsigned_char" : "float";
  (void)cursor_.word();  // the name of the array
  if (keyword == "color_scalars")
    cursor_.skipNumbers(cursor_.product(cursor_.count(), tupleCount_), colors);
  else if (keyword == "lookup_table")
    cursor_.skipNumbers(cursor_.product(4, cursor_.count()), colors);
  else if (keyword == "vectors" || keyword == "normals")
    cursor_.skipNumbers(cursor_.product(3, tupleCount_), cursor_.word());
  else if (keyword == "tensors")
    cursor_.skipNumbers(cursor_.product(9, tupleCount_), cursor_.word());
  else if (keyword == "tensors6")
    cursor_.skipNumbers(cursor_.product(6, tupleCount_), cursor_.word());
  else if (keyword == "global_ids" || keyword == "pedigree_ids" || keyword == "edge_flags")
    cursor_.skipNumbers(tupleCount_, cursor_.word());
  else if (keyword == "texture_coordinates") {
    const Index dimension = cursor_.count();
    cursor_.skipNumbers(cursor_.product(dimension, tupleCount_), cursor_.word());
  } else
    cursor_.fail("'" + keyword +
                 "' is no keyword of a PolyData file here; the data before it may be too few or too many");
  readMetadata();
}

void LegacyCheck::readScalars()
{
  (void)cursor_.word();  // the name of the array
  const std::string type = cursor_.word();
  const Index components = cursor_.peekWord() == "lookup_table" ? 1 : cursor_.count();
  cursor_.requireWord("lookup_table");
  (void)cursor_.word();  // the name of the table
  cursor_.skipNumbers(cursor_.product(components, tupleCount_), type);
  readMetadata();
}

void LegacyCheck::readFields()
{
  (void)cursor_.word();  // the name of the field
  const Index arrayCount = cursor_.count();
  for (Index i = 0; i < arrayCount; ++i) {
    (void)cursor_.word();  // the name of the array
    const Index components = cursor_.count();
    const Index tuples = cursor_.count();
    cursor_.skipNumbers(cursor_.product(components, tuples), cursor_.word());
    readMetadata();
  }
}

/// Names of components and the like, up to an empty line.
void LegacyCheck::readMetadata()
{
  if (cursor_.peekWord() != "metadata") return;
  (void)cursor_.word();
  (void)cursor_.line();
  cursor_.skipParagraph();
}

}  // namespace

void requireSoundLegacyFile(std::string_view bytes, const std::string& file)
{
  LegacyCheck(bytes, file).run();
}

}  // namespace holdfast

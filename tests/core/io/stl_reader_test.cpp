#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>

#include "core/io/bad_file.h"

namespace holdfast {
namespace {

using test::BadFile;

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

/// A binary file whose header counts `counted` facets and which holds `held`, all zero.
std::string binary(const std::string& header, std::uint32_t counted, std::size_t held)
{
  std::string bytes = header;
  bytes.resize(80, ' ');
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((counted >> shift) & 0xFFU);
  return bytes + std::string(50 * held, '\0');
}

TEST(StlReader, ABinaryFileMayBeginWithSolid)
{
  EXPECT_EQ(readStl(binary("solid part\nfacet", 2, 2), "").mesh.faces.size(), 2);
}

TEST(StlReader, ATextFileMayHaveSeveralSolidsAndAnyName)
{
  const Mesh mesh =
      readStl("solid\n" + kFacet + "endsolid\nsolid facet outer loop\n" + kFacet + kFacet + "endsolid whatever\n", "")
          .mesh;
  EXPECT_EQ(mesh.faces.size(), 3);
  EXPECT_EQ(mesh.vertexCount(), 9);
  EXPECT_EQ(mesh.positions.row(7).transpose(), Vector3(1, 0, 0));
}

TEST(StlReader, AnEmptySolidBesideAFullOneIsRead)
{
  EXPECT_EQ(readStl("solid a\nendsolid a\nsolid b\n" + kFacet + "endsolid b\n", "").mesh.faces.size(), 1);
}

class BadStl : public testing::TestWithParam<BadFile> {};

TEST_P(BadStl, IsRefusedAtItsPlace)
{
  test::expectRefused(GetParam(), readStl);
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadStl,
    testing::Values(
        BadFile{"ShorterThanAHeader", "hello", 0, "byte 5", "the file ends inside the header"},
        BadFile{"Truncated", binary("x", 3, 2), 0, "byte 184", "3 facets that its header counts need 234 bytes"},
        BadFile{"TruncatedAndSolid", binary("solid", 3, 2), 0, "byte 184", "need 234 bytes"},
        BadFile{"HugeCount", binary("x", 0xFFFFFFFEU, 1), 0, "byte 134", "4294967294 facets"},
        BadFile{"UnfilledCountAndNoWholeFacets", binary("x", 0, 1) + "abc", 0, "byte 137", "0 facets that its header"},
        BadFile{"NoFacetsBinary", binary("x", 0, 0), 0, "byte 80", "the mesh has no faces: "},
        BadFile{"NoFacetsText", "solid a\nendsolid a\n", 2, "", "the mesh has no faces: "},
        BadFile{"NoEnd", "solid a\n" + kFacet, 8, "", "ends inside a solid, without 'endsolid'"},
        BadFile{"EndsInFacet", "solid a\nfacet normal 0 0 1\nouter", 3, "", "ends inside a solid"},
        BadFile{"TextBehind", "solid a\n" + kFacet + "endsolid a\nfacet\n", 10, "",
                "'facet' stands where 'solid' must"},
        BadFile{"FourVertices",
                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\n", 7,
                "", "'vertex' stands where 'endloop' must"},
        BadFile{"TwoVertices", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", 6, "",
                "'endloop' stands where 'vertex' must"},
        BadFile{"MissingCoordinate",
                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex 1 0 0\nvertex 0 1 0\n", 5, "",
                "coordinate z is 'vertex', which is not a number"},
        BadFile{"Garbage", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 O\n", 4, "", "coordinate z is 'O'"},
        BadFile{"TooLarge", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1e400\n", 4, "", "no double can hold"},
        BadFile{"GarbageNormal", "solid a\nfacet normal 0 up 1\nouter loop\n", 2, "", "'up', which is not a number"},
        BadFile{"NoFacet", "solid a\nvertex 0 0 0\n", 2, "", "'vertex' stands where 'facet' or 'endsolid' must"}),
    testing::PrintToStringParamName());

}  // namespace
}  // namespace holdfast

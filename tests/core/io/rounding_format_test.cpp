#include <cmath>

#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>

namespace holdfast {
namespace {

/// One decimal, which is less than single precision has.
Positions tenths(const Positions& positions, std::vector<std::string>& notes)
{
  notes.emplace_back("rounded");
  return positions.unaryExpr([](double x) { return std::round(x * 10) / 10; });
}

TEST(RoundingFormat, WritesWhatItSaysThatItStores)
{
  Mesh triangle;
  triangle.positions.resize(3, 3);
  triangle.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  triangle.faces.add({0, 1, 2});
  FileLayout layout;
  layout.extension = ".tenths";
  layout.numbers = {{0, 0}, {6, 3}, {12, 6}};
  layout.stored = tenths;
  const MeshDocument document = makeDocument("0 0 0\n1 0 0\n0 1 0\n", layout, triangle);

  Positions moved = triangle.positions;
  moved.row(1) << 1.26, 0.04, -0.31;
  const Serialized file = document.source->withPositions(document.mesh, moved);
  EXPECT_EQ(file.bytes, "0 0 0\n1.3 0 -0.3\n0 1 0\n");
  ASSERT_TRUE(file.stored.has_value());
  EXPECT_EQ(file.stored->row(1), Eigen::RowVector3d(1.3, 0, -0.3));
}

}  // namespace
}  // namespace holdfast

#include <vector>

#include <gtest/gtest.h>

#include <holdfast/factor/strips.h>

namespace holdfast {
namespace {

TEST(Strips, KeepEachNumberInAPlaceOfItsOwnAndWasteNone)
{
  for (const int size : {1, kStripWidth, kStripWidth + 1, 3 * kStripWidth - 1})
    for (const int columns : {1, kStripWidth - 1, kStripWidth, kStripWidth + 7, size}) {
      if (columns > size) continue;
      std::vector<int> uses(static_cast<std::size_t>(numbersInStrips(columns, size)), 0);
      for (int column = 0; column < columns; ++column)
        for (int row = stripOf(column); row < size; ++row)
          ++uses.at(static_cast<std::size_t>(placeInStrips(row, column, size)));
      EXPECT_EQ(uses, std::vector<int>(uses.size(), 1)) << columns << " of " << size;
    }
}

}  // namespace
}  // namespace holdfast

#include "holdfast/widgets/rotation_sphere/thinned_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace holdfast {
namespace {

/// Cells of a grid that hold something. A table with room to spare, probed from place to place: sets of the standard
/// library take several times as long.
class TakenCells {
 public:
  explicit TakenCells(std::size_t most)
  {
    std::size_t size = 2;
    while (size < 2 * most) size *= 2;
    taken_.resize(size, kFree);
  }

  /// False where the cell was taken.
  bool take(std::uint64_t cell)
  {
    const std::size_t mask = taken_.size() - 1;
    // Fibonacci hashing: D. Knuth, The Art of Computer Programming 3, 6.4.
    std::size_t at = (cell * 0x9E3779B97F4A7C15U >> 32U) & mask;
    while (taken_[at] != kFree) {
      if (taken_[at] == cell) return false;
      at = (at + 1) & mask;
    }
    taken_[at] = cell;
    return true;
  }

 private:
  static constexpr std::uint64_t kFree = 0;  // no cell: cells count from 1 along each axis

  std::vector<std::uint64_t> taken_;
};

std::uint64_t cellOf(const Vector3& place, double side)
{
  constexpr double kMiddle = 1 << 20;
  std::uint64_t cell = 0;
  for (const double coordinate : place)
    cell = cell << 21U |
           static_cast<std::uint64_t>(std::clamp(std::floor(coordinate / side) + kMiddle, 1.0, 2 * kMiddle - 1));
  return cell;
}

std::vector<Index> firstOfCells(const std::vector<Vector3>& places, const std::vector<Index>& among, double side)
{
  TakenCells taken(among.size());
  std::vector<Index> first;
  for (const Index place : among)
    if (taken.take(cellOf(places[place], side))) first.push_back(place);
  return first;
}

}  // namespace

std::vector<Index> thinnedPlaces(const std::vector<Vector3>& places, Index most, double finest)
{
  std::vector<Index> chosen(places.size());
  std::iota(chosen.begin(), chosen.end(), Index{0});
  for (double side = finest; static_cast<Index>(chosen.size()) > most; side *= 2)
    chosen = firstOfCells(places, chosen, side);
  return chosen;
}

}  // namespace holdfast

#include "render/compare_pictures.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

namespace holdfast::test {
namespace {

constexpr int kLargestDifference = 10;

std::string nameOfRunningTest()
{
  const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
  return std::string(info.test_suite_name()) + "." + info.name() + ".png";
}

std::string keep(const Picture& picture)
{
  const std::filesystem::path folder = HOLDFAST_RENDERED_DIR;
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = folder / nameOfRunningTest();
  std::ofstream(path, std::ios::binary) << toPng(picture, path.string());
  return path.string();
}

/// Returns the baselines of the running test. Those of one renderer lie in the folder itself, those of others in
/// folders named after them.
std::vector<std::filesystem::path> baselines()
{
  const std::filesystem::path folder = HOLDFAST_BASELINE_DIR;
  std::vector<std::filesystem::path> paths{folder / nameOfRunningTest()};
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_directory()) paths.push_back(entry.path() / nameOfRunningTest());
  std::erase_if(paths, [](const std::filesystem::path& path) { return !std::filesystem::exists(path); });
  return paths;
}

/// Of the baseline that is the most like it; 1 where there is none.
double leastShareOfOtherPixels(const Picture& picture)
{
  double least = 1;
  for (const std::filesystem::path& baseline : baselines())
    least = std::min(least, shareOfOtherPixels(picture, readPng(baseline)));
  return least;
}

}  // namespace

Picture readPng(const std::filesystem::path& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  const int* const size = image.GetDimensions();
  if (image.GetNumberOfScalarComponents() != 3) return {};
  const auto* const first = static_cast<const unsigned char*>(image.GetScalarPointer());
  return {{size[0], size[1]}, {first, first + 3 * image.GetNumberOfPoints()}};
}

double shareOfOtherPixels(const Picture& a, const Picture& b)
{
  if (a.size.width != b.size.width || a.size.height != b.size.height) return 1;
  std::size_t others = 0;
  for (std::size_t k = 0; k < a.pixels.size(); k += 3) {
    int largest = 0;
    for (std::size_t c = k; c < k + 3; ++c) largest = std::max(largest, std::abs(a.pixels[c] - b.pixels[c]));
    if (largest > kLargestDifference) ++others;
  }
  return static_cast<double>(3 * others) / static_cast<double>(a.pixels.size());
}

std::string differenceFromBaseline(const Picture& picture)
{
  if (baselines().empty())
    return "there is no baseline " HOLDFAST_BASELINE_DIR "/" + nameOfRunningTest() + "; if " + keep(picture) +
           " is right, copy it there";
  const double share = leastShareOfOtherPixels(picture);
  if (share <= kLargestShareOfOtherPixels) return {};
  return std::to_string(100 * share) +
         " % of the pixels are those of no baseline in " HOLDFAST_BASELINE_DIR "; compare them with " + keep(picture);
}

std::string differenceFromBaseline(vtkCamera& camera, const std::function<Picture()>& draw)
{
  std::string difference = differenceFromBaseline(draw());
  if (!difference.empty()) return difference;
  camera.Azimuth(0.1);
  const double share = leastShareOfOtherPixels(draw());
  if (share > kLargestShareOfOtherPixels) return {};
  return "a camera that is turned by a tenth of a degree changes no more than " + std::to_string(100 * share) +
         " % of the pixels: the comparison would not see it";
}

}  // namespace holdfast::test

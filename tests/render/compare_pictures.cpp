#include "render/compare_pictures.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
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

std::string keep(const Picture& picture)
{
  const std::filesystem::path folder = HOLDFAST_RENDERED_DIR;
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = folder / nameOfRunningTest();
  std::ofstream(path, std::ios::binary) << toPng(picture, path.string());
  return path.string();
}

}  // namespace

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
  const std::filesystem::path baseline = std::filesystem::path(HOLDFAST_BASELINE_DIR) / nameOfRunningTest();
  if (!std::filesystem::exists(baseline))
    return "there is no baseline " + baseline.string() + "; if " + keep(picture) + " is right, copy it there";
  const double share = shareOfOtherPixels(picture, readPng(baseline));
  if (share <= kLargestShareOfOtherPixels) return {};
  return std::to_string(100 * share) + " % of the pixels are not those of " + baseline.string() + "; compare it with " +
         keep(picture);
}

}  // namespace holdfast::test

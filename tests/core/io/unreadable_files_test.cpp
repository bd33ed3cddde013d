#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/words/error.h>

#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

class UnreadableFiles : public testing::Test {
 protected:
  [[nodiscard]] static std::string refusal(const std::filesystem::path& path)
  {
    try {
      static_cast<void>(readMesh(path));
      return "read";
    } catch (const InputError& error) {
      return error.what();
    }
  }

  /// `bytes`, with a byte of zero behind (or before) each.
  [[nodiscard]] static std::string wide(const std::string& bytes, bool isBigEndian)
  {
    std::string result;
    for (const char c : bytes) result += isBigEndian ? std::string{'\0', c} : std::string{c, '\0'};
    return result;
  }

  /// `bytes` and a hole up to `size`, which takes no room on the disk.
  [[nodiscard]] std::filesystem::path sparse(const std::string& name, const std::string& bytes,
                                             std::uintmax_t size) const
  {
    std::filesystem::path path = folder_.file(name, bytes);
    std::filesystem::resize_file(path, size);
    return path;
  }

  test::TemporaryFolder folder_;
};

const std::vector<std::pair<std::string, std::string>> kTexts{{".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
                                                              {".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
                                                              {".ply", "ply\nformat ascii 1.0\n"},
                                                              {".stl", "solid a\nendsolid a\n"},
                                                              {".vtp", "<?xml version=\"1.0\"?>\n"}};

TEST_F(UnreadableFiles, WideTextIsNamed)
{
  for (const auto& [extension, text] : kTexts) {
    for (const std::string& bytes :
         {"\xFF\xFE" + wide(text, false), "\xFE\xFF" + wide(text, true), wide(text, false), wide(text, true)})
      EXPECT_THAT(refusal(folder_.file("wide" + extension, bytes)),
                  HasSubstr("the text is in UTF-16: save it as UTF-8 or ASCII"))
          << extension;
    EXPECT_THAT(refusal(folder_.file("wider" + extension, std::string("\xFF\xFE\0\0v\0\0\0", 8))), HasSubstr("UTF-32"))
        << extension;
  }
}

constexpr std::uintmax_t kTwoGigabytes = std::uintmax_t{1} << 31U;

/// The most memory that this process has held, in kilobytes.
long mostMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST_F(UnreadableFiles, GigabytesOfZerosTakeNoMemory)
{
  constexpr long kSmall = 64 * 1024;  // kilobytes
  const long before = mostMemory();
  EXPECT_THAT(refusal(sparse("zeros.obj", "", kTwoGigabytes)), HasSubstr("byte 0: zero bytes begin here"));
  EXPECT_THAT(refusal(sparse("zeros.off", "", kTwoGigabytes)), HasSubstr("byte 0: zero bytes begin here"));
  EXPECT_THAT(refusal(sparse("zeros.ply", "", kTwoGigabytes)), HasSubstr("not with 'ply'"));
  EXPECT_THAT(refusal(sparse("zeros.stl", "", kTwoGigabytes)), HasSubstr("byte 80: zero bytes begin here"));
  EXPECT_THAT(refusal(sparse("zeros.vtp", "", kTwoGigabytes)), HasSubstr("it does not begin with '<'"));
  EXPECT_THAT(refusal(sparse("zeros.xyz", "", kTwoGigabytes)), HasSubstr("not a mesh format"));
  EXPECT_LT(mostMemory() - before, kSmall);
}

TEST_F(UnreadableFiles, ADownloadThatWasNotFilledTakesNoMemory)
{
  constexpr long kSmall = 64 * 1024;  // kilobytes
  const long before = mostMemory();
  EXPECT_THAT(refusal(sparse("part.obj", kTexts[0].second, kTwoGigabytes)), HasSubstr("byte 32: zero bytes begin"));
  EXPECT_LT(mostMemory() - before, kSmall);
}

TEST_F(UnreadableFiles, AFewZerosHarmNoText)
{
  const std::string named = "g " + std::string(70000, 'a') + std::string(100, '\0') + "\n" + kTexts[0].second;
  for (const std::string& bytes : {named, kTexts[0].second + std::string(4096, '\0')})
    EXPECT_EQ(refusal(folder_.file("few.obj", bytes)), "read");
}

TEST_F(UnreadableFiles, AnotherTextSaysWhereItIsNoObj)
{
  EXPECT_THAT(refusal(folder_.file("a.obj", "solid a\nfacet normal 0 0 1\n")),
              HasSubstr("the mesh has no vertices: an OBJ file needs 'v' lines; export the mesh again; line 1 begins "
                        "with 'solid', which OBJ does not have: is it another format?"));
}

}  // namespace
}  // namespace holdfast

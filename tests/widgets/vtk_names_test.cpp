// The classes that are named as VTK's are, against the rules of docs/widgets.md for their files and their signatures.
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

std::vector<std::filesystem::path> headersOfWidgets()
{
  std::vector<std::filesystem::path> headers;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourceFolder() + "/widgets/holdfast"))
    if (entry.path().extension() == ".h") headers.push_back(entry.path());
  return headers;
}

bool isNamedAsVtk(const std::filesystem::path& header)
{
  return header.stem().string().starts_with("vtkHoldfast");
}

std::vector<std::filesystem::path> headersNamedAsVtk()
{
  std::vector<std::filesystem::path> headers = headersOfWidgets();
  std::erase_if(headers, [](const auto& header) { return !isNamedAsVtk(header); });
  return headers;
}

std::vector<std::string> foundIn(const std::string& text, const std::regex& pattern)
{
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

/// Returns the names after `class`, at the beginning of a line, of classes that are defined.
std::vector<std::string> classesIn(const std::string& header)
{
  return foundIn(header, std::regex(R"(\nclass (\w+)[^;{]*\{)"));
}

/// Returns the classes of a header that have the macro of VTK's types.
std::vector<std::string> typesIn(const std::string& header)
{
  return foundIn(header, std::regex(R"(\n *vtkTypeMacro\((\w+),)"));
}

/// Returns the header without what is private, and without comments.
std::string interfaceOf(const std::string& header)
{
  return std::regex_replace(header.substr(0, header.find("\n private:")), std::regex("//.*"), "");
}

TEST(VtkNames, AHeaderHasTheOneClassOfItsName)
{
  EXPECT_THAT(headersNamedAsVtk(), SizeIs(21));
  for (const std::filesystem::path& path : headersNamedAsVtk()) {
    const std::string header = test::bytesOf(path);
    EXPECT_THAT(classesIn(header), ElementsAre(path.stem().string()));
    EXPECT_THAT(typesIn(header), ElementsAre(path.stem().string()));
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(path).replace_extension(".cpp"))) << path;
  }
  for (const std::filesystem::path& path : headersOfWidgets())
    if (!isNamedAsVtk(path)) {
      EXPECT_THAT(classesIn(test::bytesOf(path)), Not(Contains(HasSubstr("vtkHoldfast")))) << path;
    }
}

TEST(VtkNames, OtherClassesOfVtksKindAreThoseThatNoProgramWraps)
{
  std::vector<std::string> others;
  for (const std::filesystem::path& path : headersOfWidgets())
    if (!isNamedAsVtk(path))
      for (const std::string& type : typesIn(test::bytesOf(path))) others.push_back(type);
  const std::string page = test::bytesOf(test::sourceFolder() + "/docs/widgets.md");
  EXPECT_THAT(others, Not(IsEmpty()));
  for (const std::string& name : others) EXPECT_THAT(page, HasSubstr('`' + name + '`'));
}

TEST(VtkNames, SignaturesHaveNoOptional)
{
  for (const std::filesystem::path& path : headersNamedAsVtk())
    EXPECT_THAT(interfaceOf(test::bytesOf(path)), Not(HasSubstr("std::optional"))) << path;
}

TEST(VtkNames, EveryClassPrintsItself)
{
  for (const std::filesystem::path& path : headersNamedAsVtk())
    EXPECT_THAT(interfaceOf(test::bytesOf(path)), HasSubstr("void PrintSelf(")) << path;
}

TEST(VtkNamesMustFail, ForTwoClassesInAHeader)
{
  EXPECT_THAT(classesIn("\nclass A;\nclass B : public C {\n};\nclass D {\n};\n"), SizeIs(2));
  EXPECT_THAT(interfaceOf("std::optional<int> a();\n private:\n  std::optional<int> b;\n"), HasSubstr("std::optional"));
}

}  // namespace
}  // namespace holdfast

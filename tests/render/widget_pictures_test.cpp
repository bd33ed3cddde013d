// The examples of docs/widgets.md as a program, and the pictures that it draws for that page.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/compare_pictures.h"
#include "support/child_process.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// A widget changes no fewer pixels of 172,800.
constexpr double kLeastShareOfAWidget = 0.001;

/// What the program has said; its pictures are in `folder`.
std::string drawPictures(const test::TemporaryFolder& folder, const std::vector<std::string>& options = {})
{
  std::vector<std::string> command{HOLDFAST_WIDGET_PICTURES, test::dataFolder(), folder.path().string()};
  command.insert(command.end(), options.begin(), options.end());
  const test::ProcessResult run = test::runProcess(command);
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return run.out;
}

/// The pictures that look as without their widget.
std::vector<std::string> withoutAWidget(const test::TemporaryFolder& pictures, const test::TemporaryFolder& without)
{
  std::vector<std::string> names;
  for (const std::string& name : without.names())
    if (test::shareOfOtherPixels(test::readPng(pictures.path() / name), test::readPng(without.path() / name)) <
        kLeastShareOfAWidget)
      names.push_back(name);
  return names;
}

TEST(WidgetPictures, ShowTheirWidgetsWhoseObserversAreCalled)
{
  const test::TemporaryFolder pictures;
  const std::string said = drawPictures(pictures);
  for (const char* const words : {"moved by", "a point of face", "a curve through", "measured",
                                  "held by the middle button", "only the layer", "the handle is at"})
    EXPECT_THAT(said, HasSubstr(words));
  const test::TemporaryFolder without;
  EXPECT_THAT(drawPictures(without, {"off"}), IsEmpty());
  EXPECT_THAT(without.names(), SizeIs(8));
  EXPECT_EQ(pictures.names(), without.names());
  EXPECT_THAT(withoutAWidget(pictures, without), IsEmpty());
  EXPECT_THAT(withoutAWidget(without, without), SizeIs(8)) << "the control: widgets that are switched off";
}

}  // namespace
}  // namespace holdfast

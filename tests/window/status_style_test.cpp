#include <QImage>
#include <QPainter>
#include <array>

#include <gtest/gtest.h>

#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/controls/theme.h>

#include "widgets/lab_color.h"

namespace holdfast {
namespace {

using Status = std::optional<ConstraintStatus>;

constexpr int kSide = 16;
constexpr std::array<Status, 7> kEvery{std::nullopt,
                                       ConstraintStatus::Independent,
                                       ConstraintStatus::Met,
                                       ConstraintStatus::Redundant,
                                       ConstraintStatus::Conflicting,
                                       ConstraintStatus::Missed,
                                       ConstraintStatus::Disabled};

/// An icon as it stands in a table with this palette.
QImage drawnOn(Status status, const QPalette& palette)
{
  QImage image(kSide, kSide, QImage::Format_RGB32);
  image.fill(palette.color(QPalette::Base));
  QPainter painter(&image);
  statusIcon(status, palette).paint(&painter, image.rect());
  return image;
}

/// The pixels that differ clearly to an eye.
int clearlyOther(const QImage& a, const QImage& b, test::Vision vision)
{
  constexpr double kClear = 20;
  const auto seen = [&](const QImage& image, int x, int y) {
    const QColor color = image.pixelColor(x, y);
    return test::toLab(test::seenBy(vision, {color.redF(), color.greenF(), color.blueF()}));
  };
  int count = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) count += test::distance(seen(a, x, y), seen(b, x, y)) > kClear ? 1 : 0;
  return count;
}

/// Light, and dark.
class StatusStyle : public ::testing::TestWithParam<Appearance> {
 protected:
  const QPalette palette = paletteOf(GetParam());
};

TEST_P(StatusStyle, NoTwoLookAlikeToAnyEye)
{
  constexpr int kLeast = kSide * kSide / 8;
  for (const test::Vision vision : {test::Vision::Usual, test::Vision::WithoutGreen, test::Vision::WithoutRed})
    for (std::size_t a = 0; a < kEvery.size(); ++a)
      for (std::size_t b = a + 1; b < kEvery.size(); ++b)
        EXPECT_GE(clearlyOther(drawnOn(kEvery[a], palette), drawnOn(kEvery[b], palette), vision), kLeast)
            << a << " and " << b << ", vision " << static_cast<int>(vision);
}

TEST_P(StatusStyle, SignsStandOutFromThePaper)
{
  // WCAG 2.2, 1.4.11. What is thinner than a pixel is mixed with the paper, and the least sign has few pixels.
  constexpr double kLeast = 3;
  const QColor paper = palette.color(QPalette::Base);
  for (const Status& status : kEvery) {
    const QImage image = drawnOn(status, palette);
    int count = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) count += contrast(image.pixelColor(x, y), paper) >= kLeast ? 1 : 0;
    EXPECT_GE(count, 10) << (status ? name(*status) : "none");
  }
}

TEST_P(StatusStyle, TextsAreReadable)
{
  // WCAG 2.2, 1.4.3.
  constexpr double kLeast = 4.5;
  for (const QPalette::ColorRole paper :
       {QPalette::Base, QPalette::AlternateBase, QPalette::Window, QPalette::Button, QPalette::ToolTipBase}) {
    const QColor ground = palette.color(paper);
    for (const QPalette::ColorRole ink : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
      EXPECT_GE(contrast(palette.color(ink), ground), kLeast) << ink << " on " << paper;
    EXPECT_GE(contrast(quietColor(palette), ground), kLeast) << paper;
    for (const Status& status : kEvery) EXPECT_GE(contrast(statusColor(status, palette), ground), kLeast) << paper;
  }
  for (const auto& [ink, paper] : {std::pair(QPalette::HighlightedText, QPalette::Highlight),
                                   {QPalette::PlaceholderText, QPalette::Base},
                                   {QPalette::Link, QPalette::Base}})
    EXPECT_GE(contrast(palette.color(ink), palette.color(paper)), kLeast) << ink << " on " << paper;
}

INSTANTIATE_TEST_SUITE_P(Themes, StatusStyle, ::testing::Values(Appearance::Light, Appearance::Dark),
                         [](const auto& each) { return each.param == Appearance::Light ? "Light" : "Dark"; });

TEST(Contrast, OfBlackAndWhiteIsTheLargest)
{
  EXPECT_NEAR(contrast(Qt::black, Qt::white), 21, 1e-9);
  EXPECT_NEAR(contrast(QColor("#767676"), Qt::white), 4.54, 0.005) << "as the standard's notes say";
}

}  // namespace
}  // namespace holdfast

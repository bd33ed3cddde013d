#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/window/panels/color_panel.h>

#include "gestures.h"
#include "open_document.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

class ColorPanelTest : public ::testing::Test {
 protected:
  void SetUp() override
  {
    QObject::connect(&panel, &ColorPanel::settingsChanged, &panel,
                     [this](const ColorSettings& settings) { changes.push_back(settings); });
    QObject::connect(&panel, &ColorPanel::displaySettingsChanged, &panel,
                     [this](const DisplaySettings& settings) { displays.push_back(settings); });
    ASSERT_TRUE(test::showAndWait(panel));
  }

  template <class Widget>
  [[nodiscard]] Widget& find(const char* name) const
  {
    return *panel.findChild<Widget*>(name);
  }

  void chooseFixed() { find<QComboBox>("colorRangeKind").setCurrentIndex(1); }

  /// Types in the place of what is there, and ends with Enter.
  void typeNumber(const char* name, const char* text)
  {
    auto& edit = find<QLineEdit>(name);
    edit.selectAll();
    test::type(edit, text);
    test::pressKey(edit, Qt::Key_Return);
  }

  Editor editor;
  ColorPanel panel{editor};
  std::vector<ColorSettings> changes;
  std::vector<DisplaySettings> displays;
};

TEST_F(ColorPanelTest, KeysChooseTheField)
{
  auto& field = find<QComboBox>("colorField");
  test::pressKey(field, Qt::Key_Down);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].field, ColorBy::Detail);
  EXPECT_TRUE(find<QLabel>("colorExplanation").text().contains("Unit"));
}

TEST_F(ColorPanelTest, EveryFieldIsExplainedWithItsUnit)
{
  for (int k = 1; k < find<QComboBox>("colorField").count(); ++k) {
    find<QComboBox>("colorField").setCurrentIndex(k);
    EXPECT_GT(find<QLabel>("colorExplanation").text().size(), 30) << k;
    EXPECT_TRUE(find<QLabel>("colorExplanation").text().contains("unit", Qt::CaseInsensitive)) << k;
  }
}

TEST_F(ColorPanelTest, TypedEndsAreTakenToTheLastBit)
{
  chooseFixed();
  typeNumber("colorLow", "0.1000000000000000055");
  typeNumber("colorHigh", "12345.678901234567");
  const auto* range = std::get_if<FixedRange>(&changes.back().range);
  ASSERT_NE(range, nullptr);
  EXPECT_EQ(range->low, 0.1);
  EXPECT_EQ(range->high, 12345.678901234567);
  panel.setSettings(changes.back());
  EXPECT_EQ(find<QLineEdit>("colorHigh").text(), "12345.678901234567");
}

TEST_F(ColorPanelTest, RangesThatCannotBeAreRefusedWithTheReason)
{
  chooseFixed();
  const std::size_t before = changes.size();
  for (const char* const text : {"-5", "0", "abc", "nan", "1e999"}) {
    typeNumber("colorHigh", text);
    EXPECT_EQ(changes.size(), before) << text;
    EXPECT_TRUE(find<QLabel>("colorRefusal").isVisible()) << text;
    EXPECT_EQ(std::get<FixedRange>(panel.settings().range).high, 1) << text;
  }
  typeNumber("colorHigh", "2");
  EXPECT_FALSE(find<QLabel>("colorRefusal").isVisible());
  EXPECT_EQ(std::get<FixedRange>(panel.settings().range).high, 2);
}

TEST_F(ColorPanelTest, AFixedRangeBeginsAsWhatIsOnScreen)
{
  panel.setShownScale(ColorScale{"", Scaling::Linear, 0.25, 7.5});
  EXPECT_TRUE(find<QLabel>("colorAutomaticRange").text().contains("7.5"));
  chooseFixed();
  EXPECT_EQ(std::get<FixedRange>(changes.back().range).low, 0.25);
  EXPECT_EQ(std::get<FixedRange>(changes.back().range).high, 7.5);
}

TEST_F(ColorPanelTest, AFixedRangeIsThatOfItsField)
{
  auto& field = find<QComboBox>("colorField");
  const auto show = [&](ColorBy other) { field.setCurrentIndex(static_cast<int>(other)); };
  show(ColorBy::Displacement);
  chooseFixed();
  typeNumber("colorLow", "2");
  typeNumber("colorHigh", "60");
  show(ColorBy::Rotation);
  EXPECT_TRUE(std::holds_alternative<AutomaticRange>(changes.back().range)) << "millimetres are no radians";
  EXPECT_EQ(changes.back().field, ColorBy::Rotation);
  EXPECT_EQ(find<QComboBox>("colorRangeKind").currentIndex(), 0);
  chooseFixed();
  typeNumber("colorHigh", "3");
  show(ColorBy::Displacement);
  EXPECT_EQ(std::get<FixedRange>(changes.back().range).low, 2);
  EXPECT_EQ(std::get<FixedRange>(changes.back().range).high, 60);
  EXPECT_EQ(find<QLineEdit>("colorHigh").text(), "60");
  show(ColorBy::Rotation);
  EXPECT_EQ(std::get<FixedRange>(changes.back().range).high, 3);
  find<QComboBox>("colorRangeKind").setCurrentIndex(0);
  show(ColorBy::Displacement);
  show(ColorBy::Rotation);
  EXPECT_TRUE(std::holds_alternative<AutomaticRange>(changes.back().range)) << "chosen since";
}

TEST_F(ColorPanelTest, OtherRangesAreThoseOfEveryField)
{
  find<QComboBox>("colorRangeKind").setCurrentIndex(2);
  find<QSpinBox>("colorDecades").setValue(9);
  find<QComboBox>("colorField").setCurrentIndex(static_cast<int>(ColorBy::Detail));
  EXPECT_EQ(std::get<LogarithmicRange>(changes.back().range).decades, 9);
}

TEST_F(ColorPanelTest, AnotherDocumentHasAnAutomaticRange)
{
  chooseFixed();
  ASSERT_TRUE(test::openMesh(editor, test::grid(3, 3), {}));
  EXPECT_TRUE(std::holds_alternative<AutomaticRange>(panel.settings().range));
  find<QComboBox>("colorField").setCurrentIndex(static_cast<int>(ColorBy::Detail));
  find<QComboBox>("colorField").setCurrentIndex(static_cast<int>(ColorBy::Displacement));
  EXPECT_TRUE(std::holds_alternative<AutomaticRange>(changes.back().range));
}

TEST_F(ColorPanelTest, ARefusalGoesWhenTheNumberIsRight)
{
  chooseFixed();
  const auto& refusal = find<QLabel>("colorRefusal");
  typeNumber("colorHigh", "abc");
  ASSERT_TRUE(refusal.isVisible());
  typeNumber("colorHigh", "1");
  EXPECT_FALSE(refusal.isVisible()) << "it was 1 before";
  typeNumber("colorHigh", "-5");
  ASSERT_TRUE(refusal.isVisible()) << "the end is below the beginning";
  find<QLineEdit>("colorHigh").selectAll();
  test::type(find<QLineEdit>("colorHigh"), "7");
  EXPECT_FALSE(refusal.isVisible()) << "while it is typed";
}

TEST_F(ColorPanelTest, LeavingAFieldThatWasNotEditedChangesNothing)
{
  chooseFixed();
  const std::size_t before = changes.size();
  test::pressKey(find<QLineEdit>("colorLow"), Qt::Key_Return);
  EXPECT_EQ(changes.size(), before);
}

TEST_F(ColorPanelTest, LogarithmicRangesHaveDecades)
{
  find<QComboBox>("colorRangeKind").setCurrentIndex(2);
  find<QSpinBox>("colorDecades").setValue(9);
  EXPECT_EQ(std::get<LogarithmicRange>(changes.back().range).decades, 9);
}

TEST_F(ColorPanelTest, SettingsFromElsewhereAreShownWithoutSignals)
{
  panel.setSettings({ColorBy::Force, LogarithmicRange{7}, ColorMap::Grey});
  panel.setDisplaySettings(
      {RestGhost::Surface, MeshEdges::All, SurfaceDisplay::Points, RotationDisplay::Arrows, false});
  EXPECT_TRUE(changes.empty());
  EXPECT_TRUE(displays.empty());
  EXPECT_EQ(find<QComboBox>("colorField").currentIndex(), static_cast<int>(ColorBy::Force));
  EXPECT_EQ(find<QComboBox>("colorMap").currentData().toInt(), static_cast<int>(ColorMap::Grey));
  EXPECT_EQ(find<QSpinBox>("colorDecades").value(), 7);
  EXPECT_TRUE(find<QCheckBox>("rotationArrows").isChecked());
  EXPECT_FALSE(find<QCheckBox>("constraintGlyphs").isChecked());
}

TEST_F(ColorPanelTest, SwitchesTellAllOfTheDisplay)
{
  test::pressKey(find<QCheckBox>("rotationArrows"), Qt::Key_Space);
  find<QComboBox>("restGhost").setCurrentIndex(2);
  find<QComboBox>("meshEdges").setCurrentIndex(1);
  find<QComboBox>("surfaceDisplay").setCurrentIndex(2);
  test::pressKey(find<QCheckBox>("constraintGlyphs"), Qt::Key_Space);
  ASSERT_EQ(displays.size(), 5U);
  EXPECT_EQ(displays.back(), (DisplaySettings{RestGhost::Surface, MeshEdges::All, SurfaceDisplay::Points,
                                              RotationDisplay::Arrows, false}));
}

}  // namespace
}  // namespace holdfast

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "holdfast/widgets/gizmo/gizmo_drag.h"

namespace holdfast {
namespace {

NumericInput inputOf(const std::string& keys)
{
  NumericInput input;
  for (const char key : keys) input.add(key);
  return input;
}

TEST(NumericInput, IsTheNearestDoubleOfItsDigits)
{
  EXPECT_EQ(inputOf("12.5").value(), 12.5);
  EXPECT_EQ(inputOf("0.1").value(), 0.1);
  EXPECT_EQ(inputOf(".5").value(), 0.5);
  EXPECT_EQ(inputOf("5.").value(), 5);
  EXPECT_EQ(inputOf("1,5").value(), 1.5) << "the point of half the keyboards";
}

TEST(NumericInput, HasOnePointAndTurnsItsSignAtAnyTime)
{
  EXPECT_EQ(inputOf("1.2.3").text(), "1.23");
  EXPECT_EQ(inputOf("3-").value(), -3);
  EXPECT_EQ(inputOf("-3").value(), -3);
  EXPECT_EQ(inputOf("-3-").value(), 3);
  EXPECT_EQ(inputOf("-.5").value(), -0.5);
}

TEST(NumericInput, IsNothingBeforeItsFirstDigit)
{
  for (const char* keys : {"", "-", ".", "-."}) EXPECT_EQ(inputOf(keys).value(), 0) << keys;
  EXPECT_TRUE(inputOf("").isEmpty());
  EXPECT_FALSE(inputOf("-").isEmpty());
}

TEST(NumericInput, TakesBackTheLastKey)
{
  NumericInput input = inputOf("-4.5");
  for (const char* left : {"-4.", "-4", "-", "", ""}) {
    input.chop();
    EXPECT_EQ(input.text(), left);
  }
}

TEST(NumericInput, TakesNoOtherKeys)
{
  EXPECT_EQ(inputOf("1e5x 2").text(), "152");
  for (const char key : {'e', '+', '\r', '\0'}) EXPECT_FALSE(NumericInput::isBegunBy(key)) << key;
  for (const char key : NumericInput::kKeys) EXPECT_TRUE(NumericInput::isBegunBy(key)) << key;
}

TEST(NumericInput, StaysFiniteHoweverLongItIsTyped)
{
  const NumericInput input = inputOf(std::string(1000, '9'));
  EXPECT_GT(input.value(), 1e20);
  EXPECT_TRUE(std::isfinite(input.value()));
}

}  // namespace
}  // namespace holdfast

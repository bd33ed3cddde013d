#include <QKeyEvent>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <holdfast/widgets/tools/typed_amount.h>

namespace holdfast {
namespace {

QKeyEvent keyOf(char character, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
  return {QEvent::KeyPress, Qt::Key_unknown, modifiers, QString(character)};
}

TypedAmount typed(const char* keys)
{
  TypedAmount amount;
  for (; *keys != 0; ++keys) amount.add(keyOf(*keys));
  return amount;
}

TEST(TypedAmount, IsTheNearestDoubleOfItsDigits)
{
  EXPECT_EQ(typed("12.5").value(), 12.5);
  EXPECT_EQ(typed("0.1").value(), 0.1);
  EXPECT_EQ(typed(".5").value(), 0.5);
  EXPECT_EQ(typed("5.").value(), 5);
  EXPECT_EQ(typed("1,5").value(), 1.5) << "the point of half the keyboards";
}

TEST(TypedAmount, HasOnePointAndTurnsItsSignAtAnyTime)
{
  EXPECT_EQ(typed("1.2.3").text(), "1.23");
  EXPECT_EQ(typed("3-").value(), -3);
  EXPECT_EQ(typed("-3").value(), -3);
  EXPECT_EQ(typed("-3-").value(), 3);
}

TEST(TypedAmount, IsNothingBeforeItsFirstDigit)
{
  for (const char* keys : {"", "-", ".", "-."}) EXPECT_EQ(typed(keys).value(), 0) << keys;
  EXPECT_TRUE(typed("").isEmpty());
  EXPECT_FALSE(typed("-").isEmpty());
}

TEST(TypedAmount, TakesNoOtherKeys)
{
  EXPECT_EQ(typed("1e5x 2").text(), "152");
  EXPECT_FALSE(TypedAmount::isBegunBy(keyOf('e')));
  EXPECT_FALSE(TypedAmount::isBegunBy(keyOf('1', Qt::ControlModifier)));
  EXPECT_TRUE(TypedAmount::isBegunBy(keyOf('1', Qt::KeypadModifier)));
  EXPECT_FALSE(TypedAmount::isBegunBy({QEvent::KeyPress, Qt::Key_Shift, Qt::NoModifier, QString()}));
}

TEST(TypedAmount, StaysFiniteHoweverLongItIsTyped)
{
  EXPECT_TRUE(std::isfinite(typed(std::string(1000, '9').c_str()).value()));
}

}  // namespace
}  // namespace holdfast

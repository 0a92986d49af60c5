// Numbers with decimal commas, which look like two.
#include "base/text/decimal_commas.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(DecimalCommas, AreBetweenWholeNumbers)
{
    EXPECT_EQ(decimal_comma_in("0,5"), "0,5");
    EXPECT_EQ(decimal_comma_in("min(x,2)*-12,75"), "12,75");
    EXPECT_EQ(decimal_comma_in("12,5 7"), "12,5");
    for (const char* text : {"", ",", "5,", ",5", "0.1,0.2", "0, 5", "x,5", "5,x", "a1,2", "1,2e", "1,2.5", "1.0,5"})
        EXPECT_EQ(decimal_comma_in(text), "") << text;
}

TEST(DecimalCommas, AreNamedWithThePointThatIsMeant)
{
    EXPECT_EQ(decimal_comma_words("0,5+x"), "; the comma of \"0,5\" is no decimal point: must be 0.5");
    EXPECT_EQ(decimal_comma_words("min(x, y)"), "");
    for (const char* text : {"4m", " 4 mm", "4px"})
        EXPECT_EQ(decimal_comma_words(text), "; this number takes no unit: write 4, in the manual's unit") << text;
    EXPECT_EQ(unit_words("7.1 %"), "; this number takes no unit: write 0.071");
    const auto is_part = [](double value) { return value >= 0.05 && value <= 1; };
    EXPECT_EQ(unit_words("50%", is_part), "; this number takes no unit: write 0.5");
    EXPECT_EQ(unit_words("0.3mm", is_part), "; this number takes no unit: write 0.3, in the manual's unit");
    for (const char* text : {"4m", "4%", "101%", "0.3%"})
        EXPECT_EQ(unit_words(text, is_part), "; this number takes no unit") << text;
    for (const char* text : {"4", "m", "4x", "", "1e5", "0x4m"}) EXPECT_EQ(unit_words(text), "") << text;
}

TEST(Separators, AreMixedWhereACommaStandsAmongBlanks)
{
    for (const char* text : {"0 0 1,5 2", "0,5 0 2 2", "0 0 1 2,5", "0 0 1 1,5"})
        EXPECT_TRUE(mixes_separators(text, 4, 2)) << text;
    for (const char* text :
         {"0 0 1 2", "0,0,1,2", "0, 0, 1, 2", "0,0 1,2", "0,0 1,2 x", "0 , 0 , 1 , 2", "0 0 1 2 min(x,y)", "0,0,1,2,x"})
        EXPECT_FALSE(mixes_separators(text, 4, 2)) << text;
    EXPECT_TRUE(mixes_separators("0 0 0 1 1 1,5 x", 6, 3));
    EXPECT_FALSE(mixes_separators("0,0,0 1,1,1 x", 6, 3));
}

}
}

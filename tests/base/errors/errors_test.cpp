// Messages are one line that any terminal can show, whatever files hold.
#include "base/errors/errors.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(Printable, LeavesTextAlone)
{
    for (const char* text : {"", "a b", "caf\u00e9 \u4e2d \U0001F600", "\u00a0", "back\\slash", "\uE000\uFFFD"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesControlCharacters)
{
    EXPECT_EQ(printable("a\nb\rc\td"), "a\\nb\\rc\\td");
    EXPECT_EQ(printable("\x1b[2J\x7f"), "\\x1b[2J\\x7f");
    EXPECT_EQ(printable(std::string_view("\0\x1f", 2)), "\\x00\\x1f");
    EXPECT_EQ(printable("\u009b31m"), "\\xc2\\x9b31m") << "C1: the other way to begin a terminal's command";
}

TEST(Printable, EscapesBytesThatAreNoUtf8)
{
    // The Unicode Standard, table 3-7: which sequences are well-formed.
    EXPECT_EQ(printable("\xff"), "\\xff");
    EXPECT_EQ(printable("a\x80z"), "a\\x80z");
    EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut off";
    EXPECT_EQ(printable("\xc3("), "\\xc3(");
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "longer than needed";
    EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond the last character";
    EXPECT_EQ(printable("\xf4\x8f\xbf\xbf"), "\xf4\x8f\xbf\xbf") << "the last one";
}

TEST(Shortened, KeepsWholeCharacters)
{
    EXPECT_EQ(shortened("abcdef", 6), "abcdef");
    EXPECT_EQ(shortened("abcdef", 5), "abcde...");
    EXPECT_EQ(shortened("abc\u00e9f", 4), "abc...");
    EXPECT_EQ(shortened("abc\u00e9f", 5), "abc\u00e9...");
    EXPECT_EQ(shortened("\x80\x80\x80", 2), "\x80\x80...") << "no characters at all";
}

template <class Error>
class Errors : public ::testing::Test
{
};
using AllErrors = ::testing::Types<InputError, DeviceError, StorageError>;
TYPED_TEST_SUITE(Errors, AllErrors);

TYPED_TEST(Errors, AreOneLineButForDetails)
{
    EXPECT_STREQ(TypeParam("a\nb").what(), "a\\nb");
    EXPECT_STREQ(TypeParam("a\nb", "; it said:\n    c").what(), "a\\nb; it said:\n    c");
}

/// Errors as processes send them to each other.
TYPED_TEST(Errors, StayAsTheyAreWhenThrownAgain)
{
    const TypeParam error("a\nb \xff", ": c\n");
    EXPECT_STREQ(TypeParam({}, error.what()).what(), error.what());
    EXPECT_STREQ(TypeParam(TypeParam("a\nb \xff").what()).what(), "a\\nb \\xff");
}

TEST(InputErrors, OfValuesAreOfBearableLength)
{
    const std::string message =
        invalid_value({"c.toml", 3}, std::string(1000, 'k'), std::string(1000, 'v'), "must be short").what();
    EXPECT_TRUE(message.starts_with("c.toml:3: kkk")) << message;
    EXPECT_TRUE(message.ends_with("v...: must be short")) << message;
    EXPECT_LT(message.size(), 400U);
}

TEST(InputErrors, CarryWhatTheyAreAboutAsFields)
{
    const InputError error = invalid_value({"c.toml", 3}, "seed", "-1", "must be at least 0");
    EXPECT_STREQ(error.what(), "c.toml:3: seed = -1: must be at least 0");
    EXPECT_EQ(error.place().file, "c.toml");
    EXPECT_EQ(error.place().line, 3);
    EXPECT_EQ(error.key(), "seed");
    EXPECT_EQ(error.value(), "-1");
    EXPECT_EQ(error.allowed(), "must be at least 0");

    EXPECT_STREQ(InputError::at({"--set a", 0, true}, "must be key=value").what(), "--set a: must be key=value");
    EXPECT_EQ(InputError("no place").place().file, "");
}

/// A library says what is wrong, and whoever has read the file where.
TEST(InputErrors, AreSaidOfAnotherPlace)
{
    const InputError nowhere = invalid_value({}, "colors", "99", "must be less");
    EXPECT_STREQ(nowhere.what(), "colors = 99: must be less");
    const InputError here = nowhere.moved_to({"c.toml", 7});
    EXPECT_STREQ(here.what(), "c.toml:7: colors = 99: must be less");
    EXPECT_EQ(here.key(), "colors");
    EXPECT_STREQ(here.moved_to({"{out}", 2}).what(), "{out}:2: colors = 99: must be less");
    const InputError long_one("it failed", "; it said:\n    a");
    EXPECT_STREQ(long_one.moved_to({"c.toml"}).what(), "c.toml: it failed; it said:\n    a") << "details stay lines";
}

}
}

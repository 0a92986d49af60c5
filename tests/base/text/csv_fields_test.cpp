// Fields of CSV: the rules and examples of RFC 4180, section 2.
#include "base/text/csv_fields.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::Optional;

TEST(CsvFields, AreThoseOfTheStandard)
{
    EXPECT_THAT(csv_fields("aaa,bbb,ccc"), Optional(ElementsAre("aaa", "bbb", "ccc")));
    EXPECT_THAT(csv_fields(R"("aaa","b""bb",ccc)"), Optional(ElementsAre("aaa", "b\"bb", "ccc")));
    EXPECT_THAT(csv_fields(R"("a,a",b)"), Optional(ElementsAre("a,a", "b")));
    EXPECT_THAT(csv_fields(R"("""","")"), Optional(ElementsAre("\"", "")));
    EXPECT_THAT(csv_fields(",a,"), Optional(ElementsAre("", "a", "")));
    EXPECT_THAT(csv_fields(""), Optional(ElementsAre("")));
}

TEST(CsvFields, AreNothingWhereQuotesDoNotFit)
{
    for (const char* line : {"\"a", "a,\"b,c", "\"a\"\"", "\"a\"b,c", "\""}) EXPECT_FALSE(csv_fields(line)) << line;
}

TEST(CsvFields, ReadWhatIsQuoted)
{
    for (const char* text : {"", "a", "a,b", "\"", "say \"a, b\"", "{\"rho\":0.7,\"stop\":\"points\"}"})
        EXPECT_THAT(csv_fields("x," + csv_quoted(text) + "," + csv_quoted(text)),
                    Optional(ElementsAre("x", text, text)));
    EXPECT_EQ(csv_quoted("two\nlines"), "\"two lines\"");
}

}
}

// JSON that is none, or that would take what looks at it too deep.
#include "base/files/json_file.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

std::string error_of(std::string_view text)
{
    return message_of([&] { parsed_json(text, "a.json"); });
}

TEST(JsonFile, IsRead)
{
    const TemporaryFolder folder;
    EXPECT_EQ(read_json_file(folder.write("a.json", "{\"a\": [1, 2.5]}")), nlohmann::json({{"a", {1, 2.5}}}));
    EXPECT_THROW(read_json_file(folder.path() / "none.json"), InputError);
}

TEST(JsonFile, ErrorsNameTheLine)
{
    EXPECT_EQ(error_of(""), "a.json:1: is not JSON: unexpected end of input; expected '[', '{', or a literal");
    EXPECT_EQ(error_of("{\n\"a\": 1,\n}\n"), "a.json:3: is not JSON: unexpected '}'; expected string literal");
    EXPECT_EQ(error_of("[1e999]"), "a.json: is not JSON: number overflow parsing '1e999'");
}

TEST(JsonFile, LongTextsAreNotRepeated) { EXPECT_LT(error_of("[\"" + std::string(5000, 'x')).size(), 300U); }

TEST(JsonFile, DeepValuesAreRefused)
{
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    EXPECT_NO_THROW(parsed_json(nested(60), "a.json"));
    EXPECT_EQ(error_of(nested(100'000)), "a.json: lists and objects lie more than 64 deep in one another");
}

}
}

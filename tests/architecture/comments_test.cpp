// A comment says by itself what it is about: readers jump to its line, and do not know what was said above it.
#include "tests/architecture/source_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {
namespace {

using test::SourceFile;
using testing::ElementsAre;
using testing::IsEmpty;

/// Beginnings that point to another comment.
constexpr std::array<std::string_view, 4> riddles{"The same", "Likewise", "Ditto", "As above"};

bool is_space_in_line(char letter) { return letter == ' ' || letter == '\t'; }

/// The sign of a comment at the end of a text, such as "//" or "/*", with what Doxygen adds to it; empty: there is
/// none.
std::string_view comment_sign_at_end(std::string_view before, bool has_hash_comments)
{
    while (!before.empty() && is_space_in_line(before.back())) before.remove_suffix(1);
    std::size_t begin = before.size();
    const std::string_view letters = has_hash_comments ? "#" : "/*!<";
    while (begin > 0 && letters.find(before[begin - 1]) != std::string_view::npos) --begin;
    const std::string_view sign = before.substr(begin);
    return has_hash_comments || sign.starts_with("//") || sign.starts_with("/*") ? sign : std::string_view();
}

/// True if a line has nothing but a comment to its end with this sign: such a line below it goes on with the comment.
bool is_comment_line(std::string_view line, std::string_view sign)
{
    while (!line.empty() && is_space_in_line(line.front())) line.remove_prefix(1);
    return line.starts_with(sign) && !sign.starts_with("/*");
}

/// The lines with comments that begin with a riddle, as "path:line: text".
std::vector<std::string> riddles_of(const SourceFile& file)
{
    std::vector<std::string> found;
    std::string_view before, rest = file.text;
    for (int number = 1; !rest.empty(); ++number) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        const bool has_riddle = std::ranges::any_of(riddles, [&](std::string_view riddle) {
            const std::size_t at = line.find(riddle), end = at + riddle.size();
            if (at == std::string_view::npos) return false;
            if (end < line.size() && std::isalpha(static_cast<unsigned char>(line[end]))) return false;
            const std::string_view sign = comment_sign_at_end(line.substr(0, at), file.has_hash_comments());
            return !sign.empty() && !(is_comment_line(line, sign) && is_comment_line(before, sign));
        });
        if (has_riddle) found.push_back(file.path + ":" + std::to_string(number) + ": " + std::string(line));
        before = line;
    }
    return found;
}

TEST(Comments, AreNoRiddles)
{
    for (const SourceFile& file : test::source_files())
        for (const std::string& riddle : riddles_of(file)) ADD_FAILURE() << riddle;
}

TEST(Comments, AreFoundWhereTheyBeginWithARiddle)
{
    for (const std::string_view riddle : riddles) {
        const std::string words = std::string(riddle) + " of tiles.";
        for (const std::string sign : {"//", "///", "///<", "/*", "/**"})
            EXPECT_THAT(riddles_of({"a.hpp", "int a;\nint b; " + sign + " " + words + "\n"}),
                        ElementsAre("a.hpp:2: int b; " + sign + " " + words));
        EXPECT_THAT(riddles_of({"a.cl", "  //" + words}), ElementsAre("a.cl:1:   //" + words));
        for (const char* name : {"a/CMakeLists.txt", "a.cmake", "a.py", "a.sh", "lab"})
            EXPECT_THAT(riddles_of({name, "# " + words + "\n"}), ElementsAre(std::string(name) + ":1: # " + words));
    }
}

TEST(Comments, MayHaveSuchWordsWithin)
{
    for (const std::string_view riddle : riddles) {
        const std::string words = std::string(riddle) + " of tiles.";
        EXPECT_THAT(riddles_of({"a.hpp", "/// A set.\n/// " + words + "\nauto a = \"" + words + "\";\n"}), IsEmpty());
        EXPECT_THAT(riddles_of({"a.hpp", "/// A set. " + words + "\n/// " + std::string(riddle) + "ness\n"}),
                    IsEmpty());
        EXPECT_THAT(riddles_of({"a.py", "# A set.\n# " + words + "\nprint('" + words + "')\n"}), IsEmpty());
    }
}

}
}

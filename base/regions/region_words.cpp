#include "base/regions/region_words.hpp"

#include "base/regions/space_region.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace poissonlab {

bool begins_with(std::string_view text, std::string_view word)
{
    return text.size() >= word.size() && std::ranges::equal(text.substr(0, word.size()), word, [](char a, char b) {
               return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
           });
}

namespace {

/// Kinds of shapes that WKT has and that are not read.
constexpr std::array unread_wkt{"CURVE",        "SURFACE",    "CIRCULARSTRING",    "COMPOUNDCURVE",
                                "CURVEPOLYGON", "LINEARRING", "POLYHEDRALSURFACE", "TIN",
                                "TRIANGLE"};

/// The word alone, before a bracket or before blanks: what goes on otherwise is a file's name, such as points.geojson.
bool begins_with_whole(std::string_view text, std::string_view word)
{
    if (!begins_with(text, word)) return false;
    return text.size() == word.size() || std::string_view("( \t\r\n").find(text[word.size()]) != std::string_view::npos;
}

}

bool is_wkt_text(std::string_view text)
{
    if (begins_with(text, "SRID=")) return true;
    if (begins_with(text, "MULTI")) text.remove_prefix(5);
    for (const char* word : {"POLYGON", "POINT", "LINESTRING", "GEOMETRYCOLLECTION"})
        for (const char* dimensions : {"", "Z", "M", "ZM"})
            if (begins_with_whole(text, std::string(word) + dimensions)) return true;
    // Others are not known here, which their reader says: brackets tell them from names of files, "triangle (1).svg".
    return text.find('(') != text.npos && text[text.find_last_not_of(" \t\r\n;")] == ')' &&
           std::ranges::any_of(unread_wkt, [&](const char* word) { return begins_with_whole(text, word); });
}

std::string_view without_blanks_around(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n";
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // a mark of byte order
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

bool is_region_text(std::string_view text)
{
    const std::string_view begin = without_blanks_around(text);
    return begin.starts_with('{') || is_wkt_text(begin) || begins_with(begin, "rectangle ") ||
           begins_with(begin, "disk ") || begins_with(begin, "formula ") || begins_with(begin, "path ") ||
           is_space_region_text(begin);
}

}

#include "io/point_file.hpp"

#include "errors/errors.hpp"
#include "io/point_file_formats.hpp"
#include "io/text_lines.hpp"
#include "io/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

bool is_printable(char c) { return c >= ' ' && c <= '~'; }

/// `text` fit for one line of an error message: printable and not too long.
std::string shown(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::string result(text.substr(0, longest));
    for (char& c : result) {
        if (!is_printable(c)) c = '?';
    }
    if (text.size() > longest) result += "...";
    return result;
}

/// What a coordinate that is none should have been.
std::string allowed_coordinate(double value)
{
    return value == 1 ? "must be a number in [0, 1), without 1 itself (on the torus, 1 is 0)"
                      : "must be a number in [0, 1)";
}

}

std::vector<PointSet> read_points(const std::filesystem::path& path)
{
    const std::string content = read_whole_file(path);
    const PointFileContent file{path.string(), content};
    if (file.bytes.starts_with(npy_magic)) return read_npy_points(file);
    LineReader lines(file.bytes);
    if (lines.next() && trimmed(lines.line()) == ply_magic) return read_ply_points(file);
    return read_text_points(file);
}

void append_coordinate(const PointFileContent& file, int line, std::string_view word,
                       std::vector<double>& coordinates)
{
    double value = 0;
    if (!parse_number(word, value)) {
        if (!std::ranges::all_of(word, is_printable)) {
            fail_in_point_file(file, line, word, "not text; a point file is text, PLY or NumPy (.npy)");
        }
        fail_in_point_file(file, line, word.empty() ? "nothing beside a comma" : word,
                           "must be a number in [0, 1); a line that is not a point starts with `# `");
    }
    if (!is_coordinate(value)) fail_in_point_file(file, line, word, allowed_coordinate(value));
    coordinates.push_back(value);
}

void fail_coordinate_at_byte(const PointFileContent& file, std::size_t offset, double value)
{
    throw InputError(fmt::format("{}: byte {}: {}: {}", file.name, offset, value, allowed_coordinate(value)));
}

void fail_in_point_file(const PointFileContent& file, int line, std::string_view value,
                        std::string_view allowed)
{
    throw InputError(
        fmt::format("{}: {}: {}", to_string(SourceLocation{file.name, line}), shown(value), allowed));
}

}

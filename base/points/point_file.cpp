#include "base/points/point_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/flat_points.hpp"
#include "base/points/hdf5_reading.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

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

/// Does a line of text begin with a number, whatever comes after it?
bool begins_with_number(std::string_view line)
{
    double value = 0;
    if (line.starts_with('"')) line.remove_prefix(1);
    return parse_number(line.substr(0, line.find_first_of(" \t,;\"")), value);
}

}

std::string allowed_coordinate(double value, const CoordinateRange& range)
{
    if (range.high == any_coordinates.high) return "must be a number";
    const std::string allowed = fmt::format("must be a number in [{}, {})", range.low, range.high);
    if (value == range.high)
        return allowed + fmt::format(", without {0} itself (on the torus, {0} is {1})", range.high, range.low);
    return allowed;
}

CoordinateRange declared_range(const PointFileContent& file)
{
    for (LineReader lines(file.bytes); lines.next();) {
        WordReader words(lines.line());
        const std::string_view first = words.next() ? words.word() : std::string_view{};
        if (first == "end_header" || begins_with_number(trimmed(lines.line()))) break;
        if ((first != "#" && first != "comment") || !words.next() || words.word() != "domain") continue;
        const std::string_view text = words.next() ? words.word() : std::string_view{};
        if (const auto range = parse_range(text)) return *range;
        fail_in_point_file(file, lines.number(), text, "a domain is LOW:HIGH, two numbers, the first smaller");
    }
    return {};
}

std::optional<CoordinateRange> parse_range(std::string_view text)
{
    CoordinateRange range;
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos && !parse_number(text.substr(0, colon), range.low)) return {};
    if (!parse_number(colon == std::string_view::npos ? text : text.substr(colon + 1), range.high)) return {};
    // Their difference must be a number, too.
    if (!(range.low < range.high) || !std::isfinite(range.high - range.low)) return {};
    return range;
}

namespace {

PointFileContent content_of(const std::filesystem::path& path, std::string_view bytes, const PointReading& how)
{
    return {path.string(), bytes, {}, how.told, how.options};
}

/// The sets of a file as they are there; `range` becomes that of their coordinates.
std::vector<PointSet> read_all_coordinates(const std::filesystem::path& path, const PointReading& how,
                                           CoordinateRange& range)
{
    if (is_hdf5_file(path)) return {read_hdf5_points(path, how, range)};
    const std::string content = read_whole_file(path);
    PointFileContent file = content_of(path, content, how);
    check_no_particles(how, path);
    const bool is_npy = file.bytes.starts_with(npy_magic);
    const bool is_utk = file.bytes.starts_with(utk_magic) || file.bytes.starts_with(swapped_utk_magic);
    if (!is_npy && !is_utk) file.bytes = plain_text(file.name, file.bytes);
    file.range = how.range ? *how.range : is_npy || is_utk ? CoordinateRange{} : declared_range(file);
    range = file.range;
    if (is_npy) return read_npy_points(file);
    if (is_utk) return read_utk_points(file);
    LineReader lines(file.bytes);
    if (lines.next() && trimmed(lines.line()) == ply_magic) return read_ply_points(file);
    return read_text_points(file);
}

}

std::vector<PointSet> read_points(const std::filesystem::path& path, const PointReading& how)
{
    CoordinateRange range;
    std::vector<PointSet> sets = read_all_coordinates(path, how, range);
    if (const auto axis = flat_axis(sets, to_unit(0, range))) {
        for (PointSet& set : sets) set = without_axis(std::move(set), *axis);
        if (how.told) how.told(printable(path.string()) + ": " + flat_sentence(*axis));
    }
    return sets;
}

std::vector<PointSet> read_points(const std::filesystem::path& path, std::optional<CoordinateRange> range)
{
    return read_points(path, PointReading{.range = range});
}

std::vector<PointSet> read_own_points(const std::filesystem::path& path, std::optional<CoordinateRange> range)
{
    CoordinateRange found;
    return read_all_coordinates(path, PointReading{.range = range}, found);
}

std::vector<std::filesystem::path> files_of_points(const std::filesystem::path& path)
{
    if (is_hdf5_file(path)) return parts_of_hdf5_points(path);
    return {path};
}

std::vector<std::filesystem::path> without_further_parts(const std::vector<std::filesystem::path>& files,
                                                         const std::function<void(const std::string&)>& told)
{
    std::vector<std::filesystem::path> kept;
    std::map<std::filesystem::path, std::filesystem::path> first_of; // parts, and the file that names them all
    for (const auto& file : files) {
        const auto named = first_of.find(std::filesystem::weakly_canonical(file));
        if (named != first_of.end()) {
            if (told)
                told(fmt::format("{}: is read already, as part of the snapshot of {}", printable(file.string()),
                                 printable(named->second.string())));
            continue;
        }
        kept.push_back(file);
        const auto parts = files_of_points(file);
        if (parts.size() < 2) continue;
        for (const auto& part : parts) first_of.emplace(std::filesystem::weakly_canonical(part), file);
    }
    return kept;
}

void check_no_particles(const PointReading& how, const std::filesystem::path& path)
{
    if (!how.particles) return;
    throw InputError::at({path.string()},
                         fmt::format("has no types of particles: {} is for snapshots in HDF5",
                                     fmt::format(fmt::runtime(how.options.particles), *how.particles)));
}

std::string_view plain_text(const std::string& name, std::string_view text)
{
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw InputError::at({name}, "is text in UTF-16, as some programs call \"Unicode\": must be saved as UTF-8");
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    return text;
}

double number_in(const PointFileContent& file, int line, std::string_view word)
{
    double value = 0;
    if (parse_number(word, value)) return value;
    if (!std::ranges::all_of(word, is_printable))
        fail_in_point_file(file, line, word, "not text; a point file is text, PLY, NumPy (.npy), HDF5 or UTK (.bin)");
    fail_in_point_file(file, line, word.empty() ? "nothing beside a comma" : word,
                       allowed_coordinate(0.5 * file.range.low + 0.5 * file.range.high, file.range) +
                           "; a line that is not a point starts with `# `");
}

void fail_in_point_file(const PointFileContent& file, int line, std::string_view value, std::string_view allowed)
{
    throw InputError::at({file.name, line}, fmt::format("{}: {}", shown(value), allowed));
}

}

#include "base/points/point_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/flat_points.hpp"
#include "base/points/hdf5_reading.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/text/decimal_commas.hpp"
#include "base/text/plain_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <map>

namespace poissonlab {
namespace {

/// The words between blanks.
std::vector<std::string_view> words_between_blanks(std::string_view text)
{
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

/// The range between two numbers.
std::optional<CoordinateRange> range_between(std::string_view low, std::string_view high)
{
    CoordinateRange range;
    if (!parse_number(low, range.low) || !parse_number(high, range.high)) return {};
    // Their difference must be a number, too.
    if (!(range.low < range.high) || !std::isfinite(range.high - range.low)) return {};
    return range;
}

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

std::vector<double> PointDomain::sides() const
{
    std::vector<double> sides;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
        sides.push_back(ranges_[axis].high - ranges_[axis].low);
    return sides;
}

bool PointDomain::is_square() const
{
    const std::vector<double> lengths = sides();
    return std::ranges::adjacent_find(lengths, std::not_equal_to{}) == lengths.end();
}

std::optional<CoordinateRange> parse_range(std::string_view text)
{
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return range_between("0", text);
    return range_between(text.substr(0, colon), text.substr(colon + 1));
}

std::optional<PointDomain> parse_domain(std::string_view text)
{
    const std::vector<std::string_view> words = words_between_blanks(text);
    const std::size_t count = words.size();
    const bool are_corners = count == 4 || count == 6;
    if (!are_corners && (count == 0 || count > 3)) return {};
    std::vector<CoordinateRange> ranges;
    for (std::size_t i = 0; i < (are_corners ? count / 2 : count); ++i) {
        const auto range = are_corners ? range_between(words[i], words[i + count / 2]) : parse_range(words[i]);
        if (!range) return {};
        ranges.push_back(*range);
    }
    return count == 1 ? PointDomain(ranges.front()) : PointDomain(ranges);
}

std::string allowed_coordinate(double value, const CoordinateRange& range)
{
    if (range.high == any_coordinates.high) return "must be a number";
    const std::string allowed = fmt::format("must be a number in [{}, {})", range.low, range.high);
    if (value == range.high)
        return allowed + fmt::format(", without {0} itself (on the torus, {0} is {1})", range.high, range.low);
    return allowed;
}

PointDomain declared_domain(const PointFileContent& file)
{
    for (LineReader lines(file.bytes); lines.next();) {
        WordReader words(lines.line());
        const std::string_view first = words.next() ? words.word() : std::string_view{};
        if (first == "end_header" || begins_with_number(trimmed(lines.line()))) break;
        if ((first != "#" && first != "comment") || !words.next() || words.word() != "domain") continue;
        const std::string_view text = words.next() ? words.word() : std::string_view{};
        std::string domain(text);
        while (words.next() && words.word().find(':') != std::string_view::npos)
            domain += " " + std::string(words.word());
        if (const auto declared = parse_domain(domain)) return *declared;
        fail_in_point_file(file, lines.number(), text, "a domain is LOW:HIGH, two numbers, the first smaller");
    }
    return {};
}

namespace {

bool has_first_bytes(const std::filesystem::path& path, std::string_view bytes)
{
    std::string begin(bytes.size(), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return file.gcount() == static_cast<std::streamsize>(bytes.size()) && begin == bytes;
}

PointFileContent content_of(const std::filesystem::path& path, std::string_view bytes, const PointReading& how)
{
    return {path.string(), bytes, {}, how.told, how.options, how.degrees_sentence, how.classes};
}

/// The sets of a file as they are there; `domain` becomes that of their coordinates.
std::vector<PointSet> read_all_coordinates(const std::filesystem::path& path, const PointReading& how,
                                           PointDomain& domain)
{
    if (is_hdf5_file(path)) return {read_hdf5_points(path, how, domain)};
    const std::string content = read_whole_file(path);
    PointFileContent file = content_of(path, content, how);
    check_no_particles(how, path);
    const bool is_npy = file.bytes.starts_with(npy_magic);
    const bool is_utk = file.bytes.starts_with(utk_magic) || file.bytes.starts_with(swapped_utk_magic);
    if (!is_npy && !is_utk) file.bytes = plain_text(file.name, file.bytes);
    file.domain = how.domain ? *how.domain : is_npy || is_utk ? PointDomain{} : declared_domain(file);
    domain = file.domain;
    if (is_npy) return read_npy_points(file);
    if (is_utk) return read_utk_points(file);
    LineReader lines(file.bytes);
    if (lines.next() && trimmed(lines.line()) == ply_magic) return read_ply_points(file);
    if (begins_as_geojson(trimmed(file.bytes))) return read_geojson_points(file);
    return read_text_points(file);
}

/// The domain of points of which an axis was left out. Throws InputError where it had no range for each axis.
PointDomain without_axis(const PointDomain& domain, std::size_t axis, const std::filesystem::path& path)
{
    if (domain.dimension() == 0 || (domain.dimension() == 2 && axis == 2)) return domain;
    if (domain.dimension() == 2)
        throw InputError::at(
            {path.string()},
            "has points in a plane of space where the domain has 2 ranges: must have one for each axis");
    std::vector<CoordinateRange> ranges;
    for (std::size_t i = 0; i < 3; ++i)
        if (i != axis) ranges.push_back(domain[i]);
    return PointDomain(ranges);
}

}

bool is_hdf5_file(const std::filesystem::path& path)
{
    return !is_no_lasting_file(path) && has_first_bytes(path, hdf5_magic);
}

std::vector<PointSet> read_points_in_box(const std::filesystem::path& path, const PointReading& how,
                                         PointDomain& domain)
{
    std::vector<PointSet> sets = read_all_coordinates(path, how, domain);
    if (const auto axis = flat_axis(sets, to_unit(0, domain[2]))) {
        for (PointSet& set : sets) set = without_axis(std::move(set), *axis);
        domain = without_axis(domain, *axis, path);
        if (how.told) how.told(printable(path.string()) + ": " + flat_sentence(*axis));
    }
    const int axes = domain.dimension();
    if (axes > 0 && axes != sets.front().dimension)
        throw InputError::at({path.string()}, fmt::format("has {}D points where the domain has {} ranges: must have "
                                                          "one for each axis",
                                                          sets.front().dimension, axes));
    return sets;
}

std::vector<PointSet> read_points(const std::filesystem::path& path, const PointReading& how)
{
    PointDomain domain;
    std::vector<PointSet> sets = read_points_in_box(path, how, domain);
    if (!domain.is_square())
        throw InputError::at({path.string()},
                             "declares a domain whose sides differ; must be a square (cube) here, or have each "
                             "coordinate over its side");
    return sets;
}

std::vector<PointSet> read_points(const std::filesystem::path& path, std::optional<CoordinateRange> range)
{
    PointReading how;
    if (range) how.domain = *range;
    return read_points(path, how);
}

std::vector<PointSet> read_own_points(const std::filesystem::path& path, std::optional<CoordinateRange> range)
{
    PointReading how;
    if (range) how.domain = *range;
    PointDomain found;
    return read_all_coordinates(path, how, found);
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
    const auto place_of = [](const std::filesystem::path& file) {    // pipes such as /dev/stdin have none
        std::error_code unknown;
        const auto place = std::filesystem::weakly_canonical(file, unknown);
        return unknown ? file : place;
    };
    for (const auto& file : files) {
        const auto named = first_of.find(place_of(file));
        if (named != first_of.end()) {
            if (told)
                told(fmt::format("{}: is read already, as part of the snapshot of {}", printable(file.string()),
                                 printable(named->second.string())));
            continue;
        }
        kept.push_back(file);
        const auto parts = files_of_points(file);
        if (parts.size() < 2) continue;
        for (const auto& part : parts) first_of.emplace(place_of(part), file);
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

double number_in(const PointFileContent& file, int line, std::string_view word)
{
    double value = 0;
    if (parse_number(word, value)) return value;
    if (!std::ranges::all_of(word, is_printable))
        fail_in_point_file(file, line, word, "not text; a point file is text, PLY, NumPy (.npy), HDF5 or UTK (.bin)");
    fail_in_point_file(file, line, word.empty() ? "nothing beside a comma" : word,
                       allowed_coordinate(0.5 * file.domain[0].low + 0.5 * file.domain[0].high, file.domain[0]) +
                           "; a line that is not a point starts with `# `" + decimal_comma_words(word));
}

void fail_in_point_file(const PointFileContent& file, int line, std::string_view value, std::string_view allowed)
{
    throw InputError::at({file.name, line}, fmt::format("{}: {}", shown(value), allowed));
}

}

#include "base/points/point_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/flat_points.hpp"
#include "base/points/hdf5_reading.hpp"
#include "base/points/point_file_formats.hpp"

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

/// The end of the message about a number that is no coordinate: the numbers that are.
std::string allowed_coordinate(double value, const CoordinateRange& range)
{
    if (range.high == any_coordinates.high) return "must be a number";
    const std::string allowed = fmt::format("must be a number in [{}, {})", range.low, range.high);
    if (value == range.high)
        return allowed + fmt::format(", without {0} itself (on the torus, {0} is {1})", range.high, range.low);
    return allowed;
}

bool is_number(std::string_view word)
{
    double value = 0;
    return parse_number(word, value);
}

}

PointDomain declared_domain(const PointFileContent& file)
{
    for (LineReader lines(file.bytes); lines.next();) {
        WordReader words(lines.line());
        const bool has_word = words.next();
        const std::string_view first = has_word ? words.word() : std::string_view{};
        if (first == "end_header" || (has_word && is_number(first))) break;
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

/// The set of an HDF5 file, whose reader knows squares and cubes alone, in any domain.
PointSet read_hdf5_points_in(const std::filesystem::path& path, const std::optional<PointDomain>& domain)
{
    if (!domain || domain->dimension() == 0)
        return read_hdf5_points(path, domain ? std::optional((*domain)[0]) : std::nullopt);
    PointSet set = read_hdf5_points(path, any_coordinates);
    for (std::size_t i = 0; i < set.coordinates.size(); ++i) {
        const CoordinateRange& range = (*domain)[i % static_cast<std::size_t>(set.dimension)];
        double& value = set.coordinates[i];
        if (!is_coordinate(value, range))
            throw InputError::at({path.string()}, fmt::format("point {}: {}: {}", i / set.dimension, value,
                                                              allowed_coordinate(value, range)));
        value = to_unit(value, range);
    }
    return set;
}

/// The sets of a file as they are there; `domain` becomes that of their coordinates.
std::vector<PointSet> read_all_coordinates(const std::filesystem::path& path, std::optional<PointDomain>& domain)
{
    const std::string content = read_whole_file(path);
    PointFileContent file{path.string(), content};
    if (file.bytes.starts_with(hdf5_magic)) return {read_hdf5_points_in(path, domain)};
    const bool is_npy = file.bytes.starts_with(npy_magic);
    const bool is_utk = file.bytes.starts_with(utk_magic) || file.bytes.starts_with(swapped_utk_magic);
    file.domain = domain ? *domain : is_npy || is_utk ? PointDomain{} : declared_domain(file);
    domain = file.domain;
    if (is_npy) return read_npy_points(file);
    if (is_utk) return read_utk_points(file);
    LineReader lines(file.bytes);
    if (lines.next() && trimmed(lines.line()) == ply_magic) return read_ply_points(file);
    return read_text_points(file);
}

}

std::vector<PointSet> read_points_in_box(const std::filesystem::path& path, std::optional<PointDomain>& domain,
                                         const std::function<void(const std::string& sentence)>& told)
{
    std::vector<PointSet> sets = read_all_coordinates(path, domain);
    if (are_flat(sets, domain ? to_unit(0, (*domain)[2]) : 0)) {
        for (PointSet& set : sets) set = without_third(std::move(set));
        if (told) told(printable(path.string()) + ": " + flat_sentence);
    }
    const int axes = domain ? domain->dimension() : 0;
    if (axes > 0 && axes != sets.front().dimension)
        throw InputError::at({path.string()}, fmt::format("has {}D points where the domain has {} ranges: must have "
                                                          "one for each axis",
                                                          sets.front().dimension, axes));
    return sets;
}

std::vector<PointSet> read_points(const std::filesystem::path& path, std::optional<PointDomain> domain,
                                  const std::function<void(const std::string& sentence)>& told)
{
    std::vector<PointSet> sets = read_points_in_box(path, domain, told);
    if (domain && !domain->is_square())
        throw InputError::at({path.string()},
                             "declares a domain whose sides differ; must be a square (cube) here, or have each "
                             "coordinate over its side");
    return sets;
}

std::vector<PointSet> read_own_points(const std::filesystem::path& path, std::optional<CoordinateRange> range)
{
    std::optional<PointDomain> domain = range;
    return read_all_coordinates(path, domain);
}

void append_coordinate(const PointFileContent& file, int line, std::size_t axis, std::string_view word,
                       std::vector<double>& coordinates)
{
    const CoordinateRange& range = file.domain[std::min<std::size_t>(axis, 2)];
    double value = 0;
    if (!parse_number(word, value)) {
        if (!std::ranges::all_of(word, is_printable)) {
            fail_in_point_file(file, line, word, "not text; a point file is text, PLY, NumPy (.npy) or UTK (.bin)");
        }
        fail_in_point_file(file, line, word.empty() ? "nothing beside a comma" : word,
                           allowed_coordinate(0.5 * range.low + 0.5 * range.high, range) +
                               "; a line that is not a point starts with `# `");
    }
    if (!is_coordinate(value, range)) fail_in_point_file(file, line, word, allowed_coordinate(value, range));
    coordinates.push_back(to_unit(value, range));
}

void fail_coordinate_at_byte(const PointFileContent& file, std::size_t axis, std::size_t offset, double value)
{
    throw InputError::at({file.name},
                         fmt::format("byte {}: {}: {}", offset, value, allowed_coordinate(value, file.domain[axis])));
}

void fail_in_point_file(const PointFileContent& file, int line, std::string_view value, std::string_view allowed)
{
    throw InputError::at({file.name, line}, fmt::format("{}: {}", shown(value), allowed));
}

}

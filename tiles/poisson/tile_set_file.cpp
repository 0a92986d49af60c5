#include "tiles/poisson/tile_set_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/geometry/relative_radius.hpp"
#include "tiles/poisson/tile_set_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

namespace poissonlab {
namespace {

constexpr std::string_view magic = "PTILES\r\n";
/// Each version is written for what those before it cannot say; the last one has classes.
constexpr std::uint32_t first_version = 1, second_version = 2, last_version = 3;
constexpr std::uint32_t monotile_version = 4; ///< of files that monotile_points_file.hpp reads
constexpr std::size_t header_size = 128;
constexpr std::size_t checksum_offset = 120;
constexpr std::size_t first_reserved_offset = 88, last_reserved_offset = 116; ///< of either version

/// Writes numbers one after the other, little-endian.
class HeaderWriter
{
public:
    explicit HeaderWriter(std::string& bytes) : bytes_(bytes) {}

    template <class T>
    HeaderWriter& operator<<(T value)
    {
        auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if constexpr (std::endian::native != std::endian::little) std::ranges::reverse(raw);
        bytes_.append(raw.data(), raw.size());
        return *this;
    }

private:
    std::string& bytes_;
};

/// Reads numbers one after the other, little-endian.
class HeaderReader
{
public:
    explicit HeaderReader(std::string_view bytes) : bytes_(bytes) {}

    template <class T>
    T next()
    {
        const T value = load<T>(bytes_, std::endian::little);
        bytes_.remove_prefix(sizeof(T));
        return value;
    }

private:
    std::string_view bytes_;
};

std::size_t coordinate_count(const PoissonTileParameters& p)
{
    return std::size_t{p.tiles} * p.points_per_tile * static_cast<std::size_t>(p.dimension);
}

std::size_t chain_count(const PoissonTileParameters& p)
{
    return p.border == TileBorder::chain ? std::size_t{2} * p.colors * p.colors : 0;
}

std::size_t rank_count(const PoissonTileParameters& p)
{
    return p.ranked ? std::size_t{p.tiles} * p.points_per_tile : 0;
}

/// The bytes that say what classes there are, at the end of the file.
std::size_t class_bytes(const PoissonTileParameters& p)
{
    const std::size_t classes = p.classes.count();
    return classes * sizeof(std::uint32_t) + class_pair_count(classes) * (sizeof(double) + sizeof(std::uint64_t));
}

std::uint32_t version_of(const PoissonTileParameters& p)
{
    if (!p.classes.is_empty()) return last_version;
    const bool is_of_version_1 =
        p.border == TileBorder::strip && p.joint_iterations == 0 && !p.null_peaks && !p.ranked && p.equal_moments == 0;
    return is_of_version_1 ? first_version : second_version;
}

/// A number that must be one of a few: 0 or 1.
template <class T>
T choice(HeaderReader& reader, const char* what, std::uint32_t largest)
{
    const auto value = reader.next<std::uint32_t>();
    if (value > largest) throw InputError(fmt::format("{} = {}: must be at most {}", what, value, largest));
    return static_cast<T>(value);
}

void expect(HeaderReader& reader, const char* what, std::uint32_t expected)
{
    const auto value = reader.next<std::uint32_t>();
    if (value != expected) throw InputError(fmt::format("{} {}: must be {}", what, value, expected));
}

struct Header
{
    std::uint32_t version = 0;
    PoissonTileParameters parameters; ///< but for what classes there are
    std::uint32_t classes = 0;
    std::uint64_t squared_min_distance = 0;
    Overhang overhang;
    std::uint64_t checksum = 0;
    std::uint64_t file_size = 0;
};

Header decode_fields(std::string_view bytes)
{
    Header header;
    PoissonTileParameters& p = header.parameters;
    HeaderReader reader(bytes.substr(magic.size()));
    header.version = reader.next<std::uint32_t>();
    if (header.version == monotile_version)
        throw InputError("has the points of an aperiodic monotile: must be a set of square tiles here");
    if (header.version < first_version || header.version > last_version)
        throw InputError(
            fmt::format("version of the format {}: must be {} to {}", header.version, first_version, last_version));
    expect(reader, "offset of the points", header_size);
    p.kind = choice<PoissonTileKind>(reader, "kind", 2);
    p.dimension = choice<int>(reader, "dimension", 3);
    p.colors = reader.next<std::uint32_t>();
    p.tiles = reader.next<std::uint32_t>();
    p.points_per_tile = reader.next<std::uint32_t>();
    if (header.version == last_version) {
        header.classes = choice<std::uint32_t>(reader, "classes", most_classes);
        if (header.classes == 0) throw InputError("classes = 0: must be at least 1 in version 3");
    } else {
        expect(reader, "reserved number at byte 36:", 0);
    }
    header.squared_min_distance = reader.next<std::uint64_t>();
    p.relative_radius = reader.next<double>();
    p.seed = reader.next<std::uint64_t>();
    p.filling = choice<TileFilling>(reader, "filling", 1);
    p.attempts = reader.next<std::uint32_t>();
    p.factor = reader.next<double>();
    p.lloyd_iterations = reader.next<std::uint32_t>();
    p.repulsion = choice<bool>(reader, "repulsion", 1);
    if (header.version > first_version) {
        p.border = choice<TileBorder>(reader, "border", 1);
        p.joint_iterations = reader.next<std::uint32_t>();
        p.null_peaks = choice<bool>(reader, "null_peaks", 1);
        header.overhang.below = choice<std::int32_t>(reader, "points below squares", tile_units / 2);
        header.overhang.above = choice<std::int32_t>(reader, "points above squares", tile_units / 2);
        p.ranked = choice<bool>(reader, "ranked", 1);
        p.equal_moments = choice<std::uint32_t>(reader, "equal_moments", max_moment_order);
    }
    header.checksum = load<std::uint64_t>(bytes.substr(checksum_offset), std::endian::little);
    return header;
}

/// The first bytes of a binary file, at least those of the header, checked.
Header decode_header(std::string_view bytes)
{
    if (!bytes.starts_with(magic)) throw InputError("is no Poisson tile set: neither .ptiles nor JSON");
    if (bytes.size() < header_size)
        throw InputError(fmt::format("ends after {} bytes: must have a header of {}", bytes.size(), header_size));
    Header header = decode_fields(bytes);
    const std::size_t first = header.version == first_version ? first_reserved_offset : last_reserved_offset;
    const std::string_view reserved = bytes.substr(first, checksum_offset - first);
    if (reserved.find_first_not_of('\0') != std::string_view::npos)
        throw InputError(fmt::format("reserved bytes {} to {}: must be 0", first, checksum_offset - 1));
    check_stored(header.parameters, header.squared_min_distance);
    const std::size_t numbers =
        coordinate_count(header.parameters) + chain_count(header.parameters) + rank_count(header.parameters);
    PoissonTileParameters with_classes;
    with_classes.classes.points.resize(header.classes);
    header.file_size = header_size + numbers * sizeof(std::uint16_t) + class_bytes(with_classes);
    return header;
}

void check_size(const Header& header, std::uint64_t size)
{
    if (size != header.file_size)
        throw InputError(fmt::format("has {} bytes: must be {} for {} tiles of {} points", size, header.file_size,
                                     header.parameters.tiles, header.parameters.points_per_tile));
}

std::vector<std::uint16_t> numbers_of(std::string_view bytes)
{
    std::vector<std::uint16_t> numbers(bytes.size() / sizeof(std::uint16_t));
    if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
    if constexpr (std::endian::native != std::endian::little) {
        for (std::uint16_t& x : numbers) x = static_cast<std::uint16_t>(x << 8 | x >> 8);
    }
    return numbers;
}

/// Reads what classes there are, and checks it with everything else.
void decode_classes(HeaderReader reader, const Header& header, PoissonTileSet& set)
{
    TileClasses& classes = set.parameters.classes;
    for (std::uint32_t i = 0; i < header.classes; ++i) classes.points.push_back(reader.next<std::uint32_t>());
    classes.distances = ClassDistances(header.classes);
    for (std::size_t j = 0; j < header.classes; ++j)
        for (std::size_t i = 0; i <= j; ++i) classes.distances.set(i, j, reader.next<double>());
    for (std::size_t pair = 0; pair < class_pair_count(header.classes); ++pair)
        set.class_squared_distances.push_back(reader.next<std::uint64_t>());
    check_stored(set.parameters, set.squared_min_distance);
}

PoissonTileSet decode_binary(std::string_view bytes)
{
    const Header header = decode_header(bytes);
    check_size(header, bytes.size());
    const std::uint64_t found = tile_file_checksum(bytes);
    if (found != header.checksum)
        throw InputError(fmt::format("is damaged: its checksum is {:016x}, must be {:016x}", found, header.checksum));
    PoissonTileSet set{header.parameters, header.squared_min_distance, {}};
    bytes.remove_prefix(header_size);
    const auto next = [&](std::size_t count) {
        std::vector<std::uint16_t> numbers = numbers_of(bytes.substr(0, count * sizeof(std::uint16_t)));
        bytes.remove_prefix(count * sizeof(std::uint16_t));
        return numbers;
    };
    set.points = next(coordinate_count(set.parameters));
    set.chain_lengths = next(chain_count(set.parameters));
    set.ranks = next(rank_count(set.parameters));
    if (header.classes > 0) decode_classes(HeaderReader(bytes), header, set);
    check_ranks(set);
    const Overhang overhang = overhang_of(set);
    if (overhang.below != header.overhang.below)
        throw InputError(fmt::format("points below squares = {}: must be {}", header.overhang.below, overhang.below));
    if (overhang.above != header.overhang.above)
        throw InputError(fmt::format("points above squares = {}: must be {}", header.overhang.above, overhang.above));
    return set;
}

/// JSON objects start with a brace, after white space.
bool looks_like_json(std::string_view bytes)
{
    const std::size_t start = bytes.find_first_not_of(" \t\r\n");
    return start != std::string_view::npos && bytes[start] == '{';
}

/// Throws `error` again, with the file's name.
[[noreturn]] void fail(const std::string& name, const InputError& error) { throw error.moved_to({name}); }

/// Refuses other files, and files that are cut off, before they are read into memory.
void check_start(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return;
    std::string start(header_size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (!file && file.gcount() == 0) return; // empty, or no permission: reading it says so
    start.resize(static_cast<std::size_t>(file.gcount()));
    if (looks_like_json(start)) return;
    const Header header = decode_header(start);
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error) check_size(header, size);
}

void encode_classes(HeaderWriter& writer, const PoissonTileSet& set)
{
    const TileClasses& classes = set.parameters.classes;
    for (const std::uint32_t points : classes.points) writer << points;
    for (std::size_t j = 0; j < classes.count(); ++j)
        for (std::size_t i = 0; i <= j; ++i) writer << classes.distances.at(i, j);
    for (const std::uint64_t squared : set.class_squared_distances) writer << squared;
}

}

std::uint64_t tile_file_checksum(std::string_view file)
{
    Xxh64 hash;
    hash.add(file.substr(0, checksum_offset));
    hash.add(file.substr(header_size));
    return hash.value();
}

void check_stored(const PoissonTileParameters& p, std::uint64_t squared_min_distance)
{
    check(p);
    if (!(p.factor > 0 && p.factor <= 1))
        throw InputError(fmt::format("factor = {}: must be a number greater than 0 and at most 1", p.factor));
    const double largest = max_min_distance(p.points_per_tile, p.dimension) * tile_units;
    if (static_cast<double>(squared_min_distance) > largest * largest)
        throw InputError(fmt::format("guaranteed squared minimum distance {}: must be at most {:.0f} with {} points "
                                     "per tile",
                                     squared_min_distance, std::floor(largest * largest), p.points_per_tile));
}

PoissonTileSet decode_tile_set(std::string_view bytes, const std::string& name)
{
    try {
        if (!looks_like_json(bytes)) return decode_binary(bytes);
        PoissonTileSet set = tile_set_from_json(bytes);
        check_stored(set.parameters, set.squared_min_distance);
        return set;
    } catch (const InputError& error) {
        fail(name, error);
    }
}

std::string encode_tile_set(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    check_stored(p, set.squared_min_distance);
    if (set.points.size() != coordinate_count(p))
        throw InputError(fmt::format("{} coordinates: must be {}", set.points.size(), coordinate_count(p)));
    if (set.chain_lengths.size() != chain_count(p))
        throw InputError(fmt::format("{} lengths of chains: must be {}", set.chain_lengths.size(), chain_count(p)));
    if (set.class_squared_distances.size() != class_pair_count(p.classes.count()))
        throw InputError(fmt::format("{} distances of pairs of classes: must be {}", set.class_squared_distances.size(),
                                     class_pair_count(p.classes.count())));
    check_ranks(set);
    const Overhang overhang = overhang_of(set);
    std::string bytes(magic);
    bytes.reserve(header_size + 2 * set.points.size());
    HeaderWriter writer(bytes);
    writer << version_of(p) << static_cast<std::uint32_t>(header_size) << static_cast<std::uint32_t>(p.kind)
           << static_cast<std::uint32_t>(p.dimension) << p.colors << p.tiles << p.points_per_tile
           << static_cast<std::uint32_t>(p.classes.count()) << set.squared_min_distance << p.relative_radius << p.seed
           << static_cast<std::uint32_t>(p.filling) << p.attempts << p.factor << p.lloyd_iterations
           << static_cast<std::uint32_t>(p.repulsion) << static_cast<std::uint32_t>(p.border) << p.joint_iterations
           << static_cast<std::uint32_t>(p.null_peaks) << static_cast<std::uint32_t>(overhang.below)
           << static_cast<std::uint32_t>(overhang.above) << static_cast<std::uint32_t>(p.ranked) << p.equal_moments;
    bytes.resize(header_size);
    for (const std::uint16_t x : set.points) writer << x;
    for (const std::uint16_t length : set.chain_lengths) writer << length;
    for (const std::uint16_t rank : set.ranks) writer << rank;
    encode_classes(writer, set);
    std::string sum;
    HeaderWriter(sum) << tile_file_checksum(bytes);
    bytes.replace(checksum_offset, sum.size(), sum);
    return bytes;
}

PoissonTileSet read_tile_set(const std::filesystem::path& path)
{
    try {
        check_start(path);
    } catch (const InputError& error) {
        fail(path.string(), error);
    }
    return decode_tile_set(read_whole_file(path), path.string());
}

void write_tile_set(const std::filesystem::path& path, const PoissonTileSet& set)
{
    const std::string bytes = encode_tile_set(set);
    write_whole_file(path, path.extension() == ".json" ? tile_set_to_json(set) : bytes);
}

}

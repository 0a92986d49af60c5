// The kinds of [[tile_set]] and [[tiling]], and of the command `tiling`: tiles that are drawn or printed and, of
// tilings, tested.
#include "base/files/whole_file.hpp"
#include "base/images/square_image.hpp"
#include "host/kinds/kinds.hpp"
#include "host/scenes/shown_tiling.hpp"
#include "results/file_names.hpp"
#include "results/pictures/tiling_result.hpp"
#include "version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <string>

namespace poissonlab {
namespace {

// Tile sets and tilings of an experiment: their tiles as text, and how random the colours of a tiling are.

inline constexpr int statistics_lags = 320; ///< beyond the 256 after which the shortest hash function repeats

constexpr double least_expected = 10;           // of a cell of a chi-square test
constexpr std::uint64_t statistics_size = 1024; // tiles along each axis
constexpr std::uint64_t statistics_samples = statistics_size * statistics_size / 4;

/// Colours where tiles meet, and how many tiles there are of each.
struct Survey
{
    std::vector<ColorField> fields;
    std::vector<std::uint64_t> tiles; ///< by position in the set, at even places; empty: too many tiles to count
};

/// The places whose colours a tile brings to the fields: its lower left corner, its southern and western edge, or the
/// same faces and the lower one.
std::vector<std::string> field_names(TileKind kind)
{
    if (kind == TileKind::wang) return {"horizontal edges", "vertical edges"};
    if (kind == TileKind::wang_cube)
        return {"northern and southern faces", "eastern and western faces", "top and bottom faces"};
    return {"corners"};
}

std::vector<Color> colors_of(TileKind kind, TileIndex index, WangColors colors)
{
    if (kind == TileKind::wang) {
        const WangTile tile = wang_tile(index, colors);
        return {tile.south, tile.west};
    }
    if (kind == TileKind::wang_cube) {
        const WangCube cube = wang_cube(index, colors.horizontal);
        return {cube.south, cube.west, cube.bottom};
    }
    if (kind == TileKind::cube) return {cube_tile(index, colors.horizontal).bottom.south_west};
    return {corner_tile(index, colors.horizontal).south_west};
}

Survey survey_of(const ShownTiling& config)
{
    const TilingRequest& request = config.request;
    const TileSet set = tile_set_of(request);
    CubeWindow window = config.window;
    window.width = window.height = statistics_size;
    window.depth = 1;
    Survey survey;
    const bool counted = static_cast<double>(statistics_samples) >= least_expected * static_cast<double>(set.size());
    if (counted) survey.tiles.resize(set.size());
    const WangColors all_colors = request.all_colors();
    const std::size_t count = field_names(request.kind).size();
    survey.fields.assign(
        count, {request.colors, statistics_size, std::vector<std::uint8_t>(statistics_size * statistics_size)});
    if (request.kind == TileKind::wang) survey.fields[1].colors = all_colors.vertical;
    stream_tiles(request, window, [&](std::int64_t x, std::int64_t y, auto, std::span<const TileIndex> tiles) {
        const auto row = static_cast<std::uint64_t>(y) - static_cast<std::uint64_t>(window.y);
        auto column = static_cast<std::uint64_t>(x) - static_cast<std::uint64_t>(window.x);
        for (const TileIndex tile : tiles) {
            const auto colors = colors_of(request.kind, tile, all_colors);
            for (std::size_t f = 0; f < count; ++f)
                survey.fields[f].values[row * statistics_size + column] = static_cast<std::uint8_t>(colors[f]);
            if (counted && row % 2 == 0 && column % 2 == 0) ++survey.tiles.at(set.position(tile).value());
            ++column;
        }
    });
    return survey;
}

/// The text of tiles.txt: indices separated by blanks, a row a line, north first; of cubes, layers from the
/// bottom, an empty line between them; of a set, all tiles in one line.
std::string tiles_text(const ShownTiling& config)
{
    std::string text;
    if (config.is_set()) {
        const TileSet set = tile_set_of(config);
        for (std::uint64_t i = 0; i < set.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : " ", set.index(i));
        return text + "\n";
    }
    const std::int64_t end = stepped(config.window.x, config.window.width);
    std::int64_t layer = config.window.z;
    stream_tiles(config.request, config.window,
                 [&](std::int64_t x, auto, std::int64_t z, std::span<const TileIndex> tiles) {
                     if (z != layer) text += "\n";
                     layer = z;
                     text += fmt::format("{}{}", fmt::join(tiles, " "), stepped(x, tiles.size()) == end ? "\n" : " ");
                 });
    return text;
}

/// The statistics of the tiling as it would be without its period, after which it repeats because the config says so.
TilingStatistics tiling_statistics(const ShownTiling& config)
{
    const Survey survey = survey_of(config);
    TilingStatistics statistics;
    statistics.size = statistics_size;
    statistics.samples = statistics_samples;
    if (!survey.tiles.empty()) statistics.tiles = test_frequencies(survey.tiles);
    for (std::size_t f = 0; f < survey.fields.size(); ++f) {
        const ColorField& field = survey.fields[f];
        const auto counts = color_counts(field);
        statistics.colors.push_back({field_names(config.request.kind)[f],
                                     counts,
                                     test_frequencies(counts),
                                     {},
                                     color_autocorrelation(field, statistics_lags)});
    }
    return statistics;
}

constexpr double largest_regions_2d = 0.2071; // octagons of neighbouring corners meet at (1 + sqrt 2) r = 1/2
constexpr double largest_regions_3d = 0.1306; // and at (1 + 2 sqrt 2) r = 1/2
constexpr std::int64_t max_paired_colors = 16;

/// The words of a kind of tiles; of all kinds where they are described.
std::vector<std::string> words_of(const Keys& keys, TileKind kind, const std::vector<std::string>& (*words)(TileKind))
{
    std::vector<std::string> all = words(kind);
    if (keys.is_read()) return all;
    for (const auto& [other, name] : tile_kinds.entries)
        for (const std::string& word : words(other))
            if (std::ranges::find(all, word) == all.end()) all.push_back(word);
    return all;
}

/// Aperiodic sets have one number of colours, which need not be given; vertical edges of Wang tiles can have another
/// number.
void color_keys(Keys& keys, TilingRequest& request, const std::string& word, bool are_needed = false)
{
    const Color own = own_colors(request.kind, word);
    const Color most = word == "corner" ? max_paired_colors : most_colors_of(request.kind);
    request.colors = own > 0 ? own : 2;
    const auto colors =
        keys.integer("colors", request.colors, request.colors, own > 0 ? own : most, "the number of colours")
            .otherwise("2; of aperiodic sets theirs");
    if (are_needed) Keys::Said(colors).required();
    std::optional<Color> vertical;
    keys.integer("vertical_colors", vertical, 2, max_colors, "the number of colours of vertical edges")
        .otherwise("as many as colors")
        .only_if(request.kind == TileKind::wang, "Wang tiles only");
    request.vertical_colors = vertical.value_or(request.colors) == request.colors ? 0 : *vertical;
}

/// Rows of tile indices, north first, all of the same length.
void read_given_tiles(const Keys& keys, const ConfigNode& node, TilingRequest& request)
{
    const auto wrong = [&] { return keys.invalid("indices", "must be rows [[..], [..]] of as many indices each"); };
    if (request.kind != TileKind::wang && request.kind != TileKind::corner)
        throw keys.invalid("indices", "is for Wang and corner tiles");
    const auto* rows = node.get_if<ConfigList>();
    if (!rows || rows->empty()) throw wrong();
    for (const ConfigNode& row : *rows) {
        const auto* tiles = row.get_if<ConfigList>();
        if (!tiles || tiles->empty() || (request.given_width > 0 && tiles->size() != request.given_width))
            throw wrong();
        request.given_width = tiles->size();
        for (const ConfigNode& tile : *tiles) {
            const auto* index = tile.get_if<std::int64_t>();
            if (!index || *index < 0 || *index > std::numeric_limits<TileIndex>::max()) throw wrong();
            request.given.push_back(static_cast<TileIndex>(*index));
        }
    }
    if (request.given.size() > max_shown_tiles)
        throw keys.invalid("indices", fmt::format("must be at most {} tiles", max_shown_tiles));
    request.algorithm = given_tiles_word;
}

/// The indices of a set, which are different ones.
void read_given_set(const Keys& keys, const ConfigNode& node, ShownTiling& s)
{
    const auto* items = node.get_if<ConfigList>();
    if (!items || items->empty() || items->size() > max_shown_tiles)
        throw keys.invalid("indices", "must be a list of tile indices");
    for (const ConfigNode& item : *items) {
        const auto* index = item.get_if<std::int64_t>();
        if (!index || *index < 0) throw keys.invalid("indices", "must be a list of tile indices");
        if (*index > std::numeric_limits<TileIndex>::max() ||
            std::ranges::find(s.request.given, *index) != s.request.given.end())
            throw keys.invalid("indices", "must be different indices of tiles");
        s.request.given.push_back(static_cast<TileIndex>(*index));
    }
    s.set = given_tiles_word;
}

constexpr std::size_t most_hash_tables = 16;
constexpr auto table_sizes_allowed = "whole numbers from 2 to 65536, at most 16 of them";

void read_table_sizes(const Keys& keys, const ConfigNode& node, std::vector<std::uint32_t>& sizes)
{
    const auto* list = node.get_if<ConfigList>();
    const ConfigList items = list ? *list : ConfigList(1, node);
    for (const ConfigNode& item : items)
        if (const auto* size = item.get_if<std::int64_t>(); size && *size >= 2 && *size <= PermutationHash::max_size)
            sizes.push_back(static_cast<std::uint32_t>(*size));
    if (items.empty() || sizes.size() != items.size() || sizes.size() > most_hash_tables)
        throw keys.invalid("entries", std::string("must be ") + table_sizes_allowed);
}

void hash_keys(Keys& keys, TilingRequest& request)
{
    std::string hash = hash_names()[static_cast<std::size_t>(request.hash)];
    keys.word("hash", hash, hash_names(), "what gives lattice points their colours");
    request.hash = static_cast<HashKind>(std::ranges::find(hash_names(), hash) - hash_names().begin());
    keys.value(
            "entries", table_sizes_allowed,
            "entries of the hash function's tables; those of \"long-period\" have no common divisors, and the first is "
            "the range, a multiple of the number of colours",
            [&](const ConfigNode& node) { read_table_sizes(keys, node, request.entries); })
        .at_most(most_hash_tables)
        .otherwise("256 or a little less; of \"long-period\" 24 and six primes near it, or near these");
    keys.check("entries", [&] {
        for (const Color colors : {request.colors, request.all_colors().vertical})
            make_color_hash(request.hash_choice(), colors, 1);
    });
    const std::size_t axes = axes_of(request.kind);
    const std::vector<std::string> names{"MX", "MY", "MZ"};
    std::vector<std::int64_t> p;
    keys.whole_numbers("period", p, 0, {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(axes)},
                       "after how many tiles along x, y (cubes: z) the tiling closes, 0: it does not", 1)
        .at_most(3)
        .otherwise("it does not close");
    for (std::size_t i = 0; i < p.size(); ++i)
        (i == 0 ? request.period.x : i == 1 ? request.period.y : request.period.z) = p[i];
}

void window_keys_of_tiling(Keys& keys, ShownTiling& s)
{
    const std::size_t axes = axes_of(s.request.kind);
    const std::vector<std::string> parts = axes == 1 ? std::vector<std::string>{"X", "width"}
                                           : axes == 2
                                               ? std::vector<std::string>{"X", "Y", "width", "height"}
                                               : std::vector<std::string>{"X", "Y", "Z", "width", "height", "depth"};
    if (axes != 2) s.window = axes == 3 ? CubeWindow{0, 0, 0, 4, 4, 4} : CubeWindow{0, 0, 0, 16, 1, 1};
    std::vector<std::int64_t> w;
    auto window =
        keys.whole_numbers("window", w, -any_integer - 1, parts,
                           "the tiles: the lowest one, and how many along each axis (cubes: X Y Z width height depth; "
                           "dominoes: X width)")
            .at_most(6)
            .otherwise("16 tiles along each axis, of cubes 4");
    if (!s.is_drawn) window.required();
    if (w.empty()) return;
    std::uint64_t tiles = 1;
    for (std::size_t i = axes; i < w.size(); ++i) {
        if (!s.is_drawn && w[i] < 1) throw keys.invalid("window", "sizes must be at least 1");
        if (s.is_drawn && (w[i] < 1 || static_cast<std::uint64_t>(w[i]) > max_shown_tiles / tiles))
            throw keys.invalid("window", fmt::format("must have at least 1 tile along each axis, and at most {} in all",
                                                     max_shown_tiles));
        if (s.is_drawn) tiles *= static_cast<std::uint64_t>(w[i]);
    }
    const auto first = [&](std::size_t axis) { return axis < axes ? w[axis] : 0; };
    const auto size = [&](std::size_t axis) { return axis < axes ? static_cast<std::uint64_t>(w[axes + axis]) : 1; };
    s.window = {first(0), first(1), first(2), size(0), size(1), size(2)};
    if (s.request.is_scanline() && (s.window.x != 0 || s.window.y != 0 || s.window.z != 0))
        throw keys.invalid("window", fmt::format("with {}, {} must be 0", keys.shown("algorithm", s.request.algorithm),
                                                 axes == 3 ? "X, Y and Z" : "X and Y"));
}

/// Tilings with aperiodic sets have no hash function and never close, nor do scanlines; given tiles have nothing but
/// themselves.
void check_own_keys(const Keys& keys, const ShownTiling& s)
{
    const TilingRequest& request = s.request;
    if (request.is_given())
        for (const char* key : {"algorithm", "hash", "entries", "period", "window"})
            if (keys.is_given(key)) throw keys.invalid(key, "has no place beside indices");
    if (request.is_direct() || (request.is_scanline() && s.is_drawn)) return;
    for (const char* key : {"hash", "entries", "period"})
        if (keys.is_given(key))
            throw keys.invalid(key, "has no place beside " + keys.shown("algorithm", request.algorithm));
}

void region_keys(Keys& keys, ShownTiling& s)
{
    const bool is_cube = s.request.kind == TileKind::cube;
    keys.number("regions", s.regions, {0, is_cube ? largest_regions_3d : largest_regions_2d},
                "the Poisson disk radius, in tiles, whose regions are drawn instead; 0: tiles are");
    if (s.regions > 0 && (s.request.kind == TileKind::wang_cube || s.request.kind == TileKind::domino))
        throw keys.invalid("regions", "is for Wang tiles, corner tiles and corner cubes");
}

/// Makes the tile set as the tiles library does.
void check_tiles(const ShownTiling& s)
{
    if (s.is_set()) {
        if (tile_set_of(s).size() > max_shown_tiles)
            throw InputError(fmt::format("more than {} tiles cannot be drawn", max_shown_tiles));
        return;
    }
    if (s.request.is_given()) check_given_tiles(s.request);
    CubeWindow one = s.window;
    one.width = one.height = one.depth = 1;
    stream_tiles(s.request, one, [](auto, auto, auto, auto) {});
}

void kind_key(Keys& keys, ShownTiling& s) { keys.word("kind", s.request.kind, tile_kinds, "the tiles"); }

void tile_set_picture_keys(Keys& keys, ShownTiling& s)
{
    kind_key(keys, s);
    const auto names = words_of(keys, s.request.kind, tile_set_names);
    s.set = names.front();
    keys.word("tiles", s.set, names, "the set");
    keys.value("indices", "a list of tile indices", "the tiles of the set, instead of one that has a name",
               [&](const ConfigNode& node) { read_given_set(keys, node, s); })
        .otherwise("those of the set")
        .excludes("tiles");
    color_keys(keys, s.request, s.set);
    region_keys(keys, s);
    if (keys.is_read()) keys.check([&] { check_tiles(s); });
}

void tiling_keys(Keys& keys, ShownTiling& s)
{
    TilingRequest& request = s.request;
    kind_key(keys, s);
    const auto names = words_of(keys, request.kind, tiling_algorithms);
    request.algorithm = names.front();
    keys.word("algorithm", request.algorithm, names, "how tiles are chosen");
    if (s.is_drawn)
        keys.value("indices", "rows [[..], [..]] of tile indices", "the tiles themselves, north first",
                   [&](const ConfigNode& node) { read_given_tiles(keys, node, request); })
            .otherwise("those of the algorithm");
    color_keys(keys, request, request.algorithm, !s.is_drawn);
    hash_keys(keys, request);
    check_own_keys(keys, s);
    window_keys_of_tiling(keys, s);
    if (s.is_drawn) region_keys(keys, s);
    if (request.is_given()) s.window = {0, 0, 0, request.given_width, request.given.size() / request.given_width, 1};
    if (keys.is_read()) keys.check([&] { check_tiles(s); });
}

std::string tiling_label(const ShownTiling& s)
{
    const TilingRequest& request = s.request;
    const char* kind = tile_kind_words(request.kind);
    const std::string colors = request.vertical_colors > 0
                                   ? fmt::format("{} x {}", request.colors, request.vertical_colors)
                                   : fmt::format("{}", request.colors);
    if (s.set == "corner") return fmt::format("Wang tiles equivalent to corner tiles, {} colours", colors);
    if (request.is_given()) return fmt::format("Given tiling of {}, {} colours", kind, colors);
    std::string label =
        s.is_set() ? fmt::format("{} set of {}, {} colours", s.set == given_tiles_word ? "given" : s.set, kind, colors)
                   : fmt::format("{} tiling of {}, {} colours", request.algorithm, kind, colors);
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

/// Tilings of the plane or of space without end: those that close repeat, and given ones are too small.
bool has_statistics(const ShownTiling& s)
{
    return !s.is_set() && s.request.period == Period{} && !s.request.is_given() && s.request.kind != TileKind::domino;
}

std::map<std::string, std::string> image_metadata(const TilingRequest& request)
{
    return {{"algorithm", request.algorithm},
            {"colors", fmt::format("{}", request.colors)},
            {"seed", fmt::format("{}", request.seed)},
            {"version", POISSONLAB_VERSION_STRING}};
}

/// The members of results.json that the settings decide.
TilingResult described_tiling(const ShownTiling& s)
{
    const TilingRequest& request = s.request;
    const TileSet set = tile_set_of(s);
    TilingResult result;
    result.kind = request.kind;
    result.colors = set.colors().horizontal;
    if (set.colors().vertical != result.colors) result.vertical_colors = set.colors().vertical;
    result.tiles = set.size();
    result.file = file_names::tiles;
    result.regions = s.regions;
    result.set = s.set;
    if (s.is_set()) return result;
    const CubeWindow& w = s.window;
    result.algorithm = request.algorithm;
    result.origin = {w.x, w.y, w.z};
    result.size = {w.width, w.height, w.depth};
    if (request.is_direct()) {
        const HashPeriod period = hash_period_of(request);
        result.hash = hash_names().at(static_cast<std::size_t>(request.hash));
        result.hash_period = {period.x, period.y};
        for (const std::int64_t along : {request.period.x, request.period.y, request.period.z})
            result.period.push_back(static_cast<std::size_t>(along));
    }
    return result;
}

TilingResult make_shown_tiling(const ShownTiling& shown, std::uint64_t seed, const DistributionPlace&,
                               DistributionFiles& files)
{
    ShownTiling own = shown;
    own.request.seed = seed;
    TilingResult result = described_tiling(own);
    write_whole_file(files.add(file_names::tiles), tiles_text(own));
    if (!has_statistics(own)) return result;
    result.statistics = tiling_statistics(own);
    for (ColorStatistics& colors : result.statistics->colors) {
        colors.autocorrelation_file = autocorrelation_file(colors);
        write_square_image(files.add(colors.autocorrelation_file),
                           {2 * statistics_lags + 1, std::move(colors.autocorrelation.z)}, image_metadata(own.request));
        colors.autocorrelation.z.clear();
    }
    return result;
}

std::string tiling_folder(const KindSettings& settings)
{
    const auto& shown = settings.as<ShownTiling>();
    return fmt::format("{}-{}-{}-C-{}", shown.is_set() ? "tile-set" : "tiling", tile_kinds[shown.request.kind],
                       shown.is_set() ? shown.set : shown.request.algorithm, shown.request.colors);
}

}

TileSet tile_set_of(const ShownTiling& shown)
{
    const TilingRequest& request = shown.request;
    if (!shown.is_set()) return tile_set_of(request);
    if (shown.set != given_tiles_word) return make_tile_set(request.kind, request.all_colors(), shown.set);
    const TileSet complete = TileSet::complete(request.kind, request.all_colors());
    for (const TileIndex index : request.given)
        if (index >= complete.size())
            throw InputError(fmt::format("indices: {}: must be less than {}", index, complete.size()));
    return {request.kind, request.all_colors(), request.given};
}

Kind tile_set_picture_kind()
{
    Kind kind = make_kind<ShownTiling>({"tile_set", "", "", "Tile set", "Draw all tiles of a set", false},
                                       tile_set_picture_keys, tiling_label, make_shown_tiling);
    kind.folder = tiling_folder;
    return kind;
}

Kind tiling_kind()
{
    Kind kind = make_kind<ShownTiling>({"tiling", "", "", "Tiling", "Draw a tiling, and test its colours", false},
                                       tiling_keys, tiling_label, make_shown_tiling);
    kind.folder = tiling_folder;
    return kind;
}

Kind printed_tiling_kind()
{
    ShownTiling printed;
    printed.is_drawn = false;
    return make_kind({"", "tiling", "tiling", "Tile indices", "Print the tile indices of a stochastic tiling", false},
                     tiling_keys, tiling_label, make_shown_tiling, printed);
}

}

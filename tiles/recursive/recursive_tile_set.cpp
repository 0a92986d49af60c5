#include "tiles/recursive/recursive_tile_set.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace poissonlab {
namespace {

/// The colours of one side of a tile's cells, from west to east or from south to north.
using SideColors = std::array<Color, 4>;

std::array<SideColors, 4> outer_colors(const RecursiveTile& tile)
{
    std::array<SideColors, 4> sides; // north, east, south, west
    const auto colors = [&](std::uint32_t x, std::uint32_t y) { return wang_colors_of(tile.children[4 * y + x]); };
    for (std::uint32_t i = 0; i < 4; ++i) {
        sides[0][i] = colors(i, 3).north;
        sides[1][i] = colors(3, i).east;
        sides[2][i] = colors(i, 0).south;
        sides[3][i] = colors(0, i).west;
    }
    return sides;
}

bool children_fit_inside(const RecursiveTile& tile)
{
    const auto colors = [&](std::uint32_t x, std::uint32_t y) { return wang_colors_of(tile.children[4 * y + x]); };
    for (std::uint32_t i = 0; i < 4; ++i)
        for (std::uint32_t j = 0; j < 3; ++j)
            if (colors(j, i).east != colors(j + 1, i).west || colors(i, j).north != colors(i, j + 1).south)
                return false;
    return true;
}

/// Equal borders of tiles must be divided equally: each pair of sides with the same colours.
bool borders_fit(const RecursiveTiles& tiles)
{
    std::array<std::array<SideColors, 2>, 2> found{}; // of horizontal and vertical edges, by colour
    std::array<std::array<bool, 2>, 2> is_known{};
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        const WangTile c = wang_colors_of(i);
        const auto sides = outer_colors(tiles[i]);
        const std::array<Color, 4> own{c.north, c.east, c.south, c.west};
        for (std::size_t side = 0; side < 4; ++side) {
            const std::size_t direction = side % 2;
            if (is_known[direction][own[side]] && found[direction][own[side]] != sides[side]) return false;
            is_known[direction][own[side]] = true;
            found[direction][own[side]] = sides[side];
        }
    }
    return true;
}

bool has_every_link(const RecursiveTile& tile, std::uint32_t points_per_tile)
{
    if (tile.links.size() != std::size_t{recursive_cells} * points_per_tile) return false;
    std::vector<bool> seen(tile.links.size());
    for (const RecursiveLink link : tile.links) {
        if (link.point() >= points_per_tile) return false;
        const std::size_t number = std::size_t{link.cell()} * points_per_tile + link.point();
        if (seen[number]) return false;
        seen[number] = true;
    }
    return true;
}

void check_tile_set(std::uint32_t points_per_tile, const RecursiveTiles& tiles)
{
    if (points_per_tile < min_recursive_points || points_per_tile > max_recursive_points)
        throw InputError(fmt::format("{} points per tile: must be from {} to {}", points_per_tile, min_recursive_points,
                                     max_recursive_points));
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        for (const std::uint8_t child : tiles[i].children)
            if (child >= even_wang_tiles)
                throw InputError(fmt::format("tile {} has a smaller tile {}: must be below 8", i, child));
        if (!children_fit_inside(tiles[i]))
            throw InputError(fmt::format("the smaller tiles of tile {} do not fit beside each other", i));
        if (!has_every_link(tiles[i], points_per_tile))
            throw InputError(fmt::format("tile {} does not have each point of its smaller tiles once", i));
    }
    if (!borders_fit(tiles)) throw InputError("borders of one colour are not divided in one way");
}

}

RecursivePlaces places_of_links(const RecursiveTiles& tiles, std::uint32_t points_per_tile)
{
    RecursivePlaces places;
    for (auto& each : places) each.resize(points_per_tile);
    // Every round makes two more bits right, wherever it starts.
    for (int round = 0; round < 16; ++round) {
        const RecursivePlaces before = places;
        for (std::size_t i = 0; i < even_wang_tiles; ++i)
            for (std::uint32_t k = 0; k < points_per_tile; ++k) {
                const RecursiveLink link = tiles[i].links[k];
                places[i][k] = place_in_parent(link.cell(), before[tiles[i].children[link.cell()]][link.point()]);
            }
    }
    return places;
}

RecursiveTileSet::RecursiveTileSet(std::uint32_t points_per_tile, std::uint64_t seed, RecursiveTiles tiles)
    : points_per_tile_(points_per_tile), seed_(seed), tiles_(std::move(tiles))
{
    check_tile_set(points_per_tile_, tiles_);
    places_ = places_of_links(tiles_, points_per_tile_);
}

namespace {

constexpr std::string_view recursive_magic = "RECWANG1";
constexpr std::size_t head_bytes = 20;
constexpr std::size_t checksum_bytes = 8;

std::size_t tile_bytes(std::uint32_t points_per_tile)
{
    return recursive_cells + std::size_t{2} * recursive_cells * points_per_tile;
}

template <class T>
void append(std::string& bytes, T value)
{
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes.push_back(static_cast<char>(value >> 8 * i & 0xFF));
}

RecursiveTileSet tiles_in(std::string_view bytes)
{
    if (!bytes.starts_with(recursive_magic) || bytes.size() < head_bytes + checksum_bytes)
        throw InputError("is not a file of recursive Wang tiles");
    const auto points = load<std::uint32_t>(bytes.substr(8), std::endian::little);
    if (points > max_recursive_points ||
        bytes.size() != head_bytes + even_wang_tiles * tile_bytes(points) + checksum_bytes)
        throw InputError(fmt::format("has {} bytes, which do not fit {} points per tile", bytes.size(), points));
    const std::string_view content = bytes.substr(0, bytes.size() - checksum_bytes);
    if (xxh64_bytes(content) != load<std::uint64_t>(bytes.substr(content.size()), std::endian::little))
        throw InputError("is damaged: its checksum is another one");
    RecursiveTiles tiles;
    std::string_view rest = content.substr(head_bytes);
    for (RecursiveTile& tile : tiles) {
        for (std::uint8_t& child : tile.children) {
            child = static_cast<std::uint8_t>(rest[0]);
            rest.remove_prefix(1);
        }
        for (std::size_t i = 0; i < std::size_t{recursive_cells} * points; ++i) {
            tile.links.push_back({load<std::uint16_t>(rest, std::endian::little)});
            rest.remove_prefix(2);
        }
    }
    return {points, load<std::uint64_t>(bytes.substr(12), std::endian::little), std::move(tiles)};
}

}

std::string recursive_tile_bytes(const RecursiveTileSet& tiles)
{
    std::string bytes(recursive_magic);
    append(bytes, tiles.points_per_tile());
    append(bytes, tiles.seed());
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        for (const std::uint8_t child : tiles.tile(i).children) append(bytes, child);
        for (const RecursiveLink link : tiles.tile(i).links) append(bytes, link.word);
    }
    append(bytes, xxh64_bytes(bytes));
    return bytes;
}

void write_recursive_tiles(const std::filesystem::path& file, const RecursiveTileSet& tiles)
{
    write_whole_file(file, recursive_tile_bytes(tiles));
}

RecursiveTileSet read_recursive_tiles(const std::filesystem::path& file)
{
    const std::string bytes = read_whole_file(file);
    try {
        return tiles_in(bytes);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

}

#include "tiles/aperiodic/tile_list.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace poissonlab {
namespace {

/// Different values in ascending order.
template <class Value>
std::vector<Value> different(std::vector<Value> values)
{
    std::ranges::sort(values);
    const auto rest = std::ranges::unique(values);
    values.erase(rest.begin(), rest.end());
    return values;
}

template <class Value>
Color number_of(const std::vector<Value>& sorted, const Value& value)
{
    return static_cast<Color>(std::ranges::lower_bound(sorted, value) - sorted.begin());
}

/// Pairs of corner colours as one number each: west (south) first.
std::uint64_t pair_of(Color first, Color second) { return std::uint64_t{first} << 32 | second; }

/// The indices at which the values of each colour begin among sorted ones, and the end.
std::vector<std::size_t> begins_of(const std::vector<ListPlace>& sorted, Color colors, auto color_at)
{
    std::vector<std::size_t> begins(std::size_t{colors} + 1);
    for (const ListPlace place : sorted) ++begins[color_at(place) + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    return begins;
}

std::span<const ListPlace> part(const std::vector<ListPlace>& sorted, const std::vector<std::size_t>& begins,
                                Color color)
{
    if (std::size_t{color} + 1 >= begins.size()) return {};
    return std::span(sorted).subspan(begins[color], begins[color + 1] - begins[color]);
}

}

Color color_count(const WangList& list) { return std::max(list.colors.horizontal, list.colors.vertical); }

WangList renumbered(std::vector<WangTile> tiles)
{
    std::vector<Color> horizontal, vertical;
    for (const WangTile& tile : tiles) {
        horizontal.insert(horizontal.end(), {tile.north, tile.south});
        vertical.insert(vertical.end(), {tile.east, tile.west});
    }
    horizontal = different(std::move(horizontal));
    vertical = different(std::move(vertical));
    for (WangTile& tile : tiles)
        tile = {number_of(horizontal, tile.north), number_of(vertical, tile.east), number_of(horizontal, tile.south),
                number_of(vertical, tile.west)};
    return {std::move(tiles), {static_cast<Color>(horizontal.size()), static_cast<Color>(vertical.size())}};
}

CornerList renumbered(std::vector<CornerTile> tiles)
{
    std::vector<Color> colors;
    for (const CornerTile& tile : tiles)
        colors.insert(colors.end(), {tile.north_east, tile.south_east, tile.south_west, tile.north_west});
    colors = different(std::move(colors));
    for (CornerTile& tile : tiles)
        tile = {number_of(colors, tile.north_east), number_of(colors, tile.south_east),
                number_of(colors, tile.south_west), number_of(colors, tile.north_west)};
    return {std::move(tiles), static_cast<Color>(colors.size())};
}

WangList wang_list_of(const CornerList& list)
{
    std::vector<std::uint64_t> horizontal, vertical;
    for (const CornerTile& t : list.tiles) {
        horizontal.insert(horizontal.end(), {pair_of(t.north_west, t.north_east), pair_of(t.south_west, t.south_east)});
        vertical.insert(vertical.end(), {pair_of(t.south_east, t.north_east), pair_of(t.south_west, t.north_west)});
    }
    horizontal = different(std::move(horizontal));
    vertical = different(std::move(vertical));
    WangList wang{{}, {static_cast<Color>(horizontal.size()), static_cast<Color>(vertical.size())}};
    wang.tiles.reserve(list.tiles.size());
    for (const CornerTile& t : list.tiles)
        wang.tiles.push_back({number_of(horizontal, pair_of(t.north_west, t.north_east)),
                              number_of(vertical, pair_of(t.south_east, t.north_east)),
                              number_of(horizontal, pair_of(t.south_west, t.south_east)),
                              number_of(vertical, pair_of(t.south_west, t.north_west))});
    return wang;
}

WangList transposed(const WangList& list)
{
    WangList result{list.tiles, {list.colors.vertical, list.colors.horizontal}};
    for (WangTile& tile : result.tiles) tile = {tile.west, tile.south, tile.east, tile.north};
    return result;
}

TilesByColor::TilesByColor(const WangList& list) : by_west_(list.tiles.size()), by_north_(list.tiles.size())
{
    const auto& tiles = list.tiles;
    std::iota(by_west_.begin(), by_west_.end(), ListPlace{0});
    by_north_ = by_west_;
    std::ranges::stable_sort(by_west_, {}, [&](ListPlace i) { return tiles[i].west; });
    std::ranges::stable_sort(by_north_, {}, [&](ListPlace i) { return pair_of(tiles[i].north, tiles[i].west); });
    west_begins_ = begins_of(by_west_, list.colors.vertical, [&](ListPlace i) { return tiles[i].west; });
    north_begins_ = begins_of(by_north_, list.colors.horizontal, [&](ListPlace i) { return tiles[i].north; });
    wests_.reserve(tiles.size());
    for (const ListPlace i : by_north_) wests_.push_back(tiles[i].west);
}

std::span<const ListPlace> TilesByColor::with_west(Color west) const { return part(by_west_, west_begins_, west); }

std::span<const ListPlace> TilesByColor::with_north(Color north) const { return part(by_north_, north_begins_, north); }

std::span<const ListPlace> TilesByColor::with_north_and_west(Color north, Color west) const
{
    const auto all = with_north(north);
    if (all.empty()) return {};
    const auto first = wests_.begin() + static_cast<std::ptrdiff_t>(north_begins_[north]);
    const auto [begin, end] = std::equal_range(first, first + static_cast<std::ptrdiff_t>(all.size()), west);
    return all.subspan(static_cast<std::size_t>(begin - first), static_cast<std::size_t>(end - begin));
}

namespace {

constexpr std::size_t most_tiles = 65'536;

/// Words numbered in the order in which they come.
class ColorNumbers
{
public:
    Color of(std::string_view word)
    {
        return numbers_.try_emplace(std::string(word), static_cast<Color>(numbers_.size())).first->second;
    }
    Color count() const { return static_cast<Color>(numbers_.size()); }

private:
    std::map<std::string, Color> numbers_;
};

std::vector<std::string_view> words_of(std::string_view line)
{
    std::vector<std::string_view> words;
    for (WordReader reader(line.substr(0, line.find('#'))); reader.next();) words.push_back(reader.word());
    return words;
}

class TileReader
{
public:
    explicit TileReader(const std::string& name) : name_(name) {}

    void read(std::string_view text)
    {
        for (LineReader lines(text); lines.next();) {
            const auto words = words_of(lines.line());
            if (words.empty()) continue;
            if (words.size() == 1 && tiles_.empty() && !has_kind_ && (words[0] == "wang" || words[0] == "corner")) {
                has_kind_ = true;
                is_corner_ = words[0] == "corner";
            } else {
                add(words, lines.number());
            }
        }
        if (tiles_.empty()) throw InputError::at({name_}, "has no tiles");
    }

    ReadTiles result() const
    {
        ReadTiles read;
        if (is_corner_) {
            read.corners.colors = first_.count();
            for (const auto& t : tiles_) read.corners.tiles.push_back({t[0], t[1], t[2], t[3]});
            read.wang = wang_list_of(read.corners);
        } else {
            read.wang.colors = {first_.count(), second_.count()};
            for (const auto& t : tiles_) read.wang.tiles.push_back({t[0], t[1], t[2], t[3]});
        }
        warn(read);
        return read;
    }

private:
    void add(const std::vector<std::string_view>& words, int line)
    {
        if (words.size() != 4)
            throw InputError::at({name_, line}, fmt::format("has {} words: must be four colours, {}", words.size(),
                                                            is_corner_ ? "NE SE SW NW" : "N E S W"));
        ColorNumbers& second = is_corner_ ? first_ : second_;
        const std::array<Color, 4> tile{first_.of(words[0]), second.of(words[1]), first_.of(words[2]),
                                        second.of(words[3])};
        const auto [place, is_new] = lines_.try_emplace(tile, line);
        if (!is_new) throw InputError::at({name_, line}, fmt::format("is the tile of line {} again", place->second));
        if (tiles_.size() == most_tiles)
            throw InputError::at({name_, line}, fmt::format("is a tile too many: at most {}", most_tiles));
        tiles_.push_back(tile);
    }

    /// A tile without any neighbour on some side never occurs in a tiling.
    void warn(ReadTiles& read) const
    {
        std::set<Color> north, east, south, west;
        for (const WangTile& t : read.wang.tiles) {
            north.insert(t.north);
            east.insert(t.east);
            south.insert(t.south);
            west.insert(t.west);
        }
        for (std::size_t i = 0; i < tiles_.size(); ++i) {
            const WangTile& t = read.wang.tiles[i];
            const char* side = !south.contains(t.north)   ? "north"
                               : !west.contains(t.east)   ? "east"
                               : !north.contains(t.south) ? "south"
                               : !east.contains(t.west)   ? "west"
                                                          : nullptr;
            if (side)
                read.warnings.push_back(fmt::format("{}:{}: no tile fits on the {} of this one: it cannot occur in a "
                                                    "tiling",
                                                    printable(name_), lines_.at(tiles_[i]), side));
        }
    }

    std::string name_;
    bool has_kind_ = false;
    bool is_corner_ = false;
    ColorNumbers first_;  ///< of horizontal edges, or of corners
    ColorNumbers second_; ///< of vertical edges
    std::vector<std::array<Color, 4>> tiles_;
    std::map<std::array<Color, 4>, int> lines_;
};

}

ReadTiles parse_tile_list(std::string_view text, const std::string& name)
{
    TileReader reader(name);
    reader.read(text);
    return reader.result();
}

ReadTiles read_tile_list(const std::filesystem::path& file)
{
    return parse_tile_list(read_whole_file(file), file.string());
}

std::string tile_list_text(const WangList& list)
{
    std::string text = "wang # north east south west\n";
    for (const WangTile& t : list.tiles) text += fmt::format("{} {} {} {}\n", t.north, t.east, t.south, t.west);
    return text;
}

std::string tile_list_text(const CornerList& list)
{
    std::string text = "corner # north-east south-east south-west north-west\n";
    for (const CornerTile& t : list.tiles)
        text += fmt::format("{} {} {} {}\n", t.north_east, t.south_east, t.south_west, t.north_west);
    return text;
}

}

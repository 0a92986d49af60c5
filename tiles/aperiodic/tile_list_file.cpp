#include "tiles/aperiodic/tile_list_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <set>

namespace poissonlab {
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

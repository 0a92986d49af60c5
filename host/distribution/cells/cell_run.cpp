// kind = "cells": a map of cells by the colours of corners, with an alphabet.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/cells/cell_files.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/keys/keys.hpp"
#include "host/settings/toml_reader.hpp"
#include "tiles/cells/cell_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace poissonlab {
namespace {

// Alphabets of cells as TOML files: docs/cells.md.

/// "#rrggbb"
CellColor color_of(const std::string& key, const ConfigNode& node)
{
    const auto* text = node.get_if<std::string>();
    std::uint32_t number = 0;
    const bool has_digits = text && text->size() == 7 && text->front() == '#' &&
                            std::from_chars(text->data() + 1, text->data() + 7, number, 16).ptr == text->data() + 7;
    if (!has_digits) throw invalid_node(key, node, "must be a colour, \"#rrggbb\"");
    return {static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8 & 255U),
            static_cast<std::uint8_t>(number & 255U)};
}

/// Reads an alphabet key by key; the file's name stands in each message.
class AlphabetReader
{
public:
    explicit AlphabetReader(const std::filesystem::path& file)
        : file_(file), table_(read_toml(read_whole_file(file), file.string()))
    {}

    CellAlphabet read()
    {
        check_keys(table_, {"name", "size", "corner", "glyphs", "cell", "rule"});
        alphabet_.name = file_.stem().string();
        alphabet_.size = 16;
        Keys keys(table_, {file_.string()}, "");
        keys.text("name", alphabet_.name, "of the alphabet");
        keys.integer("size", alphabet_.size, least_cell_pixels, most_cell_pixels, "pixels along a cell's side");
        read_corners();
        read_glyphs();
        drawings_.resize(cells());
        for (const ConfigNode* cell : read_tables(table_, "cell")) read_cell(*cell->get_if<ConfigTable>());
        fill_by_rule();
        for (std::optional<Drawing>& drawing : drawings_) alphabet_.cells.push_back(std::move(*drawing));
        return std::move(alphabet_);
    }

private:
    using Drawing = std::vector<CellColor>;

    std::size_t cells() const
    {
        const std::size_t pairs = alphabet_.corners.size() * alphabet_.corners.size();
        return pairs * pairs;
    }

    void read_corners()
    {
        for (const ConfigNode* node : read_tables(table_, "corner")) {
            const auto& table = *node->get_if<ConfigTable>();
            check_keys(table, {"name", "color", "weight"});
            CellCorner corner;
            corner.name = fmt::format("{}", alphabet_.corners.size() + 1);
            Keys keys(table, node->location, "");
            keys.text("name", corner.name, "of the colour");
            keys.integer("weight", corner.weight, 0, most_cell_weight, "how often corners have it");
            corner.color = color_of("color", required_node(table, node->location, "[[corner]]", "color"));
            if (std::ranges::any_of(alphabet_.corners, [&](const CellCorner& c) { return c.name == corner.name; }))
                throw InputError::at(node->location,
                                     fmt::format("[[corner]]: there are two of the name {}", corner.name));
            alphabet_.corners.push_back(corner);
        }
        if (alphabet_.corners.size() < 2 || alphabet_.corners.size() > most_cell_colors)
            throw InputError::at({file_.string()}, fmt::format("{} tables [[corner]]: must be 2 to {}",
                                                               alphabet_.corners.size(), most_cell_colors));
        if (alphabet_.weights() == 0)
            throw InputError::at({file_.string()}, "weight: must be more than 0 of one corner");
    }

    void read_glyphs()
    {
        const ConfigNode* node = find(table_, "glyphs");
        if (!node) return;
        const auto* table = node->get_if<ConfigTable>();
        if (!table) throw invalid_node("glyphs", *node, "must be a table, [glyphs]");
        for (const ConfigEntry& entry : *table) {
            if (entry.key.size() != 1)
                throw invalid_node(entry.key, entry.node, "must be called by one letter or sign of ASCII");
            glyphs_[entry.key.front()] = color_of(entry.key, entry.node);
        }
    }

    Color corner_of(const ConfigNode& node) const
    {
        std::vector<std::string> names;
        for (const CellCorner& corner : alphabet_.corners) names.push_back(corner.name);
        const auto* name = node.get_if<std::string>();
        const auto found = name ? std::ranges::find(names, *name) : names.end();
        if (found == names.end())
            throw invalid_node("corners", node, fmt::format("must be one of {}", fmt::join(names, ", ")));
        return static_cast<Color>(found - names.begin());
    }

    /// Takes corners in the order in which one reads: north-west, north-east, south-west, south-east.
    CornerTile corners_of(const ConfigTable& cell, const SourceLocation& where) const
    {
        const ConfigNode& node = required_node(cell, where, "[[cell]]", "corners");
        const auto* list = node.get_if<ConfigList>();
        if (!list || list->size() != 4)
            throw invalid_node("corners", node, "must be four names: north-west, north-east, south-west, south-east");
        CornerTile corners;
        corners.north_west = corner_of((*list)[0]);
        corners.north_east = corner_of((*list)[1]);
        corners.south_west = corner_of((*list)[2]);
        corners.south_east = corner_of((*list)[3]);
        return corners;
    }

    Drawing drawing_of(const ConfigTable& cell, const SourceLocation& where) const
    {
        const ConfigNode& node = required_node(cell, where, "[[cell]]", "rows");
        const auto* list = node.get_if<ConfigList>();
        const auto size = static_cast<std::size_t>(alphabet_.size);
        const auto wrong = [&](const ConfigNode& at) {
            return invalid_node("rows", at, fmt::format("must be {} texts of {} glyphs of ASCII", size, size));
        };
        if (!list || list->size() != size) throw wrong(node);
        Drawing drawing;
        for (const ConfigNode& row : *list) {
            const auto* text = row.get_if<std::string>();
            if (!text || text->size() != size) throw wrong(row);
            for (const char glyph : *text) {
                const auto found = glyphs_.find(glyph);
                if (found == glyphs_.end())
                    throw invalid_node(
                        "rows", row, fmt::format("the glyph {} is not in [glyphs]", printable(std::string(1, glyph))));
                drawing.push_back(found->second);
            }
        }
        return drawing;
    }

    void read_cell(const ConfigTable& cell)
    {
        check_keys(cell, {"corners", "rows", "turned"});
        const SourceLocation where = cell.empty() ? SourceLocation{file_.string()} : cell.front().node.location;
        CornerTile corners = corners_of(cell, where);
        Drawing drawing = drawing_of(cell, where);
        bool is_turned = false;
        Keys(cell, where, "").flag("turned", is_turned, "whether turns of the cell are drawn alike");
        const CornerTile first = corners;
        do {
            std::optional<Drawing>& place = drawings_[corner_index(corners, alphabet_.colors())];
            if (place) throw InputError::at(where, fmt::format("[[cell]]: {} is drawn twice", names_of(corners)));
            place = drawing;
            corners = poissonlab::turned(corners);
            drawing = poissonlab::turned(drawing, alphabet_.size);
        } while (is_turned && corners != first);
    }

    std::string names_of(const CornerTile& t) const
    {
        const auto name = [&](Color color) { return alphabet_.corners[color].name; };
        return fmt::format("{} {} over {} {}", name(t.north_west), name(t.north_east), name(t.south_west),
                           name(t.south_east));
    }

    void fill_by_rule()
    {
        const ConfigNode* node = find(table_, "rule");
        CellRule rule;
        if (node) {
            const auto* table = node->get_if<ConfigTable>();
            if (!table) throw invalid_node("rule", *node, "must be a table, [rule]");
            check_keys(*table, {"border", "border_width"});
            Keys(*table, node->location, "").number("border_width", rule.border_width, {0, 1}, "in cells");
            if (const ConfigNode* border = find(*table, "border")) rule.border = color_of("border", *border);
        }
        for (TileIndex cell = 0; cell < drawings_.size(); ++cell) {
            if (drawings_[cell]) continue;
            const CornerTile corners = corner_tile(cell, alphabet_.colors());
            if (!node)
                throw InputError::at(
                    {file_.string()},
                    fmt::format("the cell {} has no [[cell]], and there is no [rule]", names_of(corners)));
            drawings_[cell] = ruled_cell(alphabet_, rule, corners);
        }
    }

    std::filesystem::path file_;
    ConfigTable table_;
    CellAlphabet alphabet_;
    std::map<char, CellColor> glyphs_;
    std::vector<std::optional<Drawing>> drawings_;
};

/// Throws InputError with the line of what is wrong, and names the corners of a cell that has neither a drawing nor a
/// rule.
CellAlphabet read_cell_alphabet(const std::filesystem::path& file) { return AlphabetReader(file).read(); }

/// Places count modulo 2^32; sums with sides must not overflow.
constexpr std::int64_t farthest_cell = std::int64_t{1} << 52;

void cell_keys(Keys& keys, CellSettings& s)
{
    keys.file("alphabet", s.alphabet, "the drawings of cells by the colours of their corners, TOML",
              "an alphabet of cells")
        .required();
    std::vector<std::int64_t> window(s.window.begin(), s.window.end());
    keys.whole_numbers("window", window, -farthest_cell, {"X", "Y", "width", "height"},
                       "the cells that are drawn: the lower left one, width and height");
    if (window[0] > farthest_cell || window[1] > farthest_cell)
        throw keys.invalid("window", "must begin within 2^52 cells");
    const auto most = static_cast<std::int64_t>(most_map_cells);
    if (window[2] < 1 || window[3] < 1 || window[2] > most || window[3] > most || window[2] * window[3] > most)
        throw keys.invalid("window", fmt::format("must have 1 to {} cells", most_map_cells));
    std::ranges::copy(window, s.window.begin());
}

std::string cell_label(const CellSettings& s) { return "Cells of " + printable(s.alphabet.stem().string()); }

DistributionResult make_cells(const CellSettings& settings, std::uint64_t seed, const DistributionPlace&,
                              DistributionFiles& files)
{
    const DrawnCells drawn = drawn_cells(settings, seed);
    const Color colors = drawn.alphabet.colors();
    std::vector<std::string> names;
    for (const CellCorner& corner : drawn.alphabet.corners) names.push_back(corner.name);
    DistributionResult result;
    result.facts = {fmt::format("{} colours of corners: {}", colors, fmt::join(names, ", ")),
                    fmt::format("{} cells of {} x {} pixels", drawn.alphabet.cells.size(), drawn.alphabet.size,
                                drawn.alphabet.size)};
    write_cell_map(files.add("map.png"), drawn.alphabet, drawn.map);
    result.pictures.push_back({"map.png", "A window of the endless map."});
    write_cell_map(files.add("map-tiles.png"), drawn.alphabet, packed_cells(colors));
    result.pictures.push_back({"map-tiles.png", "All cells, packed so that neighbours fit, also across the borders."});
    write_whole_file(files.add("map.tmx"), tiled_map(drawn.alphabet, drawn.map, "map-tiles.png"));
    write_whole_file(files.add("map.csv"), cell_numbers(drawn.alphabet, drawn.map));
    result.files = {"map.tmx", "map.csv"};
    result.numbers = cell_counts(drawn);
    return result;
}

}

DrawnCells drawn_cells(const CellSettings& settings, std::uint64_t seed)
{
    DrawnCells drawn{read_cell_alphabet(settings.alphabet), {}};
    const auto [x, y, width, height] = settings.window;
    const std::int64_t pixels = std::max(width, height) * drawn.alphabet.size;
    if (pixels > static_cast<std::int64_t>(most_map_side))
        throw InputError(fmt::format("window: {} cells of {} pixels are more than {} along a side of the picture",
                                     std::max(width, height), drawn.alphabet.size, most_map_side));
    drawn.map =
        cell_map(drawn.alphabet, {x, y, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height)}, seed);
    return drawn;
}

std::vector<DistributionNumber> cell_counts(const DrawnCells& drawn)
{
    const Color colors = drawn.alphabet.colors();
    std::vector<std::size_t> corners(colors);
    for (const TileIndex cell : drawn.map.cells) ++corners[corner_tile(cell, colors).south_west];
    const std::set<TileIndex> different(drawn.map.cells.begin(), drawn.map.cells.end());
    std::vector<DistributionNumber> numbers{
        {"cells", "Cells", static_cast<double>(drawn.map.cells.size()), "of the window"},
        {"different", "Different cells", static_cast<double>(different.size()),
         fmt::format("of {}", drawn.alphabet.cells.size())}};
    for (Color c = 0; c < colors; ++c)
        numbers.push_back(
            {fmt::format("corners_{}", c + 1), "Corners of " + drawn.alphabet.corners[c].name,
             static_cast<double>(corners[c]) / static_cast<double>(drawn.map.cells.size()),
             fmt::format("part of all; by weights {:.3g}",
                         static_cast<double>(drawn.alphabet.corners[c].weight) / drawn.alphabet.weights())});
    return numbers;
}

Kind cell_kind()
{
    return make_kind<CellSettings>({"distribution", "cells", "texture cells", "Map of cells",
                                    "Draw an endless map of cells by the colours of their corners, also for Tiled",
                                    false},
                                   cell_keys, cell_label, make_cells);
}

}

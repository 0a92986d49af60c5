#include "host/settings/tilings/polygon_tiling_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/settings/keys/keys.hpp"
#include "host/settings/toml_reader.hpp"
#include "tiles/prototiles/periodic_tiling.hpp"
#include "tiles/prototiles/ring_expression.hpp"
#include "tiles/prototiles/substitution.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <mutex>
#include <set>
#include <sstream>

namespace poissonlab {
namespace {

constexpr std::size_t most_prototiles = 64;
constexpr std::size_t most_placed = 1000; ///< parts of a tile, tiles of a unit or start
constexpr std::size_t most_corners = 200;

// Light ones, so that outlines show.
constexpr std::array prototile_colors{"#f2e2b3", "#7fa8c9", "#d98c6a", "#9bbf85", "#b79bc9", "#e8c35a"};

/// Reads a tiling key by key.
class PolygonTilingReader
{
public:
    PolygonTilingReader(std::string_view text, const std::string& name) : name_(name), table_(read_toml(text, name)) {}

    PolygonTiling read()
    {
        Keys keys(table_, {name_}, "");
        if (find(table_, "rule")) return read_other_lengths(keys);
        check_keys(table_,
                   {"title", "source", "directions", "lengths", "magnification", "period", "unit", "tile", "start"});
        int directions = 12;
        keys.text("title", tiling_.title, "of the tiling");
        keys.text("source", tiling_.source, "where it comes from");
        keys.integer("directions", directions, 8, 12, "of unit vectors");
        if (directions % 2 != 0) throw keys.invalid("directions", "must be 8, 10 or 12");
        tiling_.ring = RootRing(directions);
        read_lengths(keys);
        const auto tables = read_tables(table_, "tile");
        if (tables.empty() || tables.size() > most_prototiles)
            throw problem(fmt::format("{} tables [[tile]]: must be 1 to {}", tables.size(), most_prototiles));
        for (const ConfigNode* table : tables) read_prototile(*table);
        if (find(table_, "period"))
            read_period();
        else
            read_substitution(tables);
        return std::move(tiling_);
    }

private:
    /// rule = "hat": the tiles of a tiling that the program brings, with edges of other lengths.
    PolygonTiling read_other_lengths(Keys& keys)
    {
        check_keys(table_, {"title", "source", "rule", "lengths"});
        std::string rule;
        keys.word("rule", rule, substitution_words(), "a tiling that the program brings");
        tiling_ = PolygonTilingReader(built_in_tiling_text(rule + ".toml"), rule + ".toml").read();
        keys.text("title", tiling_.title, "of the tiling");
        keys.text("source", tiling_.source, "where it comes from");
        read_lengths(keys);
        if (const ConfigNode* node = find(table_, "lengths")) check_lengths(*node);
        return std::move(tiling_);
    }

    void read_lengths(Keys& keys)
    {
        constexpr double largest = 1000;
        const ConfigNode* node = find(table_, "lengths");
        if (!node) return;
        const ConfigList& items = list("lengths", *node, 2, 2, "numbers in quotes");
        for (std::size_t i = 0; i < 2; ++i) {
            const RingPlace length = number("lengths", items[i]);
            tiling_.lengths[i] = tiling_.ring.value(length)[0];
            if (!tiling_.ring.is_real(length) || !(tiling_.lengths[i] > 0 && tiling_.lengths[i] <= largest))
                throw keys.invalid("lengths", fmt::format("must be two real numbers above 0, up to {}", largest));
        }
    }

    /// Refuses turns by odd powers of z, which would exchange the lengths.
    void check_lengths(const ConfigNode& node) const
    {
        const auto turns_evenly = [](const PlacedTile& tile) { return is_even(tile.motion.turn); };
        const auto turn_evenly = [&](const std::vector<PlacedTile>& tiles) {
            return std::ranges::all_of(tiles, turns_evenly);
        };
        if (!std::ranges::all_of(tiling_.parts, turn_evenly) ||
            !std::ranges::all_of(tiling_.starts, [&](const StartPatch& s) { return turn_evenly(s.tiles); }))
            throw invalid_node("lengths", node,
                               fmt::format("is for substitutions whose tiles turn by multiples of {} degrees",
                                           720 / tiling_.ring.order()));
    }

    static bool is_even(const RingPlace& place) { return place.c[1] == 0 && place.c[3] == 0; }

    InputError problem(const std::string& what) const { return InputError::at({name_}, what); }

    RingPlace number(const std::string& key, const ConfigNode& node) const
    {
        const auto* text = node.get_if<std::string>();
        if (!text) throw invalid_node(key, node, "must be a number in quotes, such as \"1 + 2 @60\"");
        return number(key, node, *text);
    }

    RingPlace number(const std::string& key, const ConfigNode& node, std::string_view text) const
    {
        try {
            return ring_expression(tiling_.ring, text);
        } catch (const InputError& error) {
            throw invalid_node(key, node, error.what());
        }
    }

    static const ConfigList& list(const std::string& key, const ConfigNode& node, std::size_t least, std::size_t most,
                                  const std::string& what)
    {
        const auto* items = node.get_if<ConfigList>();
        if (!items || items->size() < least || items->size() > most)
            throw invalid_node(key, node, fmt::format("must be a list of {} to {} {}", least, most, what));
        return *items;
    }

    std::size_t prototile_of(const std::string& name) const
    {
        return static_cast<std::size_t>(std::ranges::find(tiling_.prototiles, name, &Prototile::name) -
                                        tiling_.prototiles.begin());
    }

    void read_prototile(const ConfigNode& node)
    {
        const auto& table = *node.get_if<ConfigTable>();
        check_keys(table, {"name", "color", "corners", "sides", "edges", "outline", "outline_edges", "arcs", "parts"});
        Prototile prototile;
        prototile.color = prototile_colors[tiling_.prototiles.size() % prototile_colors.size()];
        Keys keys(table, node.location, "");
        keys.text("name", prototile.name, "of the tile").required();
        if (!std::ranges::all_of(prototile.name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '-'; }))
            throw keys.invalid("name", "must be one word of letters, digits and -");
        if (prototile_of(prototile.name) < tiling_.prototiles.size())
            throw keys.invalid("name", "is the name of two tiles");
        if (const ConfigNode* color = find(table, "color")) prototile.color = color_of("color", *color);
        read_corners(keys, table, node.location, prototile);
        if (find(table, "edges")) read_letters(keys, "edges", prototile.edges, prototile.corners.size());
        read_outline(keys, table, prototile);
        read_arcs(table, prototile);
        tiling_.prototiles.push_back(std::move(prototile));
    }

    void read_corners(Keys& keys, const ConfigTable& table, const SourceLocation& where, Prototile& prototile) const
    {
        const ConfigNode* sides = find(table, "sides");
        if (sides && find(table, "corners")) throw invalid_node("sides", *sides, "cannot be combined with corners");
        if (sides) return read_regular(keys, prototile);
        const ConfigNode& node = required_node(table, where, "[[tile]]", "corners");
        if (const auto* name = node.get_if<std::string>()) { // another tile's
            const auto other = std::ranges::find(tiling_.prototiles, *name, &Prototile::name);
            if (other == tiling_.prototiles.end())
                throw invalid_node("corners", node, "must be a list, or the name of a tile before this one");
            prototile.corners = other->corners;
            prototile.edges = other->edges;
            return;
        }
        for (const ConfigNode& corner : list("corners", node, 3, most_corners, "numbers in quotes"))
            prototile.corners.push_back(number("corners", corner));
        const std::set<RingPlace> different(prototile.corners.begin(), prototile.corners.end());
        if (different.size() < prototile.corners.size()) throw invalid_node("corners", node, "must be different ones");
        if (!(tiling_.ring.value(quadruple_area(tiling_.ring, prototile.corners))[1] > 1e-6))
            throw invalid_node("corners", node, "must go around the tile counterclockwise");
    }

    void read_regular(Keys& keys, Prototile& prototile) const
    {
        int sides = 3;
        keys.integer("sides", sides, 3, 24, "of a regular polygon");
        const int directions = tiling_.ring.order();
        if (directions % sides != 0)
            throw keys.invalid("sides", fmt::format("must be a divisor of {}, the directions", directions));
        prototile.is_regular = true;
        RingPlace corner;
        for (int i = 0; i < sides; ++i) {
            prototile.corners.push_back(corner);
            corner = corner + tiling_.ring.unit(i * (directions / sides));
        }
    }

    static void read_letters(Keys& keys, const std::string& key, std::string& letters, std::size_t edges)
    {
        keys.text(key, letters, "a letter for each edge");
        const bool are_letters = std::ranges::all_of(letters, [](unsigned char c) { return std::isalnum(c) != 0; });
        if (!are_letters || letters.size() != edges)
            throw keys.invalid(key, fmt::format("must be {} letters or digits, one for each edge", edges));
    }

    void read_outline(Keys& keys, const ConfigTable& table, Prototile& prototile) const
    {
        const ConfigNode* outline = find(table, "outline");
        const ConfigNode* letters = find(table, "outline_edges");
        if (!outline && !letters) return;
        if (!outline || !letters)
            throw invalid_node(outline ? "outline" : "outline_edges", outline ? *outline : *letters,
                               "needs both outline and outline_edges");
        for (const ConfigNode& item : list("outline", *outline, 3, most_corners, "numbers in quotes")) {
            const auto* text = item.get_if<std::string>();
            if (!text) throw invalid_node("outline", item, "must be a number in quotes, such as \"1 + @60 p\"");
            try {
                prototile.outline.push_back(shifted_expression(tiling_.ring, *text));
            } catch (const InputError& error) {
                throw invalid_node("outline", item, error.what());
            }
        }
        read_letters(keys, "outline_edges", prototile.outline_edges, prototile.outline.size());
    }

    void read_arcs(const ConfigTable& table, Prototile& prototile) const
    {
        const ConfigNode* node = find(table, "arcs");
        if (!node) return;
        for (const ConfigNode& item : list("arcs", *node, 1, most_corners, "tables { corner, radius, color }")) {
            const auto* entries = item.get_if<ConfigTable>();
            if (!entries) throw invalid_node("arcs", item, "must be a table { corner, radius, color }");
            check_keys(*entries, {"corner", "radius", "color"});
            TileArc arc;
            const auto last = static_cast<std::int64_t>(prototile.corners.size()) - 1;
            Keys(*entries, item.location, "").integer("corner", arc.corner, 0, last, "around which it goes").required();
            const RingPlace radius = number("radius", required_node(*entries, item.location, "arcs", "radius"));
            arc.radius = tiling_.ring.value(radius)[0];
            if (!tiling_.ring.is_real(radius) || !(arc.radius > 0))
                throw invalid_node("radius", *find(*entries, "radius"), "must be a real number above 0");
            arc.color = color_of("color", required_node(*entries, item.location, "arcs", "color"));
            prototile.arcs.push_back(arc);
        }
    }

    static std::string color_of(const std::string& key, const ConfigNode& node)
    {
        const auto* text = node.get_if<std::string>();
        const bool is_color =
            text && text->size() == 7 && text->front() == '#' &&
            std::ranges::all_of(text->substr(1), [](unsigned char c) { return std::isxdigit(c) != 0; });
        if (!is_color) throw invalid_node(key, node, "must be a colour, \"#rrggbb\"");
        return *text;
    }

    /// "kite at 1 + phi turn @72 mirrored": all but the name may be left out.
    PlacedTile placed(const std::string& key, const ConfigNode& node) const
    {
        constexpr auto allowed = "must be a tile and its place, such as \"kite at 1 + @60 turn @120 mirrored\"";
        const auto* text = node.get_if<std::string>();
        if (!text) throw invalid_node(key, node, allowed);
        std::istringstream words(*text);
        std::string name, word;
        words >> name;
        PlacedTile tile{prototile_of(name), {}};
        if (tile.prototile == tiling_.prototiles.size())
            throw invalid_node(key, node, fmt::format("{}; no tile is called \"{}\"", allowed, name));
        std::string at, turn, *read = nullptr;
        while (words >> word) {
            const bool is_new = (word == "at" && at.empty()) || (word == "turn" && turn.empty());
            if (is_new)
                read = word == "at" ? &at : &turn;
            else if (word == "mirrored" && !tile.motion.is_mirrored)
                tile.motion.is_mirrored = true, read = nullptr;
            else if (read)
                *read += word + " ";
            else
                throw invalid_node(key, node, allowed);
        }
        if (!at.empty()) tile.motion.at = number(key, node, at);
        if (!turn.empty()) tile.motion.turn = number(key, node, turn);
        if (tile.motion.turn == RingPlace{}) throw invalid_node(key, node, "must not turn by 0");
        return tile;
    }

    std::vector<PlacedTile> placed_tiles(const std::string& key, const ConfigNode& node) const
    {
        std::vector<PlacedTile> tiles;
        for (const ConfigNode& item : list(key, node, key == "parts" ? 0 : 1, most_placed, "tiles with their places"))
            tiles.push_back(placed(key, item));
        return tiles;
    }

    /// All similarities have one factor, so that tiles of one level have one size. `size`: that of the first; 0: none.
    void check_turns(const std::string& key, const ConfigNode& node, const std::vector<PlacedTile>& tiles,
                     std::optional<RingPlace>& size) const
    {
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const RingPlace& turn = tiles[i].motion.turn;
            const RingPlace square = tiling_.ring.times(turn, tiling_.ring.conjugate(turn));
            if (size && *size != square)
                throw invalid_node(key, (*node.get_if<ConfigList>())[i],
                                   "must turn by a number of the absolute value that the others have");
            size = square;
        }
    }

    void read_period()
    {
        for (const char* const key : {"magnification", "start", "lengths"})
            if (const ConfigNode* node = find(table_, key))
                throw invalid_node(key, *node, "cannot be combined with period");
        const ConfigNode& period = *find(table_, "period");
        const ConfigList& vectors = list("period", period, 2, 2, "numbers in quotes");
        tiling_.period = {number("period", vectors[0]), number("period", vectors[1])};
        const RingPlace& first = tiling_.period[0];
        const auto area = quadruple_area(tiling_.ring, {RingPlace{}, first, first + tiling_.period[1]});
        if (!(tiling_.ring.value(area)[1] > 1e-6))
            throw invalid_node("period", period, "must be two vectors, the second to the left of the first");
        const ConfigNode& unit = required_node(table_, {name_}, "period", "unit");
        tiling_.unit = placed_tiles("unit", unit);
        std::optional<RingPlace> size{RingPlace{{1, 0, 0, 0}}};
        check_turns("unit", unit, tiling_.unit, size);
        if (!unit_fills_period(tiling_)) throw invalid_node("unit", unit, "must have the area of a period");
        for (const ConfigNode* table : read_tables(table_, "tile"))
            if (const ConfigNode* parts = find(*table->get_if<ConfigTable>(), "parts"))
                throw invalid_node("parts", *parts, "cannot be combined with period");
    }

    void read_substitution(const std::vector<const ConfigNode*>& tables)
    {
        const ConfigNode& node = required_node(table_, {name_}, "no period", "magnification");
        read_magnification(node);
        std::optional<RingPlace> size;
        for (const ConfigNode* table : tables) {
            const ConfigNode& parts =
                required_node(*table->get_if<ConfigTable>(), table->location, "[[tile]]", "parts");
            tiling_.parts.push_back(placed_tiles("parts", parts));
            check_turns("parts", parts, tiling_.parts.back(), size);
        }
        check_vanishing(tables);
        read_starts();
        if (!is_multiplication(tiling_.ring, tiling_.magnification)) check_map(node);
        if (const ConfigNode* lengths = find(table_, "lengths")) check_lengths(*lengths);
        if (!(Substitution(tiling_, 0).inflation() > 1.005))
            throw invalid_node("magnification", node, "must be larger than the turns of the parts");
    }

    void read_magnification(const ConfigNode& node)
    {
        const RootRing& ring = tiling_.ring;
        if (node.get_if<ConfigList>()) {
            const ConfigList& images = list("magnification", node, 2, 2, "numbers in quotes");
            if (ring.order() == 10) throw invalid_node("magnification", node, "must be one number for 10 directions");
            tiling_.magnification = {number("magnification", images[0]), number("magnification", images[1])};
        } else {
            const RingPlace factor = number("magnification", node);
            tiling_.magnification = {factor, ring.times(ring.unit(1), factor)};
            if (!turn_of_magnification(ring, tiling_.magnification))
                throw invalid_node("magnification", node, "must be a real number times a unit vector, or 1 plus one");
        }
    }

    /// The first tile and first parts never vanish, so that addresses may end in zeros.
    void check_vanishing(const std::vector<const ConfigNode*>& tables) const
    {
        for (std::size_t i = 0; i < tables.size(); ++i) {
            const auto& parts = tiling_.parts[i];
            if (parts.empty() ? i == 0 : tiling_.parts[parts[0].prototile].empty())
                throw invalid_node("parts", *find(*tables[i]->get_if<ConfigTable>(), "parts"),
                                   i == 0 && parts.empty() ? "must not be empty for the first tile"
                                                           : "must begin with a tile that has parts");
        }
    }

    /// A linear map that is no multiplication commutes with turns by even powers of z only, and not with mirrors.
    void check_map(const ConfigNode& node) const
    {
        std::optional<bool> mirrored;
        for (const auto& parts : tiling_.parts)
            for (const PlacedTile& part : parts) {
                if (tiling_.parts[part.prototile].empty()) continue;
                const RingPlace& turn = part.motion.turn;
                if (!is_even(turn) || tiling_.ring.times(turn, tiling_.ring.conjugate(turn)) != tiling_.ring.unit(0) ||
                    (mirrored && *mirrored != part.motion.is_mirrored))
                    throw invalid_node("magnification", node,
                                       fmt::format("must be one number where some parts are mirrored, or where they "
                                                   "turn by other numbers than unit vectors at multiples of {} degrees",
                                                   720 / tiling_.ring.order()));
                mirrored = part.motion.is_mirrored;
            }
    }

    void read_starts()
    {
        for (std::size_t i = 0; i < tiling_.prototiles.size(); ++i)
            if (!tiling_.parts[i].empty()) tiling_.starts.push_back({tiling_.prototiles[i].name, {PlacedTile{i, {}}}});
        for (const ConfigNode* node : read_tables(table_, "start")) {
            const auto& table = *node->get_if<ConfigTable>();
            check_keys(table, {"name", "tiles"});
            StartPatch start;
            Keys keys(table, node->location, "");
            keys.text("name", start.name, "of the start").required();
            if (std::ranges::find(tiling_.starts, start.name, &StartPatch::name) != tiling_.starts.end())
                throw keys.invalid("name", "is the name of two tiles or starts");
            const ConfigNode& tiles = required_node(table, node->location, "[[start]]", "tiles");
            start.tiles = placed_tiles("tiles", tiles);
            std::optional<RingPlace> size;
            check_turns("tiles", tiles, start.tiles, size);
            tiling_.starts.push_back(std::move(start));
        }
    }

    std::string name_;
    ConfigTable table_;
    PolygonTiling tiling_;
};

}

const std::vector<std::string>& substitution_words()
{
    static const std::vector<std::string> words{"penrose-kite-dart",
                                                "penrose-rhombs",
                                                "robinson-triangles",
                                                "kite-domino",
                                                "shield",
                                                "chair",
                                                "sphinx",
                                                "hat",
                                                "turtle",
                                                "spectre"};
    return words;
}

const std::vector<std::string>& periodic_words()
{
    static const std::vector<std::string> words{
        "3.3.3.3.3.3", "4.4.4.4",          "6.6.6",     "3.3.3.3.6",       "3.3.3.4.4",
        "3.3.4.3.4",   "3.4.6.4",          "3.6.3.6",   "3.12.12",         "4.6.12",
        "4.8.8",       "matched-octagons", "trihedral", "cheese-sandwich", "anisohedral-octomino"};
    return words;
}

const PolygonTiling& built_in_tiling(const std::string& word)
{
    static std::map<std::string, PolygonTiling> known;
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    const auto found = known.find(word);
    if (found != known.end()) return found->second;
    const std::string name = word + ".toml";
    const std::string_view text = built_in_tiling_text(name);
    if (text.empty()) throw std::out_of_range(word);
    return known.emplace(word, PolygonTilingReader(text, name).read()).first->second;
}

PolygonTiling read_polygon_tiling(const std::filesystem::path& file)
{
    return PolygonTilingReader(read_whole_file(file), file.string()).read();
}

}

// A table [[packing]]: all tiles of a set on a torus with their numbers, puzzles of them, and the graph of a row
// (Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.5 and figures 5.7 to 5.13).
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/textures/chosen_packing.hpp"
#include "host/distribution/textures/packing_pictures.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/distributions/texture_config.hpp"
#include "tiles/packing/closed_packing.hpp"
#include "tiles/packing/packing_search.hpp"
#include "tiles/packing/packings.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>

namespace poissonlab {
namespace {

/// The different sets of edges that meet at the corners of a packing of Wang tiles.
std::size_t corners_in(const TilePacking& packing)
{
    const WangColors colors{packing.colors, packing.colors};
    const auto at = [&](Color x, Color y) {
        return wang_tile(packing.at({x % packing.side(), y % packing.side()}), colors);
    };
    std::set<TileIndex> corners;
    for (Color y = 0; y < packing.side(); ++y)
        for (Color x = 0; x < packing.side(); ++x) {
            const WangTile north_east = at(x + 1, y + 1), south_west = at(x, y);
            corners.insert(wang_index({north_east.west, north_east.south, south_west.east, south_west.north}, colors));
        }
    return corners.size();
}

/// The squares of texture that are stored for texture mapping without seams at corners: D. section 5.4 saves the second
/// half by corner tiles.
void add_memory(const TilePacking& packing, bool is_of_corners, DistributionResult& result)
{
    const auto tiles = static_cast<double>(packing.tiles.size());
    if (packing.kind == TileKind::corner) {
        result.numbers.push_back({"stored_squares", "Squares of texture", tiles, "one packing is enough"});
        return;
    }
    result.numbers.push_back({"corners_in_packing", "Corners in this packing",
                              is_of_corners ? tiles : static_cast<double>(corners_in(packing)),
                              fmt::format("of the {} ways in which edges meet in tilings", packing.tiles.size())});
    result.numbers.push_back(
        {"stored_squares", "Squares of texture", 2 * tiles, "with Wei's second packing, of corners"});
}

void add_indices(const TilePacking& packing, DistributionFiles& files, DistributionResult& result)
{
    std::string text;
    for (Color row = packing.side(); row-- > 0;)
        for (Color column = 0; column < packing.side(); ++column)
            text += fmt::format("{}{}", packing.at({column, row}), column + 1 == packing.side() ? "\n" : " ");
    write_whole_file(files.add("tiles.txt"), text);
    result.files.emplace_back("tiles.txt");
}

/// Names the method, and says which kinds and numbers of colours it has: the same for tables and the command.
void packing_method_keys(Keys& keys, PackingSettings& s)
{
    static const std::vector<std::string> methods{"closed", "printed", "product",   "eulerian", "search",
                                                  "pegs",   "fewest",  "symmetric", "grown"};
    keys.word("method", s.method, methods, "how the packing is made");
    if (!keys.is_given("method")) return;
    const auto refuse = [&](const char* allowed) { throw keys.invalid("method", allowed); };
    const bool is_corner = s.kind == TileKind::corner;
    if (s.method == "printed" && s.colors > 4) refuse("has at most 4 colours");
    if (s.method == "product" && (is_corner || s.colors != 3)) refuse("is for wang tiles of 3 colours");
    if (s.method == "eulerian" && is_corner) refuse("is for wang tiles");
    if (const auto searched = search_method(s.method)) {
        const bool is_symmetric = *searched == PackingMethod::symmetric;
        if (s.colors > most_searched_colors(*searched))
            refuse(is_symmetric ? "has at most 5 colours" : "has at most 4 colours");
        if (!is_symmetric && !s.is_printed && s.colors > 3) refuse("takes years for more than 3 colours");
        if (!is_corner && (s.method == "pegs" || s.method == "fewest")) refuse("is for corner tiles");
        if (is_symmetric && is_corner && s.colors == 2)
            refuse("is for corner tiles of 3 colours or more: of 2 there are none");
    }
    if (s.method == "grown" && (!is_corner || s.colors != 3)) refuse("is for corner tiles of 3 colours");
}

void packing_keys(Keys& keys, PackingSettings& s)
{
    static constexpr WordTable<TileKind, 2> kinds{{{{TileKind::corner, "corner"}, {TileKind::wang, "wang"}}}};
    keys.word("kind", s.kind, kinds, "the kind of tiles");
    Keys::Said colors =
        keys.integer("colors", s.colors, 2, max_colors, "the number of colours, at most 16 in a picture");
    if (s.is_printed) colors.required();
    if (!s.is_printed && s.colors > most_drawn_colors) throw keys.invalid("colors", most_drawn_words);
    packing_method_keys(keys, s);
    if (!s.is_printed)
        keys.word("show", s.show, {"tiles", "puzzle", "dominoes", "graph", "row", "corners"}, "what is drawn");
    if (s.show == "corners" && s.kind == TileKind::corner)
        throw keys.invalid("show", "\"corners\" is for Wang tiles, whose corners do not follow from their edges");
}

std::string packing_label(const PackingSettings& settings)
{
    const char* const kind = settings.kind == TileKind::corner ? "corner tiles" : "Wang tiles";
    if (settings.show == "puzzle") return fmt::format("Puzzle of {}, {} colours", kind, settings.colors);
    if (settings.show == "dominoes") return fmt::format("Dominoes of {} colours", settings.colors);
    if (settings.show == "graph") return fmt::format("Graph of the dominoes of {} colours", settings.colors);
    if (settings.show == "corners")
        return fmt::format("Packing of the corners of {}, {} colours", kind, settings.colors);
    if (settings.show == "row") return fmt::format("Packing of the dominoes of {} colours", settings.colors);
    std::string label = fmt::format("{} packing of {}, {} colours", settings.method, kind, settings.colors);
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

DistributionResult make_packing(const PackingSettings& settings, std::uint64_t seed, const DistributionPlace&,
                                DistributionFiles& files)
{
    DistributionResult result;
    if (settings.show == "dominoes" || settings.show == "row") {
        const bool is_packed = settings.show == "row";
        result.facts = {fmt::format("{} tiles", settings.colors * settings.colors)};
        files.add_marks("dominoes.json", drawn_dominoes(settings.colors, is_packed),
                        is_packed ? "Each once on a circle, neighbours having the same colour where they meet."
                                  : "The complete set: all pairs of colours.",
                        result);
        return result;
    }
    if (settings.show == "graph") {
        files.add_marks("graph.json", drawn_graph(settings.colors),
                        "A vertex a colour, an edge a tile: every Eulerian circuit is a packing.", result);
        return result;
    }
    const TilePacking packing = chosen_packing(settings, seed);
    if (const auto fault = packing_fault(packing)) throw std::logic_error("a packing that is not one: " + *fault);
    result.facts = {fmt::format("{} x {} places", packing.side(), packing.side()),
                    fmt::format("{} tiles, each once", packing.tiles.size())};
    add_indices(packing, files, result);
    add_memory(packing, settings.show == "corners", result);
    if (settings.show == "puzzle")
        files.add_marks("puzzle.json", drawn_puzzle(packing),
                        "Pieces that fit where their colours do, and nowhere else.", result);
    else if (settings.show == "corners")
        files.add_marks("corners.json", drawn_corner_packing(packing),
                        "Edges that meet at corners, each set once; arms go on in the next square.", result);
    else
        files.add_marks("packing.json", drawn_packing(packing),
                        "All tiles with their numbers; opposite sides fit as well. The first row is the lowest.",
                        result);
    return result;
}

}

std::optional<PackingMethod> search_method(const std::string& method)
{
    static constexpr WordTable<PackingMethod, 4> methods{{{{PackingMethod::tiles, "search"},
                                                           {PackingMethod::pegs, "pegs"},
                                                           {PackingMethod::fewest, "fewest"},
                                                           {PackingMethod::symmetric, "symmetric"}}}};
    return methods.find(method);
}

TilePacking chosen_packing(const PackingSettings& settings, std::uint64_t seed)
{
    if (settings.method == "printed") return printed_packing(settings.kind, settings.colors);
    if (settings.method == "product") return printed_product_packing();
    if (settings.method == "eulerian") return euler_packing(settings.colors, seed);
    if (const auto searched = search_method(settings.method))
        return random_packing(settings.kind, settings.colors, *searched, seed);
    if (settings.method == "grown") return grown_packing(printed_packing(settings.kind, 2), seed);
    return closed_packing(settings.kind, settings.colors);
}

Kind packing_kind()
{
    return make_kind<PackingSettings>(
        {"packing", "", "", "Packing", "Draw all tiles of a set on a torus, each once", false}, packing_keys,
        packing_label, make_packing);
}

Kind printed_packing_kind()
{
    PackingSettings printed;
    printed.is_printed = true;
    return make_kind({"", "packing", "packing", "Tile packing",
                      "Print, draw or verify a tile packing, or make a puzzle of it", false},
                     packing_keys, packing_label, make_packing, printed);
}

}

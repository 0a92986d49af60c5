// poissonlab packing: tile packings, printed, drawn, verified, and as puzzles.
#include "app/commands/kind_options.hpp"
#include "app/commands/output_file.hpp"
#include "app/commands/tilings/packing_search_work.hpp"
#include "app/commands/tilings/tile_rows.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/textures/chosen_packing.hpp"
#include "host/kinds/kinds.hpp"
#include "reports/drawings/tile_image.hpp"
#include "reports/drawings/tilings/puzzle_image.hpp"
#include "tiles/packing/closed_packing.hpp"
#include "tiles/packing/packings.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <span>

namespace poissonlab {
namespace {

constexpr auto packing_notes =
    R"(A packing has all C^4 tiles of a complete set on a torus of C^2 x C^2 places, each once, so that neighbours fit.
Prints tile indices, a row of tiles a line, north first, as `tiling` does.
  closed     any C, place and tile follow from each other in constant time (the default)
  printed    C = 2, 3, 4: the dissertation's, found by search
  product    wang, C = 3: the dissertation's, by the product of two circuits of dominoes
  eulerian   wang: the product of two random Eulerian circuits of dominoes, all of them equally likely
  search     C = 2, 3, 4: the first one with tiles tried in random order; good for puzzles. The dissertation's search
             for one of 4 colours took 280 days (corner) and 23 years (wang) of processor time
  pegs       corner, C = 2, 3, 4: the same with the colours of corners, one after another
  fewest     corner, C = 2, 3, 4: where a corner has the fewest colours left first; the fastest of these three for C = 3
  symmetric  C = 2 to 5 (corner: from 3 on): one that is the same after C places to the east and with the next colours;
             a second; corner tiles of five colours seconds or minutes, by the seed
  grown      corner, C = 3: a random one around the printed one of two colours; seconds
--all prints every packing of two colours, with empty lines between: 32 of corner tiles, 203520 of Wang tiles.
--count counts them; of more than two colours nobody has.
Searches use all cores (--threads) and give the same packing on any number of them. --checkpoint FILE keeps a search
every 30 seconds and when it is interrupted; the same command goes on. FILE.lock beside it keeps other processes away.
--shard i/n is for clusters: each share of the tree has a checkpoint of its own, and the counts of all shards add up. A
shard without a packing prints none and exits with status 0; the whole tree without one is an error. A line says how much
of the tree is done, and how many nodes it has by an estimate.
--verify reads such a table: exit status 2 if it is no packing.
--puzzle writes jigsaw pieces for a laser cutter, in millimetres: red lines are cut, blue ones point to the north.
  poissonlab packing corner --colors 3
  poissonlab packing corner --colors 2 --method search --seed 3 --puzzle puzzle.svg --kerf 0.2
  poissonlab packing corner --colors 4 --method fewest --checkpoint search.txt --shard 1/400)";

const OutputFormats packing_formats{{".png", ".svg"}}, puzzle_formats{{".svg"}};

struct PackingOptions : KindOptions
{
    using KindOptions::KindOptions;
    SearchOptions search;
    std::filesystem::path verified; ///< empty: none
    std::filesystem::path out;      ///< a picture; empty: none
    std::filesystem::path puzzle;
    PuzzleCut cut;
};

/// Prints the tiles of rows from north to south.
template <class TileAt>
void print_rows(TileRows& rows, Color side, const TileAt& tile_at)
{
    std::vector<TileIndex> row(side);
    for (Color y = side; y-- > 0;) {
        for (Color x = 0; x < side; ++x) row[x] = tile_at(PackingPlace{x, y});
        rows.add(std::span<const TileIndex>(row), true);
    }
}

void print_packing(TileRows& rows, const TilePacking& packing)
{
    print_rows(rows, packing.side(), [&](PackingPlace place) { return packing.at(place); });
}

/// --all and --count try choices by their numbers, of the method that was asked for, or of tiles.
PackingProblem problem_of(const PackingOptions& options, const PackingSettings& asked)
{
    PackingProblem problem{asked.kind, asked.colors, search_method(asked.method).value_or(PackingMethod::tiles)};
    if (!options.search.all && !options.search.count) problem.seed = options.seed();
    return problem;
}

/// Fails, once all is printed, where the checkpoint lacks the end of the search.
void check_is_written(const FoundPackings& found)
{
    if (!found.unwritten.empty()) throw StorageError(found.unwritten);
}

void print_all_packings(const PackingOptions& options, const PackingSettings& asked)
{
    const FoundPackings found = found_packings(problem_of(options, asked), options.search, options);
    TileRows rows(options.prints_json(), "packings");
    for (const TilePacking& packing : found.packings) {
        if (&packing != &found.packings.front()) rows.next_block();
        print_packing(rows, packing);
    }
    rows.finish();
    check_is_written(found);
}

void print_count(const PackingOptions& options, const PackingSettings& asked)
{
    const FoundPackings found = found_packings(problem_of(options, asked), options.search, options);
    if (options.prints_json())
        fmt::print("{}\n", nlohmann::ordered_json{{"kind", tile_kinds[asked.kind]},
                                                  {"colors", asked.colors},
                                                  {"packings", found.count},
                                                  {"nodes", found.nodes}}
                               .dump(2));
    else
        fmt::print("{}\n", found.count);
    check_is_written(found);
}

void check_drawn_colors(Color colors)
{
    if (colors > most_drawn_colors) throw InputError(fmt::format("packing: --colors {}: {}", colors, most_drawn_words));
}

void write_packing_picture(const TilePacking& packing, const std::filesystem::path& file)
{
    TileGrid grid{packing.kind, {packing.colors, packing.colors}, packing.side(), {}};
    for (Color y = packing.side(); y-- > 0;)
        for (Color x = 0; x < packing.side(); ++x) grid.tiles.push_back(packing.at({x, y}));
    const Drawing drawing = draw_tiles(grid);
    write_picture_file(file, drawing, static_cast<int>(drawing.width));
}

void check_cut(const PackingOptions& options)
{
    const auto [piece, kerf] = options.cut;
    if (!(piece >= 5 && piece <= 500))
        throw InputError(fmt::format("packing: --piece {}: must be a number from 5 to 500, in millimetres", piece));
    // A cut as wide as a third of a knob's neck leaves no knob.
    if (!(kerf >= 0 && kerf <= piece / 50))
        throw InputError(
            fmt::format("packing: --kerf {}: must be a number from 0 to {:.4g}, in millimetres", kerf, piece / 50));
}

/// Refuses options that would change nothing: seeds and threads of what is neither random nor searched, and methods of
/// tables that are not made.
void check_unused_options(const PackingOptions& options, const PackingSettings& asked)
{
    const SearchOptions& search = options.search;
    const bool is_searched = search_method(asked.method).has_value(), tries_all = search.all || search.count;
    if (tries_all && !is_searched && asked.method != "closed")
        throw InputError(
            fmt::format("packing: --method {}: cannot be combined with {}, which searches: must be search, "
                        "pegs, fewest or symmetric",
                        asked.method, search.all ? "--all" : "--count"));
    const bool is_random = (is_searched || asked.method == "eulerian" || asked.method == "grown") && !tries_all;
    if (!options.verified.empty() && asked.method != "closed")
        throw InputError(fmt::format("packing: --method {}: cannot be combined with --verify", asked.method));
    if (options.seed() != 1 && (!is_random || !options.verified.empty()))
        throw InputError(
            fmt::format("packing: --seed {}: is for one packing of --method eulerian, search, pegs, fewest, "
                        "symmetric or grown",
                        options.seed()));
    if (search.threads > 0 && !is_searched && !tries_all)
        throw InputError(fmt::format("packing: --threads {}: is for searches only", search.threads));
    if (options.puzzle.empty() && (options.cut.piece != PuzzleCut{}.piece || options.cut.kerf != PuzzleCut{}.kerf))
        throw InputError("packing: --piece and --kerf need --puzzle");
}

void check_search(const PackingOptions& options, const PackingSettings& asked, bool is_drawn)
{
    const SearchOptions& search = options.search;
    if ((search.all || search.count) && (is_drawn || !options.verified.empty()))
        throw InputError(fmt::format("packing: {} prints only: not with --verify, --out or --puzzle",
                                     search.all ? "--all" : "--count"));
    if (search.all && search.count) throw InputError("packing: --all and --count: only one of them");
    if (search.all && asked.colors != 2)
        throw InputError(
            fmt::format("packing: --all with --colors {}: must be 2, nobody has seen all others", asked.colors));
    const bool is_search = search.all || search.count || search_method(asked.method);
    if ((!search.checkpoint.empty() || !search.shard.empty()) && (!is_search || !options.verified.empty()))
        throw InputError(fmt::format("packing: {}: is for searches only: --all, --count, --method search, pegs, fewest "
                                     "or symmetric",
                                     search.checkpoint.empty() ? "--shard" : "--checkpoint"));
    if (is_search && asked.colors > most_searched_colors(problem_of(options, asked).method))
        throw InputError(fmt::format("packing: --colors {}: must be at most {} to be searched", asked.colors,
                                     most_searched_colors(problem_of(options, asked).method)));
}

void check_packing_options(const PackingOptions& options, const PackingSettings& asked)
{
    const bool is_drawn = !options.out.empty() || !options.puzzle.empty();
    if (is_drawn) check_drawn_colors(asked.colors);
    check_search(options, asked, is_drawn);
    check_unused_options(options, asked);
    check_cut(options);
    if (!options.out.empty()) checked_output("packing", "--out", options.out, packing_formats);
    if (!options.puzzle.empty()) checked_output("packing", "--puzzle", options.puzzle, puzzle_formats);
}

/// A table of a file, which is a packing.
TilePacking verified_packing(const PackingOptions& options, const PackingSettings& asked)
{
    // A table of 64^2 rows is 120 MB of text.
    constexpr Color most_verified_colors = 64;
    if (asked.colors > most_verified_colors)
        throw InputError(
            fmt::format("packing: --colors {}: must be at most {} to verify", asked.colors, most_verified_colors));
    const TilePacking packing = read_packing(options.verified, asked.kind, asked.colors);
    if (const auto fault = packing_fault(packing)) throw InputError::at({options.verified.string()}, *fault);
    return packing;
}

void draw_packing(const PackingOptions& options, const TilePacking& packing)
{
    if (!options.out.empty()) write_packing_picture(packing, output_name(options.out, packing_formats));
    if (!options.puzzle.empty())
        write_whole_file(output_name(options.puzzle, puzzle_formats), drawing_svg(draw_puzzle(packing, options.cut)));
}

void say_verified(const PackingOptions& options, const PackingSettings& asked)
{
    const std::string file = printable(options.verified.string());
    const std::uint64_t tiles = std::uint64_t{asked.colors} * asked.colors * asked.colors * asked.colors;
    if (options.prints_json())
        fmt::print("{}\n",
                   nlohmann::ordered_json{
                       {"file", file}, {"kind", tile_kinds[asked.kind]}, {"colors", asked.colors}, {"tiles", tiles}}
                       .dump(2));
    else
        fmt::print("{}: a packing of the complete {} tile set over {} colours: {} tiles, each once, all neighbours "
                   "fit\n",
                   file, tile_kinds[asked.kind], asked.colors, tiles);
}

void pack(const PackingOptions& options)
{
    const KindSettings read = options.settings();
    const auto& asked = read.as<PackingSettings>();
    check_packing_options(options, asked);
    if (options.search.all) return print_all_packings(options, asked);
    if (options.search.count) return print_count(options, asked);
    if (!options.verified.empty()) {
        draw_packing(options, verified_packing(options, asked));
        return say_verified(options, asked);
    }
    const bool is_drawn = !options.out.empty() || !options.puzzle.empty();
    if (asked.method == "closed" && !is_drawn) {
        TileRows rows(options.prints_json());
        print_rows(rows, asked.colors * asked.colors,
                   [&](PackingPlace place) { return packed_tile(asked.kind, place, asked.colors); });
        return rows.finish();
    }
    FoundPackings found;
    if (search_method(asked.method))
        found = found_packings(problem_of(options, asked), options.search, options);
    else
        found.packings.push_back(chosen_packing(asked, options.seed()));
    TileRows rows(options.prints_json());
    for (const TilePacking& packing : found.packings) { // one, or none of a shard
        draw_packing(options, packing);
        print_packing(rows, packing);
    }
    rows.finish();
    check_is_written(found);
}

}

Command packing_command()
{
    const auto o = std::make_shared<PackingOptions>(*find_kind("", "packing"), "kind");
    return kind_command(
        o,
        joined(
            {{{"--verify", &o->verified, "Check this table instead of making one", "FILE"}},
             o->search.options(),
             {{"--out", &o->out, "Draw the tiles as well (.png, .svg)", "PICTURE"},
              {"--puzzle", &o->puzzle, "Write a jigsaw puzzle as well (.svg)", "FILE"},
              {"--piece", &o->cut.piece, "The side of the puzzle's tiles in millimetres; default: 30", "MM"},
              {"--kerf", &o->cut.kerf,
               "The width of the cut, for which pieces are made larger; default: 0, one cut for two pieces", "MM"}}}),
        packing_notes, pack);
}

}

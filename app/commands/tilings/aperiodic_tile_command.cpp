// poissonlab aperiodic tile: tilings with aperiodic sets, printed or drawn.
#include "app/commands/tilings/aperiodic_choice.hpp"
#include "app/commands/tilings/tile_rows.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "host/aperiodic_tiling/beatty_generator.hpp"
#include "tiles/aperiodic/constructed_tilings.hpp"
#include "tiles/aperiodic/tiling_search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace poissonlab {
namespace {

constexpr auto aperiodic_tile_notes =
    R"(Prints the tiles of a window, numbered from 0 in the order of the set, a row a line, north first.
  beatty        kari, culik: any place from -1048576 (columns: -2^40) on, each tile exact
  substitution  ammann: places from -610 to 1973
  search        any set: a rectangle at 0 0, by trying; large ones may not be found
Corner tiles of --construction lie over a tiling with the set that they are made of.
  poissonlab aperiodic tile kari --window -8 -8 16 16
  poissonlab aperiodic tile ammann --construction rotation --window 0 0 32 32 --out tiling.png)";

constexpr std::size_t most_drawn_tiles_of_tiling = 20'000;
constexpr std::size_t most_stored_tiles = 16'000'000;

enum class TilingMethod
{
    beatty,
    substitution,
    search
};
constexpr WordTable<TilingMethod, 3> tiling_methods{{{{TilingMethod::beatty, "beatty"},
                                                      {TilingMethod::substitution, "substitution"},
                                                      {TilingMethod::search, "search"}}}};

struct AperiodicTileOptions : AskedTiles
{
    std::vector<std::int64_t> window; ///< X Y W H
    std::string method;               ///< empty: the set's own
    WorkOptions work;
};

/// The method that a set has of its own.
TilingMethod own_method(const std::string& set)
{
    if (set == "kari" || set == "culik") return TilingMethod::beatty;
    return set == "ammann" ? TilingMethod::substitution : TilingMethod::search;
}

TilingMethod checked_method(const AperiodicTileOptions& o)
{
    if (o.method.empty()) return own_method(o.set);
    const TilingMethod method = value_of_word("aperiodic tile", "--method", o.method, tiling_methods);
    if (method != TilingMethod::search && method != own_method(o.set))
        throw InputError(fmt::format("aperiodic tile: --method {}: there is none for {}", o.method, o.set));
    return method;
}

TileWindow checked_tile_window(const AperiodicTileOptions& o, TilingMethod method)
{
    const auto& w = o.window;
    if (w.size() != 4) throw InputError(fmt::format("aperiodic tile: --window {}: must be X Y W H", fmt::join(w, " ")));
    if (w[2] < 1 || w[3] < 1)
        throw InputError(fmt::format("aperiodic tile: --window {}: sizes must be at least 1", fmt::join(w, " ")));
    const std::int64_t most = o.out.empty() ? most_stored_tiles : most_drawn_tiles_of_tiling;
    if (w[2] > most / w[3])
        throw InputError(fmt::format("aperiodic tile: --window {}: at most {} tiles can be {}", fmt::join(w, " "), most,
                                     o.out.empty() ? "printed" : "drawn"));
    if (method == TilingMethod::search && (w[0] != 0 || w[1] != 0))
        throw InputError(fmt::format("aperiodic tile: --window {}: by search, X and Y must be 0", fmt::join(w, " ")));
    return {w[0], w[1], static_cast<std::uint64_t>(w[2]), static_cast<std::uint64_t>(w[3])};
}

std::vector<ListPlace> beatty_window(const AperiodicTileOptions& o, const TileWindow& window)
{
    const BeattyTiling tiling(o.set == "kari" ? BeattySet::kari : BeattySet::culik, o.work.seed());
    std::vector<ListPlace> places;
    const DistributionPlace place = o.work.place("aperiodic tile", true);
    if (place.engine == Engine::reference) {
        const auto tiles = reference::beatty_tiles(tiling, window);
        places.assign(tiles.begin(), tiles.end());
    } else {
        check_beatty_window(window);
        const Device& device = place.device();
        check_fits("aperiodic tile", BeattyGenerator::memory(window), device.info());
        BeattyGenerator(device, tiling).stream(window, [&](std::span<const std::uint8_t> tiles) {
            places.insert(places.end(), tiles.begin(), tiles.end());
        });
    }
    return places;
}

std::vector<ListPlace> searched_window(const AperiodicTileOptions& o, const WangList& wang, const TileWindow& window)
{
    bool is_proven = false;
    auto tiles = search_tiling(
        wang, {static_cast<std::size_t>(window.width), static_cast<std::size_t>(window.height), o.work.seed()},
        &is_proven);
    if (tiles) return std::move(*tiles);
    if (is_proven)
        throw InputError(
            fmt::format("aperiodic tile: no {} x {} tiles of {} fit together", window.width, window.height, o.set));
    throw InputError(fmt::format("aperiodic tile: the search found no {} x {} tiles; another --seed or a smaller "
                                 "window may do",
                                 window.width, window.height));
}

/// The tiles of a window, and the set that they belong to.
struct MadeTiling
{
    ChosenTiles chosen;
    std::vector<ListPlace> tiles;
};

MadeTiling made_tiling(const AperiodicTileOptions& o, TilingMethod method, const TileWindow& window)
{
    MadeTiling made{chosen_set("aperiodic tile", o.set), {}};
    const WangList base = made.chosen.wang;
    WindowMaker maker = [&o, method, base](const TileWindow& w) {
        return method == TilingMethod::beatty         ? beatty_window(o, w)
               : method == TilingMethod::substitution ? ammann_tiles_of(w, o.work.seed())
                                                      : searched_window(o, base, w);
    };
    if (!o.construction.empty()) {
        const CornerConstruction construction = chosen_construction("aperiodic tile", o.construction);
        auto steps = repeat_construction(base, construction, o.repeat);
        if (steps.size() < o.repeat)
            throw InputError(
                fmt::format("aperiodic tile: repetition {} is ambiguous: there is none after it", steps.size()));
        for (std::size_t i = 0; i < steps.size(); ++i) {
            // Each step lies over the tiling with the Wang tiles of the one before.
            const WangList below = i == 0 ? base : steps[i - 1].wang;
            maker = [below, construction, corners = steps[i].corners.list, under = std::move(maker)](
                        const TileWindow& w) { return corner_tiles_of(below, corners, construction, w, under); };
        }
        made.chosen = {made.chosen.name, steps.back().wang, steps.back().corners.list};
    }
    made.tiles = maker(window);
    return made;
}

void tile(const AperiodicTileOptions& options)
{
    const TilingMethod method = checked_method(options);
    const TileWindow window = checked_tile_window(options, method);
    options.work.engine("aperiodic tile"); // throws for one that there is not
    const bool is_drawn = !options.out.empty();
    std::filesystem::path out;
    if (is_drawn) out = checked_output("aperiodic tile", "--out", options.out, picture_formats());
    const MadeTiling made = made_tiling(options, method, window);
    const auto width = static_cast<std::size_t>(window.width);
    if (is_drawn) {
        write_tile_picture(out, made.chosen, made.tiles, width, false);
        return;
    }
    TileRows rows(options.as_json);
    for (std::size_t row = 0; row < window.height; ++row)
        rows.add(std::span<const ListPlace>(made.tiles).subspan(row * width, width), true);
    rows.finish();
}

}

Command aperiodic_tile_command()
{
    const auto o = std::make_shared<AperiodicTileOptions>();
    return {"tile", "Print or draw a window of a tiling with an aperiodic set",
            joined({{{"SET", &o->set, aperiodic_set_help},
                     {"--window", &o->window, "The tiles: lower left one, width and height", "X Y W H", required, 4},
                     {"--construction", &o->construction, "Corner tiles of aperiodic convert instead", "NAME"},
                     allowing({"--repeat", &o->repeat, "How often that construction; default: 1", "K"},
                              Integers{1, most_repetitions}),
                     {"--method", &o->method, "beatty, substitution or search; default: the set's own, else search",
                      "NAME"},
                     {"--out", &o->out, "Draw the tiling instead (.svg, .png)", "FILE"},
                     {.name = "--json", .target = &o->as_json, .help = "Print the tiles as JSON", .excludes = "--out"}},
                    o->work.options()}),
            aperiodic_tile_notes, action_on(o, tile)};
}

}

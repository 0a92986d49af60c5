#include "app/commands/tilings/aperiodic_choice.hpp"

#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "host/settings/nearest_key.hpp"
#include "reports/drawings/tile_image.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/tile_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>

namespace poissonlab {
namespace {

/// The error for a set that is neither known nor a file: it may be a slip of the pen.
InputError unknown_set(const std::string& command, const std::string& name)
{
    const auto names = aperiodic_set_names();
    return InputError(fmt::format("{}: SET {}: must be one of \"{}\", or a file of tiles{}", command,
                                  shortened(printable(name)), fmt::join(names, "\", \""), did_you_mean(name, names)));
}

template <class Tile>
std::vector<Tile> tiles_at(const std::vector<Tile>& tiles, std::span<const ListPlace> places)
{
    std::vector<Tile> result;
    for (const ListPlace place : places) result.push_back(tiles.at(place));
    return result;
}

}

ChosenTiles chosen_set(const std::string& command, const std::string& name)
{
    if (const AperiodicSet* const known = find_aperiodic_set(name)) return {name, known->tiles()};
    std::error_code unknown;
    if (!std::filesystem::exists(name, unknown)) throw unknown_set(command, name);
    ReadTiles read = read_tile_list(name);
    for (const std::string& warning : read.warnings) fmt::print(stderr, "poissonlab: note: {}\n", warning);
    ChosenTiles chosen{name, std::move(read.wang)};
    if (read.are_corners()) chosen.corners = std::move(read.corners);
    return chosen;
}

CornerConstruction chosen_construction(const std::string& command, const std::string& word)
{
    return value_of_word(command, "--construction", word, corner_constructions);
}

ChosenTiles constructed_tiles(const std::string& command, const AskedTiles& asked)
{
    ChosenTiles chosen = chosen_set(command, asked.set);
    if (asked.construction.empty()) return chosen;
    auto steps = repeat_construction(chosen.wang, chosen_construction(command, asked.construction), asked.repeat);
    if (steps.size() < asked.repeat)
        throw InputError(fmt::format("{}: repetition {} is ambiguous: there is none after it", command, steps.size()));
    chosen.name += fmt::format(", {} construction{}", asked.construction,
                               asked.repeat > 1 ? fmt::format(" repeated {} times", asked.repeat) : "");
    chosen.wang = std::move(steps.back().wang);
    chosen.corners = std::move(steps.back().corners.list);
    return chosen;
}

void write_tile_picture(const std::filesystem::path& file, const ChosenTiles& chosen, std::span<const ListPlace> places,
                        std::size_t columns, bool has_gaps)
{
    TileGrid grid;
    grid.kind = chosen.corners ? TileKind::corner : TileKind::wang;
    grid.columns = columns;
    grid.tiles.resize(places.size());
    grid.has_gaps = has_gaps;
    const Drawing drawing = chosen.corners ? draw_tiles(grid, tiles_at(chosen.corners->tiles, places))
                                           : draw_tiles(grid, tiles_at(chosen.wang.tiles, places));
    write_picture_file(file, drawing);
}

}

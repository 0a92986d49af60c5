// kind = "cells": a map of cells by the colours of corners, with an alphabet.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/cells/alphabet_file.hpp"
#include "host/distribution/cells/cell_files.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace poissonlab {
namespace {

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

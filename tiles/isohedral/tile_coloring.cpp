// Colourings of isohedral tilings: no two neighbours alike, and perfect ones where they are found.
//
// Kaplan, SIGGRAPH 2008 class notes, II, sections 7.2 and 7.4.1: translations permute colours; those found here are
// cyclic shifts. Whether a colouring is perfect is checked, not assumed.
#include "tiles/isohedral/isohedral_tile.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace poissonlab {
namespace {

constexpr std::uint32_t most_colors = 6;
constexpr int most_tries = 4000; // colourings looked at for each number of colours

/// A tile of the unit at (0, 0) and one beside it.
struct NeighbourPair
{
    std::uint32_t aspect;
    TilePlace other;
};

std::vector<NeighbourPair> neighbour_pairs(const IsohedralTile& tile)
{
    std::vector<NeighbourPair> pairs;
    for (std::uint32_t aspect = 0; aspect < tile.aspects().size(); ++aspect)
        for (std::size_t edge = 0; edge < tile.corners().size(); ++edge)
            pairs.push_back({aspect, tile.neighbour({aspect, 0, 0}, edge)});
    return pairs;
}

/// The least number of times after which a permutation has brought all back.
std::int32_t order_of(const std::vector<std::uint32_t>& permutation)
{
    std::int32_t order = 1;
    for (std::uint32_t color = 0; color < permutation.size(); ++color) {
        std::int32_t length = 1;
        for (std::uint32_t at = permutation[color]; at != color; at = permutation[at]) ++length;
        order = std::lcm(order, length);
    }
    return order;
}

/// The image of a colour under a power of a permutation.
std::uint32_t power_image(const std::vector<std::uint32_t>& permutation, std::uint32_t color, std::int32_t power)
{
    const std::int32_t order = order_of(permutation), steps = (power % order + order) % order;
    for (std::int32_t i = 0; i < steps; ++i) color = permutation[color];
    return color;
}

/// The number of units along each axis after which colours repeat.
std::int32_t units_of(const TileColoring& coloring)
{
    const auto& permutations = coloring.permutations;
    return permutations[0].empty() ? static_cast<std::int32_t>(coloring.colors)
                                   : std::lcm(order_of(permutations[0]), order_of(permutations[1]));
}

class ColoringSearch
{
public:
    ColoringSearch(const IsohedralTile& tile, std::uint32_t colors)
        : tile_(tile), pairs_(neighbour_pairs(tile)), found_{}
    {
        trial_.colors = colors;
        trial_.aspects.assign(tile.aspects().size(), 0);
    }

    /// The first proper colouring, or the first perfect one after it.
    bool run()
    {
        for (std::uint32_t first = 0; first < trial_.colors; ++first)
            for (std::uint32_t second = 0; second < trial_.colors; ++second) {
                trial_.steps = {first, second};
                if (extend(0)) return true;
            }
        return found_.colors > 1;
    }

    const TileColoring& found() const { return found_; }

private:
    bool fits(std::uint32_t aspect) const
    {
        return std::ranges::all_of(pairs_, [&](const NeighbourPair& pair) {
            if (pair.aspect > aspect || pair.other.aspect > aspect) return true;
            if (pair.aspect != aspect && pair.other.aspect != aspect) return true;
            return trial_.aspects[pair.aspect] != trial_.of(pair.other);
        });
    }

    /// True where a perfect colouring was found, or enough was tried.
    bool extend(std::uint32_t aspect)
    {
        if (aspect == trial_.aspects.size()) {
            TileColoring coloring = trial_;
            coloring.is_perfect = is_perfect(tile_, trial_);
            if (found_.colors == 1 || coloring.is_perfect) found_ = coloring;
            return coloring.is_perfect || ++tries_ > most_tries;
        }
        for (std::uint32_t color = 0; color < (aspect == 0 ? 1 : trial_.colors); ++color) {
            trial_.aspects[aspect] = color;
            if (fits(aspect) && extend(aspect + 1)) return true;
        }
        return false;
    }

    const IsohedralTile& tile_;
    std::vector<NeighbourPair> pairs_;
    TileColoring trial_, found_;
    int tries_ = 0;
};

}

std::uint32_t TileColoring::of(const TilePlace& place) const
{
    if (!permutations[0].empty())
        return power_image(permutations[1], power_image(permutations[0], aspects[place.aspect], place.column),
                           place.row);
    const std::int64_t sum = std::int64_t{aspects[place.aspect]} + std::int64_t{steps[0]} * place.column +
                             std::int64_t{steps[1]} * place.row;
    const std::int64_t rest = sum % colors;
    return static_cast<std::uint32_t>(rest < 0 ? rest + colors : rest);
}

bool is_proper(const IsohedralTile& tile, const TileColoring& coloring)
{
    // Permutations that do not commute change which colours meet from unit to unit.
    const std::int32_t units = units_of(coloring);
    for (const NeighbourPair& pair : neighbour_pairs(tile))
        for (std::int32_t column = 0; column < units; ++column)
            for (std::int32_t row = 0; row < units; ++row)
                if (coloring.of({pair.aspect, column, row}) ==
                    coloring.of({pair.other.aspect, pair.other.column + column, pair.other.row + row}))
                    return false;
    return true;
}

bool is_perfect(const IsohedralTile& tile, const TileColoring& coloring)
{
    // Each hop maps the tiles around it; colours must go to colours, one to one.
    const std::int32_t units = units_of(coloring);
    for (std::size_t edge = 0; edge < tile.corners().size(); ++edge) {
        std::map<std::uint32_t, std::uint32_t> image;
        for (std::uint32_t aspect = 0; aspect < tile.aspects().size(); ++aspect)
            for (std::int32_t column = 0; column < units; ++column)
                for (std::int32_t row = 0; row < units; ++row) {
                    const TilePlace place{aspect, column, row};
                    const std::uint32_t from = coloring.of(place), to = coloring.of(tile.image(place, edge));
                    if (image.try_emplace(from, to).first->second != to) return false;
                }
    }
    return true;
}

TileColoring proper_coloring(const IsohedralTile& tile)
{
    TileColoring proper;
    for (std::uint32_t colors = 2; colors <= most_colors; ++colors) {
        ColoringSearch search(tile, colors);
        if (!search.run()) continue;
        const bool is_first = proper.colors == 1;
        if (is_first || search.found().is_perfect) proper = search.found();
        if (proper.is_perfect || !is_first) break;
    }
    return proper;
}

}

#include "tiles/cells/cell_alphabet.hpp"

#include <cmath>

namespace poissonlab {
namespace {

/// The heaviest colour at a place, how much more it weighs than the next one, and how fast that grows per cell.
struct Heaviest
{
    std::size_t color = 0;
    double lead = 0, slope = 0;
};

/// Bilinear weights of colours at (x, y), 0 to 1, y going south.
Heaviest heaviest(const std::array<Color, 4>& from_north_west, std::size_t colors, double x, double y)
{
    const std::array<double, 4> weights{(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
    const std::array<double, 4> along_x{-(1 - y), 1 - y, -y, y}, along_y{-(1 - x), -x, 1 - x, x};
    std::array<double, most_cell_colors> sums{}, slopes_x{}, slopes_y{};
    for (std::size_t i = 0; i < 4; ++i) {
        sums[from_north_west[i]] += weights[i];
        slopes_x[from_north_west[i]] += along_x[i];
        slopes_y[from_north_west[i]] += along_y[i];
    }
    Heaviest found;
    for (std::size_t c = 1; c < colors; ++c)
        if (sums[c] > sums[found.color]) found.color = c;
    std::size_t next = found.color == 0 ? 1 : 0;
    for (std::size_t c = 0; c < colors; ++c)
        if (c != found.color && sums[c] > sums[next]) next = c;
    found.lead = sums[found.color] - sums[next];
    found.slope = std::hypot(slopes_x[found.color] - slopes_x[next], slopes_y[found.color] - slopes_y[next]);
    return found;
}

}

std::uint32_t CellAlphabet::weights() const
{
    std::uint32_t sum = 0;
    for (const CellCorner& corner : corners) sum += corner.weight;
    return sum;
}

std::vector<CellColor> ruled_cell(const CellAlphabet& alphabet, const CellRule& rule, const CornerTile& corners)
{
    const std::array<Color, 4> all{corners.north_west, corners.north_east, corners.south_west, corners.south_east};
    std::vector<CellColor> drawing;
    for (int row = 0; row < alphabet.size; ++row)
        for (int column = 0; column < alphabet.size; ++column) {
            const Heaviest there =
                heaviest(all, alphabet.corners.size(), (column + 0.5) / alphabet.size, (row + 0.5) / alphabet.size);
            const bool is_border = there.lead < rule.border_width / 2 * there.slope;
            drawing.push_back(is_border ? rule.border : alphabet.corners[there.color].color);
        }
    return drawing;
}

std::vector<CellColor> turned(const std::vector<CellColor>& drawing, int size)
{
    std::vector<CellColor> result(drawing.size());
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            result[static_cast<std::size_t>(column * size + size - 1 - row)] =
                drawing[static_cast<std::size_t>(row * size + column)];
    return result;
}

CornerTile turned(const CornerTile& corners)
{
    CornerTile result;
    result.north_east = corners.north_west;
    result.south_east = corners.north_east;
    result.south_west = corners.south_east;
    result.north_west = corners.south_west;
    return result;
}

}

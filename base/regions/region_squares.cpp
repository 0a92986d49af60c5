#include "base/regions/region_squares.hpp"

#include <cmath>

namespace poissonlab {
namespace {

/// The part of the squares that is enough.
constexpr double well_filled = 1.0 / 2;

double positions_in(const FixedRegion& region) { return region.area() / std::pow(region.unit(), 2); }
double positions_in(const FixedSpace& space) { return space.volume() / std::pow(space.unit(), 3); }

template <typename Region>
RegionSquares<Region> halves_of(const Region& region, const RegionSquares<Region>& whole)
{
    using Position = PositionIn<Region>;
    constexpr std::size_t dimension = std::tuple_size_v<Position>;
    RegionSquares<Region> halves{{}, whole.shift - 1};
    const std::uint32_t side = 1u << halves.shift;
    for (const Position& corner : whole.corners)
        for (std::uint32_t half = 0; half < 1u << dimension; ++half) {
            Position low = corner, high;
            for (std::size_t k = 0; k < dimension; ++k) {
                low[k] += (half >> k & 1) * side;
                high[k] = low[k] + (side - 1);
            }
            if (region.side_of({low, high}) != RegionSide::outside) halves.corners.push_back(low);
        }
    return halves;
}

/// `enough`: the search ends where the region fills this part of the squares; above 1 it never does.
template <typename Region>
RegionSquares<Region> found_squares(const Region& region, std::size_t most, double enough = well_filled,
                                    int least_shift = 0)
{
    constexpr int dimension = std::tuple_size_v<PositionIn<Region>>;
    RegionSquares<Region> squares{{{}}, FixedRegion::coordinate_bits};
    const auto is_filled = [&] {
        const double positions = static_cast<double>(squares.corners.size()) * std::pow(2.0, dimension * squares.shift);
        return positions_in(region) >= enough * positions;
    };
    while (squares.shift > least_shift && !squares.corners.empty() && !is_filled()) {
        RegionSquares<Region> halves = halves_of(region, squares);
        if (halves.corners.size() > most) break;
        squares = std::move(halves);
    }
    return squares;
}

}

RegionSquares<FixedRegion> squares_of(const FixedRegion& region, std::size_t most)
{
    return found_squares(region, most);
}
RegionSquares<FixedSpace> squares_of(const FixedSpace& space, std::size_t most) { return found_squares(space, most); }

RegionSquares<FixedRegion> small_squares_of(const FixedRegion& region, std::size_t most, int shift)
{
    return found_squares(region, most, 2, shift);
}

}

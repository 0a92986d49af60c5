#include "tiles/poisson/tile_moments.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr std::array moment_order_names{"first", "second", "third"};

constexpr std::int64_t stored_middle = 32'768;

/// Products of this monomial in the power of a sum of coordinates: order! / (x! y! z!).
double multiplicity(const Monomial& monomial)
{
    constexpr std::array factorials{1.0, 1.0, 2.0, 6.0};
    double result = factorials[order_of(monomial)];
    for (const std::uint8_t exponent : monomial) result /= factorials[exponent];
    return result;
}

/// The number of tiles that have a colour in common with a tile in a tiling, itself among them.
double dependent_tiles(const PoissonTileParameters& p)
{
    if (p.kind == PoissonTileKind::frame) return 1;
    return std::pow(p.kind == PoissonTileKind::edge ? 5 : 3, p.dimension);
}

using AllMoments = std::vector<std::vector<std::int64_t>>; ///< by tile and monomial

MomentOrder moments_of_order(const PoissonTileParameters& p, const std::vector<Monomial>& monomials,
                             const AllMoments& moments, std::uint32_t order)
{
    MomentOrder result{.are_equal = true};
    const double unit = std::pow(stored_scale(p.border).step / double{tile_units}, order);
    double squares = 0; // of differences from the mean, as a symmetric tensor has them
    for (std::size_t m = 0; m < monomials.size(); ++m) {
        if (order_of(monomials[m]) != order) continue;
        std::int64_t low = INT64_MAX, high = INT64_MIN;
        double sum = 0, squared_sum = 0; // of differences from tile 0, which are small
        for (std::uint32_t tile = 0; tile < p.tiles; ++tile) {
            const std::int64_t moment = moments[tile][m];
            low = std::min(low, moment);
            high = std::max(high, moment);
            if (moment != moments[0][m] && result.are_equal) {
                result.are_equal = false;
                result.odd_tile = tile;
            }
            const double difference = static_cast<double>(moment - moments[0][m]) * unit;
            sum += difference;
            squared_sum += difference * difference;
        }
        result.difference = std::max(result.difference, high - low);
        const double mean = sum / p.tiles;
        squares += multiplicity(monomials[m]) * std::max(0.0, squared_sum / p.tiles - mean * mean);
    }
    constexpr std::array factorials{1.0, 1.0, 2.0, 6.0};
    const double step = std::pow(2 * std::numbers::pi, order) / factorials[order];
    result.largest_difference = static_cast<double>(result.difference) * unit;
    result.power = result.are_equal ? 0 : step * step * squares * dependent_tiles(p) / p.points_per_tile;
    return result;
}

}

std::vector<Monomial> monomials_up_to(std::uint32_t order, int dimension)
{
    std::vector<Monomial> monomials;
    for (std::uint32_t sum = 1; sum <= order; ++sum)
        for (std::uint32_t x = sum + 1; x-- > 0;)
            for (std::uint32_t y = sum - x + 1; y-- > 0;)
                if (const std::uint32_t z = sum - x - y; z == 0 || dimension == 3)
                    monomials.push_back(
                        {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(z)});
    return monomials;
}

std::int64_t value_of(const Monomial& monomial, const std::array<std::int64_t, 3>& at)
{
    std::int64_t product = 1;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::uint8_t i = 0; i < monomial[k]; ++i) product *= at[k];
    return product;
}

std::array<std::int64_t, 3> from_middle(std::span<const std::uint16_t> stored)
{
    std::array<std::int64_t, 3> at{};
    for (std::size_t k = 0; k < stored.size(); ++k) at[k] = stored[k] - stored_middle;
    return at;
}

std::vector<std::int64_t> moments_of(const PoissonTileSet& set, std::uint32_t tile,
                                     const std::vector<Monomial>& monomials)
{
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    const std::span<const std::uint16_t> points = set.tile(tile);
    std::vector<std::int64_t> moments(monomials.size());
    for (std::size_t i = 0; i < points.size(); i += dimension) {
        const auto at = from_middle(points.subspan(i, dimension));
        for (std::size_t m = 0; m < monomials.size(); ++m) moments[m] += value_of(monomials[m], at);
    }
    return moments;
}

std::uint32_t TileMoments::equal_order() const
{
    const auto first = std::ranges::find(orders, false, &MomentOrder::are_equal);
    return static_cast<std::uint32_t>(first - orders.begin());
}

TileMoments tile_moments(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    const std::vector<Monomial> monomials = monomials_up_to(max_moment_order, p.dimension);
    AllMoments moments(p.tiles);
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, p.tiles), [&](const auto& range) {
        for (std::uint32_t tile = range.begin(); tile < range.end(); ++tile)
            moments[tile] = moments_of(set, tile, monomials);
    });
    TileMoments result;
    for (std::uint32_t order = 1; order <= max_moment_order; ++order)
        result.orders[order - 1] = moments_of_order(p, monomials, moments, order);
    return result;
}

std::int64_t rounded_moment(std::uint32_t order, std::uint32_t points_per_tile)
{
    std::int64_t most = std::int64_t{order} * points_per_tile;
    for (std::uint32_t i = 1; i < order; ++i) most *= stored_middle;
    return most;
}

std::vector<TileMoments> class_moments(const PoissonTileSet& set)
{
    std::vector<TileMoments> moments;
    for (std::uint32_t of = 0; of < set.parameters.classes.count(); ++of)
        moments.push_back(tile_moments(class_subset(set, of)));
    return moments;
}

void check_moments(const PoissonTileParameters& p, const TileMoments& moments, const std::string& whose)
{
    for (std::uint32_t order = 1; order <= p.equal_moments; ++order) {
        const MomentOrder& found = moments.orders[order - 1];
        const bool is_exact = order <= exact_moment_order(p);
        if (is_exact ? found.are_equal : found.difference <= rounded_moment(order, p.points_per_tile)) continue;
        throw invalid_value({}, "equal_moments", fmt::format("{}", p.equal_moments),
                            fmt::format("must be at most {}: {} moments of {}tile {} are not those of "
                                        "tile 0",
                                        order - 1, moment_order_names[order - 1], whose, found.odd_tile));
    }
}

}

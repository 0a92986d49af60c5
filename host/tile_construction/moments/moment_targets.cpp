#include "host/tile_construction/moments/moment_targets.hpp"

#include "host/tile_construction/filling/tile_filling.hpp"

#include <cmath>

namespace poissonlab {
namespace {

constexpr std::int32_t tile_middle = tile_units / 2;

std::int64_t integer_power(std::int64_t base, std::uint32_t exponent)
{
    std::int64_t result = 1;
    for (std::uint32_t i = 0; i < exponent; ++i) result *= base;
    return result;
}

/// Sums are too large for the sum over all tiles, differences from one tile are not.
std::vector<std::int64_t> mean_moments(const PoissonTileSet& set, const std::vector<Monomial>& monomials)
{
    const std::vector<std::int64_t> first = moments_of(set, 0, monomials);
    std::vector<double> differences(monomials.size());
    for (std::uint32_t tile = 1; tile < set.parameters.tiles; ++tile) {
        const std::vector<std::int64_t> found = moments_of(set, tile, monomials);
        for (std::size_t m = 0; m < monomials.size(); ++m)
            differences[m] += static_cast<double>(found[m] - first[m]) / set.parameters.tiles;
    }
    std::vector<std::int64_t> mean = first;
    for (std::size_t m = 0; m < monomials.size(); ++m) mean[m] += std::llround(differences[m]);
    return mean;
}

/// Their mean, where a square is odd if its number is: so are sums of them.
std::vector<std::int64_t> wanted_moments(const PoissonTileSet& set, const std::vector<Monomial>& monomials)
{
    std::vector<std::int64_t> wanted = mean_moments(set, monomials);
    const auto axes = static_cast<std::size_t>(set.parameters.dimension);
    for (std::size_t m = 0; m < monomials.size(); ++m)
        for (std::size_t k = 0; k < axes; ++k)
            if (monomials[m][k] == 2 && order_of(monomials[m]) == 2) wanted[m] += (wanted[m] - wanted[k]) & 1;
    return wanted;
}

}

double moment_margin(const PoissonTileParameters& p)
{
    if (p.equal_moments == 0) return 0;
    const std::int32_t step = stored_scale(p.border).step;
    return 2 * std::sqrt(static_cast<double>(p.dimension)) * static_cast<double>(exact_reach) * step;
}

MomentTargets::MomentTargets(const PoissonTileSet& set, std::uint32_t order)
    : p_(set.parameters), order_(order), monomials_(monomials_up_to(order, p_.dimension))
{
    const auto add = [&](const PoissonTileSet& of) {
        for (const std::int64_t moment : wanted_moments(of, monomials_)) wanted_.push_back(moment);
    };
    if (p_.classes.is_empty()) add(set);
    for (std::uint32_t of = 0; of < p_.classes.count(); ++of) add(class_subset(set, of));
}

StoredFromMiddle MomentTargets::stored(const UnitPosition& position) const
{
    const std::int32_t step = stored_scale(p_.border).step;
    StoredFromMiddle at{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(p_.dimension); ++k) at[k] = (position[k] - tile_middle) / step;
    return at;
}

std::vector<std::int64_t> MomentTargets::left(std::span<const UnitPosition> others) const
{
    std::vector<std::int64_t> result = wanted_;
    for (const UnitPosition& other : others) {
        const StoredFromMiddle at = stored(other);
        const std::size_t first = class_of(other, p_) * monomials_.size();
        for (std::size_t m = 0; m < monomials_.size(); ++m) result[first + m] -= value_of(monomials_[m], at);
    }
    return result;
}

std::vector<std::int64_t> MomentTargets::left_in_units(std::span<const UnitPosition> others) const
{
    std::vector<std::int64_t> result = left(others);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] *= integer_power(stored_scale(p_.border).step, order_of(monomials_[i % monomials_.size()]));
    return result;
}

bool MomentTargets::make_exact(std::vector<UnitPosition>& inside, std::span<const UnitPosition> others) const
{
    const std::vector<std::int64_t> all_left = left(others);
    for (std::uint32_t of = 0; of < class_count(); ++of)
        if (!make_exact(inside, of, all_left)) return false;
    return true;
}

/// Moves the points of one class.
bool MomentTargets::make_exact(std::vector<UnitPosition>& inside, std::uint32_t of,
                               const std::vector<std::int64_t>& all_left) const
{
    std::vector<std::size_t> own;
    std::vector<StoredFromMiddle> points;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (class_of(inside[i], p_) != of) continue;
        own.push_back(i);
        points.push_back(stored(inside[i]));
    }
    const auto first = all_left.begin() + static_cast<std::ptrdiff_t>(of * monomials_.size());
    const std::vector<std::int64_t> wanted(first, first + static_cast<std::ptrdiff_t>(monomials_.size()));
    if (!make_moments_exact(points, wanted, order_, p_.dimension)) return false;
    const std::int32_t step = stored_scale(p_.border).step;
    for (std::size_t i = 0; i < own.size(); ++i)
        for (std::size_t k = 0; k < static_cast<std::size_t>(p_.dimension); ++k)
            inside[own[i]][k] = static_cast<std::int32_t>(points[i][k]) * step + tile_middle;
    return true;
}

}

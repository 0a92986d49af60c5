#include "host/texture/judged_texture.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// By how many times a tiling's slow power may exceed that of the other set, and the part of all power below which
/// nobody sees it.
///
/// A share of n frequencies of the same power is a mean of n/2 exponential variates, so that the ratio of two pictures
/// of one law has the F distribution. It exceeds 1.5 in 0.3 % of all cases for two tilings of 16 x 16 tiles, which have
/// 192 such frequencies. To an exemplar as wide as 8 tiles, it does so in 6 %, to one as wide as 4 tiles in 28 %: no
/// limit above 1 on that ratio tells a spoiled tiling from chance.
constexpr double most_slow_times = 1.5, least_seen_power = 0.05;

double share_of_new(const TilingJudgement& judgement) { return judgement.novelty[1].value_or(0); }

/// Returns true if the features of a set that is chosen together break at its edges.
bool is_broken(const TilingJudgement& together, const TilingJudgement& apart, int edge, int size)
{
    return together.feature > edge && 2 * together.feature <= size && share_of_new(together) > share_of_new(apart);
}

bool is_uneven(const TilingJudgement& together, const TilingJudgement& apart)
{
    if (!together.slow || !apart.slow) return false;
    const double tiling = together.slow->tiling;
    return tiling > std::max({least_seen_power, together.slow->exemplar, most_slow_times * apart.slow->tiling});
}

}

TextureChoice better_texture(const TilingJudgement& together, const TilingJudgement& apart, int edge, int size)
{
    const auto novelty = [](const TilingJudgement& kept, const TilingJudgement& other) {
        return kept.novelty[1] && other.novelty[1]
                   ? fmt::format("with {:.1f} % of new patches against {:.1f} %", 100 * *kept.novelty[1],
                                 100 * *other.novelty[1])
                   : std::string("without a count of new patches, as the picture is too small");
    };
    if (is_broken(together, apart, edge, size))
        return {false, fmt::format("Fitted one after another, {}: in the set that is chosen together, features of {} "
                                   "pixels break at edges of {} pixels",
                                   novelty(apart, together), together.feature, edge)};
    if (is_uneven(together, apart))
        return {false,
                fmt::format("Fitted one after another, {}: in the set that is chosen together, light that changes "
                            "over more than a tile has {:.1f} % of the power; in the picture it has {:.1f} %",
                            novelty(apart, together), 100 * together.slow->tiling, 100 * together.slow->exemplar)};
    return {true, fmt::format("Chosen together, {}", novelty(together, apart))};
}

}

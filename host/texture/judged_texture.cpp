#include "host/texture/judged_texture.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// By how many times a tiling's slow power may exceed the exemplar's, and the part of all power below which nobody sees
/// it.
constexpr double most_slow_times = 1.5, least_seen_power = 0.05;

double share_of_new(const TilingJudgement& judgement) { return judgement.novelty[1].value_or(0); }

/// Whether the features of a set that is chosen together break at its edges.
bool is_broken(const TilingJudgement& together, const TilingJudgement& apart, int edge, int size)
{
    return together.feature > edge && 2 * together.feature <= size && share_of_new(together) > share_of_new(apart);
}

bool is_uneven(const TilingJudgement& together, const TilingJudgement& apart)
{
    if (!together.slow || !apart.slow) return false;
    const double tiling = together.slow->tiling;
    return tiling > std::max(least_seen_power, most_slow_times * together.slow->exemplar) &&
           tiling > apart.slow->tiling;
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

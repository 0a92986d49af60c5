// Claims of the dissertation about how long tile sets and large sets take to make: times of 2006 stand beside today's.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

/// The time that building the largest set of tiles of a kind took, and of what it is.
std::string building_words(const ClaimSeries& report, const char* sampler, int dimension)
{
    const TileSetRecord* largest = nullptr;
    for (const auto* series : report.all({.sampler = sampler, .dimension = dimension})) {
        const auto& set = series->stored->tile_set;
        if (set && set->build &&
            (largest == nullptr || set->tiles * set->points_per_tile > largest->tiles * largest->points_per_tile))
            largest = &*set;
    }
    if (largest == nullptr) return {};
    return fmt::format("{} {} of {} points: {}", format_count(largest->tiles), sampler, largest->points_per_tile,
                       format_seconds(largest->build->seconds));
}

std::optional<ClaimOutcome> building_times(const ClaimSeries& report)
{
    const std::string words =
        joined_words({building_words(report, "corner-tiles", 2), building_words(report, "edge-tiles", 2),
                      building_words(report, "template-tiles", 2), building_words(report, "sphere-tiles", 3)});
    if (words.empty()) return std::nullopt;
    return ClaimOutcome{Agreement::shown, words};
}

}

std::vector<PaperClaim> claims_about_building()
{
    const SeriesQuery many{.sampler = "dart-throwing", .numbers = {{"relative_radius", 0.70}}, .points = plate_points};
    return {{"4.5-time", "4.5", "Making a tile set takes from several minutes to several hours.",
             "times of 2006 beside those of the largest sets here, on the machine that built them: shown",
             building_times},
            time_claim("6.3-many", "6.3", "Sets of 100,000 points and more are very difficult to make in practice.",
                       {{"262,144 points, ρ = 0.70", many}})};
}

}

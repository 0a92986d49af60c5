// Claims of section 6.11 about corner-based tiles.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/tile_quality.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace poissonlab {
namespace {

using Needs = SeriesQuery::Needs;
using CornerOutcome = std::optional<ClaimOutcome>;

/// The sizes of the sets that were built, which the number of colours decides.
CornerOutcome counts_of_tiles(const ClaimSeries& report)
{
    std::vector<std::string> words;
    for (const char* sampler : {"corner-tiles", "edge-tiles"}) {
        std::map<double, std::uint64_t> counts;
        for (SeriesPointer series : report.all({.sampler = sampler}))
            if (const auto colors = number_parameter(*series, "colors"); colors && series->stored->tile_set)
                counts[*colors] = series->stored->tile_set->tiles;
        for (const auto& [colors, tiles] : counts)
            words.push_back(fmt::format("{}, C = {}: {}", sampler, format_exact(colors), format_count(tiles)));
    }
    if (words.empty()) return std::nullopt;
    return ClaimOutcome{Agreement::shown, joined_words(words)};
}

double colors_of(const ReportSeries& series) { return number_parameter(series, "colors").value_or(0); }

/// Corner tiles of some colours or more, `most` of them, against edge tiles of as many points a tile.
CornerOutcome better_than_edges(const ClaimSeries& report, double fewest_colors, double most, double factor)
{
    Cases cases;
    TileSetFlag flag;
    std::vector<Estimate> ratios;
    for_equal_points(tiling_spectra(report, "corner-tiles"), tiling_spectra(report, "edge-tiles"),
                     [&](const ReportSeries& corner, const ReportSeries& edge) {
                         if (set_size(corner) > most || colors_of(corner) < fewest_colors) return;
                         ratios.push_back(ratio_of(mean_peak(corner), mean_peak(edge)));
                         cases.add(flag.if_several({&corner, &edge}, is_below(ratios.back(), factor)));
                     });
    return cases.outcome("mean peaks " + range_words(ratios, 2) + " times those of edge tiles", flag.words());
}

/// Against every series of the same relative radius without tiles, made by Lloyd relaxation and repulsion.
CornerOutcome radial_like_untiled(const ClaimSeries& report)
{
    const auto references = report.all({.sampler = "lloyd",
                                        .numbers = {{"until_relative_radius", 0.75}},
                                        .points = usual_points,
                                        .needs = Needs::spectrum});
    Cases cases;
    TileSetFlag flag;
    std::vector<Estimate> values;
    for (SeriesPointer series : tiling_spectra(report, "corner-tiles"))
        for (SeriesPointer reference : references) {
            if (colors_of(*series) < 4 || points_per_tile(*series) < 32) continue;
            const auto distance = distance_of_curves(*series, *reference);
            if (!distance) continue;
            values.push_back(*distance);
            cases.add(flag.if_several({series}, is_below(*distance, 0.1)));
        }
    return cases.outcome(range_words(values, 2) + " on average", flag.words());
}

CornerOutcome less_anisotropy(const ClaimSeries& report)
{
    Cases cases;
    TileSetFlag flag;
    std::vector<Estimate> differences;
    for (const char* sampler : {"edge-tiles", "template-tiles"})
        for_equal_points(tiling_spectra(report, "corner-tiles"), tiling_spectra(report, sampler),
                         [&](const ReportSeries& corner, const ReportSeries& other) {
                             if (colors_of(corner) < 4) return;
                             differences.push_back(
                                 difference_of(peak_excess_anisotropy(other), peak_excess_anisotropy(corner)));
                             cases.add(flag.if_several({&corner, &other}, is_above(differences.back(), 3)));
                         });
    return cases.outcome(range_words(differences, 2) + " dB less", flag.words());
}

CornerOutcome plates_better(const ClaimSeries& report)
{
    Cases cases(fewest_pictures);
    std::vector<double> ratios;
    const auto compare = [&](const ReportSeries& corner, const ReportSeries& other) {
        if (number_parameter(corner, "relative_radius") != number_parameter(other, "relative_radius") &&
            number_parameter(other, "relative_radius").value_or(1) > 0.75)
            return; // a larger radius aliases more by itself
        const auto finding = has_weaker_plates(report, corner, other);
        if (!finding) return;
        ratios.push_back(report.false_rings(corner)->strength / report.false_rings(other)->strength);
        cases.add(*finding);
    };
    for (const char* sampler : {"edge-tiles", "template-tiles"})
        for_equal_points(tiling_plates(report, "corner-tiles"), tiling_plates(report, sampler), compare);
    return cases.outcome("false plates " + range_words(ratios, 2) + " times as strong");
}

std::vector<TimedSeries> timed_corner_tiles()
{
    std::vector<TimedSeries> timed;
    for (const int colors : {4, 6, 8})
        for (const int points : {32, 48, 64})
            timed.push_back({fmt::format("C = {}, N = {}", colors, points),
                             {.sampler = "corner-tiles",
                              .numbers = {{"colors", colors}, {"points_per_tile", points}},
                              .points = usual_points}});
    return timed;
}

bool is_good_corner_set(SeriesPointer series) { return colors_of(*series) >= 3 && points_per_tile(*series) >= 32; }

/// The mean number of points of a tile in the regions of this name.
std::optional<double> region_points_of(const ReportSeries& series, const std::string& name)
{
    if (!series.stored->tile_set) return std::nullopt;
    const auto& regions = series.stored->tile_set->regions;
    const auto found = std::ranges::find(regions, name, &RegionPoints::name);
    return found == regions.end() ? std::nullopt : std::optional(found->points);
}

/// Corners are octagons with sides of two radii, whose area goes with 1 / N; strips are as wide, but as long as tiles.
/// Sets of one relative radius are compared, each with that of the fewest points a tile.
CornerOutcome few_points_near_corners(const ClaimSeries& report)
{
    std::map<double, std::map<double, SeriesPointer>> sets; ///< by the relative radius, by the points a tile
    for (SeriesPointer series : report.all({.sampler = "corner-tiles"}))
        if (const auto radius = number_parameter(*series, "relative_radius"))
            if (region_points_of(*series, "corners") && region_points_of(*series, "edges"))
                sets[*radius].try_emplace(points_per_tile(*series), series);
    Cases cases;
    std::vector<double> corners, edges;
    for (const auto& [radius, by_points] : sets) {
        const double first = *region_points_of(*by_points.begin()->second, "corners");
        for (const auto& [points, series] : by_points) {
            corners.push_back(*region_points_of(*series, "corners"));
            edges.push_back(*region_points_of(*series, "edges"));
            const bool holds = std::abs(corners.back() - first) <= 0.5 && 1.5 * corners.back() <= edges.back();
            cases.add(by_points.size() > 1 ? finding_if(holds) : Finding::open);
        }
    }
    return cases.outcome(fmt::format("{} near corners, {} near edges", range_words(corners, 2), range_words(edges, 2)));
}

}

std::vector<PaperClaim> claims_about_corner_tiles()
{
    return {
        {"6.11-tiles", "6.11", "C colours make C⁴ corner tiles, but C¹² edge tiles.",
         "shown, as it follows from what the tiles are: tiles of the sets that were built", counts_of_tiles},
        reach_by_lloyd_claim("6.11-radius", "6.11",
                             "Corner tiles reach relative radii of up to 0.85, because they use Lloyd relaxation.",
                             {.sampler = "corner-tiles"}, 0.85),
        {"6.11-good", "6.11", "From 3 colours and 32 points a tile on, spectra are rather good.",
         calibration_criterion(),
         [](const ClaimSeries& report) {
             return shown_spectra(tiling_spectra(report, "corner-tiles"), true, is_good_corner_set);
         }},
        {"6.11-order", "6.11", "From 3 colours and 32 points a tile on, spectra are better than with fewer.",
         order_criterion(),
         [](const ClaimSeries& report) {
             return are_better(tiling_spectra(report, "corner-tiles"), is_good_corner_set);
         }},
        {"6.11-better", "6.11",
         "Spectra of corner tiles are significantly better than those of edge tiles, even with smaller sets of tiles.",
         std::string("mean peak below that of 4,096 edge tiles with as many points a tile, for 81 to 2,401 corner "
                     "tiles, by two standard errors; ") +
             several_sets_criterion,
         [](const ClaimSeries& report) { return better_than_edges(report, 3, 2401, 1); }},
        {"6.11-peaks", "6.11", "The peaks are much smaller than those of edge tiles (4, 6 and 8 colours).",
         std::string("mean peak at most half of that of edge tiles with as many points a tile, by two standard "
                     "errors; ") +
             several_sets_criterion,
         [](const ClaimSeries& report) { return better_than_edges(report, 4, 1e9, 0.5); }},
        {"6.11-radial", "6.11", "The radially averaged power is almost that of sets without tiles (4 colours or more).",
         std::string("mean absolute difference from Lloyd relaxation with repulsion to the same relative radius below "
                     "0.1, at equal frequencies over √N, 32 points a tile or more; ") +
             several_sets_criterion,
         radial_like_untiled},
        {"6.11-anisotropy", "6.11",
         "The anisotropy still has peaks, but is much smaller than that of other tiles (4 colours or more).",
         std::string("the largest anisotropy of a ring is at least 3 dB below that of edge and template tiles with as "
                     "many points a tile, by two standard errors; ") +
             several_sets_criterion,
         less_anisotropy},
        {"6.11-plate", "6.11",
         "The zone plate is sampled significantly better than by other tiles, even with small sets.",
         std::string("strongest false plate below that of edge tiles (relative radius 0.70) and template tiles with "
                     "as many points a tile; ") +
             pictures_criterion,
         plates_better},
        {"6.11-corner-points", "6.11",
         "The number of points near corners is constant, and much smaller than that near edges.",
         "points of a tile near corners within half a point of those of the fewest points a tile, and those near edges "
         "1.5 times as many, for each relative radius; open where there is one number of points a tile",
         few_points_near_corners},
        time_claim(
            "6.11-time", "6.11",
            "Some 16,384 points take 0.088, 0.102, 0.122 s with 4 colours, 0.238, 0.319, 0.415 s with 6, and 0.629, "
            "0.911, 1.200 s with 8 (32, 48, 64 points a tile), most of it to read the tile set.",
            timed_corner_tiles()),
    };
}

}

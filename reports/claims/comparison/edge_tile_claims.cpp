// Claims of section 6.7 about the peaks of all methods that tile, and of section 6.9 about edge-based tiles.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/tile_spectra.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using Needs = SeriesQuery::Needs;
using EdgeOutcome = std::optional<ClaimOutcome>;

constexpr std::array poisson_tiles = {"edge-tiles", "template-tiles", "corner-tiles"};

/// Tiles whose borders are chains, and which are relaxed together, have little left of these peaks: the words say how
/// much.
std::string words_on_chains(const ClaimSeries& report)
{
    std::vector<double> peaks;
    for (const char* sampler : {"template-tiles", "corner-tiles"})
        for (SeriesPointer series : report.all({.sampler = sampler, .points = usual_points, .needs = Needs::spectrum}))
            if (const Estimate* peak = estimate_of(*series, "near_lattice_peaks"); peak && has_chains(*series))
                peaks.push_back(peak->value);
    if (peaks.empty()) return "";
    return fmt::format("tiles with chains, not of the papers: {} up to the first ring", range_words(peaks, 2));
}

/// Powers of K sets at half the peaks (the others are mirror images) are exponential with mean 1.
Finding has_peaks(const LatticePeaks& peaks, int realizations)
{
    const double independent = 0.5 * static_cast<double>(peaks.peaks) * realizations;
    const double errors = (peaks.mean_ratio - 1) * std::sqrt(independent);
    return errors > 4 ? Finding::holds : errors > 2 ? Finding::open : Finding::fails;
}

EdgeOutcome tilings_have_peaks(const ClaimSeries& report)
{
    Cases cases;
    std::vector<double> ratios;
    const auto count = [&](SeriesPointer series) {
        const auto& peaks = series->stored->measures.lattice_peaks;
        if (!peaks || peaks->peaks < 2) return;
        cases.add(has_peaks(*peaks, series->stored->realizations));
        ratios.push_back(peaks->mean_ratio);
    };
    for (const char* sampler : poisson_tiles) std::ranges::for_each(tiling_spectra(report, sampler), count);
    for (const char* sampler : {"shade-tiles", "averaged-tiles"})
        std::ranges::for_each(report.all({.sampler = sampler, .needs = Needs::spectrum}), count);
    return cases.outcome(fmt::format("mean peak {} times the power around it", range_words(ratios, 2)),
                         words_on_chains(report));
}

/// The share of the power that peaks have against what counting shared points predicts.
EdgeOutcome shared_points_cause_peaks(const ClaimSeries& report)
{
    constexpr double factor = 1.5;
    Cases cases;
    std::vector<double> measured, predicted, ratios;
    for (const char* sampler : poisson_tiles)
        for (SeriesPointer series : tiling_spectra(report, sampler)) {
            const auto share = lattice_share(*series);
            const auto foretold = predicted_lattice_share(*series);
            if (!share || !foretold) continue;
            measured.push_back(100 * share->value);
            predicted.push_back(100 * *foretold);
            const Estimate ratio = ratio_of(*share, {*foretold, {}});
            ratios.push_back(ratio.value);
            cases.add(is_within(ratio, 1 / factor, factor));
        }
    return cases.outcome(fmt::format("{} % of the power on the lattice, {} % predicted; {} times that",
                                     range_words(measured, 2), range_words(predicted, 2), range_words(ratios, 2)));
}

/// Neighbours in one number, compared by a quantity that is to be smaller.
template <typename Same, typename Varied, typename Quantity>
EdgeOutcome neighbours_are_lower(const ClaimSeries& report, const Same& same, const Varied& varied,
                                 const Quantity& quantity, const char* unit)
{
    Cases cases;
    TileSetFlag flag;
    std::vector<double> ratios;
    for (const char* sampler : {"template-tiles", "corner-tiles"})
        for_neighbours(tiling_spectra(report, sampler), same, varied,
                       [&](const ReportSeries& a, const ReportSeries& b) {
                           const std::optional<Estimate> of_a = quantity(a), of_b = quantity(b);
                           if (!of_a || !of_b) return;
                           const Estimate ratio = ratio_of(*of_b, *of_a);
                           ratios.push_back(ratio.value);
                           cases.add(flag.if_several({&a, &b}, is_below(ratio, 1)));
                       });
    return cases.outcome(range_words(ratios, 2) + unit, flag.words());
}

EdgeOutcome more_tiles_are_lower(const ClaimSeries& report)
{
    return neighbours_are_lower(report, points_per_tile, set_size, mean_peak, " times as high");
}

/// Tilings of as many points have fewer tiles where these have more points, which alone makes their peaks lower: shares
/// of the power are compared.
EdgeOutcome less_common_is_lower(const ClaimSeries& report)
{
    return neighbours_are_lower(report, set_size, points_per_tile, lattice_share, " times the share");
}

// 6.9

/// Pictures at relative radii of 0.70 and 0.80 of as many points a tile: first the smaller radius.
template <typename Visit>
void for_plates_of_two_radii(const ClaimSeries& report, const Visit& visit)
{
    SeriesQuery low{.sampler = "edge-tiles", .points = plate_points, .needs = Needs::plate}, high = low;
    low.numbers = {{"relative_radius", 0.70}};
    high.numbers = {{"relative_radius", 0.80}};
    for_equal_points(report.all(low), report.all(high), visit);
}

EdgeOutcome wider_plates_are_better(const ClaimSeries& report)
{
    Cases cases(fewest_pictures);
    for_plates_of_two_radii(report, [&](const ReportSeries& a, const ReportSeries& b) {
        const double x = plate_error(a, 0, plate_middle), y = plate_error(b, 0, plate_middle);
        if (x == 0 || y == 0) return;
        cases.add(compared_plates(y, x), fmt::format("N = {}: {}, against {}", format_exact(points_per_tile(a)),
                                                     format_significant(y, 3), format_significant(x, 3)));
    });
    return cases.outcome();
}

EdgeOutcome wider_plates_alias_more(const ClaimSeries& report)
{
    Cases cases(fewest_pictures);
    for_plates_of_two_radii(report, [&](const ReportSeries& a, const ReportSeries& b) {
        const auto finding = has_weaker_plates(report, a, b);
        if (!finding) return;
        cases.add(*finding, fmt::format("N = {}: {}, against {}", format_exact(points_per_tile(a)),
                                        format_significant(report.false_rings(b)->strength, 3),
                                        format_significant(report.false_rings(a)->strength, 3)));
    });
    return cases.outcome();
}

EdgeOutcome tiles_are_fast(const ClaimSeries& report)
{
    std::vector<const char*> methods{"dart-throwing"};
    methods.insert(methods.end(), poisson_tiles.begin(), poisson_tiles.end());
    const bool has_tiles = std::ranges::any_of(
        poisson_tiles, [&](const char* sampler) { return !of_usual_size(report, sampler).empty(); });
    return has_tiles ? shown_times(report, methods) : std::nullopt;
}

/// A set of edge tiles has few edges, however many tiles: with two colours each is in half of all places, and what it
/// does to the points around it adds up over a tiling. Corner tiles of many colours have more of them.
EdgeOutcome wavelike_artifacts(const ClaimSeries& report)
{
    Cases cases;
    TileSetFlag flag;
    std::vector<double> edges, corners;
    const auto corner_sets = tiling_spectra(report, "corner-tiles");
    for (SeriesPointer edge : tiling_spectra(report, "edge-tiles"))
        for_equal_points({edge}, corner_sets, [&](const ReportSeries&, const ReportSeries& corner) {
            const auto of_edges = speckle(*edge), of_corners = speckle(corner);
            if (set_size(corner) < 4096 || !of_edges || !of_corners) return;
            edges.push_back(*of_edges);
            corners.push_back(*of_corners);
            const double more = *of_edges - *of_corners;
            cases.add(flag.if_several({edge, &corner}, more > 0.1 ? Finding::holds
                                                       : more > 0 ? Finding::open
                                                                  : Finding::fails));
        });
    return cases.outcome(joined_words({fmt::format("{} dB above chance, corner tiles {}", range_words(edges, 2),
                                                   range_words(corners, 2)),
                                       "the paper cannot explain them; edge tiles have two edges a direction, corner "
                                       "tiles of as many tiles 64"}),
                         flag.words());
}

}

std::vector<PaperClaim> claims_about_peaks()
{
    return {
        {"6.7-peaks", "6.7",
         "The spectra of all methods that tile have peaks at multiples of the reciprocal of the tile size, which "
         "cannot be eliminated.",
         "the mean peak is more than four standard errors above the power around it in every series; open from two on",
         tilings_have_peaks},
        {"6.7-cause", "6.7",
         "The peaks come from the limited number of tiles, and from points that tiles have in common.",
         "the share of the power on the lattice is that of points which a tile has in common with another one of a "
         "tiling, counted in the tile set, within a factor of 1.5",
         shared_points_cause_peaks},
        {"6.7-more-tiles", "6.7", "More tiles make the peaks lower.",
         std::string("mean peak of each series of corner and template tiles against the next larger set of as many "
                     "points a tile, by two standard errors; ") +
             several_sets_criterion,
         more_tiles_are_lower},
        {"6.7-less-common", "6.7", "Fewer points that tiles have in common make the peaks lower.",
         std::string("share of the power in the peaks, of each series against the next larger number of points a tile, "
                     "of which a smaller part is common, by two standard errors; ") +
             several_sets_criterion,
         less_common_is_lower},
    };
}

std::vector<PaperClaim> claims_about_edge_tiles()
{
    return {
        reach_by_lloyd_claim("6.9-radius", "6.9",
                             "Edge tiles reach relative radii of up to 0.85, because they use Lloyd relaxation.",
                             {.sampler = "edge-tiles"}, 0.85),
        {"6.9-low", "6.9", "Relative radius 0.80 reproduces the low frequencies of the zone plate better than 0.70.",
         "lower root mean square error where the plate has up to a quarter of a cycle per pixel; open within 5 %, and "
         "with fewer than three comparisons, as each picture is of one tile set",
         wider_plates_are_better},
        {"6.9-aliasing", "6.9", "Relative radius 0.80 is more subject to aliasing than 0.70.",
         std::string("the strongest false plate is stronger, in units of the noise around it; ") + pictures_criterion,
         wider_plates_alias_more},
        {"6.9-plate", "6.9", "A small amount of structured aliasing is visible in the zone plate by edge tiles.",
         false_plates_criterion,
         [](const ClaimSeries& report) { return false_plates(report, tiling_plates(report, "edge-tiles"), true); }},
        {"6.9-fast", "6.9", "Methods that tile are typically very fast.",
         std::string(shown_times_criterion) + ", and those of dart throwing, which is accelerated here",
         tiles_are_fast},
        {"6.9-wavelike", "6.9", "The spectra of edge tiles show strange wavelike artifacts.",
         std::string("anisotropy between the peaks above that of 4,096 corner tiles with as many points a tile, by "
                     "0.1 dB; ") +
             several_sets_criterion,
         wavelike_artifacts},
    };
}

}

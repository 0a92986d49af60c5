// Claims of sections 6.7 to 6.11 and 6.15, about Poisson disk tiles.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/tile_spectra.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

using Needs = SeriesQuery::Needs;
using Outcome = std::optional<ClaimOutcome>;

/// Above these a spectrum is called bad here: anisotropy between the peaks of the lattice, which is what few tiles
/// leave, in dB above chance, and the mean peak, which is what few points that tiles do not share leave. Not the share
/// of power in the peaks: the points that all tiles share decide it, so that no set of template tiles of the
/// dissertation could have less than an eighth there, whatever its spectrum looks like.
constexpr double bad_anisotropy_db = 2;
constexpr double bad_peak = 300;

std::vector<SeriesPointer> plates(const ClaimSeries& report, const std::string& sampler)
{
    return report.all({.sampler = sampler, .points = plate_points, .needs = Needs::plate});
}

/// Pairs of series that differ in one of two numbers only, with no value of the report between: first the smaller one.
template <typename Same, typename Varied, typename Visit>
void for_neighbours(std::vector<SeriesPointer> series, const Same& same, const Varied& varied, const Visit& visit)
{
    std::ranges::stable_sort(series, {}, [&](SeriesPointer s) { return std::pair(same(*s), varied(*s)); });
    for (std::size_t i = 1; i < series.size(); ++i)
        if (same(*series[i - 1]) == same(*series[i]) && varied(*series[i - 1]) < varied(*series[i]))
            visit(*series[i - 1], *series[i]);
}

// 6.7

/// Tiles whose borders are chains, and which are relaxed together, have little left of these peaks: the words say how
/// much.
std::string words_on_chains(const ClaimSeries& report)
{
    std::vector<double> peaks;
    for (const char* sampler : {"template-tiles", "corner-tiles"})
        for (SeriesPointer series :
             report.all({.sampler = sampler, .points = usual_points, .needs = Needs::spectrum})) {
            const auto& numbers = series->stored->measures.numbers;
            const auto found = numbers.find("near_lattice_peaks");
            if (has_chains(*series) && found != numbers.end()) peaks.push_back(found->second.value);
        }
    if (peaks.empty()) return "";
    return fmt::format("tiles with chains, not of the papers: {} up to the first ring", range_words(peaks, 2));
}

Outcome tilings_have_peaks(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    for (const char* sampler : {"edge-tiles", "template-tiles", "corner-tiles"})
        for (SeriesPointer series : tiling_spectra(report, sampler)) {
            const auto& peaks = *series->stored->measures.lattice_peaks;
            // Powers of K sets at half the peaks (the others are mirror images) are exponential with mean 1.
            const double independent = 0.5 * static_cast<double>(peaks.peaks) * series->stored->realizations;
            if (independent < 1) continue;
            tally.add(peaks.mean_ratio > 1 + 4 / std::sqrt(independent));
            ratios.push_back(peaks.mean_ratio);
        }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(),
                        joined_words({fmt::format("mean peak {} times the power around it", range_words(ratios, 2)),
                                      tally.words(), words_on_chains(report)})};
}

Outcome more_tiles_are_lower(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    for (const char* sampler : {"template-tiles", "corner-tiles"})
        for_neighbours(tiling_spectra(report, sampler), points_per_tile, set_size,
                       [&](const ReportSeries& fewer, const ReportSeries& more) {
                           ratios.push_back(mean_peak(more) / mean_peak(fewer));
                           tally.add(ratios.back() < 1);
                       });
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(ratios, 2) + " times as high", tally.words()})};
}

/// Tilings of as many points have fewer tiles where these have more points, which alone makes their peaks lower: shares
/// of the power are compared.
Outcome less_common_is_lower(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    for (const char* sampler : {"template-tiles", "corner-tiles"})
        for_neighbours(tiling_spectra(report, sampler), set_size, points_per_tile,
                       [&](const ReportSeries& fewer, const ReportSeries& more) {
                           const auto a = lattice_share(fewer), b = lattice_share(more);
                           if (!a || !b) return;
                           ratios.push_back(*b / *a);
                           tally.add(ratios.back() < 1);
                       });
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(ratios, 2) + " times the share", tally.words()})};
}

std::vector<PaperClaim> tiling_claims()
{
    return {
        {"6.7-peaks", "6.7",
         "The spectra of all methods that tile have peaks at multiples of the reciprocal of the tile size, which "
         "cannot be eliminated.",
         "the mean peak is more than four standard errors above the power around it in every series",
         tilings_have_peaks},
        {"6.7-more-tiles", "6.7", "More tiles make the peaks lower.",
         "mean peak of each series of corner and template tiles against the next larger set of as many points a tile",
         more_tiles_are_lower},
        {"6.7-less-common", "6.7", "Fewer points that tiles have in common make the peaks lower.",
         "share of the power in the peaks, of each series against the next larger number of points a tile, of which a "
         "smaller part is common",
         less_common_is_lower},
    };
}

// 6.9

Outcome wider_plates(const ClaimSeries& report, bool aliasing)
{
    Tally tally;
    std::vector<std::string> words;
    const SeriesQuery query{.sampler = "edge-tiles", .points = plate_points, .needs = Needs::plate};
    auto low = query, high = query;
    low.numbers = {{"relative_radius", 0.70}};
    high.numbers = {{"relative_radius", 0.80}};
    for_equal_points(report.all(low), report.all(high), [&](const ReportSeries& a, const ReportSeries& b) {
        double x = 0, y = 0;
        if (aliasing) {
            const auto p = report.false_rings(a), q = report.false_rings(b);
            if (!p || !q) return;
            x = p->strength, y = q->strength;
        } else {
            x = plate_error(a, 0, 0.25), y = plate_error(b, 0, 0.25);
        }
        tally.add(aliasing ? y > x : y < x);
        words.push_back(fmt::format("N = {}: {}, against {}", format_exact(points_per_tile(a)),
                                    format_significant(y, 3), format_significant(x, 3)));
    });
    if (tally.empty()) return std::nullopt;
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

/// Times of tilings and of dart throwing from the same machine.
Outcome tiles_are_fast(const ClaimSeries& report)
{
    const auto* darts = report.one({.sampler = "dart-throwing", .points = usual_points});
    if (darts == nullptr || darts->stored->sample_seconds.empty()) return std::nullopt;
    Tally tally;
    std::vector<double> factors;
    for (const char* sampler : {"edge-tiles", "template-tiles", "corner-tiles"})
        for (SeriesPointer series : report.all({.sampler = sampler, .points = usual_points})) {
            if (series->stored->sample_seconds.empty() || series->run->machine != darts->run->machine) continue;
            factors.push_back(median(darts->stored->sample_seconds) / median(series->stored->sample_seconds));
            tally.add(factors.back() > 1);
        }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(),
                        joined_words({range_words(factors, 2) + " times as fast as dart throwing", tally.words()})};
}

std::vector<PaperClaim> edge_claims()
{
    return {
        reach_claim("6.9-radius", "6.9", "Edge tiles reach relative radii of up to 0.85.", {.sampler = "edge-tiles"},
                    0.85),
        {"6.9-low", "6.9", "Relative radius 0.80 reproduces the low frequencies of the zone plate better than 0.70.",
         "lower root mean square error where the plate has up to a quarter of a cycle per pixel (one set each: no "
         "error known)",
         [](const ClaimSeries& report) { return wider_plates(report, false); }},
        {"6.9-aliasing", "6.9", "But it is more subject to aliasing.",
         "the strongest false plate is stronger, in units of the noise around it",
         [](const ClaimSeries& report) { return wider_plates(report, true); }},
        {"6.9-fast", "6.9", "Methods that tile are typically very fast.",
         "shorter median time for 16,384 points than dart throwing on the same machine", tiles_are_fast},
    };
}

// 6.10

const std::string good_criterion = fmt::format(
    "good: between the peaks of the tiling's lattice anisotropy is at most {} dB above chance, and the mean "
    "peak is at most {} times the power around it",
    format_exact(bad_anisotropy_db), format_exact(bad_peak));

template <typename Selected>
Outcome judged_spectra(const std::vector<SeriesPointer>& all, bool good, const Selected& selected)
{
    Tally tally;
    std::vector<double> anisotropies, peaks, shares;
    for (SeriesPointer series : all) {
        if (!selected(series) || !series->stored->measures.numbers.contains("off_lattice_anisotropy")) continue;
        anisotropies.push_back(speckle(*series));
        peaks.push_back(mean_peak(*series));
        shares.push_back(100 * lattice_share(*series).value_or(0));
        tally.add((anisotropies.back() <= bad_anisotropy_db && peaks.back() <= bad_peak) == good);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(),
                        joined_words({range_words(anisotropies, 2) + " dB above chance",
                                      fmt::format("mean peak {}", range_words(peaks, 2)),
                                      range_words(shares, 2) + " % of the power in the peaks", tally.words()})};
}

Outcome many_tiles_are_alike(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    const auto all = tiling_spectra(report, "template-tiles");
    for_equal_points(all, all, [&](const ReportSeries& a, const ReportSeries& b) {
        if (set_size(a) != 128 || set_size(b) != 256) return;
        ratios.push_back(mean_peak(b) / mean_peak(a));
        tally.add(std::abs(ratios.back() - 1) < 0.1);
    });
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{
        tally.agreement(),
        joined_words({"mean peaks " + range_words(ratios, 3) + " times those of 128 tiles", tally.words()})};
}

/// Template tiles against sets of other kinds with as many points a tile and no more than half as many tiles again.
Outcome template_peaks_largest(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    for (const char* sampler : {"corner-tiles", "edge-tiles"})
        for_equal_points(tiling_spectra(report, "template-tiles"), tiling_spectra(report, sampler),
                         [&](const ReportSeries& template_tiles, const ReportSeries& other) {
                             const bool most = set_size(template_tiles) >= 128;
                             if (!most || (sampler == std::string("corner-tiles") && set_size(other) > 256)) return;
                             ratios.push_back(mean_peak(template_tiles) / mean_peak(other));
                             tally.add(ratios.back() > 1);
                         });
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{
        tally.agreement(),
        joined_words({range_words(ratios, 2) + " times as high as those of other tiles", tally.words()})};
}

Outcome peaks_in_anisotropy(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> values;
    for (SeriesPointer series : tiling_spectra(report, "template-tiles")) {
        values.push_back(peak_anisotropy(*series));
        tally.add(values.back() > series->curve.background_db + 10);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(values, 2) + " dB at most", tally.words()})};
}

Outcome plates_improve(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    const auto visit = [&](const ReportSeries& fewer, const ReportSeries& more) {
        const auto a = report.false_rings(fewer), b = report.false_rings(more);
        if (!a || !b) return;
        ratios.push_back(b->strength / a->strength);
        tally.add(ratios.back() < 1);
    };
    for_neighbours(plates(report, "template-tiles"), points_per_tile, set_size, visit);
    for_neighbours(plates(report, "template-tiles"), set_size, points_per_tile, visit);
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(ratios, 2) + " times as strong", tally.words()})};
}

bool is_large(SeriesPointer series) { return set_size(*series) >= 32 && points_per_tile(*series) >= 32; }

std::vector<PaperClaim> template_claims()
{
    return {
        {"6.10-bad", "6.10",
         "Spectra of template tiles with 16 or 24 points a tile, or with 1 to 16 tiles, are rather bad.",
         good_criterion,
         [](const ClaimSeries& report) {
             return judged_spectra(tiling_spectra(report, "template-tiles"), false, [](SeriesPointer series) {
                 return set_size(*series) <= 16 || points_per_tile(*series) <= 24;
             });
         }},
        {"6.10-good", "6.10", "Spectra of template tiles with at least 32 points a tile and 32 tiles are rather good.",
         good_criterion,
         [](const ClaimSeries& report) {
             return judged_spectra(tiling_spectra(report, "template-tiles"), true, is_large);
         }},
        {"6.10-alike", "6.10", "Spectra of 128 and 256 template tiles are not that different.",
         "mean peaks within 10 % of each other", many_tiles_are_alike},
        {"6.10-pronounced", "6.10",
         "The lattice of peaks of template tiles is more pronounced than with other tiles, because the tiles have the "
         "template's points in common.",
         "mean peak of 128 tiles or more above that of corner tiles (at most 256) and edge tiles with as many points a "
         "tile; counting the points that tiles share predicts it",
         template_peaks_largest},
        {"6.10-anisotropy", "6.10", "The peaks of template tiles turn up in the anisotropy as well.",
         "the ring with the largest anisotropy is at least 10 dB above chance", peaks_in_anisotropy},
        {"6.10-plate", "6.10",
         "The zone plate by template tiles shows severe structured aliasing, whatever the parameters.",
         "the strongest false plate is stronger than noise makes once in 100 pictures",
         [](const ClaimSeries& report) { return false_plates(report, plates(report, "template-tiles"), true); }},
        {"6.10-improves", "6.10",
         "The zone plate by template tiles improves with more tiles and with more points a tile.",
         "the strongest false plate of each series against the next larger number of tiles, or of points a tile",
         plates_improve},
    };
}

// 6.11

Outcome counts_of_tiles(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> corner;
    for (const char* sampler : {"corner-tiles", "edge-tiles"})
        for (SeriesPointer series : report.all({.sampler = sampler})) {
            if (!series->stored->tile_set || !tiles_of_set(*series)) continue;
            tally.add(static_cast<double>(series->stored->tile_set->tiles) == set_size(*series));
            if (sampler == std::string("corner-tiles")) corner.push_back(set_size(*series));
        }
    if (corner.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(corner, 4) + " corner tiles", tally.words()})};
}

/// Corner tiles of some colours or more, `most` of them, against edge tiles of as many points a tile.
Outcome better_than_edges(const ClaimSeries& report, double fewest_colors, double most, double factor)
{
    Tally tally;
    std::vector<double> ratios;
    for_equal_points(tiling_spectra(report, "corner-tiles"), tiling_spectra(report, "edge-tiles"),
                     [&](const ReportSeries& corner, const ReportSeries& edge) {
                         if (set_size(corner) > most || number_parameter(corner, "colors").value_or(0) < fewest_colors)
                             return;
                         ratios.push_back(mean_peak(corner) / mean_peak(edge));
                         tally.add(ratios.back() < factor);
                     });
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{
        tally.agreement(),
        joined_words({"mean peaks " + range_words(ratios, 2) + " times those of edge tiles", tally.words()})};
}

/// Sets of the same relative radius without tiles: Lloyd relaxation and repulsion.
SeriesPointer untiled(const ClaimSeries& report)
{
    return report.one({.sampler = "lloyd",
                       .numbers = {{"until_relative_radius", 0.75}},
                       .points = usual_points,
                       .needs = Needs::spectrum});
}

Outcome radial_like_untiled(const ClaimSeries& report)
{
    const auto* reference = untiled(report);
    if (reference == nullptr) return std::nullopt;
    Tally tally;
    std::vector<double> values;
    for (SeriesPointer series : tiling_spectra(report, "corner-tiles")) {
        if (number_parameter(*series, "colors").value_or(0) < 4 || points_per_tile(*series) < 32) continue;
        const auto distance = distance_of_curves(*series, *reference);
        if (!distance) continue;
        values.push_back(*distance);
        tally.add(*distance < 0.1);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(values, 2) + " on average", tally.words()})};
}

Outcome less_anisotropy(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> differences;
    for (const char* sampler : {"edge-tiles", "template-tiles"})
        for_equal_points(tiling_spectra(report, "corner-tiles"), tiling_spectra(report, sampler),
                         [&](const ReportSeries& corner, const ReportSeries& other) {
                             if (number_parameter(corner, "colors").value_or(0) < 4) return;
                             differences.push_back(peak_anisotropy(other) - peak_anisotropy(corner));
                             tally.add(differences.back() > 3);
                         });
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(differences, 2) + " dB less", tally.words()})};
}

Outcome plates_better(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    const auto compare = [&](const ReportSeries& corner, const ReportSeries& other) {
        if (number_parameter(corner, "relative_radius") != number_parameter(other, "relative_radius") &&
            number_parameter(other, "relative_radius").value_or(1) > 0.75)
            return; // a larger radius aliases more by itself
        const auto a = report.false_rings(corner), b = report.false_rings(other);
        if (!a || !b) return;
        ratios.push_back(a->strength / b->strength);
        tally.add(ratios.back() < 1);
    };
    for (const char* sampler : {"edge-tiles", "template-tiles"})
        for_equal_points(plates(report, "corner-tiles"), plates(report, sampler), compare);
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(),
                        joined_words({"false plates " + range_words(ratios, 2) + " times as strong", tally.words()})};
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

bool is_good_corner_set(SeriesPointer series)
{
    return number_parameter(*series, "colors").value_or(0) >= 3 && points_per_tile(*series) >= 32;
}

std::vector<PaperClaim> corner_claims()
{
    return {
        {"6.11-tiles", "6.11", "C colours make C⁴ corner tiles, but C¹² edge tiles.",
         "counts in the tile sets that were built", counts_of_tiles},
        reach_claim("6.11-radius", "6.11", "Corner tiles reach relative radii of up to 0.85.",
                    {.sampler = "corner-tiles"}, 0.85),
        {"6.11-good", "6.11", "From 3 colours and 32 points a tile on, spectra are rather good.", good_criterion,
         [](const ClaimSeries& report) {
             return judged_spectra(tiling_spectra(report, "corner-tiles"), true, is_good_corner_set);
         }},
        {"6.11-better", "6.11",
         "Spectra of corner tiles are significantly better than those of edge tiles, even with smaller sets of tiles.",
         "mean peak below that of 4,096 edge tiles with as many points a tile, for 81 to 2,401 corner tiles",
         [](const ClaimSeries& report) { return better_than_edges(report, 3, 2401, 1); }},
        {"6.11-peaks", "6.11", "The peaks are much smaller than those of edge tiles (4, 6 and 8 colours).",
         "mean peak at most half of that of edge tiles with as many points a tile",
         [](const ClaimSeries& report) { return better_than_edges(report, 4, 1e9, 0.5); }},
        {"6.11-radial", "6.11", "The radially averaged power is almost that of sets without tiles (4 colours or more).",
         "mean absolute difference from Lloyd relaxation with repulsion to the same relative radius below 0.1, at "
         "equal frequencies over √N, 32 points a tile or more",
         radial_like_untiled},
        {"6.11-anisotropy", "6.11",
         "The anisotropy still has peaks, but is much smaller than that of other tiles (4 colours or more).",
         "the largest anisotropy of a ring is at least 3 dB below that of edge and template tiles with as many points "
         "a tile",
         less_anisotropy},
        {"6.11-plate", "6.11",
         "The zone plate is sampled significantly better than by other tiles, even with small sets.",
         "strongest false plate below that of edge tiles (relative radius 0.70) and template tiles with as many points "
         "a tile",
         plates_better},
        time_claim(
            "6.11-time", "6.11",
            "Some 16,384 points take 0.088, 0.102, 0.122 s with 4 colours, 0.238, 0.319, 0.415 s with 6, and 0.629, "
            "0.911, 1.200 s with 8 (32, 48, 64 points a tile), most of it to read the tile set.",
            timed_corner_tiles()),
    };
}

// 6.15

std::vector<PaperClaim> sphere_claims()
{
    const SeriesQuery spheres{.sampler = "sphere-tiles", .dimension = 3};
    const auto spectra_of_spheres = [spheres](const ClaimSeries& report) {
        auto query = spheres;
        query.needs = Needs::spectrum;
        return report.all(query);
    };
    return {
        reach_claim("6.15-tiles-radius", "6.15", "Poisson sphere tiles reach a large relative radius, 0.75.", spheres,
                    0.75),
        {"6.15-tiles-radial", "6.15", "The radially averaged power of sphere tiles is rather good.",
         blue_noise_criterion,
         [spectra_of_spheres](const ClaimSeries& report) -> Outcome {
             Tally tally;
             std::vector<std::string> words;
             for (SeriesPointer series : spectra_of_spheres(report)) {
                 const auto blue = blue_noise(*series);
                 tally.add(blue.holds);
                 words.push_back(blue.words);
             }
             if (tally.empty()) return std::nullopt;
             return ClaimOutcome{tally.agreement(), joined_words(words)};
         }},
        {"6.15-tiles-anisotropy", "6.15", "The anisotropy of sphere tiles is a bit high.",
         "the mean over shells of at least 100 samples is more than 0.5 dB above what chance gives",
         [spectra_of_spheres](const ClaimSeries& report) -> Outcome {
             Tally tally;
             std::vector<double> values;
             for (SeriesPointer series : spectra_of_spheres(report)) {
                 values.push_back(mean_excess_anisotropy(*series));
                 tally.add(values.back() > 0.5);
             }
             if (tally.empty()) return std::nullopt;
             return ClaimOutcome{tally.agreement(), range_words(values, 2) + " dB above it"};
         }},
    };
}

}

std::vector<PaperClaim> claims_about_tiles()
{
    std::vector<PaperClaim> claims;
    for (const auto& part : {tiling_claims(), edge_claims(), template_claims(), corner_claims(), sphere_claims()})
        claims.insert(claims.end(), part.begin(), part.end());
    return claims;
}

}

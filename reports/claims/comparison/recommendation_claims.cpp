// The recommendations of the dissertation's chapter 6: section 6.16.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/tile_spectra.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

using Recommendation = std::optional<ClaimOutcome>;

/// Finds the series of a method that have the usual size, and the same density everywhere.
std::vector<const ReportSeries*> usual_series(const ClaimSeries& report, const char* sampler)
{
    auto found = of_usual_size(report, sampler);
    std::erase_if(found, [](const ReportSeries* series) { return follows_density(*series); });
    return found;
}

std::optional<Estimate> excess_anisotropy(const ReportSeries& series)
{
    if (!has_estimated_spectrum(series) || tiles_of_set(series) == 1) return std::nullopt;
    return mean_excess_anisotropy(series);
}

/// Shows what Shade's tiles lack, beside the numbers of later tiles.
Recommendation shade_beside_others(const ClaimSeries& report)
{
    std::vector<std::string> words;
    for (const char* sampler : {"shade-tiles", "edge-tiles", "corner-tiles"}) {
        std::vector<double> radii, densities;
        for (const ReportSeries* series : usual_series(report, sampler)) {
            const Estimate* density = estimate_of(*series, "border_density");
            if (!density || !series->stored->relative_radius) continue;
            densities.push_back(density->value);
            radii.push_back(series->stored->relative_radius->min);
        }
        if (radii.empty()) {
            if (words.empty()) return std::nullopt;
            continue;
        }
        words.push_back(fmt::format("{}: radius {}, {} of the mean density near borders", sampler,
                                    range_words(radii, 2), range_words(densities, 2)));
    }
    return ClaimOutcome{Agreement::shown, joined_words(words)};
}

Finding is_less_anisotropic(const ReportSeries& better, const ReportSeries& worse)
{
    return is_below(difference_of(*excess_anisotropy(better), *excess_anisotropy(worse)), 0);
}

/// Every series of edge tiles against every one of averaged tiles, in radius and in anisotropy.
Recommendation edges_beat_averaged(const ClaimSeries& report)
{
    Cases cases;
    TileSetFlag flag;
    std::vector<double> radii, other_radii;
    std::vector<Estimate> power, other_power;
    for (const ReportSeries* edge : usual_series(report, "edge-tiles"))
        for (const ReportSeries* averaged : usual_series(report, "averaged-tiles")) {
            const auto a = excess_anisotropy(*edge), b = excess_anisotropy(*averaged);
            const auto &radius = edge->stored->relative_radius, &other = averaged->stored->relative_radius;
            if (!a || !b || !radius || !other) continue;
            radii.push_back(radius->min);
            other_radii.push_back(other->min);
            power.push_back(*a);
            other_power.push_back(*b);
            for (const Finding finding : {finding_if(radius->min > other->min), is_less_anisotropic(*edge, *averaged)})
                cases.add(flag.if_several({edge, averaged}, finding));
        }
    return cases.outcome(fmt::format("radius {} against {}, anisotropy {} against {} dB above chance",
                                     range_words(radii, 2), range_words(other_radii, 2), range_words(power, 2),
                                     range_words(other_power, 2)),
                         flag.words());
}

/// Corner tiles against sets of another kind with at least as many tiles, of as many points a tile.
Recommendation corners_beat(const ClaimSeries& report, const char* sampler)
{
    Cases cases;
    TileSetFlag flag;
    std::vector<Estimate> own, others;
    for (const ReportSeries* corner : tiling_spectra(report, "corner-tiles"))
        for (const ReportSeries* other : tiling_spectra(report, sampler)) {
            const auto a = excess_anisotropy(*corner), b = excess_anisotropy(*other);
            if (!a || !b || set_size(*corner) > set_size(*other)) continue;
            if (points_per_tile(*corner) != points_per_tile(*other)) continue;
            own.push_back(*a);
            others.push_back(*b);
            cases.add(flag.if_several({corner, other}, is_less_anisotropic(*corner, *other)));
        }
    return cases.outcome(range_words(own, 2) + " against " + range_words(others, 2) + " dB above chance", flag.words());
}

/// The median over the series of a method.
std::optional<double> typical_anisotropy(const ClaimSeries& report, const char* sampler)
{
    std::vector<double> values;
    for (const ReportSeries* series : usual_series(report, sampler))
        if (const auto value = excess_anisotropy(*series)) values.push_back(value->value);
    return values.empty() ? std::nullopt : std::optional(median(values));
}

/// Each series against the middle one of the other methods, each of which counts by the median of its series.
Recommendation below_average(const ClaimSeries& report, const char* sampler)
{
    constexpr std::size_t fewest_methods = 3;
    std::vector<double> others;
    for (const char* other : {"dart-throwing", "relaxation-dart-throwing", "lloyd", "edge-tiles", "corner-tiles",
                              "template-tiles", "averaged-tiles", "shade-tiles", "sector-darts", "voronoi-darts"})
        if (const auto typical = typical_anisotropy(report, other)) others.push_back(*typical);
    if (others.empty()) return std::nullopt;
    const auto judge = [&](const Estimate& value) {
        return others.size() < fewest_methods ? Finding::open : is_above(value, median(others));
    };
    return over(usual_series(report, sampler), excess_anisotropy, judge, 2,
                fmt::format(" dB above chance, the middle of {} other methods has {}", others.size(),
                            format_fixed(median(others), 2)));
}

/// The worst realization of each series that draws every point once.
Recommendation low_radius(const ClaimSeries& report)
{
    constexpr double low = 0.5;
    Cases cases;
    std::vector<double> worst;
    for (const ReportSeries* series : usual_series(report, "recursive-wang-tiles")) {
        if (text_parameter(*series, "drawing") == "twice" || !series->stored->relative_radius) continue;
        worst.push_back(series->stored->relative_radius->min);
        // A single set does not tell how much worse another one is.
        const bool single = series->stored->realizations < 2;
        cases.add(worst.back() < low ? Finding::holds : single ? Finding::open : Finding::fails);
    }
    return cases.outcome(range_words(worst, 3));
}

constexpr const char* below_average_criterion =
    "every series has more anisotropy above chance, on average over rings, than the middle one of the other methods, "
    "each of which counts by the median of its series, by two standard errors; open beside fewer than three methods";

std::string corners_beat_criterion()
{
    return std::string("less anisotropy above chance on average over rings with at most as many tiles, of as many "
                       "points a tile, in every pair, by two standard errors; ") +
           several_sets_criterion;
}

}

std::vector<PaperClaim> recommendations()
{
    const std::vector<const char*> untiled{"dart-throwing", "relaxation-dart-throwing", "lloyd"};
    const std::vector<const char*> tiled{"edge-tiles", "corner-tiles", "template-tiles"};
    const std::string slow_criterion = std::string(shown_times_criterion) + "; a tenth of a second feels immediate";
    const std::string fast_criterion = std::string(shown_times_criterion) + "; a frame at 60 Hz has 17 ms";
    return {
        {"6.16-not-interactive", "6.16",
         "Dart throwing, relaxation dart throwing and Lloyd's method only suit applications that are not interactive.",
         slow_criterion, [=](const ClaimSeries& report) { return shown_times(report, untiled); }},
        {"6.16-interactive", "6.16",
         "The algorithms of Jones and of Dunbar and Humphreys suit interactive applications.", slow_criterion,
         [](const ClaimSeries& report) {
             return shown_times(report, {"voronoi-darts", "sector-darts"});
         }},
        {"6.16-real-time", "6.16", "Tile-based approaches suit real-time applications.", fast_criterion,
         [=](const ClaimSeries& report) { return shown_times(report, tiled); }},
        {"6.16-only-option", "6.16",
         "Dart throwing, relaxation dart throwing and Lloyd's method do not suit real-time applications.",
         fast_criterion, [=](const ClaimSeries& report) { return shown_times(report, untiled); }},
        {"6.16-shade", "6.16", "Shade's tiles have major shortcomings and should not be used.",
         "shown, as a recommendation: the worst relative radius, and the density within a disk's radius of the borders "
         "of tiles, beside those of later tiles",
         shade_beside_others},
        {"6.16-averaged", "6.16",
         "Tiled blue noise samples are not recommended: edge-based tiles are better in radius and spectrum.",
         std::string("a larger radius in the worst realization, and less anisotropy above chance by two standard "
                     "errors, of every series of edge tiles than of every one of averaged tiles; ") +
             several_sets_criterion,
         edges_beat_averaged},
        {"6.16-template", "6.16", "The border of template tiles brings too many artifacts into the spectrum.",
         "corner-based tiles have " + corners_beat_criterion(),
         [](const ClaimSeries& report) { return corners_beat(report, "template-tiles"); }},
        {"6.16-corner", "6.16", "Corner-based tiles produce better spectra than edge-based ones even with fewer tiles.",
         corners_beat_criterion(), [](const ClaimSeries& report) { return corners_beat(report, "edge-tiles"); }},
        {"6.16-penrose", "6.16", "The spectral properties of the method of Ostromoukhov et al. are below average.",
         below_average_criterion, [](const ClaimSeries& report) { return below_average(report, "penrose"); }},
        {"6.16-recursive", "6.16", "The spectral properties of the method of Kopf et al. are below average, too.",
         below_average_criterion,
         [](const ClaimSeries& report) { return below_average(report, "recursive-wang-tiles"); }},
        {"6.16-recursive-radius", "6.16", "The radius of the method of Kopf et al. is surprisingly low.",
         "below 0.5 in the worst realization of every series that draws points once; open where one set is not",
         low_radius},
    };
}

}

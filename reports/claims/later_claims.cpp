// Claims of papers after the dissertation about their methods, and about sets that were published.
//
// Published numbers of which it is not known how they were measured stand beside today's and are not judged.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

using Later = std::optional<ClaimOutcome>;

/// Mean anisotropy above chance of sets that have no direction; grids and rows have ten dB and more.
constexpr double isotropic_db = 1;
constexpr const char* isotropic_criterion = "the mean anisotropy of rings of 100 and more samples lies at most 1 dB "
                                            "above that of chance, by two standard errors";

/// One series without a direction refutes it, however many have one.
Later large_radii_have_directions(const ClaimSeries& report)
{
    int any = 0, refuted = 0, open = 0;
    std::vector<std::string> words;
    for (const ReportSeries* series : report.series()) {
        const auto& radius = series->stored->relative_radius;
        if (series->run->dimension != 2 || !radius || radius->mean <= 0.85 || !has_estimated_spectrum(*series))
            continue;
        const Estimate excess = mean_excess_anisotropy(*series);
        const Finding has_direction = is_above(excess, isotropic_db);
        ++any;
        refuted += has_direction == Finding::fails;
        open += has_direction == Finding::open;
        words.push_back(fmt::format("{}: radius {}, {} dB above chance", series->label, format_fixed(radius->mean, 3),
                                    with_error(excess, 2)));
    }
    if (any == 0) return std::nullopt;
    return ClaimOutcome{refuted > 0 ? Agreement::disagrees
                        : open > 0  ? Agreement::open
                                    : Agreement::agrees,
                        joined_words(words)};
}

/// No direction in any series of a method.
Later has_no_direction(const ClaimSeries& report, const char* sampler)
{
    Cases cases;
    for (const ReportSeries* series : report.all({.sampler = sampler, .needs = SeriesQuery::Needs::spectrum})) {
        const Estimate excess = mean_excess_anisotropy(*series);
        cases.add(is_below(excess, isotropic_db), with_error(excess, 2) + " dB above chance");
    }
    return cases.uncounted();
}

Later radius_is(const ClaimSeries& report, const char* sampler, double published, double tolerance)
{
    Cases cases;
    for (const ReportSeries* series : report.all({.sampler = sampler})) {
        if (!series->stored->relative_radius) continue;
        const Estimate mean = mean_of_realizations(*series->stored->relative_radius);
        cases.add(is_within(mean, published - tolerance, published + tolerance),
                  fmt::format("N = {}: {}", format_count(series->stored->points), with_error(mean, 4)));
    }
    return cases.uncounted();
}

/// Sets of equal areas have every mean nearest distance after some number of moves.
Later shown_equal_areas(const ClaimSeries& report)
{
    std::vector<std::string> words;
    for (const ReportSeries* series : report.all({.sampler = "equal-areas"}))
        if (const Estimate* nearest = estimate_of(*series, "mean_nearest_distance"))
            words.push_back(fmt::format("N = {}, {} moves: {}", format_count(series->stored->points),
                                        text_parameter(*series, "iterations"), with_error(*nearest, 4)));
    if (words.empty()) return std::nullopt;
    return ClaimOutcome{Agreement::shown, joined_words(words)};
}

/// The mean nearest distance of a method with its usual parameters.
Later nearest_distance_is(const ClaimSeries& report, const SeriesQuery& query, double published, double tolerance)
{
    Cases cases;
    for (const ReportSeries* series : report.all(query))
        if (const Estimate* nearest = estimate_of(*series, "mean_nearest_distance")) {
            cases.add(is_within(*nearest, published - tolerance, published + tolerance),
                      fmt::format("N = {}: {}", format_count(series->stored->points), with_error(*nearest, 4)));
        }
    return cases.uncounted();
}

Later first_parts_are_good(const ClaimSeries& report)
{
    Cases cases;
    for (const ReportSeries* series : report.all({.sampler = "sample-elimination"})) {
        const Estimate* parts = estimate_of(*series, "prefix_relative_radius");
        if (!parts || !series->stored->relative_radius) continue;
        const double whole = series->stored->relative_radius->mean;
        cases.add(is_above(*parts, 0.85 * whole),
                  fmt::format("{}, the whole sets {}", with_error(*parts, 3), format_fixed(whole, 3)));
    }
    return cases.uncounted();
}

/// Gaussian blue noise against equal areas, of as many points.
Later has_less_low_power(const ClaimSeries& report)
{
    Cases cases;
    for (const ReportSeries* series : of_even_density(report, "gaussian-blue-noise", SeriesQuery::Needs::anything))
        for (const ReportSeries* other : report.all({.sampler = "equal-areas", .points = series->stored->points})) {
            const Estimate *own = estimate_of(*series, "low_frequency_mean"),
                           *theirs = estimate_of(*other, "low_frequency_mean");
            if (!own || !theirs) continue;
            cases.add(is_below(difference_of(*own, *theirs), 0),
                      fmt::format("N = {}: {} against {}", format_count(series->stored->points),
                                  format_significant(own->value, 2), format_significant(theirs->value, 2)));
        }
    return cases.uncounted();
}

/// The power towards frequency 0 of saturated dart throwing.
Later saturated_power_is(const ClaimSeries& report, int dimension, double published)
{
    Cases cases;
    for (const ReportSeries* series : report.all({.sampler = "dart-throwing", .dimension = dimension})) {
        const auto& power = series->stored->measures.low_frequency_power;
        if (text_parameter(*series, "stop") != "saturation" || !power || series->stored->realizations < 2) continue;
        const double errors = std::abs(power->intercept - published) / power->intercept_standard_error;
        cases.add(errors <= 3   ? Finding::holds
                  : errors <= 5 ? Finding::open
                                : Finding::fails,
                  with_error({power->intercept, power->intercept_standard_error}, 4));
    }
    return cases.uncounted();
}

/// Makes the claim of a paper that shows its spectrum as a curve.
PaperClaim drawn_spectrum(const char* id, const char* sampler)
{
    return nyquist_and_oscillation(
        id, "The spectrum is blue noise, with an effective Nyquist frequency and an oscillation.",
        "shown beside those of other methods: numbers of the paper were not at hand", sampler);
}

Paper farthest_points()
{
    return {
        "schloemer-2011",
        "Schlömer, Heck and Deussen, <cite>Farthest-Point Optimized Point Sets with Maximized Minimum Distance</cite> "
        "(2011)",
        {{"schloemer-2011-radius", "fig. 1", "The nearest two points come to have 0.925 of the largest distance.",
          "a mean relative radius within 0.002 of it",
          [](const ClaimSeries& report) { return radius_is(report, "farthest-point", 0.925, 0.002); }},
         {"schloemer-2011-mean", "fig. 1", "On average the nearest point is at 0.932 of it.",
          "a mean nearest distance within 0.002 of it",
          [](const ClaimSeries& report) {
              return nearest_distance_is(report, {.sampler = "farthest-point"}, 0.932, 0.002);
          }},
         {"schloemer-2011-isotropic", "", "The sets are isotropic nevertheless.", isotropic_criterion,
          [](const ClaimSeries& report) { return has_no_direction(report, "farthest-point"); }},
         nyquist_and_oscillation("schloemer-2011-spectrum",
                                 "10 sets of 4,096 points have an effective Nyquist frequency of about 0.9 and an "
                                 "oscillation of about 4.6, "
                                 "almost twice that of other sets with so high a frequency.",
                                 "shown side by side: spectra were computed in another way", "farthest-point")}};
}

std::vector<PaperClaim> claims_about_published_sets()
{
    const auto nearest = [](const char* id, const char* says, const char* sampler, double published,
                            double tolerance) -> PaperClaim {
        return {id, "", says, fmt::format("a mean nearest distance within {} of it", tolerance),
                [=](const ClaimSeries& report) {
                    return nearest_distance_is(report, {.sampler = sampler}, published, tolerance);
                }};
    };
    return {nearest("utk-sets-fpo", "4,096 points of farthest point optimisation: 0.9325 on average to the nearest.",
                    "farthest-point", 0.9325, 0.002),
            {"utk-sets-bnot", "", "4,096 points with equal capacities (BNOT): 0.896 on average to the nearest.",
             "shown: every move makes sets more regular, and how many the published ones had is not known",
             shown_equal_areas},
            {"utk-sets-darts", "", "4,096 points of dart throwing at 0.75: 0.806 on average to the nearest.",
             "a mean nearest distance within 0.005 of it", [](const ClaimSeries& report) {
                 return nearest_distance_is(
                     report, {.sampler = "dart-throwing", .numbers = {{"relative_radius", 0.75}}}, 0.806, 0.005);
             }}};
}

}

std::vector<Paper> later_papers()
{
    return {
        {"lagae-2008",
         "Lagae and Dutré, <cite>A Comparison of Methods for Generating Poisson Disk Distributions</cite> (2008)",
         {{"lagae-2008-regular", "", "Relative radii above 0.85 are those of regular sets: they are anisotropic.",
           "more than 1 dB of anisotropy above chance, on average over rings of 100 and more samples that have power, "
           "in "
           "every series with such a radius, by two standard errors",
           large_radii_have_directions}}},
        paper_on_even_tilings(),
        farthest_points(),
        {"degoes-2012",
         "de Goes, Breeden, Ostromoukhov and Desbrun, <cite>Blue Noise through Optimal Transport</cite> (2012)",
         {{"degoes-2012-isotropic", "", "Sets with equal capacities are free of regular patches.", isotropic_criterion,
           [](const ClaimSeries& report) { return has_no_direction(report, "equal-areas"); }},
          drawn_spectrum("degoes-2012-spectrum", "equal-areas")}},
        {"heck-2013", "Heck, Schlömer and Deussen, <cite>Blue Noise Sampling with Controlled Aliasing</cite> (2013)",
         claims_about_controlled_aliasing()},
        {"zhang-2013",
         "Zhang and Torquato, <cite>Precise Algorithm to Generate Random Sequential Addition of Hard Hyperspheres at "
         "Saturation</cite> (2013)",
         {{"zhang-2013-2d", "", "The power of saturated dart throwing goes to 0.0587 towards frequency 0 in 2D.",
           "within three standard errors of the fitted parabola; open up to five",
           [](const ClaimSeries& report) { return saturated_power_is(report, 2, 0.0587); }},
          {"zhang-2013-3d", "", "The power of saturated dart throwing goes to 0.0558 towards frequency 0 in 3D.",
           "within three standard errors of the fitted parabola; open up to five",
           [](const ClaimSeries& report) { return saturated_power_is(report, 3, 0.0558); }}}},
        {"yuksel-2015",
         "Yuksel, <cite>Sample Elimination for Generating Poisson Disk Sample Sets</cite> (2015)",
         {{"yuksel-2015-prefixes", "4", "In progressive order every first part of a set is a Poisson disk set.",
           "the relative radius of the first half, quarter and eighth is at least 0.85 of that of the whole sets, by "
           "two "
           "standard errors",
           first_parts_are_good},
          drawn_spectrum("yuksel-2015-spectrum", "sample-elimination")}},
        {"ahmed-2022",
         "Ahmed, Ren and Wonka, <cite>Gaussian Blue Noise</cite> (2022)",
         {{"ahmed-2022-low", "", "Gaussian blue noise has less power at low frequencies than sets of equal capacities.",
           "a lower mean power up to a quarter of √N, by two standard errors, of as many points", has_less_low_power},
          drawn_spectrum("ahmed-2022-spectrum", "gaussian-blue-noise")}},
        {"utk-sets", "Point sets that the Uni(corn|form) Tool Kit published, one of each, measured here (2019)",
         claims_about_published_sets()},
    };
}

}

// The dissertation's claims about what tiles are for: section 4.7 and chapter 7, by the numbers of distributions.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using ApplicationOutcome = std::optional<ClaimOutcome>;

/// The best two tiles of 16 points: 0.6966, which is very symmetric, and 0.6528.
ApplicationOutcome radii_of_16_points(const ClaimSeries& report)
{
    Cases cases;
    for (const DistributionResult* search : report.distributions("self-similar-tile")) {
        if (std::ranges::find(search->facts, "16 points") == search->facts.end()) continue;
        for (const auto& [key, value] : {std::pair{"radius_1", 0.6966}, {"radius_2", 0.6528}})
            if (const auto radius = number_of(*search, key)) {
                cases.add(std::abs(*radius - value) < 5e-5, format_significant(*radius, 4));
            }
    }
    return cases.outcome();
}

ApplicationOutcome clumps_of_warping(const ClaimSeries& report)
{
    int warps = 0, clumps = 0;
    std::vector<double> least, before, mean, mean_before;
    for (const DistributionResult* warp : report.distributions("warp")) {
        const auto l = number_of(*warp, "least_spacing"), b = number_of(*warp, "least_spacing_before");
        const auto m = number_of(*warp, "mean_spacing"), n = number_of(*warp, "mean_spacing_before");
        if (!l || !b || !m || !n) continue;
        least.push_back(*l);
        before.push_back(*b);
        mean.push_back(*m);
        mean_before.push_back(*n);
        ++warps;
        clumps += *l < *b / 2 && *m < *n;
    }
    if (warps == 0) return std::nullopt;
    return ClaimOutcome{
        agreement_if(clumps > 0),
        joined_words({fmt::format("least {}, {} before", range_words(least, 2), range_words(before, 2)),
                      fmt::format("mean {}, {} before", range_words(mean, 2), range_words(mean_before, 2)),
                      fmt::format("in {} of {}", clumps, warps)})};
}

/// Ranked points of densities: periodic in constant regions, but as many as are asked for.
ApplicationOutcome numbers_of_zooms(const ClaimSeries& report)
{
    Cases cases;
    std::vector<double> errors;
    for (const char* kind : {"ranks", "stippling"})
        for (const DistributionResult* ranked : report.distributions(kind)) {
            const auto asked = number_of(*ranked, "asked_for"), points = number_of(*ranked, "points");
            if (!asked || !points) continue;
            errors.push_back(100 * (*points / *asked - 1));
            cases.add(std::abs(errors.back()) < 5);
        }
    return cases.outcome(range_words(errors, 2) + " % more than asked for");
}

ApplicationOutcome instances_of_a_forest(const ClaimSeries& report)
{
    Cases cases;
    std::vector<double> ratios;
    for (const DistributionResult* instances : report.distributions("instances")) {
        const auto n = number_of(*instances, "instances"), expected = number_of(*instances, "expected");
        if (!n || !expected || *expected <= 0) continue;
        ratios.push_back(*n / *expected);
        const double errors = std::abs(*n - *expected) / std::sqrt(*expected);
        cases.add(errors < 2 ? Finding::holds : errors < 4 ? Finding::open : Finding::fails);
    }
    return cases.outcome(range_words(ratios, 3) + " of the expected number");
}

/// A look-up in calls of Perlin's noise, of objects in the plane or in space. Shaders look up rows of pixels, where
/// noise is cheaper; which order the dissertation timed is not known.
std::function<ApplicationOutcome(const ClaimSeries&)> calls_of_noise(int dimension)
{
    return [dimension](const ClaimSeries& report) -> ApplicationOutcome {
        std::vector<double> anywhere, in_rows;
        for (const DistributionResult* objects : report.distributions("objects")) {
            const auto d = number_of(*objects, "timed_dimension");
            const auto random = number_of(*objects, "noise_calls_anywhere");
            const auto rows = number_of(*objects, "noise_calls_in_rows");
            if (d != dimension || !random || !rows) continue;
            anywhere.push_back(*random);
            in_rows.push_back(*rows);
        }
        if (anywhere.empty()) return std::nullopt;
        return ClaimOutcome{Agreement::shown, joined_words({range_words(anywhere, 2) + " calls at random places",
                                                            range_words(in_rows, 2) + " in rows of pixels"})};
    };
}

}

std::vector<PaperClaim> claims_about_applications()
{
    const char* const calls_shown = "shown: times depend on the machine, and on the order of the places";
    return {
        {"4.7-radii", "4.7",
         "The best self-similar tile of 16 points has a relative radius of 0.6966, the second one of 0.6528.",
         "both radii have these four digits", radii_of_16_points},
        {"7.2-clumping", "7.2", "Warping can introduce clumping.",
         "by some density nearest distances, in parts of the largest ones that it allows, are smaller on average than "
         "before, and the least one is less than half of that before",
         clumps_of_warping},
        {"7.3-zoom", "7.3",
         "The self-similar tile gives about as many points of a picture as of its zoom-ins (figure 7.4).",
         "within 5 % of the number that is asked for", numbers_of_zooms},
        {"7.5-instances", "7.5",
         "Tiles place over 2,000 trees of a forest, several thousand asteroids of a belt, by evaluating a distribution "
         "locally.",
         "numbers in windows within two square roots of those expected, as those of random points are 19 times in 20; "
         "open "
         "up to four",
         instances_of_a_forest},
        {"7.6-noise-2d", "7.6",
         "A look-up of the procedural object distribution function costs about as much as 5 calls of Perlin's noise.",
         calls_shown, calls_of_noise(2)},
        {"7.6-noise-3d", "7.6",
         "In space a look-up of the object distribution function costs about as much as 20 calls.", calls_shown,
         calls_of_noise(3)},
    };
}

}

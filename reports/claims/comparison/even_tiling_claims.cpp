// Claims of Gabrielli, Joyce and Torquato about points in tiles: what tiles have in common decides how even tilings
// are.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/tile_spectra.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace poissonlab {
namespace {

struct TileMethod
{
    const char* sampler;
    int dimension;
};
constexpr std::array tile_methods{TileMethod{"corner-tiles", 2}, TileMethod{"edge-tiles", 2},
                                  TileMethod{"template-tiles", 2}, TileMethod{"sphere-tiles", 3}};

double moments_asked(const ReportSeries& series) { return number_parameter(series, "equal_moments").value_or(0); }

/// Tilings whose tiles keep all of their points: those that are left out are not the same of all tiles.
std::vector<SeriesPointer> whole_tilings(const ClaimSeries& report)
{
    std::vector<SeriesPointer> found;
    for (const TileMethod& method : tile_methods)
        for (SeriesPointer series : report.all({.sampler = method.sampler, .dimension = method.dimension}))
            if (number_parameter(*series, "density").value_or(1) == 1) found.push_back(series);
    return found;
}

/// The mean power below 0.4 of the frequency at which tiles of so many points repeat.
std::optional<double> power_below_tiles(const ReportSeries& series, double points_of_tile)
{
    const double tiles = static_cast<double>(series.stored->points) / points_of_tile;
    const auto power = mean_power(series, 0, 0.4 * std::pow(tiles, 1.0 / series.run->dimension));
    return power ? std::optional(power->value) : std::nullopt;
}

/// Says how much less power tilings with equal moments have there than sets without tiles.
std::string words_on_untiled(const ClaimSeries& report, const std::vector<SeriesPointer>& tilings)
{
    std::vector<double> ratios;
    for (SeriesPointer series : tilings) {
        if (moments_asked(*series) == 0) continue;
        const double points = points_per_tile(*series);
        const auto own = power_below_tiles(*series, points);
        for (const char* sampler : {"lloyd", "gaussian-blue-noise", "equal-areas"})
            for (SeriesPointer other : report.all({.sampler = sampler, .dimension = series->run->dimension})) {
                const auto theirs = power_below_tiles(*other, points);
                if (own && theirs && *theirs > 0 && !follows_density(*other)) ratios.push_back(*own / *theirs);
            }
    }
    if (ratios.empty()) return "";
    return fmt::format("below 0.4 of the tiles' frequency those with equal moments have {} times the power of sets "
                       "without tiles",
                       range_words(ratios, 2));
}

std::optional<ClaimOutcome> exponent_follows_moments(const ClaimSeries& report)
{
    Tally tally;
    std::vector<std::string> words;
    const std::vector<SeriesPointer> tilings = whole_tilings(report);
    for (SeriesPointer series : tilings) {
        const Estimate* const exponent = estimate_of(*series, "hyperuniformity_exponent");
        if (exponent == nullptr) continue;
        const double moments = moments_asked(*series);
        tally.add(is_above(*exponent, 2 * moments + 1));
        if (moments > 0) words.push_back(fmt::format("m = {}: {}", moments, with_error(*exponent, 2)));
    }
    if (words.empty()) return std::nullopt; // tilings of order 0 alone say nothing of moments
    words.push_back(words_on_untiled(report, tilings));
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

}

Paper paper_on_even_tilings()
{
    return {
        "gabrielli-2008",
        "Gabrielli, Joyce and Torquato, <cite>Tilings of Space and Superhomogeneous Point Processes</cite> (2008)",
        {{"gabrielli-2008-exponent", "",
          "The power of points in tiles falls, towards frequency 0, with an exponent that the moments which tiles have "
          "in common decide: up to order m they give 2 (m + 1), as high as is wanted.",
          "the exponent of all tilings, below 0.4 of the tiles' frequency, is above 2 m + 1, so that it is nearer to "
          "that than to what one order less gives, by two standard errors; m = 0 where only numbers of points are "
          "equal",
          exponent_follows_moments}}};
}

}

// The tilings of a report whose spectra and pictures the papers' claims are about, and how many tile sets they rest on.
#pragma once

#include "reports/claims/claim_series.hpp"
#include "reports/claims/findings.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

using SeriesPointer = const ReportSeries*;

double points_per_tile(const ReportSeries& series);

/// Tiles in the set, of series that have one.
double set_size(const ReportSeries& series);

/// The mean ratio of the lattice's peaks, of series that have some, with its error.
Estimate mean_peak(const ReportSeries& series);

/// The share of the power that lies on the lattice of a tiling's frequencies; empty where it was not measured.
std::optional<Estimate> lattice_share(const ReportSeries& series);

/// The share that points have on the lattice which tiles have in common, if these are random: with the probability s
/// that a point of a tile is in another tile of the tiling as well, and 1 - s spread over all frequencies alike,
/// s + q (1 - s). Empty where the tile set did not say how many are.
std::optional<double> predicted_lattice_share(const ReportSeries& series);

/// Anisotropy between the peaks, in dB above chance; empty: not measured.
std::optional<double> speckle(const ReportSeries& series);

bool has_chains(const ReportSeries& series);

/// Spectra of tilings with their lattice peaks, of usual points and of the papers' kind: without chains, without
/// relaxing all tiles together, without points left out.
std::vector<SeriesPointer> tiling_spectra(const ClaimSeries& report, const std::string& sampler);

/// Pictures of the zone plate by such tilings.
std::vector<SeriesPointer> tiling_plates(const ClaimSeries& report, const std::string& sampler);

/// Remembers whether series rest on one tile set each. Sets of the same parameters differ, by a factor of two in the
/// power on their lattice, so that one of each leaves a comparison open.
class TileSetFlag
{
public:
    /// The finding, or open where a series takes its tiles from one set.
    Finding if_several(std::initializer_list<SeriesPointer> series, Finding finding);

    /// Says that errors between sets are not known, where a series took its tiles from one set; else nothing.
    std::string words() const;

private:
    bool has_single_ = false;
};
inline constexpr auto several_sets_criterion =
    "open where there is one tile set of each: sets of equal parameters differ";

/// Pairs of a series of each list with equal N.
template <typename Visit>
void for_equal_points(const std::vector<SeriesPointer>& first, const std::vector<SeriesPointer>& second,
                      const Visit& visit)
{
    for (SeriesPointer a : first)
        for (SeriesPointer b : second)
            if (points_per_tile(*a) == points_per_tile(*b)) visit(*a, *b);
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

/// Compares false plates: whether the first is weaker. Open where they differ by no more than noise alone gives once in
/// 100 pictures; empty without pictures.
std::optional<Finding> has_weaker_plates(const ClaimSeries& report, const ReportSeries& first,
                                         const ReportSeries& second);

/// Pictures are of one tile set each: fewer comparisons leave open what they say.
inline constexpr int fewest_pictures = 3;
inline constexpr auto pictures_criterion =
    "open where strengths differ by no more than noise alone gives, and with fewer than three comparisons, as each "
    "picture is of one tile set";

}

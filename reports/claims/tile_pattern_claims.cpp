// Claims about what tiles leave in spectra beside the lattice's peaks, and about where their points are: sections 6.9
// to 6.11.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/tile_spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// A set of edge tiles has few edges, however many tiles: with two colours each is in half of all places, and what it
/// does to the points around it adds up over a tiling. Corner tiles whose pieces are as rare show none of it.
std::optional<ClaimOutcome> wavelike_artifacts(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> edges, corners;
    const auto corner_sets = tiling_spectra(report, "corner-tiles");
    for (SeriesPointer edge : tiling_spectra(report, "edge-tiles")) {
        SeriesPointer largest = nullptr;
        for_equal_points({edge}, corner_sets, [&](const ReportSeries&, const ReportSeries& corner) {
            if (!largest || set_size(corner) > set_size(*largest)) largest = &corner;
        });
        if (!largest) continue;
        edges.push_back(speckle(*edge));
        corners.push_back(speckle(*largest));
        tally.add(edges.back() > corners.back());
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({fmt::format("{} dB above chance, corner tiles {}",
                                                                     range_words(edges, 2), range_words(corners, 2)),
                                                         "two edges a direction explain them", tally.words()})};
}

/// The power of the ring with the first lattice frequencies over that of the rings two and three away.
std::optional<double> ring_of_lattice(const ReportSeries& series)
{
    const int first = series.stored->measures.lattice_peaks->tiles;
    double ring = 0, around = 0;
    int rings = 0;
    for (const RadialBin& bin : series.curve.bins) {
        const int away = static_cast<int>(std::abs(std::lround(bin.frequency) - first));
        if (away == 0) ring = bin.power;
        if (away != 2 && away != 3) continue;
        around += bin.power;
        ++rings;
    }
    if (rings < 4 || !(around > 0)) return std::nullopt;
    return ring * rings / around;
}

std::optional<ClaimOutcome> peaks_in_radial_power(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    for (SeriesPointer series : tiling_spectra(report, "template-tiles")) {
        const auto ratio = ring_of_lattice(*series);
        if (!ratio) continue;
        ratios.push_back(*ratio);
        tally.add(*ratio > 2);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(),
                        joined_words({range_words(ratios, 2) + " times the power beside it", tally.words()})};
}

/// The mean number of points of a tile in the regions of this name.
std::optional<double> region_points_of(const ReportSeries& series, const std::string& name)
{
    if (!series.stored->tile_set) return std::nullopt;
    const auto& regions = series.stored->tile_set->regions;
    const auto found = std::ranges::find(regions, name, &RegionPoints::name);
    return found == regions.end() ? std::nullopt : std::optional(found->points);
}

/// Corners are octagons with sides of two radii, whose area goes with 1 / N; strips are as wide, but as long as tiles.
std::optional<ClaimOutcome> few_points_near_corners(const ClaimSeries& report)
{
    std::vector<double> corners, edges;
    for (SeriesPointer series : report.all({.sampler = "corner-tiles"})) {
        const auto corner = region_points_of(*series, "corners"), edge = region_points_of(*series, "edges");
        if (!corner || !edge || number_parameter(*series, "relative_radius").value_or(0) != 0.75) continue;
        corners.push_back(*corner);
        edges.push_back(*edge);
    }
    if (corners.size() < 2) return std::nullopt;
    const double first = corners.front();
    Tally tally;
    for (std::size_t i = 0; i < corners.size(); ++i)
        tally.add(std::abs(corners[i] - first) <= 0.5 && 1.5 * corners[i] <= edges[i]);
    return ClaimOutcome{tally.agreement(), joined_words({fmt::format("{} near corners, {} near edges",
                                                                     range_words(corners, 2), range_words(edges, 2)),
                                                         tally.words()})};
}

}

std::vector<PaperClaim> claims_about_patterns()
{
    return {
        {"6.9-wavelike", "6.9", "The spectra of edge tiles show strange wavelike artifacts, which cannot be explained.",
         "anisotropy between the peaks above that of the largest set of corner tiles with as many points a tile",
         wavelike_artifacts},
        {"6.10-radial", "6.10", "The peaks of template tiles turn up in the radially averaged power as well.",
         "the ring with the first frequencies of the lattice has more than twice the power of the rings two and three "
         "away",
         peaks_in_radial_power},
        {"6.11-corner-points", "6.11",
         "The number of points near corners is constant, and much smaller than that near edges.",
         "points of a tile near corners within half a point of each other, and those near edges 1.5 times as many, at "
         "a relative radius of 0.75; counting areas predicts it",
         few_points_near_corners},
    };
}

}

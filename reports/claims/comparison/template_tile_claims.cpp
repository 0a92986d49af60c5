// Claims of section 6.10 about template tiles.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/tile_quality.hpp"
#include "reports/words/number_format.hpp"

#include <cmath>

namespace poissonlab {
namespace {

using TemplateOutcome = std::optional<ClaimOutcome>;

TemplateOutcome many_tiles_are_alike(const ClaimSeries& report)
{
    constexpr double one_db = 1.26;
    Cases cases;
    TileSetFlag flag;
    std::vector<Estimate> ratios;
    const auto all = tiling_spectra(report, "template-tiles");
    for_equal_points(all, all, [&](const ReportSeries& a, const ReportSeries& b) {
        if (set_size(a) != 128 || set_size(b) != 256) return;
        ratios.push_back(ratio_of(mean_peak(b), mean_peak(a)));
        cases.add(flag.if_several({&a, &b}, is_within(ratios.back(), 1 / one_db, one_db)));
    });
    return cases.outcome("mean peaks " + range_words(ratios, 3) + " times those of 128 tiles", flag.words());
}

/// Template tiles against sets of other kinds with as many points a tile.
TemplateOutcome template_peaks_beside_others(const ClaimSeries& report)
{
    std::vector<double> ratios, predicted;
    for (const char* sampler : {"corner-tiles", "edge-tiles"})
        for_equal_points(tiling_spectra(report, "template-tiles"), tiling_spectra(report, sampler),
                         [&](const ReportSeries& template_tiles, const ReportSeries& other) {
                             ratios.push_back(mean_peak(template_tiles).value / mean_peak(other).value);
                             const auto a = predicted_lattice_share(template_tiles), b = predicted_lattice_share(other);
                             if (a && b) predicted.push_back(*a / *b);
                         });
    if (ratios.empty()) return std::nullopt;
    return ClaimOutcome{Agreement::shown,
                        joined_words({range_words(ratios, 2) + " times as high as those of other tiles",
                                      predicted.empty() ? ""
                                                        : "points in common predict shares of the power that are " +
                                                              range_words(predicted, 2) + " times as large"})};
}

TemplateOutcome peaks_in_anisotropy(const ClaimSeries& report)
{
    return over(tiling_spectra(report, "template-tiles"), peak_excess_anisotropy, above(10), 2, " dB above chance");
}

/// The power of the ring with the first lattice frequencies over that of the rings two and three away.
std::optional<Estimate> ring_of_lattice(const ReportSeries& series)
{
    const int first = series.stored->measures.lattice_peaks->tiles;
    Estimate ring;
    double around = 0;
    int rings = 0;
    for (const RadialBin& bin : series.curve.bins) {
        const int away = static_cast<int>(std::abs(std::lround(bin.frequency) - first));
        if (away == 0) ring = {bin.power, bin.power_error};
        if (away != 2 && away != 3) continue;
        around += bin.power;
        ++rings;
    }
    if (rings < 4 || !(around > 0)) return std::nullopt;
    const double scale = rings / around;
    return Estimate{ring.value * scale, *ring.standard_error * scale};
}

TemplateOutcome peaks_in_radial_power(const ClaimSeries& report)
{
    return over(tiling_spectra(report, "template-tiles"), ring_of_lattice, above(2), 2, " times the power beside it");
}

TemplateOutcome plates_improve(const ClaimSeries& report)
{
    Cases cases(fewest_pictures);
    std::vector<double> ratios;
    const auto visit = [&](const ReportSeries& fewer, const ReportSeries& more) {
        const auto finding = has_weaker_plates(report, more, fewer);
        if (!finding) return;
        ratios.push_back(report.false_rings(more)->strength / report.false_rings(fewer)->strength);
        cases.add(*finding);
    };
    const auto plates = tiling_plates(report, "template-tiles");
    for_neighbours(plates, points_per_tile, set_size, visit);
    for_neighbours(plates, set_size, points_per_tile, visit);
    return cases.outcome(range_words(ratios, 2) + " times as strong");
}

bool is_large(SeriesPointer series) { return set_size(*series) >= 32 && points_per_tile(*series) >= 32; }

bool is_small(SeriesPointer series) { return set_size(*series) <= 16 || points_per_tile(*series) <= 24; }

}

std::vector<PaperClaim> claims_about_template_tiles()
{
    return {
        {"6.10-bad", "6.10",
         "Spectra of template tiles with 16 or 24 points a tile, or with 1 to 16 tiles, are rather bad.",
         calibration_criterion(),
         [](const ClaimSeries& report) {
             return shown_spectra(tiling_spectra(report, "template-tiles"), false, is_small);
         }},
        {"6.10-good", "6.10", "Spectra of template tiles with at least 32 points a tile and 32 tiles are rather good.",
         calibration_criterion(),
         [](const ClaimSeries& report) {
             return shown_spectra(tiling_spectra(report, "template-tiles"), true, is_large);
         }},
        {"6.10-order", "6.10",
         "Spectra of template tiles with at least 32 points a tile and 32 tiles are better than all others.",
         order_criterion(),
         [](const ClaimSeries& report) { return are_better(tiling_spectra(report, "template-tiles"), is_large); }},
        {"6.10-alike", "6.10", "Spectra of 128 and 256 template tiles are not that different.",
         std::string("mean peaks within 1 dB of each other, a factor of 1.26, by two standard errors; ") +
             several_sets_criterion,
         many_tiles_are_alike},
        {"6.10-pronounced", "6.10",
         "The lattice of peaks of template tiles is more pronounced than with other tiles, because the tiles have the "
         "template's points in common.",
         "shown, as it follows from how the tiles are made: mean peaks of template tiles over those of corner and edge "
         "tiles with as many points a tile",
         template_peaks_beside_others},
        {"6.10-anisotropy", "6.10", "The peaks of template tiles turn up in the anisotropy as well.",
         "the ring with the largest anisotropy is at least 10 dB above chance, by two standard errors",
         peaks_in_anisotropy},
        {"6.10-radial", "6.10", "The peaks of template tiles turn up in the radially averaged power as well.",
         "the ring with the first frequencies of the lattice has more than twice the power of the rings two and three "
         "away, by two standard errors",
         peaks_in_radial_power},
        {"6.10-plate", "6.10",
         "The zone plate by template tiles shows severe structured aliasing, whatever the parameters.",
         false_plates_criterion,
         [](const ClaimSeries& report) { return false_plates(report, tiling_plates(report, "template-tiles"), true); }},
        {"6.10-improves", "6.10",
         "The zone plate by template tiles improves with more tiles and with more points a tile.",
         std::string("the strongest false plate of each series is weaker with the next larger number of tiles, or of "
                     "points a tile; ") +
             pictures_criterion,
         plates_improve},
    };
}

}

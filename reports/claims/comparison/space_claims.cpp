// Claims of section 6.15 about Poisson sphere distributions by dart throwing, by relaxation dart throwing and by tiles.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/tile_spectra.hpp"

namespace poissonlab {
namespace {

using SpaceOutcome = std::optional<ClaimOutcome>;

SpaceOutcome relaxation_in_space(const ClaimSeries& report)
{
    auto query = relaxation_darts(0.99, 1000);
    query.points.reset();
    query.dimension = 3;
    Cases cases;
    std::vector<double> radii;
    for (const ReportSeries* series : report.all(query)) {
        if (!series->stored->relative_radius) continue;
        radii.push_back(series->stored->relative_radius->mean);
        cases.add(is_radius_of_the_text(*series->stored->relative_radius, 0.70));
    }
    return cases.outcome(range_words(radii, 3));
}

std::vector<const ReportSeries*> spectra_in_space(const ClaimSeries& report, const char* sampler)
{
    return report.all({.sampler = sampler, .dimension = 3, .needs = SeriesQuery::Needs::spectrum});
}

SpaceOutcome sphere_tiles_are_anisotropic(const ClaimSeries& report)
{
    Cases cases;
    TileSetFlag flag;
    std::vector<Estimate> values;
    for (const ReportSeries* series : spectra_in_space(report, "sphere-tiles")) {
        values.push_back(mean_excess_anisotropy(*series));
        cases.add(flag.if_several({series}, is_above(values.back(), 0.5)));
    }
    return cases.outcome(range_words(values, 2) + " dB above it", flag.words());
}

SpaceOutcome sphere_tiles_are_blue_noise(const ClaimSeries& report)
{
    const auto series = spectra_in_space(report, "sphere-tiles");
    auto outcome = all_blue_noise(series);
    if (!outcome) return outcome;
    TileSetFlag flag;
    for (const ReportSeries* one : series)
        if (flag.if_several({one}, Finding::holds) == Finding::open) outcome->agreement = Agreement::open;
    outcome->measured = joined_words({outcome->measured, flag.words()});
    return outcome;
}

}

std::vector<PaperClaim> claims_about_spheres()
{
    return {
        reach_claim("6.15-darts", "6.15", "In 3D, dart throwing reaches relative radii of up to 0.70.",
                    {.sampler = "dart-throwing", .dimension = 3}, 0.70),
        {"6.15-relaxation", "6.15",
         "In 3D, relaxation dart throwing with a factor of 0.99 after 1,000 failures reaches 0.70.",
         radius_of_the_text_criterion, relaxation_in_space},
        {"6.15-spectrum", "6.15",
         "The spectrum of Poisson sphere distributions by dart throwing is that of blue noise.", blue_noise_criterion,
         [](const ClaimSeries& report) { return all_blue_noise(spectra_in_space(report, "dart-throwing")); }},
        {"6.15-symmetry", "6.15", "The spectrum of Poisson sphere distributions is radially symmetric.",
         low_anisotropy_criterion,
         [](const ClaimSeries& report) { return has_low_anisotropy(spectra_in_space(report, "dart-throwing")); }},
        reach_claim("6.15-tiles-radius", "6.15", "Poisson sphere tiles reach a large relative radius, 0.75.",
                    {.sampler = "sphere-tiles", .dimension = 3}, 0.75),
        {"6.15-tiles-radial", "6.15", "The radially averaged power of sphere tiles is rather good.",
         blue_noise_criterion, sphere_tiles_are_blue_noise},
        {"6.15-tiles-anisotropy", "6.15", "The anisotropy of sphere tiles is a bit high.",
         std::string("the mean over shells of at least 100 samples is more than 0.5 dB above what chance gives, ") +
             several_sets_criterion,
         sphere_tiles_are_anisotropic},
    };
}

}

// Claims of the class notes, and of papers after the dissertation.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;

std::vector<ClaimCase> polyomino_cases()
{
    return {
        {"notes-2008-fast",
         [](MadeUpReport& r, Told what) {
             set_seconds(r.add("polyominoes", {}), told(what, 0.001, 0.2, 0.02));
             set_seconds(darts(r, "0.75"), 0.02);
         },
         Kind::shown},
        {"notes-2008-blue-noise",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(r.add("polyominoes", {}),
                                     {.low = told(what, 0.05, 0.5, 0.2), .error = told(what, 0.01, 0.01, 0.2)});
         }},
        {"notes-2008-no-artifacts",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(r.add("polyominoes", {}), {.spike = told(what, 3.0, 20.0, 10.0)});
         }},
        {"notes-2008-penrose",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(r.add("polyominoes", {}), {.spike = 12.0});
             MadeUpReport::set_curve(r.add("penrose", {}), {.spike = told(what, 20.0, 8.0, 13.0)});
         }},
    };
}

/// The power of full sets towards frequency 0, with an error of 0.0002.
void full_sets_with_power(MadeUpReport& report, int dimension, double power)
{
    LowFrequencyPower fit;
    fit.intercept = power;
    fit.intercept_standard_error = 0.0002;
    stored_of(full_darts(report, dimension)).measures.low_frequency_power = fit;
}

ClaimCase isotropy(const char* id, const char* sampler)
{
    return {id, [sampler](MadeUpReport& r, Told what) {
                MadeUpReport::set_curve(r.add(sampler, {}), {.anisotropy = told(what, 0.1, 5.0, 1.0), .scatter = 1});
            }};
}

ClaimCase nearest_distance(const char* id, const char* sampler, double published)
{
    return {id, [=](MadeUpReport& r, Told what) {
                ReportSeries& series = r.add(sampler, {{"relative_radius", "0.75"}});
                set_number(series, "mean_nearest_distance", published + told(what, 0.0, 0.02, 0.002),
                           told(what, 1e-4, 1e-4, 0.01));
            }};
}

ClaimCase shown_spectrum(const char* id, const char* sampler)
{
    return {id,
            [sampler](MadeUpReport& r, Told what) {
                ReportSeries& series = r.add(sampler, {});
                MadeUpReport::set_curve(series, {});
                set_number(series, "effective_nyquist", told(what, 0.9, 0.1, 0.6));
                set_oscillation(series, told(what, 1.0, 9.0, 4.0));
            },
            Kind::shown};
}

std::vector<ClaimCase> heck_cases()
{
    return {
        {"heck-2013-step",
         [](MadeUpReport& r, Told what) {
             // Half a ring of 16,384 points is 0.0039 of their root.
             ReportSeries& series = with_target(r, "step", 0.59);
             set_number(series, "effective_nyquist", told(what, 0.6, 0.65, 0.603), 0.001);
             ReportSeries& cannot_be = r.add("target-spectrum", {{"target", "step"}, {"frequency", "0.7"}});
             MadeUpReport::set_curve(cannot_be, {});
             set_number(cannot_be, "effective_nyquist", 0.7);
         }},
        {"heck-2013-peak",
         [](MadeUpReport& r, Told what) {
             ReportSeries& series = with_target(r, "single-peak", 0.7);
             set_number(series, "effective_nyquist", told(what, 0.7, 0.59, 0.599), 0.001);
             ReportSeries& no_farther = r.add("target-spectrum", {{"target", "single-peak"}, {"frequency", "0.5"}});
             MadeUpReport::set_curve(no_farther, {});
             set_number(no_farther, "effective_nyquist", 0.5);
         }},
        {"heck-2013-oscillation",
         [](MadeUpReport& r, Told what) {
             set_oscillation(with_target(r, "step", 0.59), 1);
             ReportSeries& other = r.add("gaussian-blue-noise", {});
             MadeUpReport::set_curve(other, {});
             set_oscillation(other, told(what, 3.0, 0.5, 1.01));
             set_oscillation(r.add("lloyd", {}, 1024), 0.1); // of other points, and without a spectrum
             ReportSeries& adaptive = r.add("gaussian-blue-noise", {{"density", "1 + x"}});
             MadeUpReport::set_curve(adaptive, {});
             set_oscillation(adaptive, 0.1);
         }},
        shown_spectrum("heck-2013-spectrum", "target-spectrum"),
    };
}

std::vector<ClaimCase> optimized_cases()
{
    return {
        {"lagae-2008-regular",
         [](MadeUpReport& r, Told what) {
             // One method without directions is enough, and a lattice's rings without power have none.
             ReportSeries& lattice = r.add("lloyd", {});
             MadeUpReport::set_radius(lattice, 0.9);
             MadeUpReport::set_curve(lattice, {.anisotropy = 10});
             for (RadialBin& bin : lattice.curve.bins)
                 if (bin.frequency > 100) bin.power = 1e-25, bin.anisotropy_db = -150;
             ReportSeries& other = r.add("farthest-point", {});
             MadeUpReport::set_radius(other, 0.9);
             MadeUpReport::set_curve(other, {.anisotropy = told(what, 10.0, 0.1, 1.0), .scatter = 1});
             ReportSeries& low = r.add("equal-areas", {});
             MadeUpReport::set_radius(low, 0.8);
             MadeUpReport::set_curve(low, {});
         }},
        {"gabrielli-2008-exponent",
         [](MadeUpReport& r, Told what) {
             const auto tiling = [&](const char* sampler, int dimension, const char* moments, const char* density,
                                     double exponent, double error) {
                 ReportSeries& series =
                     r.add(sampler, {{"points_per_tile", "32"}, {"equal_moments", moments}, {"density", density}},
                           16384, dimension);
                 set_number(series, "hyperuniformity_exponent", exponent, error);
                 MadeUpReport::set_curve(series, {.low = 1e-4});
             };
             tiling("corner-tiles", 2, "0", "1", told(what, 1.8, 0.3, 1.05), 0.05);
             tiling("corner-tiles", 2, "2", "1", told(what, 5.5, 3.6, 5.05), 0.05);
             tiling("sphere-tiles", 3, "1", "1", told(what, 3.5, 1.9, 2.95), 0.05);
             tiling("template-tiles", 2, "1", "0.5", 0.1, 0.05); // points that are left out
             MadeUpReport::set_curve(lloyd(r, 20), {.low = 0.01});
         }},
        {"schloemer-2011-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radii(r.add("farthest-point", {}),
                                     told<std::vector<double>>(what, {0.9250, 0.9252}, {0.91, 0.9102}, {0.922, 0.928}));
         }},
        nearest_distance("schloemer-2011-mean", "farthest-point", 0.932),
        isotropy("schloemer-2011-isotropic", "farthest-point"),
        shown_spectrum("schloemer-2011-spectrum", "farthest-point"),
        isotropy("degoes-2012-isotropic", "equal-areas"),
        shown_spectrum("degoes-2012-spectrum", "equal-areas"),
        {"zhang-2013-2d",
         [](MadeUpReport& r, Told what) { full_sets_with_power(r, 2, told(what, 0.0589, 0.07, 0.0595)); }},
        {"zhang-2013-3d",
         [](MadeUpReport& r, Told what) { full_sets_with_power(r, 3, told(what, 0.0556, 0.07, 0.0566)); }},
        {"yuksel-2015-prefixes",
         [](MadeUpReport& r, Told what) {
             ReportSeries& series = r.add("sample-elimination", {});
             MadeUpReport::set_radius(series, 0.7);
             set_number(series, "prefix_relative_radius", told(what, 0.65, 0.4, 0.595), told(what, 1e-3, 1e-3, 0.01));
         }},
        shown_spectrum("yuksel-2015-spectrum", "sample-elimination"),
        {"ahmed-2022-low",
         [](MadeUpReport& r, Told what) {
             set_number(r.add("gaussian-blue-noise", {}), "low_frequency_mean", told(what, 0.001, 0.005, 0.003), 2e-4);
             set_number(r.add("gaussian-blue-noise", {{"density", "1 + x"}}), "low_frequency_mean", 100);
             set_number(r.add("equal-areas", {}), "low_frequency_mean", 0.0031);
             set_number(r.add("equal-areas", {}, 1024), "low_frequency_mean", 0.0001); // of other points
         }},
        shown_spectrum("ahmed-2022-spectrum", "gaussian-blue-noise"),
        nearest_distance("utk-sets-fpo", "farthest-point", 0.9325),
        nearest_distance("utk-sets-darts", "dart-throwing", 0.806),
        {"utk-sets-bnot",
         [](MadeUpReport& r, Told what) {
             set_number(r.add("equal-areas", {{"iterations", "20"}}), "mean_nearest_distance",
                        told(what, 0.897, 0.91, 0.9));
         },
         Kind::shown},
    };
}

}

std::vector<ClaimCase> cases_of_later_papers()
{
    auto cases = polyomino_cases();
    for (const auto& more : {heck_cases(), optimized_cases()}) cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}

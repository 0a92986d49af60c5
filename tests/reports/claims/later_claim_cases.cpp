// Claims of papers after the dissertation.
#include "tests/reports/support/claim_cases.hpp"

#include <cmath>

namespace poissonlab::test {

std::vector<ClaimCase> later_claim_cases()
{
    return {
        {"lagae-2008-regular",
         [](MadeUpReport& r, bool agrees) {
             // A lattice has directions; one method without them is enough.
             for (const char* sampler : {"lloyd", "farthest-point"}) {
                 ReportSeries& series = r.add(sampler, {});
                 MadeUpReport::set_radius(series, 0.9);
                 MadeUpReport::set_curve(series, {.anisotropy = agrees || sampler[0] == 'l' ? 10.0 : 0.1});
             }
             ReportSeries& low = r.add("equal-areas", {});
             MadeUpReport::set_radius(low, 0.8);
             MadeUpReport::set_curve(low, {});
         }},
        {"schloemer-2011-radius",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(r.add("farthest-point", {}), agrees ? 0.9251 : 0.91);
         }},
        {"schloemer-2011-mean",
         [](MadeUpReport& r, bool agrees) {
             set_number(r.add("farthest-point", {}), "mean_nearest_distance", agrees ? 0.9325 : 0.92);
         }},
        {"schloemer-2011-isotropic",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("farthest-point", {}), {.anisotropy = agrees ? 0.1 : 5.0});
         }},
        {"degoes-2012-isotropic",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("equal-areas", {}), {.anisotropy = agrees ? 0.1 : 5.0});
         }},
        {"heck-2013-step",
         [](MadeUpReport& r, bool agrees) {
             // With an error of a hundredth; half a ring of 16,384 points is 0.0039 of their root.
             with_target(r, "step", agrees ? 0.615 : 0.62);
             ReportSeries& cannot_be = r.add("target-spectrum", {{"target", "step"}, {"frequency", "0.7"}});
             MadeUpReport::set_curve(cannot_be, {});
             set_number(cannot_be, "effective_nyquist", 0.7);
         }},
        {"heck-2013-peak",
         [](MadeUpReport& r, bool agrees) {
             with_target(r, "single-peak", agrees ? 0.7 : 0.59);
             ReportSeries& no_farther = r.add("target-spectrum", {{"target", "single-peak"}, {"frequency", "0.5"}});
             MadeUpReport::set_curve(no_farther, {});
             set_number(no_farther, "effective_nyquist", 0.5);
         }},
        {"heck-2013-oscillation",
         [](MadeUpReport& r, bool agrees) {
             set_oscillation(with_target(r, "step", 0.59), 1);
             ReportSeries& other = r.add("gaussian-blue-noise", {});
             MadeUpReport::set_curve(other, {});
             set_oscillation(other, agrees ? 3 : 0.5);
             set_oscillation(r.add("lloyd", {}, 1024), 0.1); // of other points, and without a spectrum
             ReportSeries& adaptive = r.add("gaussian-blue-noise", {{"density", "1 + x"}});
             MadeUpReport::set_curve(adaptive, {});
             set_oscillation(adaptive, 0.1);
         }},
        {"zhang-2013-2d", [](MadeUpReport& r, bool agrees) { saturated(r, 2, agrees ? 0.0589 : 0.07); }},
        {"zhang-2013-3d", [](MadeUpReport& r, bool agrees) { saturated(r, 3, agrees ? 0.0556 : 0.07); }},
        {"yuksel-2015-prefixes",
         [](MadeUpReport& r, bool agrees) {
             ReportSeries& series = r.add("sample-elimination", {});
             MadeUpReport::set_radius(series, 0.7);
             set_number(series, "prefix_relative_radius", agrees ? 0.65 : 0.4);
         }},
        {"ahmed-2022-low",
         [](MadeUpReport& r, bool agrees) {
             set_number(r.add("gaussian-blue-noise", {}), "low_frequency_mean", agrees ? 0.001 : 0.005);
             set_number(r.add("gaussian-blue-noise", {{"density", "1 + x"}}), "low_frequency_mean", 100);
             set_number(r.add("equal-areas", {}), "low_frequency_mean", 0.0031);
             set_number(r.add("equal-areas", {}, 1024), "low_frequency_mean", 0.0001); // of other points
         }},
        {"utk-sets-fpo",
         [](MadeUpReport& r, bool agrees) {
             set_number(r.add("farthest-point", {}), "mean_nearest_distance", agrees ? 0.932 : 0.92);
         }},
        {"utk-sets-bnot",
         [](MadeUpReport& r, bool agrees) {
             set_number(r.add("equal-areas", {{"iterations", "20"}}), "mean_nearest_distance", agrees ? 0.897 : 0.91);
             set_number(r.add("equal-areas", {{"iterations", "100"}}), "mean_nearest_distance", 0.926);
         }},
        {"utk-sets-darts",
         [](MadeUpReport& r, bool agrees) {
             set_number(darts(r, "0.75"), "mean_nearest_distance", agrees ? 0.806 : 0.75);
             set_number(darts(r, "0.7"), "mean_nearest_distance", 0.7);
         }},
    };
}

}

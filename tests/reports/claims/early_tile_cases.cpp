// Claims of 6.6 to 6.8: tiles before Poisson disk tiles, and Penrose tilings.
#include "tests/reports/support/claim_cases.hpp"

#include <algorithm>

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;

ReportSeries& averaged(MadeUpReport& report, int points, int iterations = 29)
{
    return report.add("averaged-tiles",
                      {{"points_per_tile", std::to_string(points)}, {"iterations", std::to_string(iterations)}});
}

/// Radii that settle after so many of 1,000 iterations, or never.
std::vector<double> wandering(bool settles)
{
    auto radii = relaxed(0.1, 0.75, 200, 1000);
    for (std::size_t i = 200; i < radii.size() && !settles; ++i) radii[i] += i % 2 == 0 ? 0.02 : -0.02;
    return radii;
}

std::vector<ClaimCase> wang_tile_cases()
{
    return {
        {"6.6-flawed",
         [](MadeUpReport& r, Told what) {
             // Too many points near the borders are a deviation as well, but no lack.
             ReportSeries& series = r.add("shade-tiles", {{"points_per_tile", "32"}});
             set_number(series, "seam_density", 0.5);
             set_number(series, "border_density", told(what, 0.8, 1.3, 0.95));
         }},
        {"6.7-within",
         [](MadeUpReport& r, Told what) {
             for (const int points : {19, 53}) {
                 ReportSeries& series = averaged(r, points);
                 MadeUpReport::set_radius(series, 0.4);
                 set_number(series, "relative_radius_within_tiles", told(what, 0.8, 0.6, 0.75),
                            told(what, 0.001, 0.001, 0.02));
             }
         }},
        {"6.7-across",
         [](MadeUpReport& r, Told what) {
             for (const int points : {16, 19, 32, 53})
                 if (what != Told::nothing || points == 16)
                     MadeUpReport::set_radius(averaged(r, points), told(what, points == 16 ? 0.5 : 0.39, 0.6, 0.39));
             MadeUpReport::set_radius(averaged(r, 53, 1000), 0.756); // more than the paper's iterations
             ReportSeries& random = averaged(r, 53);                 // one surrounding at a time
             stored_of(random).parameters.emplace_back("variant", "one-surrounding");
             MadeUpReport::set_radius(random, 0.1);
         }},
        {"6.7-converges",
         [](MadeUpReport& r, Told what) {
             auto& series = averaged(r, 19, what == Told::nothing ? 29 : 1000);
             MadeUpReport::set_radius(series, 0.6);
             MadeUpReport::set_iterations(series, what == Told::nothing ? relaxed(0.1, 0.6, 200, 29)
                                                                        : wandering(what == Told::disagreement));
         }},
        {"6.7-spectra",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(averaged(r, 32), {.anisotropy = told(what, 5.0, -1.0, 0.0), .scatter = 1});
             MadeUpReport::set_curve(darts(r, "0.7"), {.scatter = 1});
             MadeUpReport::set_curve(lloyd(r, 16), {.scatter = 1});
         }},
        {"6.7-low",
         [](MadeUpReport& r, Told) {
             MadeUpReport::set_plate_error(averaged(r, 32), 0.01, 0.1);
             MadeUpReport::set_plate_error(r.add("jittered", {}, 262144), 0.02, 0.1);
         },
         Kind::shown},
        {"6.7-plate",
         [](MadeUpReport& r, Told what) { r.add_plate("averaged-tiles", {}, told(what, 0.3, 0.0, 0.008)); }},
    };
}

std::vector<ClaimCase> penrose_cases()
{
    return {
        {"6.8-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radii(r.add("penrose", {}),
                                     told<std::vector<double>>(what, {0.66, 0.74}, {0.8, 0.81}, {0.7, 0.78}));
         }},
        {"6.8-star",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(r.add("penrose", {}), {.spike = told(what, 20.0, 3.0, 10.2)});
         }},
        {"6.8-anisotropy",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(r.add("penrose", {}), {.anisotropy = told(what, 6.0, 0.5, 1.0), .scatter = 2});
             tiles(r, "corner", 4, 64, 2);
         }},
        {"6.8-low", [](MadeUpReport& r, Told) { MadeUpReport::set_plate_error(r.add("penrose", {}), 0.01, 0.1); },
         Kind::shown},
        {"6.8-plate", [](MadeUpReport& r, Told what) { r.add_plate("penrose", {}, told(what, 0.3, 0.0, 0.008)); }},
        {"6.8-time", [](MadeUpReport& r, Told) { set_seconds(r.add("penrose", {}), 0.02); }, Kind::shown},
    };
}

}

std::vector<ClaimCase> cases_of_early_tiles()
{
    auto cases = wang_tile_cases();
    const auto more = penrose_cases();
    cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}

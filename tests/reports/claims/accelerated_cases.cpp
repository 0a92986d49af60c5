// Claims of 6.12 to 6.14: accelerated dart throwing, and recursive Wang tiles.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;

ReportSeries& sectors(MadeUpReport& report, const char* variant)
{
    return report.add("sector-darts", {{"variant", variant}});
}

/// Full sets, and those of a variant whose power around the second peak is another one.
void second_peaks(MadeUpReport& r, const char* variant, double power, double error)
{
    MadeUpReport::set_curve(full_darts(r), {.error = error});
    MadeUpReport::set_curve(sectors(r, variant), {.beyond = power, .error = error});
}

std::vector<ClaimCase> jones_cases()
{
    return {
        {"6.12-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radius(full_darts(r), 0.776);
             MadeUpReport::set_radius(r.add("voronoi-darts", {{"relative_radius", "0.7"}}), 0.7);
             MadeUpReport::set_radii(jones(r), told<std::vector<double>>(what, {0.75, 0.75}, {0.6, 0.6}, {0.72, 0.75}));
             if (what == Told::disagreement) MadeUpReport::set_radius(full_darts(r), 0.9);
         }},
        {"6.12-spectrum",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(darts(r, "0.75"), {});
             MadeUpReport::set_curve(jones(r), {.beyond = told(what, 1.01, 1.2, 1.061)});
         }},
        {"6.12-plate",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_plate_error(darts(r, "0.75", 262144), 0.1, 0.2);
             MadeUpReport::set_plate_error(jones(r, 262144), told(what, 0.1, 0.1, 0.104),
                                           told(what, 0.2005, 0.25, 0.206));
         }},
        {"6.12-lines", [](MadeUpReport& r, Told) { MadeUpReport::set_curve(jones(r), {}); }, Kind::shown},
        {"6.12-fast",
         [](MadeUpReport& r, Told what) {
             set_seconds(darts(r, "0.75"), 0.02);
             set_seconds(jones(r), told(what, 0.01, 0.05, 0.02));
         },
         Kind::shown},
        {"6.12-time", [](MadeUpReport& r, Told) { set_seconds(jones(r), 0.05); }, Kind::shown},
    };
}

std::vector<ClaimCase> sector_cases()
{
    return {
        {"6.13-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radius(full_darts(r), 0.776);
             MadeUpReport::set_radii(sectors(r, "logarithmic"),
                                     told<std::vector<double>>(what, {0.775, 0.776}, {0.86, 0.86}, {0.79, 0.84}));
         }},
        {"6.13-logarithmic",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(full_darts(r), {});
             MadeUpReport::set_curve(sectors(r, "logarithmic"), {.beyond = told(what, 1.01, 1.5, 1.1)});
         }},
        {"6.13-plate",
         [](MadeUpReport& r, Told what) {
             ReportSeries& full = darts(r, "0.75", 262144);
             MadeUpReport::set_radius(full, 0.75);
             MadeUpReport::set_plate_error(full, 0.1, 0.2);
             MadeUpReport::set_plate_error(r.add("sector-darts", {{"variant", "logarithmic"}}, 262144),
                                           told(what, 0.1, 0.1, 0.104), told(what, 0.2005, 0.25, 0.206));
         }},
        {"6.13-linear",
         [](MadeUpReport& r, Told what) {
             second_peaks(r, "linear", told(what, 1.1, 0.9, 1.001), told(what, 0.01, 0.01, 0.5));
         }},
        {"6.13-skew",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(sectors(r, "linear"), {.anisotropy = told(what, 2.0, 0.1, 0.5), .scatter = 2});
         }},
        {"6.13-boundary",
         [](MadeUpReport& r, Told what) {
             second_peaks(r, "boundary", told(what, 1.5, 1.1, 1.2), told(what, 0.01, 0.01, 0.5));
         }},
        {"6.13-lloyd",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(full_darts(r), {});
             MadeUpReport::set_curve(lloyd(r, 16), {.peak = 3.0});
             MadeUpReport::set_curve(lloyd(r, 100), {.peak = 1.5}); // more than the dissertation shows
             ReportSeries& boundary = sectors(r, "boundary");
             MadeUpReport::set_curve(boundary, {.peak = told(what, 2.8, 1.6, 2.25)});
         }},
        {"6.13-aliasing",
         [](MadeUpReport& r, Told what) {
             r.add_plate("sector-darts", {{"variant", "boundary"}}, told(what, 0.2, 0.0, 0.008));
             r.add_plate("sector-darts", {{"variant", "linear"}}, told(what, 0.0, 0.2, 0.2));
         }},
        {"6.13-speed",
         [](MadeUpReport& r, Told) {
             set_seconds(sectors(r, "logarithmic"), 1);
             set_seconds(jones(r), 1);
         },
         Kind::shown},
        {"6.13-fast",
         [](MadeUpReport& r, Told what) {
             set_seconds(sectors(r, "linear"), told(what, 0.9, 0.2, 0.5));
             set_seconds(sectors(r, "boundary"), 0.02);
         },
         Kind::shown},
    };
}

ReportSeries& recursive(MadeUpReport& report, const char* drawing)
{
    return report.add("recursive-wang-tiles", {{"drawing", drawing}});
}

std::vector<ClaimCase> recursive_cases()
{
    return {
        {"6.14-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radii(recursive(r, "once"), told<std::vector<double>>(what, {0.0005, 0.0005, 0.44},
                                                                                     {0.5, 0.5, 0.5}, {0.0005, 0.44}));
             MadeUpReport::set_radius(recursive(r, "twice"), told(what, 0.5, 0.0, 0.0));
             ReportSeries& uneven = recursive(r, "once");
             stored_of(uneven).parameters.emplace_back("density", "gauss-and-waves");
             MadeUpReport::set_radius(uneven, 0.2);
         }},
        {"6.14-spectrum",
         [](MadeUpReport& r, Told what) {
             ReportSeries& series = recursive(r, "once");
             MadeUpReport::set_curve(series, {.low = told(what, 0.5, 0.05, 0.2), .error = told(what, 0.01, 0.01, 0.2)});
             series.curve.principal_frequency = 1e6; // two points that are close change nothing
         }},
        {"6.14-anisotropy",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(recursive(r, "once"), {.anisotropy = told(what, 4.0, 0.1, 1.0), .scatter = 2});
         }},
        {"6.14-aliasing",
         [](MadeUpReport& r, Told what) {
             r.add_plate("recursive-wang-tiles", {{"drawing", "once"}}, told(what, 0.0, 0.2, 0.008));
         }},
        {"6.14-time", [](MadeUpReport& r, Told) { set_seconds(recursive(r, "once"), 0.02); }, Kind::shown},
    };
}

}

std::vector<ClaimCase> cases_of_accelerated_darts()
{
    auto cases = jones_cases();
    for (const auto& more : {sector_cases(), recursive_cases()}) cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}

// Claims of 6.2 to 6.4: methods of analysis, dart throwing, relaxation dart throwing.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;

std::vector<ClaimCase> methodology_cases()
{
    return {
        {"6.2.2-flat",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(r.add("random", {}), {.low = 1, .peak = told(what, 1.0, 3.0, 1.09)});
         }},
        {"6.2.2-poisson-anisotropy",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(
                 r.add("random", {}),
                 {.low = 1, .peak = 1, .anisotropy = told(what, 0.1, 3.0, 0.5), .scatter = told(what, 0.1, 0.1, 4.0)});
         }},
        {"6.2.2-disk-anisotropy",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(darts(r, "0.75"),
                                     {.anisotropy = told(what, 0.1, 3.0, 0.5), .scatter = told(what, 0.1, 0.1, 4.0)});
         }},
        {"6.2.2-blue-noise",
         [](MadeUpReport& r, Told what) {
             ReportSeries& series = darts(r, "0.75");
             MadeUpReport::set_radius(series, 0.75);
             MadeUpReport::set_curve(series, {.low = told(what, 0.05, 0.5, 0.2), .error = told(what, 0.01, 0.01, 0.2)});
         }},
        {"6.2.3-aliasing",
         [](MadeUpReport& r, Told what) {
             r.add_plate("regular", {}, told(what, 0.5, 0.2, 0.5));
             r.add_plate("jittered", {}, told(what, 0.0, 0.2, 0.008));
         }},
    };
}

/// A set of the dart throwing that has this radius.
void with_blue_noise(ReportSeries& series, double radius, Told what)
{
    MadeUpReport::set_radius(series, radius);
    MadeUpReport::set_curve(series, {.beyond = told(what, 1.0, 1.3, 1.1), .error = told(what, 0.01, 0.01, 0.5)});
}

std::vector<ClaimCase> dart_cases()
{
    return {
        {"6.3-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radius(darts(r, told(what, "0.75", "0.75", "0.7")), told(what, 0.75, 0.72, 0.70));
         }},
        {"6.3-spectrum",
         [](MadeUpReport& r, Told what) {
             with_blue_noise(darts(r, "0.7"), 0.70, what);
             with_blue_noise(full_darts(r), 0.777, what);
             ReportSeries& small = darts(r, "0.55"); // smaller than what the dissertation shows
             MadeUpReport::set_radius(small, 0.55);
             MadeUpReport::set_curve(small, {.low = 0.5});
         }},
        {"6.3-noise",
         [](MadeUpReport& r, Told what) {
             r.add_plate("dart-throwing", {{"relative_radius", "0.7"}}, told(what, 0.0, 0.2, 0.008));
         }},
        {"6.3-plate",
         [](MadeUpReport& r, Told what) {
             for (const char* rho : {"0.7", "0.75"})
                 MadeUpReport::set_plate_error(darts(r, rho, 262144), 0.01, told(what, 0.05, 0.2, 0.099));
             MadeUpReport::set_plate_error(r.add("jittered", {}, 262144), 0.02, 0.1);
         }},
        {"6.3-time", [](MadeUpReport& r, Told) { set_seconds(darts(r, "0.7"), 0.012); }, Kind::shown},
        {"6.3-many", [](MadeUpReport& r, Told) { set_seconds(darts(r, "0.7", 262144), 0.3); }, Kind::shown},
    };
}

std::vector<ClaimCase> relaxation_cases()
{
    return {
        {"6.4-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radius(relaxation(r, "0.9", "100"), told(what, 0.573, 0.6, 0.6));
             if (what == Told::disagreement)
                 MadeUpReport::set_radii(relaxation(r, "0.9", "100"), {0.599, 0.6, 0.601, 0.6});
             if (what == Told::disagreement)
                 MadeUpReport::set_radii(relaxation(r, "0.99", "1000"), {0.599, 0.6, 0.601, 0.6});
         }},
        {"6.4-steeper",
         [](MadeUpReport& r, Told what) {
             // At its radius dart throwing has a width of 0.25.
             const double error = told(what, 0.001, 0.001, 0.05);
             for (const auto& [rho, width] : {std::pair("0.6", 0.3), {"0.7", 0.2}}) {
                 ReportSeries& series = darts(r, rho);
                 MadeUpReport::set_curve(series, {.width = width, .error = error});
                 MadeUpReport::set_radius(series, std::stod(rho));
             }
             ReportSeries& relaxed_darts = relaxation(r, "0.99", "1000");
             MadeUpReport::set_curve(relaxed_darts, {.width = told(what, 0.22, 0.28, 0.24), .error = error});
             MadeUpReport::set_radius(relaxed_darts, 0.65);
         }},
        {"6.4-plate",
         [](MadeUpReport& r, Told what) {
             for (const double radius : {0.68, 0.70}) {
                 ReportSeries& other = darts(r, std::to_string(radius), 262144);
                 MadeUpReport::set_radius(other, radius);
                 MadeUpReport::set_plate_error(other, 0.01, 0.1);
             }
             MadeUpReport::set_plate_error(relaxation(r, "0.99", "1000", 262144), 0.01, told(what, 0.05, 0.2, 0.1));
         }},
        {"6.4-time", [](MadeUpReport& r, Told) { set_seconds(relaxation(r, "0.9", "100"), 0.01); }, Kind::shown},
    };
}

}

std::vector<ClaimCase> cases_of_untiled_sets()
{
    auto cases = methodology_cases();
    for (const auto& more : {dart_cases(), relaxation_cases()}) cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}

// Claims of chapter 6 about methods without tiles.
#include "tests/reports/support/claim_cases.hpp"

#include <cmath>

namespace poissonlab::test {

std::vector<ClaimCase> untiled_claim_cases()
{
    return {
        {"6.2.2-flat",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("random", {}), {.low = 1, .peak = agrees ? 1.0 : 3.0});
         }},
        {"6.2.2-poisson-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("random", {}), {.low = 1, .peak = 1, .anisotropy = agrees ? 0.1 : 3});
         }},
        {"6.2.2-disk-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(darts(r, "0.75"), {.anisotropy = agrees ? 0.1 : 3});
         }},
        {"6.2.2-blue-noise",
         [](MadeUpReport& r, bool agrees) { MadeUpReport::set_curve(darts(r, "0.75"), {.low = agrees ? 0.05 : 0.5}); }},
        {"6.3-spectrum",
         [](MadeUpReport& r, bool agrees) { MadeUpReport::set_curve(darts(r, "0.7"), {.beyond = agrees ? 1 : 1.3}); }},
        {"6.3-plate",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_plate_error(darts(r, "0.7", 262144), 0.01, agrees ? 0.05 : 0.2);
             MadeUpReport::set_plate_error(r.add("jittered", {}, 262144), 0.02, 0.1);
         }},
        {"6.4-radius",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(relaxation(r, "0.9", "100"), agrees ? 0.573 : 0.6);
         }},
        {"6.4-steeper",
         [](MadeUpReport& r, bool agrees) {
             // At its radius dart throwing has a width of 0.25.
             for (const auto& [rho, width] : {std::pair("0.6", 0.3), {"0.7", 0.2}}) {
                 ReportSeries& series = darts(r, rho);
                 MadeUpReport::set_curve(series, {.width = width});
                 MadeUpReport::set_radius(series, std::stod(rho));
             }
             ReportSeries& relaxed_darts = relaxation(r, "0.99", "1000");
             MadeUpReport::set_curve(relaxed_darts, {.width = agrees ? 0.23 : 0.27});
             MadeUpReport::set_radius(relaxed_darts, 0.65);
         }},
        {"6.4-plate",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_plate_error(darts(r, "0.7", 262144), 0.01, 0.1);
             MadeUpReport::set_plate_error(relaxation(r, "0.99", "1000", 262144), 0.01, agrees ? 0.05 : 0.2);
         }},
        {"6.5-converges",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_iterations(lloyd(r, 128), relaxed(0.6, 0.8, agrees ? 20 : 400));
         }},
        {"6.5-increases",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_iterations(lloyd(r, 128), relaxed(0.7, agrees ? 0.8 : 0.65, 20));
         }},
        {"6.5-fewer-points",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_iterations(lloyd(r, 128, 256), relaxed(0.7, agrees ? 0.82 : 0.76, 20));
             MadeUpReport::set_iterations(lloyd(r, 128, 4096), relaxed(0.7, 0.79, 20));
         }},
        {"6.5-settles",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_iterations(lloyd(r, 128), relaxed(0.6, agrees ? 0.8 : 0.7, 20));
         }},
        {"6.5-peaks",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(lloyd(r, 1), {.peak = 1.5, .width = 0.2});
             MadeUpReport::set_curve(lloyd(r, 4), {.peak = agrees ? 2.5 : 1.2, .width = agrees ? 0.1 : 0.3});
         }},
        {"6.5-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(lloyd(r, 0), {});
             MadeUpReport::set_curve(lloyd(r, 16), {.anisotropy = agrees ? 0.1 : 2});
         }},
        {"6.5-grid",
         [](MadeUpReport& r, bool agrees) {
             auto& series = lloyd(r, 128);
             MadeUpReport::set_iterations(series, relaxed(0.6, 0.8, 20));
             const double six = agrees ? 0.7 : 0.99;
             const_cast<Series*>(series.stored)->measures.voronoi =
                 VoronoiStatistics{0.01, {0, 0.5 - six / 2, six, 0.5 - six / 2, 0}};
         }},
        {"6.12-spectrum",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(darts(r, "0.75"), {});
             MadeUpReport::set_curve(jones(r), {.beyond = agrees ? 1.01 : 1.2});
         }},
        {"6.12-plate",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_plate_error(darts(r, "0.75", 262144), 0.1, 0.2);
             MadeUpReport::set_plate_error(jones(r, 262144), 0.1, agrees ? 0.2005 : 0.25);
         }},
        {"6.12-fast",
         [](MadeUpReport& r, bool agrees) {
             const_cast<Series*>(darts(r, "0.75").stored)->sample_seconds = {0.02};
             const_cast<Series*>(jones(r).stored)->sample_seconds = {agrees ? 0.01 : 0.05};
         }},
        {"6.13-logarithmic",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("dart-throwing", {{"stop", "saturation"}}), {});
             MadeUpReport::set_curve(r.add("sector-darts", {{"variant", "logarithmic"}}),
                                     {.beyond = agrees ? 1.01 : 1.5});
         }},
        {"6.13-linear",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("dart-throwing", {{"stop", "saturation"}}), {});
             MadeUpReport::set_curve(r.add("sector-darts", {{"variant", "linear"}}), {.beyond = agrees ? 1.1 : 0.9});
         }},
        {"6.13-skew",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("sector-darts", {{"variant", "linear"}}),
                                     {.anisotropy = agrees ? 2.0 : 0.1});
         }},
        {"6.13-boundary",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("dart-throwing", {{"stop", "saturation"}}), {});
             MadeUpReport::set_curve(r.add("sector-darts", {{"variant", "boundary"}}), {.beyond = agrees ? 1.5 : 1.1});
         }},
        {"6.13-fast",
         [](MadeUpReport& r, bool agrees) {
             const auto add = [&](const char* variant, double seconds) {
                 const_cast<Series*>(r.add("sector-darts", {{"variant", variant}}).stored)->sample_seconds = {seconds};
             };
             add("logarithmic", 1);
             add("linear", agrees ? 0.9 : 0.2);
             add("boundary", agrees ? 0.02 : 0.5);
         }},
        {"6.15-relaxation",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(relaxation(r, "0.99", "1000", 65536, 3), agrees ? 0.702 : 0.6);
         }},
        {"6.15-lloyd",
         [](MadeUpReport& r, bool agrees) {
             auto stuck = relaxed(0.6, 0.78, 100);
             for (std::size_t i = 20; i < 100; i += 5) stuck[i] -= 0.01;
             MadeUpReport::set_iterations(lloyd(r, 128, 4096, 2), agrees ? relaxed(0.6, 0.79, 20) : stuck);
             MadeUpReport::set_iterations(lloyd(r, 128, 4096, 3), agrees ? stuck : relaxed(0.6, 0.79, 20));
         }},
        {"6.15-spectrum",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(darts(r, "0.7", 65536, 3), {.low = agrees ? 0.05 : 0.5});
         }},
        {"6.15-symmetry",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(darts(r, "0.7", 65536, 3), {.anisotropy = agrees ? 0.0 : 2.0});
         }},
    };
}

}

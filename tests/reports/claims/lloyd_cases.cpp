// Claims of 6.5 about Lloyd relaxation.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;

void with_cells(ReportSeries& series, double six)
{
    MadeUpReport::set_iterations(series, relaxed(0.6, 0.8, 20));
    stored_of(series).measures.voronoi = VoronoiStatistics{0.01, {0, 0.5 - six / 2, six, 0.5 - six / 2, 0}};
}

}

std::vector<ClaimCase> cases_of_lloyd()
{
    return {
        {"6.5-converges",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_iterations(lloyd(r, 128),
                                          relaxed(0.6, 0.8, told(what, 20, 400, 20), told(what, 128, 128, 40)));
         }},
        {"6.5-increases",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_iterations(lloyd(r, 128), relaxed(0.7, told(what, 0.8, 0.65, 0.701), 20),
                                          told(what, 0.001, 0.001, 0.05));
         }},
        {"6.5-fewer-points",
         [](MadeUpReport& r, Told what) {
             const double scatter = told(what, 0.001, 0.001, 0.05);
             MadeUpReport::set_iterations(lloyd(r, 128, 256), relaxed(0.7, told(what, 0.82, 0.76, 0.79), 20), scatter);
             MadeUpReport::set_iterations(lloyd(r, 128, 4096), relaxed(0.7, 0.79, 20), scatter);
         }},
        {"6.5-settles",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_iterations(lloyd(r, 128), relaxed(0.6, told(what, 0.8, 0.7, 0.75), 20), 0.005);
         }},
        {"6.5-peaks",
         [](MadeUpReport& r, Told what) {
             const double error = told(what, 0.001, 0.001, 0.5);
             MadeUpReport::set_curve(lloyd(r, 1), {.peak = 1.5, .width = 0.2, .error = error});
             MadeUpReport::set_curve(
                 lloyd(r, 4), {.peak = told(what, 2.5, 1.2, 1.5), .width = told(what, 0.1, 0.3, 0.2), .error = error});
         }},
        {"6.5-anisotropy",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(lloyd(r, 0), {});
             MadeUpReport::set_curve(lloyd(r, 16), {.anisotropy = told(what, -2.0, 2.0, 0.5), .scatter = 1});
         }},
        {"6.5-grid",
         [](MadeUpReport& r, Told what) {
             with_cells(lloyd(r, 128), told(what, 0.7, 0.99, 0.95));
             with_cells(lloyd(r, 300), told(what, 0.7, 0.99, 0.95));
         }},
        {"6.5-plate", [](MadeUpReport& r, Told) { set_seconds(lloyd(r, 16, 262144), 4); }, Kind::shown},
        {"6.5-time", [](MadeUpReport& r, Told) { set_seconds(lloyd(r, 16), 0.5); }, Kind::shown},
    };
}

}

// Claims of 6.10 about template tiles.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {

std::vector<ClaimCase> cases_of_template_tiles()
{
    using Kind = ClaimCase::Kind;
    const auto plate = [](MadeUpReport& r, const char* count, const char* points, double amplitude) {
        r.add_plate("template-tiles", {{"tiles", count}, {"points_per_tile", points}}, amplitude);
    };
    return {
        {"6.10-bad", [](MadeUpReport& r, Told what) { tiles(r, "template", 8, 64, 200, told(what, 4., 1., 2.)); },
         Kind::shown},
        {"6.10-good", [](MadeUpReport& r, Told what) { tiles(r, "template", 32, 64, told(what, 200., 400., 300.)); },
         Kind::shown},
        {"6.10-order",
         [](MadeUpReport& r, Told what) {
             tiles(r, "template", 8, 64, 40, 3);
             tiles(r, "template", 64, 64, told(what, 10.0, 90.0, 90.0), told(what, 1.0, 4.0, 1.0));
             tiles(r, "template", 1, 64, 200, -100); // without power between its peaks
         }},
        {"6.10-alike",
         [](MadeUpReport& r, Told what) {
             tiles(r, "template", 128, 64, 10);
             tiles(r, "template", 256, 64, told(what, 9.9, 5.0, 8.0));
         }},
        {"6.10-pronounced",
         [](MadeUpReport& r, Told) {
             tiles(r, "template", 256, 64, 10);
             tiles(r, "corner", 4, 64, 2);
         },
         Kind::shown},
        {"6.10-anisotropy",
         [](MadeUpReport& r, Told what) {
             auto& series = tiles(r, "template", 8, 64, 10);
             series.curve.bins.clear();
             MadeUpReport::set_curve(series, {.spike = told(what, 20.0, 0.0, 10.2)});
         }},
        {"6.10-radial",
         [](MadeUpReport& r, Told what) {
             ReportSeries& series = tiles(r, "template", 64, 32, 100);
             for (RadialBin& bin : series.curve.bins)
                 if (bin.frequency == series.stored->measures.lattice_peaks->tiles) {
                     bin.power *= told(what, 3.0, 1.5, 2.0);
                     bin.power_error = told(what, 0.001, 0.001, 0.05);
                 }
         }},
        {"6.10-plate", [=](MadeUpReport& r, Told what) { plate(r, "8", "64", told(what, 0.3, 0.0, 0.008)); }},
        {"6.10-improves",
         [=](MadeUpReport& r, Told what) {
             plate(r, "8", "64", told(what, 0.4, 0.1, 0.4));
             plate(r, "64", "64", told(what, 0.1, 0.4, 0.1));
             if (what == Told::nothing) return; // one comparison
             plate(r, "8", "32", told(what, 0.8, 0.05, 0.0));
             plate(r, "64", "32", told(what, 0.4, 0.1, 0.0));
         }},
    };
}

}

// Claims of 6.15 about spheres.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {

std::vector<ClaimCase> cases_of_spheres()
{
    const auto sphere_tiles = [](MadeUpReport& r, Told what) -> ReportSeries& {
        return r.add("sphere-tiles", {{"colors", "2"}, {"sets", told(what, "3", "3", "1")}}, 65536, 3);
    };
    return {
        {"6.15-darts",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radius(darts(r, told(what, "0.7", "0.7", "0.65"), 65536, 3),
                                      told(what, 0.70, 0.66, 0.65));
         }},
        {"6.15-relaxation",
         [](MadeUpReport& r, Told what) {
             ReportSeries& series = relaxation(r, "0.99", "1000", 65536, 3);
             MadeUpReport::set_radius(series, told(what, 0.702, 0.6, 0.71));
             if (what == Told::disagreement) MadeUpReport::set_radii(series, {0.599, 0.6, 0.601, 0.6});
         }},
        {"6.15-lloyd",
         [](MadeUpReport& r, Told what) {
             auto stuck = relaxed(0.6, 0.78, 100);
             for (std::size_t i = 20; i < 100; i += 5) stuck[i] -= 0.01;
             const auto smooth = relaxed(0.6, 0.79, 20);
             MadeUpReport::set_iterations(lloyd(r, 128, 4096, 2), told(what, smooth, stuck, stuck));
             ReportSeries& space = lloyd(r, 128, 4096, 3);
             MadeUpReport::set_iterations(space, told(what, stuck, smooth, stuck));
             if (what != Told::nothing) return;
             space.iterations.resize(2); // which differ by more than they do from the plane
             for (std::size_t i = 20; i < 100; i += 3) space.iterations[0][i].relative_radius -= 0.01;
         }},
        {"6.15-spectrum",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(darts(r, "0.7", 65536, 3),
                                     {.low = told(what, 0.05, 0.5, 0.2), .error = told(what, 0.01, 0.01, 0.2)});
         }},
        {"6.15-symmetry",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(darts(r, "0.7", 65536, 3),
                                     {.anisotropy = told(what, 0.0, 2.0, 0.5), .scatter = told(what, 0.1, 0.1, 4.0)});
         }},
        {"6.15-tiles-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radius(
                 r.add("sphere-tiles", {{"relative_radius", told(what, "0.75", "0.75", "0.7")}}, 65536, 3),
                 told(what, 0.75, 0.7, 0.7));
         }},
        {"6.15-tiles-radial",
         [=](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(sphere_tiles(r, what), {.low = told(what, 0.05, 0.5, 0.05)});
         }},
        {"6.15-tiles-anisotropy",
         [=](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(sphere_tiles(r, what), {.anisotropy = told(what, 2.0, 0.0, 2.0)});
         }},
    };
}

}

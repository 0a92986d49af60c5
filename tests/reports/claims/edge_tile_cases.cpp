// Claims about the peaks of all tilings (6.7), and about edge tiles (6.9).
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;

NamedTexts edges(const char* rho, int points)
{
    return {{"colors", "2"}, {"points_per_tile", std::to_string(points)}, {"relative_radius", rho}};
}

/// Pictures of edge tiles at two relative radii.
template <class Make>
void pictures(const Make& make)
{
    for (const int points : {32, 48, 64})
        for (const char* rho : {"0.7", "0.8"}) make(edges(rho, points), rho == std::string("0.8"));
}

void share_points(ReportSeries& series, double share)
{
    TileSetRecord set;
    set.tiles = 256;
    set.points_per_tile = 64;
    set.shared_points = share;
    stored_of(series).tile_set = set;
}

std::vector<ClaimCase> peak_cases()
{
    return {
        {"6.7-peaks",
         [](MadeUpReport& r, Told what) {
             tiles(r, "corner", 4, 64, told(what, 5.0, 1.0, 1.04));
             ReportSeries& early = r.add("averaged-tiles", {});
             MadeUpReport::set_curve(early, {});
             MadeUpReport::set_peaks(early, 16, told(what, 5.0, 1.0, 1.04));
         }},
        {"6.7-cause",
         [](MadeUpReport& r, Told what) {
             // 16 x 16 tiles with a mean peak of 20 have 7.3 % of their power on the lattice.
             share_points(tiles(r, "corner", 4, 64, 20), told(what, 0.07, 0.3, 0.105));
         }},
        {"6.7-more-tiles",
         [](MadeUpReport& r, Told what) {
             tiles(r, "corner", 2, 64, 40);
             tiles(r, "corner", 4, 64, told(what, 8.0, 80.0, 39.0));
         }},
        {"6.7-less-common",
         [](MadeUpReport& r, Told what) {
             tiles(r, "template", 16, 32, 40);
             ReportSeries& more = tiles(r, "template", 16, 64, told(what, 8.0, 80.0, 8.0));
             if (what == Told::nothing) have_one_set(more);
         }},
    };
}

}

std::vector<ClaimCase> cases_of_edge_tiles()
{
    std::vector<ClaimCase> cases{
        {"6.9-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radius(r.add("edge-tiles", {{"relative_radius", told(what, "0.85", "0.85", "0.75")}}),
                                      told(what, 0.85, 0.8, 0.75));
         }},
        {"6.9-low",
         [](MadeUpReport& r, Told what) {
             pictures([&](const NamedTexts& parameters, bool is_wide) {
                 const double wide = told(what, 0.01, 0.03, 0.0201);
                 MadeUpReport::set_plate_error(r.add("edge-tiles", parameters, 262144), is_wide ? wide : 0.02, 0.1);
             });
         }},
        {"6.9-aliasing",
         [](MadeUpReport& r, Told what) {
             pictures([&](const NamedTexts& parameters, bool is_wide) {
                 r.add_plate("edge-tiles", parameters, is_wide ? told(what, 0.3, 0.1, 0.0) : told(what, 0.1, 0.3, 0.0));
             });
         }},
        {"6.9-plate",
         [](MadeUpReport& r, Told what) { r.add_plate("edge-tiles", edges("0.7", 64), told(what, 0.2, 0.0, 0.008)); }},
        {"6.9-fast",
         [](MadeUpReport& r, Told) {
             set_seconds(darts(r, "0.7"), 0.1);
             set_seconds(tiles(r, "edge", 2, 64, 10), 0.01);
         },
         Kind::shown},
        {"6.9-wavelike",
         [](MadeUpReport& r, Told what) {
             tiles(r, "edge", 2, 32, 10, told(what, 0.9, 0.1, 0.25));
             tiles(r, "corner", 4, 32, 10, 0.7);
             tiles(r, "corner", 8, 32, 10, 0.2); // as many tiles are what counts
         }},
    };
    const auto more = peak_cases();
    cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}

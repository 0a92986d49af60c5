// Claims of 6.11 about corner tiles.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;

TileSetRecord set_with_regions(std::uint64_t count, double corners)
{
    TileSetRecord set;
    set.tiles = count;
    set.points_per_tile = 64;
    set.regions = {{"corners", corners, 3.1}, {"edges", 7, 7}};
    return set;
}

/// A curve with a ring that stands out, of three tile sets.
void with_spike(MadeUpReport& r, const char* kind, int set, double spike)
{
    auto& series = tiles(r, kind, set, 64, 5);
    series.curve.bins.clear();
    MadeUpReport::set_curve(series, {.spike = spike});
}

}

std::vector<ClaimCase> cases_of_corner_tiles()
{
    return {
        {"6.11-tiles",
         [](MadeUpReport& r, Told) { stored_of(tiles(r, "corner", 3, 64, 10)).tile_set = set_with_regions(81, 3); },
         Kind::shown},
        {"6.11-radius",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_radius(r.add("corner-tiles", {{"relative_radius", told(what, "0.85", "0.85", "0.75")}}),
                                      told(what, 0.85, 0.8, 0.75));
         }},
        {"6.11-good", [](MadeUpReport& r, Told what) { tiles(r, "corner", 3, 64, 5, told(what, 1.5, 2.5, 2.0)); },
         Kind::shown},
        {"6.11-order",
         [](MadeUpReport& r, Told what) {
             tiles(r, "corner", 2, 64, 40, 3);
             ReportSeries& good = tiles(r, "corner", 4, 64, told(what, 10.0, 90.0, 10.0), told(what, 1.0, 4.0, 1.0));
             if (what == Told::nothing) have_one_set(good);
         }},
        {"6.11-better",
         [](MadeUpReport& r, Told what) {
             tiles(r, "edge", 2, 64, 20);
             tiles(r, "corner", 4, 64, told(what, 10.0, 30.0, 20.0));
         }},
        {"6.11-peaks",
         [](MadeUpReport& r, Told what) {
             tiles(r, "edge", 2, 64, 20);
             tiles(r, "corner", 8, 64, told(what, 3.0, 15.0, 10.0));
         }},
        {"6.11-radial",
         [](MadeUpReport& r, Told what) {
             MadeUpReport::set_curve(r.add("lloyd", {{"until_relative_radius", "0.75"}, {"repulsion", "true"}}), {});
             auto& series = tiles(r, "corner", 4, 64, 5);
             if (what == Told::nothing) have_one_set(series);
             series.curve.bins.clear();
             MadeUpReport::set_curve(series, {.beyond = told(what, 1.01, 1.5, 1.01)});
         }},
        {"6.11-anisotropy",
         [](MadeUpReport& r, Told what) {
             with_spike(r, "corner", 4, told(what, 5.0, 20.0, 5.0));
             with_spike(r, "edge", 2, told(what, 20.0, 5.0, 8.2));
         }},
        {"6.11-plate",
         [](MadeUpReport& r, Told what) {
             const int pairs = what == Told::nothing ? 1 : 3;
             for (int i = 0; i < pairs; ++i) {
                 const std::string points = std::to_string(32 + 16 * i);
                 r.add_plate("corner-tiles", {{"colors", "3"}, {"points_per_tile", points}}, told(what, 0.1, 0.3, 0.1));
                 r.add_plate("template-tiles", {{"tiles", "8"}, {"points_per_tile", points}},
                             told(what, 0.3, 0.1, 0.3));
             }
         }},
        {"6.11-corner-points",
         [](MadeUpReport& r, Told what) {
             for (const char* rho : {"0.7", "0.75"})
                 for (const int points : {32, 64}) {
                     if (what == Told::nothing && points == 64) continue;
                     ReportSeries& series = r.add(
                         "corner-tiles",
                         {{"colors", "4"}, {"points_per_tile", std::to_string(points)}, {"relative_radius", rho}});
                     const double corners = told(what, rho == std::string("0.7") ? 2.7 : 3.1, points / 5.0, 3.1);
                     stored_of(series).tile_set = set_with_regions(256, corners);
                 }
         }},
        {"6.11-time", [](MadeUpReport& r, Told) { set_seconds(tiles(r, "corner", 4, 64, 2), 0.001); }, Kind::shown},
    };
}

}

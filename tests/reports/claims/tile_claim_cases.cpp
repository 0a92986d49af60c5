// Claims of chapter 6 about tiles.
#include "tests/reports/support/claim_cases.hpp"

#include <cmath>

namespace poissonlab::test {

std::vector<ClaimCase> tile_claim_cases()
{
    return {
        {"6.6-flawed",
         [](MadeUpReport& r, bool agrees) {
             auto& series = r.add("shade-tiles", {{"points_per_tile", "32"}});
             const_cast<Series*>(series.stored)->measures.numbers["seam_density"] = {agrees ? 0.5 : 0.05, {}};
         }},
        {"6.7-across",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(r.add("averaged-tiles", {{"iterations", "29"}}), agrees ? 0.4 : 0.6);
         }},
        {"6.7-converges",
         [](MadeUpReport& r, bool agrees) {
             auto& series = r.add("averaged-tiles", {{"iterations", "128"}});
             MadeUpReport::set_radius(series, 0.6);
             MadeUpReport::set_iterations(series, relaxed(0.1, 0.6, agrees ? 200 : 20));
         }},
        {"6.7-peaks", [](MadeUpReport& r, bool agrees) { tiles(r, "corner", 4, 64, agrees ? 5 : 1); }},
        {"6.7-more-tiles",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "corner", 2, 64, 40);
             tiles(r, "corner", 4, 64, agrees ? 8 : 80);
         }},
        {"6.7-less-common",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "template", 16, 32, 40);
             tiles(r, "template", 16, 64, agrees ? 8 : 80);
         }},
        {"6.9-low",
         [](MadeUpReport& r, bool agrees) {
             for (const char* rho : {"0.7", "0.8"})
                 MadeUpReport::set_plate_error(
                     r.add("edge-tiles", {{"colors", "2"}, {"points_per_tile", "32"}, {"relative_radius", rho}},
                           262144),
                     (rho == std::string("0.8")) == agrees ? 0.01 : 0.02, 0.1);
         }},
        {"6.9-fast",
         [](MadeUpReport& r, bool agrees) {
             const_cast<Series*>(darts(r, "0.7").stored)->sample_seconds = {0.1};
             const_cast<Series*>(tiles(r, "edge", 2, 64, 10).stored)->sample_seconds = {agrees ? 0.01 : 1.0};
         }},
        {"6.10-bad", [](MadeUpReport& r, bool agrees) { tiles(r, "template", 8, 64, 200, agrees ? 4 : 1); }},
        {"6.10-good", [](MadeUpReport& r, bool agrees) { tiles(r, "template", 32, 64, agrees ? 200 : 400); }},
        {"6.10-alike",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "template", 128, 64, 10);
             tiles(r, "template", 256, 64, agrees ? 9.8 : 5);
         }},
        {"6.10-pronounced",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "template", 256, 64, 10);
             tiles(r, "corner", 4, 64, agrees ? 2 : 20);
         }},
        {"6.10-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             auto& series = tiles(r, "template", 8, 64, 10);
             series.curve.bins.clear();
             MadeUpReport::set_curve(series, {.spike = agrees ? 20.0 : 0.0});
         }},
        {"6.11-tiles",
         [](MadeUpReport& r, bool agrees) {
             TileSetRecord set;
             set.tiles = agrees ? 81 : 80;
             set.points_per_tile = 64;
             const_cast<Series*>(tiles(r, "corner", 3, 64, 10).stored)->tile_set = set;
         }},
        {"6.11-good", [](MadeUpReport& r, bool agrees) { tiles(r, "corner", 3, 64, 5, agrees ? 1.5 : 2.5); }},
        {"6.11-better",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "edge", 2, 64, 20);
             tiles(r, "corner", 4, 64, agrees ? 10 : 30);
         }},
        {"6.11-peaks",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "edge", 2, 64, 20);
             tiles(r, "corner", 8, 64, agrees ? 3 : 15);
         }},
        {"6.11-radial",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("lloyd", {{"until_relative_radius", "0.75"}, {"repulsion", "true"}}), {});
             auto& series = tiles(r, "corner", 4, 64, 5);
             series.curve.bins.clear();
             MadeUpReport::set_curve(series, {.beyond = agrees ? 1.01 : 1.5});
         }},
        {"6.11-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             for (const char* kind : {"corner", "edge"}) {
                 auto& series = tiles(r, kind, kind == std::string("corner") ? 4 : 2, 64, 5);
                 series.curve.bins.clear();
                 MadeUpReport::set_curve(series, {.spike = (kind == std::string("edge")) == agrees ? 20.0 : 5.0});
             }
         }},
        {"6.14-radius",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(r.add("recursive-wang-tiles", {{"drawing", "once"}}), agrees ? 0.0005 : 0.5);
             MadeUpReport::set_radius(r.add("recursive-wang-tiles", {{"drawing", "twice"}}), agrees ? 0.5 : 0.0);
             MadeUpReport::set_radius(
                 r.add("recursive-wang-tiles", {{"drawing", "once"}, {"density", "gauss-and-waves"}}), 0.2);
         }},
        {"6.14-spectrum",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("recursive-wang-tiles", {{"drawing", "once"}}),
                                     {.low = agrees ? 0.5 : 0.05});
         }},
        {"6.14-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("recursive-wang-tiles", {{"drawing", "once"}}),
                                     {.anisotropy = agrees ? 4.0 : 0.1});
         }},
        {"6.8-radius",
         [](MadeUpReport& r, bool agrees) { MadeUpReport::set_radius(r.add("penrose", {}), agrees ? 0.7 : 0.8); }},
        {"6.8-star",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("penrose", {}), {.spike = agrees ? 20.0 : 3.0});
         }},
        {"6.8-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("penrose", {}), {.anisotropy = agrees ? 6.0 : 0.5});
             tiles(r, "corner", 4, 64, 2);
         }},
        {"notes-2008-fast",
         [](MadeUpReport& r, bool agrees) {
             set_seconds(r.add("polyominoes", {}), agrees ? 0.001 : 0.2);
             set_seconds(r.add("polyominoes", {{"density", "x + 1"}}), agrees ? 0.2 : 0.001); // not even
             set_seconds(darts(r, "0.75"), 0.02);
         }},
        {"notes-2008-blue-noise",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("polyominoes", {}), {.low = agrees ? 0.05 : 0.5});
         }},
        {"notes-2008-no-artifacts",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("polyominoes", {}), {.spike = agrees ? 3.0 : 20.0});
         }},
        {"notes-2008-penrose",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("polyominoes", {}), {.spike = 12.0});
             MadeUpReport::set_curve(r.add("penrose", {}), {.spike = agrees ? 20.0 : 12.5});
         }},
        {"6.16-not-interactive",
         [](MadeUpReport& r, bool agrees) { set_seconds(darts(r, "0.7"), agrees ? 0.2 : 0.01); }},
        {"6.16-interactive",
         [](MadeUpReport& r, bool agrees) { set_seconds(r.add("sector-darts", {}), agrees ? 0.05 : 0.5); }},
        {"6.16-real-time",
         [](MadeUpReport& r, bool agrees) { set_seconds(tiles(r, "corner", 4, 64, 2), agrees ? 0.001 : 0.05); }},
        {"6.16-only-option", [](MadeUpReport& r, bool agrees) { set_seconds(darts(r, "0.7"), agrees ? 0.02 : 0.01); }},
        {"6.16-shade",
         [](MadeUpReport& r, bool agrees) {
             const_cast<Series*>(r.add("shade-tiles", {}).stored)->measures.numbers["seam_density"] = {
                 agrees ? 0.4 : 0.1, {}};
         }},
        {"6.16-averaged",
         [](MadeUpReport& r, bool agrees) {
             auto &averaged = r.add("averaged-tiles", {}), &edges = r.add("edge-tiles", {});
             MadeUpReport::set_radius(averaged, agrees ? 0.6 : 0.8);
             MadeUpReport::set_radius(edges, 0.75);
             MadeUpReport::set_curve(averaged, {.anisotropy = agrees ? 3.0 : 0.1});
             MadeUpReport::set_curve(edges, {.anisotropy = 1});
         }},
        {"6.16-template",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("template-tiles", {}), {.anisotropy = agrees ? 3.0 : 0.1});
             MadeUpReport::set_curve(r.add("corner-tiles", {}), {.anisotropy = 1});
         }},
        {"6.16-corner",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(tiles(r, "edge", 2, 64, 2), {.anisotropy = 2});
             MadeUpReport::set_curve(tiles(r, "corner", 4, 64, 2), {.anisotropy = agrees ? 1.0 : 3.0});
         }},
        {"6.16-penrose", [](MadeUpReport& r, bool agrees) { among_others(r, "penrose", agrees); }},
        {"6.16-recursive", [](MadeUpReport& r, bool agrees) { among_others(r, "recursive-wang-tiles", agrees); }},
        {"6.16-recursive-radius",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(r.add("recursive-wang-tiles", {}), agrees ? 0.3 : 0.6);
         }},
        {"6.9-wavelike",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "edge", 2, 32, 10, agrees ? 0.9 : 0.1);
             tiles(r, "corner", 4, 32, 10, 0.7);
             tiles(r, "corner", 8, 32, 10, 0.2); // the largest is what counts
         }},
        {"6.10-radial",
         [](MadeUpReport& r, bool agrees) {
             ReportSeries& series = tiles(r, "template", 64, 32, 100);
             for (RadialBin& bin : series.curve.bins)
                 if (bin.frequency == series.stored->measures.lattice_peaks->tiles) bin.power *= agrees ? 3 : 1.5;
         }},
        {"6.11-corner-points",
         [](MadeUpReport& r, bool agrees) {
             for (const int points : {32, 64}) {
                 ReportSeries& series =
                     r.add("corner-tiles",
                           {{"colors", "4"}, {"points_per_tile", std::to_string(points)}, {"relative_radius", "0.75"}});
                 const double corners = agrees ? 3.1 : points / 5.0;
                 const_cast<Series*>(series.stored)->tile_set =
                     TileSetRecord{256, 64, true, {}, {{"corners", corners, 3.1}, {"edges", 7, 7}}};
             }
         }},
        {"6.15-tiles-radial",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("sphere-tiles", {{"colors", "2"}}, 65536, 3), {.low = agrees ? 0.05 : 0.5});
         }},
        {"6.15-tiles-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("sphere-tiles", {{"colors", "2"}}, 65536, 3),
                                     {.anisotropy = agrees ? 2.0 : 0.0});
         }},
    };
}

}

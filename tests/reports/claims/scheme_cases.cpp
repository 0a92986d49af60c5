// Claims of chapters 2, 3 and 8 about tiles, tilings and hash functions; of chapters 4 and 7 about what tiles are for.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;
using Numbers = std::map<std::string, double>;

/// Counts have no errors: another number, or none.
ClaimCase exact(const char* id, const char* kind, const Numbers& agree, const Numbers& disagree)
{
    return {id, [=](MadeUpReport& r, Told what) { r.add_scheme(kind, told(what, agree, disagree, Numbers{})); },
            Kind::exact};
}

/// Shown whatever the numbers are.
ClaimCase shown(const char* id, const char* kind, const Numbers& numbers, const Numbers& others)
{
    return {id, [=](MadeUpReport& r, Told what) { r.add_scheme(kind, told(what, numbers, others, numbers)); },
            Kind::shown};
}

/// Times of tilings, those of corner tiles as given.
Numbers costs(double corner)
{
    Numbers numbers{{"scanline_wang_ns", 10}, {"scanline_corner_ns", 10}, {"tables", 2}};
    for (const char* where : {"_streamed_ns", "_anywhere_ns", "_long_streamed_ns", "_long_anywhere_ns"}) {
        for (const char* wang : {"two_hashes", "one_hash", "edge_hash"}) numbers[std::string(wang) + where] = 10;
        numbers[std::string("corner") + where] = corner;
    }
    return numbers;
}

Numbers parts(double large, double small) { return {{"parts_of_large", large}, {"parts_of_small", small}}; }

Numbers appearance(double deviation)
{
    return {{"plain_deviation", 0.25}, {"long_deviation", deviation}, {"plain_repeat", 1}, {"long_repeat", 0}};
}

Numbers evaluations(double two, double corner)
{
    return {{"corner_evaluations", corner},
            {"two_hashes_evaluations", two},
            {"one_hash_evaluations", 4},
            {"edge_hash_evaluations", 4}};
}

Numbers diffraction(double ammann, double kari)
{
    return {{"strongest_ammann", ammann}, {"strongest_kari", kari}, {"strongest_scanline-compact", 0.0079}};
}

Numbers claimed_set(double width, double height)
{
    return {{"claimed_tiles", 44},
            {"claimed_period_width", width},
            {"claimed_period_height", height},
            {"smallest_tiles", 49}};
}

}

std::vector<ClaimCase> cases_of_tilings()
{
    return {
        exact("2.6-corner-problem", "corner-problem",
              {{"wang_pairs", 1}, {"compact_wang_pairs", 1}, {"corner_pairs", 0.5}},
              {{"wang_pairs", 1}, {"compact_wang_pairs", 1}, {"corner_pairs", 1}}),
        {"3.2-choices",
         [](MadeUpReport& r, Told what) {
             DistributionResult& scheme =
                 r.add_scheme("scanline", {{"tiles", 8}, {"fewest_choices", told(what, 2.0, 1.0, 4.0)}});
             scheme.facts = {std::string("8 tiles in the ") + told(what, "compact", "compact", "complete") + " set"};
         },
         Kind::exact},
        exact("3.3-corner-evaluations", "tiling-costs", evaluations(8, 4), evaluations(8, 5)),
        exact("3.3-wang-evaluations", "tiling-costs", evaluations(8, 4), evaluations(7, 4)),
        shown("3.5-direct", "tiling-costs", costs(2), costs(30)),
        shown("3.5-corner", "tiling-costs", costs(2), costs(30)),
        exact("3.4-parts", "noise", parts(0.02, 0.9), parts(0.2, 0.9)),
        shown("3.4-time", "tiling-costs", costs(2), costs(30)),
        exact("3.4-period", "tiling-costs", {{"period", 5'930'659'848.0}}, {{"period", 5'930'659'849.0}}),
        exact("3.4-entries", "tiling-costs", {{"entries", 180}}, {{"entries", 181}}),
        exact("3.4-noise-period", "noise", {{"long_period", 739'024}}, {{"long_period", 739'025}}),
        exact("3.4-noise-entries", "noise", {{"long_entries", 76}}, {{"long_entries", 77}}),
        exact("3.4-noise-look", "noise", appearance(0.26), appearance(0.22)),
        shown("3.4-noise-time", "noise", {{"hash_time_ratio", 5}, {"noise_time_ratio", 2.5}},
              {{"hash_time_ratio", 50}, {"noise_time_ratio", 1}}),
        exact("3.1-structured", "diffraction", diffraction(0.5, 0.02), diffraction(0.02, 0.02)),
        exact("8.3-tables", "aperiodic-tables", {{"numbers", 10}, {"same", 10}, {"unavailable", 3}},
              {{"numbers", 10}, {"same", 4}, {"unavailable", 3}}),
        {"8.3-smallest",
         [](MadeUpReport& r, Told what) {
             r.add_scheme("aperiodic-tables", what == Told::disagreement ? claimed_set(2, 3) : claimed_set(0, 0));
         },
         Kind::only_refuted},
    };
}

std::vector<ClaimCase> cases_of_applications()
{
    const auto tile_of_16 = [](MadeUpReport& r, Told what) {
        const Numbers best{{"radius_1", 0.69661}, {"radius_2", 0.6528}}, worse{{"radius_1", 0.7}, {"radius_2", 0.6}};
        r.add_scheme("self-similar-tile", told(what, best, worse, best)).facts = {
            told(what, "16 points", "16 points", "20 points")};
    };
    const auto calls = [](double dimension) {
        return Numbers{{"timed_dimension", dimension}, {"noise_calls_anywhere", 4}, {"noise_calls_in_rows", 9}};
    };
    return {
        {"4.5-time",
         [](MadeUpReport& r, Told) {
             TileSetRecord set{4096, 64, false, TileSetBuild{4, "d", 2}, {}};
             stored_of(tiles(r, "corner", 8, 64, 5)).tile_set = set;
         },
         Kind::shown},
        {"4.7-radii", tile_of_16, Kind::exact},
        {"7.2-clumping",
         [](MadeUpReport& r, Told what) {
             // One density by which points clump is enough.
             for (const double least : {told(what, 0.2, 0.5, 0.2), 0.5}) {
                 Numbers numbers{{"least_spacing", least}, {"mean_spacing", 0.6}, {"mean_spacing_before", 0.8}};
                 if (what != Told::nothing) numbers["least_spacing_before"] = 0.75;
                 r.add_scheme("warp", numbers);
             }
         },
         Kind::exact},
        exact("7.3-zoom", "ranks", {{"asked_for", 1000}, {"points", 1020}}, {{"asked_for", 1000}, {"points", 1100}}),
        {"7.5-instances",
         [](MadeUpReport& r, Told what) {
             r.add_scheme("instances", {{"instances", told(what, 1010.0, 1200.0, 1090.0)}, {"expected", 1000}});
         }},
        shown("7.6-noise-2d", "objects", calls(2), calls(2)),
        shown("7.6-noise-3d", "objects", calls(3), calls(3)),
    };
}

}

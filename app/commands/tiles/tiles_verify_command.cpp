// poissonlab tiles verify: what a tile set file holds, and what is proven of its tilings.
//
// The densities in the regions are those of Lagae, Tile-Based Methods in Computer Graphics, 2007,
// figure 6.24.
#include "analysis/measures/distance_statistics.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "app/commands/command.hpp"
#include "app/commands/tiles/monotile_work.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/tile_points/point_levels.hpp"
#include "host/tile_sampling/tile_samplers.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

// The evenness of tilings with ranked tiles at lower densities.

/// Tilings of which a part of the points is kept.
struct PrefixQuality
{
    double density = 0;         ///< the part that is asked for
    double power = 0;           ///< mean below half the principal frequency of as many points
    double random_power = 0;    ///< what a random order would leave there: 1 - f + f times the power of all points
    double relative_radius = 0; ///< the smallest one, of as many points
};

constexpr std::uint32_t tilings = 4;

/// The mean power below half of the principal frequency.
double low_power(const Spectrum& spectrum)
{
    const double end = principal_frequency(spectrum.points, spectrum.dimension) / 2;
    double power = 0, samples = 0;
    for (const RadialBin& bin : radial_statistics(spectrum)) {
        if (bin.frequency >= end) continue;
        power += bin.power * static_cast<double>(bin.samples);
        samples += static_cast<double>(bin.samples);
    }
    return power / samples;
}

PrefixQuality quality_at(const PoissonTileSet& set, double density)
{
    const PoissonTileParameters& p = set.parameters;
    const std::size_t wanted = p.dimension == 2 ? 4096 : 16'384;
    const std::uint32_t side = std::max(2U, tiling_side(wanted, density * p.points_per_tile, p.dimension));
    PrefixQuality quality{.density = density, .power = 0, .random_power = 0, .relative_radius = 1e300};
    std::optional<SpectrumEstimate> part, whole;
    for (std::uint32_t seed = 1; seed <= tilings; ++seed) {
        const PointSet all = reference::torus_points(set, seed, side);
        const PointSet kept = at_density(all, density, set, seed, side);
        if (!part) {
            const int size = spectrum_size(kept.size(), p.dimension);
            part.emplace(p.dimension, size, true);
            whole.emplace(p.dimension, size, true);
        }
        part->add(kept);
        whole->add(all);
        quality.relative_radius =
            std::min(quality.relative_radius, relative_radius(min_toroidal_distance(kept), kept.size(), p.dimension));
    }
    quality.power = low_power(part->mean());
    // The whole tiling's power at the frequencies of the part.
    Spectrum of_whole = whole->mean();
    of_whole.points = part->mean().points;
    quality.random_power = 1 - density + density * low_power(of_whole);
    return quality;
}

/// Measures a quarter, a half and three quarters of the ranks, each by four toroidal tilings of which some 4,000 points
/// (in 3D, 16,000) are kept.
std::vector<PrefixQuality> prefix_qualities(const PoissonTileSet& set)
{
    std::vector<PrefixQuality> qualities;
    for (const double density : {0.25, 0.5, 0.75}) qualities.push_back(quality_at(set, density));
    return qualities;
}

constexpr auto tiles_verify_notes =
    R"(FILE is a tile set, .ptiles or JSON: see docs/tile-set-file.md. Whatever made it, the minimum distance is proven
for every tiling: the exact smallest one among all points that can be near each other. Exit status 2 if the file is
damaged, tiles do not fit together, or it promises more than is proven.
Moments: sums over the points of a tile of their coordinates, of squares and products (order 2), of cubes (order 3).
Where all tiles have the same up to order m, spectra of tilings fall off as frequency^(2 m + 2): see docs/chain-tiles.md.
Density: points in the regions over those of as many points spread evenly. Ranked sets: the power at low frequencies
that parts of their points have, over what parts by chance would have; 0.5 and less is good.
Sets of one tile that never repeats (tiles build hat, spectre): all tables but that of points are made again and compared.
Sets whose points have classes: the distance of each pair of classes is proven as well, and where it occurs; moments are
those of each class, too.
  poissonlab tiles verify corner.ptiles)";

struct TilesVerifyOptions
{
    std::filesystem::path file;
    bool json = false;
};

using Json = nlohmann::ordered_json;

/// The parameters that a file states, and its certificate.
struct Verification
{
    std::string file;
    PoissonTileParameters parameters;
    std::uint64_t stored_squared_distance = 0;
    TileCertificate certificate;
    std::vector<PrefixQuality> prefixes;                 ///< of ranked sets
    std::vector<std::uint64_t> stored_class_distances{}; ///< squared, of each pair of classes
};

Verification verify(const std::filesystem::path& file)
{
    const PoissonTileSet set = read_tile_set(file);
    try {
        const TileCertificate certificate = certify(set);
        return {file.string(),
                set.parameters,
                set.squared_min_distance,
                certificate,
                set.parameters.ranked ? prefix_qualities(set) : std::vector<PrefixQuality>{},
                set.class_squared_distances};
    } catch (const InputError& error) {
        throw error.moved_to({file.string()});
    }
}

/// The root of a squared distance in squared units, in tiles.
double distance_of(std::uint64_t squared_distance)
{
    return std::sqrt(static_cast<double>(squared_distance)) / tile_units;
}

/// The name of the regions of cells of a dimension.
std::string region_name(int cell_dimension, const PoissonTileParameters& p)
{
    if (cell_dimension == p.dimension) return "interior";
    if (p.border == TileBorder::chain && cell_dimension == 1) return "chains";
    constexpr std::array names{"corners", "edges", "faces"};
    return names[static_cast<std::size_t>(cell_dimension)];
}

std::string described_guarantee(const Verification& v)
{
    const std::uint64_t proven = v.certificate.squared_min_distance;
    if (v.stored_squared_distance == 0) return "none";
    return fmt::format("{:.6f}: {}", relative_radius_of(v.stored_squared_distance, v.parameters),
                       v.stored_squared_distance == proven  ? "what is proven"
                       : v.stored_squared_distance < proven ? "less than is proven"
                                                            : "MORE than is proven");
}

std::string described_moments(const TileMoments& moments)
{
    const std::uint32_t order = moments.equal_order();
    return order == 0 ? "none but the number of points" : fmt::format("up to order {}, in whole numbers", order);
}

/// Says how much power is left by moments that were asked for and are equal but for rounding.
std::string described_residual(const MomentOrder& moments, std::uint32_t order)
{
    return fmt::format("differ by {:.2g} tiles^{}, a power of at most {:.2g} frequency^{}, in cycles a tile",
                       moments.largest_difference, order, moments.power, 2 * order);
}

std::string place_of(const UnitPosition& at) { return fmt::format("({}, {})", at[0], at[1]); }

void print_classes(const Verification& v)
{
    const TileClasses& classes = v.parameters.classes;
    fmt::print("\n{:<22}{:>10}{:>10}{:>10}  {}\n", "classes", "asked", "proven", "stored", "where it occurs");
    for (std::size_t j = 0; j < classes.count(); ++j)
        for (std::size_t i = 0; i <= j; ++i) {
            const ClassPairProof& proof = v.certificate.classes[class_pair(i, j)];
            const bool occurs = proof.squared_min_distance == proof.squared_closure_distance;
            const std::string where = occurs ? fmt::format("tile {}: {} and {}", proof.tile, place_of(proof.points[0]),
                                                           place_of(proof.points[1]))
                                             : "a bound";
            fmt::print("{:<22}{:>10.6f}{:>10.6f}{:>10.6f}  {}\n", fmt::format("{}, {}", i, j),
                       classes.distances.at(i, j), distance_of(proof.squared_min_distance),
                       distance_of(v.stored_class_distances[class_pair(i, j)]), where);
        }
    for (std::size_t i = 0; i < classes.count(); ++i) {
        const TileMoments& moments = v.certificate.class_moments[i];
        fmt::print("{:<22}{} points a tile, relative radius {:.6f}\n", fmt::format("class {}", i), classes.points[i],
                   relative_radius(distance_of(v.certificate.classes[class_pair(i, i)].squared_min_distance),
                                   classes.points[i], v.parameters.dimension));
        fmt::print("{:<22}equal moments {}: power falls off as frequency^{}\n", "", described_moments(moments),
                   moments.proven_exponent());
    }
}

Json class_json(const Verification& v)
{
    const TileClasses& classes = v.parameters.classes;
    Json json{{"points", classes.points}};
    for (std::size_t i = 0; i < classes.count(); ++i) {
        Json asked = Json::array(), proven = Json::array(), places = Json::array();
        for (std::size_t j = 0; j < classes.count(); ++j) {
            const ClassPairProof& proof = v.certificate.classes[class_pair(i, j)];
            const bool occurs = proof.squared_min_distance == proof.squared_closure_distance;
            asked.push_back(classes.distances.at(i, j));
            proven.push_back(distance_of(proof.squared_min_distance));
            const auto place = [](const UnitPosition& at) { return Json{at[0], at[1]}; };
            const std::size_t own = i <= j ? 0 : 1;
            places.push_back(occurs ? Json{{"tile", proof.tile},
                                           {"points", {place(proof.points[own]), place(proof.points[1 - own])}}}
                                    : Json(nullptr));
        }
        json["asked_distances"].push_back(asked);
        json["min_distances"].push_back(proven);
        json["nearest"].push_back(places);
        json["relative_radii"].push_back(
            relative_radius(distance_of(v.certificate.classes[class_pair(i, i)].squared_min_distance),
                            classes.points[i], v.parameters.dimension));
        json["equal_moments"].push_back(v.certificate.class_moments[i].equal_order());
        json["proven_exponents"].push_back(v.certificate.class_moments[i].proven_exponent());
    }
    return json;
}

void print_summary(const Verification& v)
{
    const PoissonTileParameters& p = v.parameters;
    const TileCertificate& c = v.certificate;
    const auto line = [](const std::string& name, const std::string& value) { fmt::print("{:<22}{}\n", name, value); };
    line("kind", kind_name(p));
    if (p.kind != PoissonTileKind::frame) line("colours", std::to_string(p.colors));
    line("tiles", std::to_string(c.tiles));
    line("points per tile", std::to_string(c.points_per_tile));
    line("border", tile_borders[p.border]);
    line("relative radius", fmt::format("{:.6f} proven, {:.6f} asked for", c.relative_radius, p.relative_radius));
    line("minimum distance", fmt::format("{:.6f} tiles", distance_of(c.squared_min_distance)));
    line("stored guarantee", described_guarantee(v));
    line(p.dimension == 2 ? "largest empty circle" : "largest empty sphere",
         fmt::format("radius at most {:.6f} tiles, {:.4f} minimum distances", c.largest_empty_radius,
                     c.largest_empty_radius_in_min_distances));
    line("equal moments", described_moments(c.moments));
    line("low frequencies", fmt::format("power falls off as frequency^{} or faster, between the lattice's peaks",
                                        c.moments.proven_exponent()));
    for (std::uint32_t order = c.moments.equal_order() + 1; order <= p.equal_moments; ++order)
        line(fmt::format("moments of order {}", order), described_residual(c.moments.orders[order - 1], order));
    for (const PrefixQuality& prefix : v.prefixes)
        line(fmt::format("{:.0f} % of the points", 100 * prefix.density),
             fmt::format("relative radius {:.4f}, power at low frequencies {:.4f}, {:.3f} of a random part's",
                         prefix.relative_radius, prefix.power, prefix.power / prefix.random_power));
    const bool has_density = p.border == TileBorder::strip; // chains have no area of their own
    fmt::print("\n{:<22}{:>8}{:>10}{:>8}{}\n", "points of a tile near", "min", "mean", "max",
               has_density ? "   density" : "");
    for (int i = 0; i <= p.dimension; ++i) {
        const RegionCounts& r = c.regions[static_cast<std::size_t>(i)];
        fmt::print("{:<22}{:>8}{:>10.3f}{:>8}{}\n", region_name(i, p), r.min, r.mean, r.max,
                   has_density ? fmt::format("{:>10.4f}", r.density) : "");
    }
    if (!p.classes.is_empty()) print_classes(v);
}

void print_json(const Verification& v)
{
    const PoissonTileParameters& p = v.parameters;
    const TileCertificate& c = v.certificate;
    Json json{{"file", v.file},
              {"kind", kind_name(p)},
              {"dimension", p.dimension},
              {"colors", p.colors},
              {"tiles", c.tiles},
              {"points_per_tile", c.points_per_tile},
              {"border", tile_borders[p.border]},
              {"joint_iterations", p.joint_iterations},
              {"null_peaks", p.null_peaks},
              {"asked_equal_moments", p.equal_moments},
              {"equal_moments", c.moments.equal_order()},
              {"proven_exponent", c.moments.proven_exponent()},
              {"moments", Json::array()},
              {"ranked", p.ranked},
              {"relative_radius", c.relative_radius},
              {"asked_relative_radius", p.relative_radius},
              {"min_distance", distance_of(c.squared_min_distance)},
              {"squared_min_distance", c.squared_min_distance},
              {"stored_squared_min_distance", v.stored_squared_distance},
              {"largest_empty_radius", c.largest_empty_radius},
              {"largest_empty_radius_in_min_distances", c.largest_empty_radius_in_min_distances}};
    for (std::size_t i = 0; i < c.moments.orders.size(); ++i) {
        const MomentOrder& moments = c.moments.orders[i];
        json["moments"].push_back({{"order", i + 1},
                                   {"equal", moments.are_equal},
                                   {"largest_difference", moments.largest_difference},
                                   {"power", moments.power}});
    }
    for (int i = 0; i <= p.dimension; ++i) {
        const RegionCounts& r = c.regions[static_cast<std::size_t>(i)];
        json["regions"][region_name(i, p)] = {{"min", r.min}, {"mean", r.mean}, {"max", r.max}};
        if (p.border == TileBorder::strip) json["regions"][region_name(i, p)]["density"] = r.density;
    }
    for (const PrefixQuality& prefix : v.prefixes)
        json["parts"].push_back({{"density", prefix.density},
                                 {"relative_radius", prefix.relative_radius},
                                 {"low_frequency_power", prefix.power},
                                 {"random_low_frequency_power", prefix.random_power}});
    if (!p.classes.is_empty()) json["classes"] = class_json(v);
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void verify_tiles(const TilesVerifyOptions& options)
{
    if (is_monotile_points_file(options.file)) return verify_monotile(options.file, options.json);
    const Verification verification = verify(options.file);
    if (options.json)
        print_json(verification);
    else
        print_summary(verification);
    try {
        check_promises(verification.parameters, verification.stored_squared_distance, verification.certificate);
        check_class_promises(verification.parameters.classes, verification.stored_class_distances,
                             verification.certificate.classes);
    } catch (const InputError& error) {
        throw error.moved_to({verification.file});
    }
}

}

Command tiles_verify_command()
{
    const auto o = std::make_shared<TilesVerifyOptions>();
    return {"verify",
            "Check a tile set's file and prove its minimum distance",
            {{"FILE", &o->file, "The tile set (.ptiles, .json)"}, {"--json", &o->json, "Print JSON"}},
            tiles_verify_notes,
            action_on(o, verify_tiles)};
}

}

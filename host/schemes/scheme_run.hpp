// Makes what the tables [[scheme]] of a config ask for: pictures, counts and tables of tilings and tile sets.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapters 2, 3 and 8.
#pragma once

#include "base/programs/interrupt.hpp"
#include "host/schemes/scheme_settings.hpp"
#include "host/settings/keys/keys.hpp"
#include "results/pictures/distribution_files.hpp"
#include "results/statistic.hpp"
#include "tiles/isohedral/goal_outline.hpp"
#include "tiles/isohedral/isohedral_tile.hpp"
#include "tiles/prototiles/polygon_tiling.hpp"
#include "tiles/sphere/spherical_tile.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace poissonlab {

// Times of small pieces of work that are compared with each other.

/// The median time of each piece of work in nanoseconds over `steps`. Pieces take turns, so that what disturbs the
/// machine disturbs all of them. Throws Interrupted.
inline std::vector<double> median_nanoseconds(const std::vector<std::function<void()>>& pieces, double steps)
{
    constexpr int rounds = 7;
    std::vector<std::vector<double>> times(pieces.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            stop_if_interrupted();
            const auto begin = std::chrono::steady_clock::now();
            pieces[i]();
            const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
            times[i].push_back(taken.count() / steps);
        }
    std::vector<double> medians;
    for (std::vector<double>& all : times) medians.push_back(median(std::move(all)));
    return medians;
}

// Values of keys that several schemes have.

/// The numbers of a list, from -most to most; nothing for any other value.
std::optional<std::vector<double>> numbers_of_list(const ConfigNode& list, double most = 100);

/// The curve of a list of points [x, y], with (0, 0) before and (1, 0) after them; nothing for any other value.
std::optional<PlaneCurve> curve_of_node(const ConfigNode& list);

/// The key `curves` = [[[0.3, 0.1], [0.7, -0.1]], ...]: the points of each between (0, 0) and (1, 0).
void curve_keys(Keys& keys, std::vector<PlaneCurve>& curves);

/// The keys `split` and `split_curve`: the path that divides a tile. It excludes other keys.
void split_keys(Keys& keys, std::optional<TileSplit>& split, const std::vector<std::string>& excluded = {});

/// The type of settings without a goal.
const IsohedralType& type_of(const IsohedralSettings& settings);

/// The tile that the settings say. Throws InputError for parameters that it cannot have.
IsohedralTile tile_of(const IsohedralSettings& settings, std::uint64_t seed);

/// A shape that tiles are to look like, with what is cut out of it: eyes, gills.
struct GoalShape
{
    GoalOutline outline;
    std::vector<std::vector<PlanePoint>> holes; ///< in the units of the outline
};

/// Reads a region's file or description; see read_region(). Throws InputError unless it is one polygon.
GoalShape goal_of(const std::string& text);

/// The tiling that the settings name. Throws InputError for a file that is none.
PolygonTiling tiling_of(const PolygonTilingChoice& choice);

// One function a kind, each in a file of its own, which makes it and writes its files. Each throws InputError where
// that cannot be done, StorageError, and Interrupted.
DistributionResult make_corner_problem(const CornerProblemSettings& settings, std::uint64_t seed,
                                       DistributionFiles& files);
DistributionResult make_scanline_steps(const ScanlineStepsSettings& settings, std::uint64_t seed,
                                       DistributionFiles& files);
DistributionResult make_direct_scheme(const DirectTilingSettings& settings, DistributionFiles& files);
DistributionResult make_noise(const NoiseSettings& settings, std::uint64_t seed, DistributionFiles& files);
DistributionResult make_tiling_costs(const TilingCostSettings& settings, std::uint64_t seed);
DistributionResult make_construction(const ConstructionSettings& settings, std::uint64_t seed,
                                     DistributionFiles& files);
DistributionResult make_aperiodic_tables(const AperiodicTableSettings& settings, DistributionFiles& files);
DistributionResult make_diffraction(const DiffractionSettings& settings, DistributionFiles& files);
DistributionResult make_isohedral(const IsohedralSettings& settings, std::uint64_t seed, DistributionFiles& files);
/// The tiling with the tile that looks most like the goal of the settings.
DistributionResult make_goal_tiling(const IsohedralSettings& settings, DistributionFiles& files);
DistributionResult make_substitution(const SubstitutionSettings& settings, DistributionFiles& files);
DistributionResult make_periodic(const PeriodicSettings& settings, DistributionFiles& files);
DistributionResult make_bricks(const BrickSettings& settings, DistributionFiles& files);
DistributionResult make_spherical(const SphericalTileSettings& settings, DistributionFiles& files);
DistributionResult make_surface(const SurfaceSettings& settings, std::uint64_t seed, DistributionFiles& files);

}

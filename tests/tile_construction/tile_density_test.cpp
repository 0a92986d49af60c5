// Points are as dense near corners and edges as in interiors: a seam would show here first.
#include "poisson_tiles/tile_certificate.hpp"
#include "support/statistics.hpp"
#include "support/small_tile_sets.hpp"
#include "tile_construction/tile_construction.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint32_t points = 64;
constexpr std::uint32_t colors = 4;

PoissonTileParameters parameters(std::uint64_t seed)
{
    PoissonTileParameters p =
        with_repulsion(with_lloyd(tile_set_parameters(PoissonTileKind::corner, 2, colors, points, 0.75), 5));
    p.seed = seed;
    return p;
}

std::unique_ptr<TileFiller> filler_for(const PoissonTileParameters& p)
{
    return make_tile_filler(fill_settings(p), Device::open());
}

/// How much the number of points in a whole region varies in untiled sets of the same method: the standard deviation, for
/// corners and for edges.
std::array<double, 2> spread_of_counts()
{
    const PoissonTileParameters p = parameters(99);
    FillStage stage{regions_of(p), 20, false, {}, {}};
    stage.active.cells = all_cells(2);
    std::vector<FillProblem> problems(60);
    for (std::uint32_t i = 0; i < problems.size(); ++i) {
        problems[i].active = 4 * points;
        problems[i].stream = i;
    }
    std::array<std::vector<double>, 2> counts;
    for (const FilledTorus& torus : filler_for(p)->fill(stage, problems, 0)) {
        std::array<int, 16> in_cell{};
        for (const TilePosition& point : torus.active) ++in_cell[cell_at(stage.regions, point)];
        for (unsigned base = 0; base < 4; ++base) {
            counts[0].push_back(in_cell[cell_number(0, base, 2)]);
            counts[1].push_back(in_cell[cell_number(1, base, 2)]);
            counts[1].push_back(in_cell[cell_number(2, base, 2)]);
        }
    }
    std::array<double, 2> spread{};
    for (std::size_t i = 0; i < 2; ++i)
        spread[i] = test::mean_of(counts[i]).standard_error * std::sqrt(static_cast<double>(counts[i].size()));
    return spread;
}

/// A set has few corners and edges, so that their mean is not known better than their spread allows. Over many sets it is.
TEST(TileDensity, IsTheSameInAllRegions)
{
    constexpr int sets = 12;
    const std::array<double, 2> spread = spread_of_counts();
    std::array<double, 3> excess{}; // of corners, edges and interiors, in points of all their regions
    for (int seed = 1; seed <= sets; ++seed) {
        const PoissonTileParameters p = parameters(static_cast<std::uint64_t>(seed));
        const TileRegions regions = regions_of(p);
        const TileCertificate proof = certify(construct_tile_set(p, *filler_for(p)).set);
        // Whole corners: colours; whole edges, of both directions: colours^2 each.
        const double corner_mean = points * regions.volume(0);
        const double edge_mean = points * regions.volume(1);
        const double corner_excess = proof.regions[0].mean - corner_mean;
        const double edge_excess = proof.regions[1].mean - 2 * edge_mean;
        EXPECT_LT(std::abs(corner_excess), 3 * spread[0] / std::sqrt(colors)) << "seed " << seed;
        EXPECT_LT(std::abs(edge_excess), 3 * 2 * spread[1] / std::sqrt(2.0 * colors * colors)) << "seed " << seed;
        excess[0] += corner_excess / corner_mean / sets;
        excess[1] += edge_excess / (2 * edge_mean) / sets;
        excess[2] += (proof.regions[2].mean / (points * regions.volume(3)) - 1) / sets;
    }
    EXPECT_LT(std::abs(excess[0]), 3 * spread[0] / std::sqrt(1.0 * sets * colors) / (points * regions_of(parameters(1)).volume(0)));
    EXPECT_LT(std::abs(excess[1]), 0.02);
    EXPECT_LT(std::abs(excess[2]), 0.005);
}

/// The density as a function of the distance from the border, in strips of half a radius: it must not follow the regions.
TEST(TileDensity, DoesNotChangeWithTheDistanceFromTheBorder)
{
    const PoissonTileParameters p = parameters(3);
    const PoissonTileSet set = construct_tile_set(p, *filler_for(p)).set;
    const int strip = regions_of(p).width / 2;
    std::vector<double> counts(6);
    for (std::size_t i = 0; i < set.points.size(); i += 2) {
        const auto folded = [&](std::size_t axis) {
            return std::min<int>(set.points[i + axis], tile_units - set.points[i + axis]);
        };
        const auto k = static_cast<std::size_t>(std::min(folded(0), folded(1)) / strip);
        if (k < counts.size()) ++counts[k];
    }
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const double inner = 1 - 2.0 * strip * static_cast<double>(k) / tile_units;
        const double innermost = inner - 2.0 * strip / tile_units;
        const double mean = points * p.tiles * (inner * inner - innermost * innermost);
        std::printf("strip %zu: %.4f\n", k, counts[k] / mean);
    }
}

}
}

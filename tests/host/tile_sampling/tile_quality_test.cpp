// The spectra of tilings: the order of the methods, and what more colours bring.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 6.9 to 6.11.
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "host/sampling/repulsion.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tests/support/small_tile_sets.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint32_t points_per_tile = 32;
constexpr std::uint32_t side = 8;
constexpr std::uint32_t realizations = 8;
constexpr int frequencies = 256;

Device& device()
{
    static Device opened = Device::open();
    return opened;
}

Spectrum spectrum_of(PoissonTileKind kind, std::uint32_t number)
{
    const PoissonTileParameters p =
        with_repulsion(with_lloyd(tile_set_parameters(kind, 2, number, points_per_tile, 0.75), 8));
    const PoissonTileSet tiles = build_tile_set(p, Engine::opencl, []() -> Device& { return device(); }).set;
    TilePointGenerator generator(device(), tiles);
    SpectrumEstimate estimate(2, frequencies, true);
    for (std::uint32_t seed = 1; seed <= realizations; ++seed) estimate.add(generator.generate_torus(seed, side));
    return estimate.mean();
}

/// The mean height of the lattice's peaks over the power around them.
double peaks(PoissonTileKind kind, std::uint32_t number)
{
    return lattice_peaks(spectrum_of(kind, number), side).mean_ratio;
}

TEST(TileQuality, CornerTilesArePreferableToEdgeTilesAndThoseToTemplates)
{
    // 4,096 tiles each.
    const double corner = peaks(PoissonTileKind::corner, 8);
    const double edge = peaks(PoissonTileKind::edge, 2);
    const double frame = peaks(PoissonTileKind::frame, 4096);
    EXPECT_LT(2 * corner, edge);
    EXPECT_LT(1.3 * edge, frame);
}

TEST(TileQuality, PeaksFallWithTheNumberOfColors)
{
    double last = 1e300;
    for (const std::uint32_t colors : {2u, 3u, 5u, 8u}) {
        const double height = peaks(PoissonTileKind::corner, colors);
        EXPECT_LT(height, last) << colors << " colours";
        last = height;
    }
    EXPECT_LT(last, 5);
}

/// Power by frequency without the lattice's frequencies, in bins of 8.
std::vector<double> power_outside_peaks(const Spectrum& spectrum)
{
    std::vector<double> sum(frequencies / 16);
    std::vector<double> count(sum.size());
    for (int v = -frequencies / 2; v < frequencies / 2; ++v) {
        for (int u = -frequencies / 2; u < frequencies / 2; ++u) {
            if (u % static_cast<int>(side) == 0 && v % static_cast<int>(side) == 0) continue;
            const auto bin = static_cast<std::size_t>(std::hypot(u, v) / 8);
            if (bin >= sum.size()) continue;
            sum[bin] += spectrum.at(u, v);
            ++count[bin];
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= count[i];
    return sum;
}

Spectrum untiled_spectrum()
{
    const std::size_t points = std::size_t{side} * side * points_per_tile;
    SpectrumEstimate estimate(2, frequencies, true);
    RelaxationDartThrower thrower(device());
    for (std::uint32_t k = 0; k < realizations; ++k) {
        RelaxationDartThrowingRequest darts;
        darts.points = points;
        darts.attempts = 100;
        darts.stream = stream_key(5, Purpose::relaxation_dart_throwing, k);
        const PointSet thrown = thrower.throw_darts(darts).points;
        const PointSet relaxed = LloydRelaxation(device()).relax(thrown, {}, {8}).points;
        estimate.add(Repulsion(device()).repel(relaxed, {}, {min_distance_for(0.75, points, 2)}).points);
    }
    return estimate.mean();
}

/// Apart from its peaks a tiling has nearly the radial power of the untiled method. Nearly: beside pieces
/// that were there before points are less ordered, which takes a tenth off the first peak and fills what is
/// below and between peaks.
TEST(TileQuality, OutsideOfPeaksPowerIsNearlyThatOfTheUntiledMethod)
{
    const std::vector<double> tiled = power_outside_peaks(spectrum_of(PoissonTileKind::corner, 8));
    const std::vector<double> untiled = power_outside_peaks(untiled_spectrum());
    for (std::size_t i = 0; i < tiled.size(); ++i) {
        SCOPED_TRACE(testing::Message() << "frequencies from " << 8 * i);
        if (untiled[i] < 0.3) {
            EXPECT_NEAR(tiled[i], untiled[i], 0.12);
        } else {
            EXPECT_NEAR(tiled[i] / untiled[i], 1, 0.3);
        }
    }
}

}
}

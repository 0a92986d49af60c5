// Kernels and the plain algorithms make the same tile sets: kinds of tiles, numbers of points, radii and steps of the
// construction are drawn at random, so that no combination is left out because nobody thought of it.
#include "host/tile_sampling/tile_set_cache.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

/// Numbers that depend on the seed alone, whatever the standard library.
class TwinDice
{
public:
    explicit TwinDice(std::uint32_t seed) : random_(seed) {}

    /// A random number in [low, high).
    double between(double low, double high) { return low + (high - low) * (word() / 0x1p32); }
    std::uint32_t upto(std::uint32_t low, std::uint32_t high) { return low + word() % (high - low + 1); }
    bool once_in(std::uint32_t times) { return word() % times == 0; }

private:
    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }

    std::mt19937 random_;
};

/// Borders, iterations of all tiles together, and equal moments.
void choose_border(PoissonTileParameters& p, TwinDice& dice)
{
    const bool may_have_chains = p.dimension == 2 && p.kind != PoissonTileKind::edge;
    const TileBorder border = may_have_chains && dice.once_in(3) ? TileBorder::chain : TileBorder::strip;
    const std::uint32_t joint = border == TileBorder::chain || dice.once_in(3) ? dice.upto(0, 4) : 0;
    const bool has_nulling = joint > 0 && dice.once_in(2);
    set_border(p, border, joint, has_nulling, dice.once_in(5) ? dice.upto(1, 2) : 0);
}

/// Few points and small radii are as likely as many and large ones: where neighbours are far, cells reach far. CGAL
/// takes long in space, where sets are smaller.
PoissonTileParameters parameters_of_case(std::uint32_t number)
{
    TwinDice dice(number);
    PoissonTileParameters p;
    const PoissonTileFamily family = poisson_tile_families.entries[dice.upto(0, 3)].first;
    p.kind = family.kind;
    p.dimension = family.dimension;
    const bool is_in_space = p.dimension == 3;
    const bool has_many = is_in_space && dice.once_in(12);
    p.colors = p.kind == PoissonTileKind::corner && !is_in_space ? dice.upto(1, 3) : has_many ? 2 : 1;
    p.tiles = p.kind == PoissonTileKind::frame ? dice.upto(1, 9) : tile_count(p.kind, p.dimension, p.colors);
    const double most = has_many ? 9 : is_in_space ? 60 : p.tiles > 16 ? 48 : 200;
    p.points_per_tile = static_cast<std::uint32_t>(std::exp(dice.between(std::log(4), std::log(most + 1))));
    const double largest = is_in_space ? 0.6 : 0.75;
    const double room = 0.9 * std::pow(p.points_per_tile / (is_in_space ? 30.0 : 8.0), 1.0 / p.dimension);
    p.relative_radius = dice.between(0.1, std::min(largest, largest * room));
    p.lloyd_iterations = dice.once_in(4) ? 0 : dice.upto(1, has_many ? 1 : is_in_space ? 4 : 12);
    p.repulsion = dice.once_in(2);
    p.seed = number;
    choose_border(p, dice);
    return p;
}

/// The tiles and their proven distance, or why there are none.
struct TwinSet
{
    PoissonTileSet set;
    std::string error;
    bool operator==(const TwinSet&) const = default;
};

TwinSet build_twin(const PoissonTileParameters& p, Engine engine)
{
    try {
        return {build_tile_set(p, engine,
                               []() -> Device& {
                                   static Device device = Device::open();
                                   return device;
                               })
                    .set,
                ""};
    } catch (const InputError& error) {
        return {{}, error.what()};
    }
}

std::string words_of_case(const PoissonTileParameters& p)
{
    return fmt::format("{}{}, C = {}, {} tiles, N = {}, rho = {}, {} iterations, {} together{}, moments {}, {}",
                       kind_name(p), p.border == TileBorder::chain ? " with chains" : "", p.colors, p.tiles,
                       p.points_per_tile, p.relative_radius, p.lloyd_iterations, p.joint_iterations,
                       p.null_peaks ? " with nulling" : "", p.equal_moments,
                       p.repulsion ? "repulsion" : "no repulsion");
}

class TileSetTwins : public testing::TestWithParam<std::uint32_t>
{
};

TEST_P(TileSetTwins, KernelsAndPlainAlgorithmsMakeTheSameTiles)
{
    constexpr std::uint32_t sets_a_case = 10;
    for (std::uint32_t i = 0; i < sets_a_case; ++i) {
        const PoissonTileParameters p = parameters_of_case(1 + GetParam() * sets_a_case + i);
        const TwinSet expected = build_twin(p, Engine::reference);
        const TwinSet result = build_twin(p, Engine::opencl);
        EXPECT_EQ(result.error, expected.error) << words_of_case(p);
        EXPECT_TRUE(result.set == expected.set) << words_of_case(p);
    }
}

INSTANTIATE_TEST_SUITE_P(Some, TileSetTwins, testing::Range(0U, 4U));
INSTANTIATE_TEST_SUITE_P(Nightly, TileSetTwins, testing::Range(4U, 124U));

}
}

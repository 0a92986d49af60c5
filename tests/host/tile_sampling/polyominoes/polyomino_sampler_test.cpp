// The sampler of polyominoes: its sets, its cache, and what it refuses.
#include "experiment/config/plan.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/tile_sampling/polyominoes/polyomino_sampler.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace poissonlab {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class PolyominoSampling : public ::testing::Test
{
protected:
    PolyominoSampling() { setenv("POISSONLAB_CACHE", folder().c_str(), 1); }
    ~PolyominoSampling() override { unsetenv("POISSONLAB_CACHE"); }

    /// One for all tests, so that the table is built once.
    static std::string folder()
    {
        static const TemporaryFolder kept;
        return kept.path();
    }

    static std::unique_ptr<Sampler> sampler(std::size_t points, const std::string& density = "")
    {
        const SamplerSpec& spec = *find_sampler("polyominoes");
        Parameters parameters(spec.parameters);
        if (!density.empty()) parameters.set("density", density);
        return spec.create(parameters, {points, 2, 1}, Engine::reference, {});
    }

    static void expect_refused(const std::string& keys, const std::string& message)
    {
        const std::string config = "[[method]]\nsampler = \"polyominoes\"\n" + keys;
        EXPECT_THAT(message_of([&] { make_plan(parse_config(config, "test.toml")); }), HasSubstr(message));
    }
};

TEST_F(PolyominoSampling, RealizationsAreDifferentSetsOfTheSameSize)
{
    const auto polyominoes = sampler(1000);
    const PointSet first = polyominoes->sample(0), second = polyominoes->sample(1);
    EXPECT_EQ(first.size(), 1000U);
    EXPECT_EQ(second.size(), 1000U);
    EXPECT_NE(first, second);
    EXPECT_EQ(polyominoes->sample(0), first);
    EXPECT_FALSE(polyominoes->traits().sizes_vary);
}

/// The kernel against the plain twin: all levels, rows that are whole and others, any work-group size.
TEST_F(PolyominoSampling, KernelsMakeTheSamePoints)
{
    const PolyominoTable table = cached_polyomino_table(Polyomino::P, folder()).built;
    const Device device = Device::open();
    for (const std::size_t group : {std::size_t{0}, std::size_t{1}, std::size_t{48}}) {
        PolyominoGenerator generator(device, Polyomino::P, group);
        for (const std::uint32_t side : {5U, 15U}) {
            const PolyominoTorus torus(table, side, 2, 1);
            for (const std::size_t points :
                 {std::size_t{1}, std::size_t{1280}, std::size_t{5121}, std::size_t{100'000}})
                ASSERT_EQ(generator.points(torus, points), polyomino_points(torus, points));
        }
    }
}

/// Few enough for an interpreter of kernels.
TEST_F(PolyominoSampling, KernelsMakeTheSameFewPoints)
{
    const PolyominoTable table = cached_polyomino_table(Polyomino::P, folder()).built;
    PolyominoGenerator generator(Device::open(), Polyomino::P, 48);
    const PolyominoTorus torus(table, 5, 2, 1);
    for (const std::size_t points : {1U, 400U})
        ASSERT_EQ(generator.points(torus, points), polyomino_points(torus, points));
}

TEST_F(PolyominoSampling, SetsOfADensityHaveAboutAsManyPoints)
{
    const auto polyominoes = sampler(5000, "exp(-4*(x^2+y^2))");
    EXPECT_TRUE(polyominoes->traits().sizes_vary);
    EXPECT_NEAR(static_cast<double>(polyominoes->sample(0).size()), 5000, 100);
}

TEST_F(PolyominoSampling, TablesAreKept)
{
    std::vector<std::string> steps;
    const TemporaryFolder cache;
    const auto on_step = [&](const std::string& what) { steps.push_back(what); };
    const auto built = cached_polyomino_table(Polyomino::P, cache.path(), on_step);
    EXPECT_FALSE(built.cached);
    EXPECT_THAT(steps, Contains(HasSubstr("table of polyominoes: corrections 16 of 16")));
    const auto read = cached_polyomino_table(Polyomino::P, cache.path());
    EXPECT_TRUE(read.cached);
    EXPECT_EQ(read.built.rows, built.built.rows);
    std::ofstream(cache.path() / polyomino_table_name(Polyomino::P)) << "damaged";
    EXPECT_FALSE(cached_polyomino_table(Polyomino::P, cache.path()).cached);
    EXPECT_TRUE(cached_polyomino_table(Polyomino::P, cache.path()).cached);
}

TEST_F(PolyominoSampling, BuildingEndsWhenItIsTold)
{
    const TemporaryFolder cache;
    const auto stop = [](const std::string&) { throw std::runtime_error("stop"); };
    EXPECT_THROW(cached_polyomino_table(Polyomino::P, cache.path(), stop), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(cache.path() / polyomino_table_name(Polyomino::P)));
}

TEST_F(PolyominoSampling, BadParametersAreRefused)
{
    expect_refused("variant = \"L\"", "variant");
    expect_refused("seed_side = 12", "test.toml:3: seed_side = 12: must be a multiple of 5");
    expect_refused("variant = \"G\"\nseed_side = 10", "test.toml:4: seed_side = 10: must be a multiple of 6");
    expect_refused("seed_side = 0", "seed_side");
    expect_refused("density = \"x +\"", "test.toml:3: density");
    expect_refused("density = \"0\"", "0 everywhere");
    expect_refused("density = \"x\"", "must be a number that is not negative");
    expect_refused("density = \"no-picture.png\"", "no such file");
    expect_refused("density_from = \"ink\"", "is for a density");
    expect_refused("density = \"abs(x) < 0.001 && abs(y) < 0.001 ? 1 : 0.0000001\"", "densest place");
}

}
}

// The memory that samplers say that they take of a device, held against what they take; and plans that are too large
// for one.
#include "experiment/config/plan.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/exhibits.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <set>

namespace poissonlab {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::vector<SeriesPlan> memory_plan_of(const std::string& methods, int dimension = 2, std::size_t points = 4096)
{
    const std::string head = "seed = 5\n[analysis]\npoints = " + std::to_string(points) +
                             "\ndimension = " + std::to_string(dimension) + "\n";
    return make_plan(parse_config(head + methods, "test.toml"));
}

constexpr const char* methods_2d = R"(
[[method]]
sampler = "dart-throwing"
points = [256, 20000]
relative_radius = [0.3, 0.7]
[[method]]
sampler = "dart-throwing"
points = [256, 20000]
stop = "saturation"
[[method]]
sampler = "relaxation-dart-throwing"
points = [10, 1000, 10000]
factor = [0.9, 0.998]
[[method]]
sampler = "sample-elimination"
points = [5, 1000, 10000]
[[method]]
sampler = "random"
order = "sample-elimination"
points = [5, 1000, 10000]
[[method]]
sampler = "farthest-point"
points = [5, 1000, 10000]
iterations = 1
[[method]]
sampler = "target-spectrum"
iterations = 1
[[method]]
sampler = "equal-areas"
points = [5, 1000, 10000]
iterations = 0
[[method]]
sampler = "gaussian-blue-noise"
points = [200, 1000, 10000]
iterations = 1
[[method]]
sampler = "gaussian-blue-noise"
points = [1000, 4000]
density = "gauss-and-waves"
iterations = 1
[[method]]
sampler = "lloyd"
points = [5, 1000, 40000]
iterations = 1
[[method]]
sampler = "lloyd"
points = [1000, 20000]
iterations = 1
until_relative_radius = [0.05, 0.9]
repulsion = true
start = { sampler = "dart-throwing", stop = "saturation" }
[[method]]
sampler = "lloyd"
iterations = 1
start = { sampler = "regular" }
[[method]]
sampler = "corner-tiles"
colors = [1, 2, 4]
points_per_tile = [32, 128]
lloyd_iterations = 2
relative_radius = 0.4
[[method]]
sampler = "corner-tiles"
colors = [2, 4]
points_per_tile = 32
lloyd_iterations = 2
repulsion = true
joint_iterations = 4
border = ["strip", "chain"]
[[method]]
sampler = "template-tiles"
tiles = 100
lloyd_iterations = 2
relative_radius = 0.7
repulsion = true
joint_iterations = 4
border = ["strip", "chain"]
[[method]]
sampler = "edge-tiles"
colors = [1, 2]
points_per_tile = 16
lloyd_iterations = 2
joint_iterations = 4
relative_radius = 0.4
[[method]]
sampler = "edge-tiles"
colors = [1, 2]
points_per_tile = 16
lloyd_iterations = 2
relative_radius = 0.4
[[method]]
sampler = "template-tiles"
tiles = [2, 30]
lloyd_iterations = 2
relative_radius = 0.4
points = [64, 70000]
[[method]]
sampler = "random"
[[method]]
sampler = "isohedral-tiles"
[[method]]
sampler = "jittered"
[[method]]
sampler = "hexagonal"
[[method]]
sampler = "sobol"
[[method]]
sampler = "halton"
[[method]]
sampler = "best-candidate"
[[method]]
sampler = "bridson"
[[method]]
sampler = "voronoi-darts"
points = [256, 20000]
relative_radius = [0.3, 0.7]
[[method]]
sampler = "voronoi-darts"
points = [256, 20000]
stop = "saturation"
[[method]]
sampler = "sector-darts"
variant = ["logarithmic", "linear", "boundary"]
points = [256, 20000]
[[method]]
sampler = "shade-tiles"
[[method]]
sampler = "averaged-tiles"
iterations = 1
[[method]]
sampler = "recursive-wang-tiles"
points_per_tile = 128
[[method]]
sampler = "polyominoes"
[[method]]
sampler = "polyominoes"
density = "x + 1"
[[method]]
sampler = "hat-tiles"
points = [5, 10000]
[[method]]
sampler = "spectre-tiles"
points = [5, 10000]
levels = 0
[[method]]
sampler = "dodecagonal"
points = [1000, 100000]
[[method]]
sampler = "penrose"
points = [1000, 100000]
[[method]]
sampler = "penrose"
density = "x > 0 ? 1 : 0.1"
)";

constexpr const char* methods_3d = R"(
[[method]]
sampler = "dart-throwing"
points = [256, 10000]
relative_radius = [0.4, 0.6]
[[method]]
sampler = "dart-throwing"
points = 2000
stop = "saturation"
[[method]]
sampler = "relaxation-dart-throwing"
points = [100, 5000]
[[method]]
sampler = "lloyd"
points = [100, 10000]
iterations = 1
[[method]]
sampler = "lloyd"
points = 3000
iterations = 1
until_relative_radius = 0.7
repulsion = true
start = { sampler = "relaxation-dart-throwing" }
[[method]]
sampler = "sphere-tiles"
colors = [1, 2]
points_per_tile = 32
lloyd_iterations = 1
relative_radius = 0.3
[[method]]
sampler = "sphere-tiles"
colors = 2
points_per_tile = 32
lloyd_iterations = 1
relative_radius = 0.3
joint_iterations = 3
)";

class SamplerMemory : public ::testing::TestWithParam<int>
{
protected:
    ~SamplerMemory() override { unsetenv("POISSONLAB_CACHE"); }

    /// Tables of tilings, which are built without a device, are built once.
    static void copy_tables(const std::filesystem::path& from, const std::filesystem::path& to)
    {
        for (const auto& file : std::filesystem::directory_iterator(from))
            if (file.path().extension() == ".table")
                std::filesystem::copy(file, to / file.path().filename(), std::filesystem::copy_options::skip_existing);
    }

    TemporaryFolder tables_;
};

/// Never less than what is taken, or work would fail midway; at most 1.3 times as much (and a few numbers, for the
/// smallest sets), or work would be refused that fits.
TEST_P(SamplerMemory, IsForetold)
{
    Device device = Device::open();
    for (const SeriesPlan& series : memory_plan_of(GetParam() == 2 ? methods_2d : methods_3d, GetParam())) {
        SCOPED_TRACE(series.name);
        const TemporaryFolder cache; // without tile sets, so that these are built
        copy_tables(tables_.path(), cache.path());
        setenv("POISSONLAB_CACHE", cache.path().c_str(), 1);
        const std::uint64_t before = device.memory().total;
        device.watch_memory();
        const auto sampler = series.sampler->create(series.parameters, series.request, Engine::opencl,
                                                    [&]() -> Device& { return device; });
        sampler->expect(0, 100); // some methods take more for several sets
        sampler->sample(0);
        copy_tables(cache.path(), tables_.path());
        const DeviceMemory taken{device.peak_memory().largest, device.peak_memory().total - before};
        const DeviceMemory foretold =
            series.sampler->device_memory
                ? series.sampler->device_memory(series.parameters, series.request, device.info())
                : DeviceMemory{};
        EXPECT_GE(foretold.total, taken.total);
        EXPECT_GE(foretold.largest, taken.largest);
        EXPECT_LE(foretold.total, 1.3 * static_cast<double>(taken.total));
        EXPECT_LE(foretold.largest, 1.3 * static_cast<double>(taken.largest));
    }
}

INSTANTIATE_TEST_SUITE_P(In, SamplerMemory, ::testing::Values(2), ::testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(Nightly, SamplerMemory, ::testing::Values(3), ::testing::PrintToStringParamName());

/// The lists above have every sampler that makes sets itself.
TEST(SamplerMemoryCases, HaveEverySampler)
{
    std::set<std::string> tested{"file", "command"};
    for (const auto& plan : {memory_plan_of(methods_2d, 2), memory_plan_of(methods_3d, 3)})
        for (const SeriesPlan& series : plan) {
            tested.insert(series.sampler->name);
            for (const auto& [key, entry] : series.parameters.given())
                if (const SamplerChoice* start = as_sampler(entry.value)) tested.insert(start->spec->name);
        }
    for (const SamplerSpec& sampler : sampler_registry()) EXPECT_TRUE(tested.contains(sampler.name)) << sampler.name;
}

DeviceInfo small_device(std::uint64_t mebibytes)
{
    DeviceInfo device;
    device.name = "Small GPU";
    device.type = "GPU";
    device.global_memory_bytes = mebibytes << 20;
    device.max_allocation_bytes = device.global_memory_bytes / 4;
    return device;
}

std::string refusal(const std::vector<SeriesPlan>& plan, const DeviceInfo& device)
{
    return refusal_of([&] { check_device_memory(plan, device); });
}

TEST(PlanMemory, OfSeriesThatDoNotFitIsRefused)
{
    const auto plan = memory_plan_of(
        "[[method]]\nsampler = \"random\"\n[[method]]\nsampler = \"lloyd\"\niterations = [1, 2]\n", 2, 10'000'000);
    check_device_memory(plan, small_device(4096));
    EXPECT_THAT(refusal(plan, small_device(256)),
                AllOf(StartsWith("test.toml:7: Lloyd relaxation, i = 1: needs 1021.8 MiB of device memory"),
                      HasSubstr("Small GPU has 256.0 MiB, 64.0 MiB in one piece"), HasSubstr("points would fit"),
                      Not(HasSubstr("\n"))));
}

TEST(PlanMemory, IsSharedByTheProcessesOfAMachine)
{
    const auto plan = memory_plan_of("[[method]]\nsampler = \"lloyd\"\niterations = 1\n", 2, 10'000'000);
    EXPECT_EQ(refusal(plan, share_of(small_device(4096), 1)), "accepted");
    EXPECT_EQ(refusal(plan, share_of(small_device(4096), 4)), "accepted") << "needs 1021.8 MiB, and has 1024";
    EXPECT_THAT(refusal(plan, share_of(small_device(4096), 5)),
                HasSubstr("Small GPU, shared by 5 processes, has 819.2 MiB, 819.2 MiB in one piece"));
}

TEST(PlanMemory, OfConstructionsThatDoNotFitIsRefused)
{
    const auto exhibits = exhibits_in("\n\n[[construction]]\nkind = \"sphere\"\npoints_per_tile = 4096\n"
                                      "label = \"Tiles\"\n",
                                      "test.toml");
    check_device_memory(exhibits, small_device(1024));
    EXPECT_THAT(message_of([&] { check_device_memory(exhibits, small_device(1)); }),
                AllOf(StartsWith("test.toml:3: Tiles: needs "), HasSubstr("Small GPU has 1.0 MiB")));
}

/// The number of points that the message of a refusal offers.
std::size_t offered(const std::string& message)
{
    const std::string before = "up to ";
    return std::stoul(message.substr(message.find(before) + before.size()));
}

TEST(PlanMemory, RefusalsOfferTheLargestNumberThatFits)
{
    for (const std::string& method :
         {std::string("sampler = \"lloyd\"\niterations = 1\n"), std::string("sampler = \"relaxation-dart-throwing\"\n"),
          std::string("sampler = \"dart-throwing\"\nrelative_radius = 0.7\n")}) {
        SCOPED_TRACE(method);
        const std::size_t most =
            offered(refusal(memory_plan_of("[[method]]\n" + method, 2, 50'000'000), small_device(512)));
        EXPECT_EQ(refusal(memory_plan_of("[[method]]\n" + method, 2, most), small_device(512)), "accepted");
        EXPECT_EQ(offered(refusal(memory_plan_of("[[method]]\n" + method, 2, most + 1), small_device(512))), most);
    }
}

TEST(PlanMemory, CountsTheStart)
{
    const std::string lloyd = "[[method]]\nsampler = \"lloyd\"\niterations = 1\n";
    const std::string start = lloyd + "start = { sampler = \"relaxation-dart-throwing\" }\n";
    const auto offered_by = [](const std::string& method) {
        return offered(refusal(memory_plan_of(method, 2, 50'000'000), small_device(512)));
    };
    EXPECT_LT(offered_by(start), offered_by(lloyd));
}

TEST(PlanMemory, SaysWhereFewerPointsAreNoHelp)
{
    const auto plan =
        memory_plan_of("[[method]]\nsampler = \"dart-throwing\"\nstop = \"saturation\"\nmin_distance = 0.0005\n");
    EXPECT_THAT(refusal(plan, small_device(64)), HasSubstr("; fewer points would not fit either"));
}

/// Tile sets are filled, and tilings made, in pieces that fit: only the set itself must.
TEST(PlanMemory, OfTilesIsCutToFit)
{
    const std::string tiles =
        "[[method]]\nsampler = \"corner-tiles\"\ncolors = 10\npoints_per_tile = 256\nlloyd_iterations = 5\n";
    const auto plan = memory_plan_of(tiles, 2, 1'000'000);
    EXPECT_GT(plan[0].sampler->device_memory(plan[0].parameters, plan[0].request, small_device(4096)).total,
              200u << 20);
    EXPECT_EQ(refusal(plan, small_device(64)), "accepted");
    EXPECT_THAT(refusal(memory_plan_of("[[method]]\nsampler = \"edge-tiles\"\ncolors = 3\n"), small_device(64)),
                HasSubstr("fewer points would not fit either"));
}

}
}

// The law by which the memory of a sampler grows, held against what is planned for sets of 2^12, 2^16 and 2^20 points:
// a sampler that takes N^1.5 works at every size that other tests can afford, and fails at a million points.
#include "experiment/config/plan.hpp"
#include "host/settings/sampler_registry.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

namespace poissonlab {
namespace {

constexpr std::size_t small_set = 1 << 12, middle_set = 1 << 16, large_set = 1 << 20;

/// The keys that a config has to name of a method, beside its sampler.
const std::map<std::string, std::string>& needed_keys()
{
    static const std::map<std::string, std::string> keys{
        {"dart-throwing", "relative_radius = 0.7\n"},
        {"voronoi-darts", "relative_radius = 0.7\n"},
        {"lloyd", "iterations = 1\n"},
        {"corner-tiles", "colors = 2\n"},
        {"edge-tiles", "colors = 2\n"},
        {"template-tiles", "tiles = 16\n"},
        {"sphere-tiles", "colors = 2\nrelative_radius = 0.5\n"},
    };
    return keys;
}

DeviceInfo device_of_type(const std::string& type)
{
    DeviceInfo device;
    device.name = "Large device";
    device.type = type;
    device.compute_units = 16;
    device.global_memory_bytes = std::uint64_t{1} << 40;
    device.max_allocation_bytes = device.global_memory_bytes;
    device.has_double_precision = true;
    return device;
}

double planned_bytes(const std::string& keys, int dimension, std::size_t points, const DeviceInfo& device)
{
    const auto plan = make_plan(parse_config("seed = 5\n[analysis]\npoints = " + std::to_string(points) +
                                                 "\ndimension = " + std::to_string(dimension) + "\n[[method]]\n" + keys,
                                             "test.toml"));
    const SeriesPlan& series = plan.at(0);
    if (!series.sampler->device_memory) return 0;
    return static_cast<double>(series.sampler->device_memory(series.parameters, series.request, device).total);
}

struct GrowthCase
{
    const SamplerSpec* sampler;
    int dimension;
    std::string device, keys;
};

void PrintTo(const GrowthCase& at, std::ostream* out) { *out << at.keys << at.dimension << "D, " << at.device; }

std::string growth_case_name(const ::testing::TestParamInfo<GrowthCase>& info)
{
    const GrowthCase& at = info.param;
    std::string name =
        at.sampler->name + "_" + std::to_string(at.dimension) + "d_" + at.device + "_" + std::to_string(info.index);
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

/// Every sampler in every dimension that it has, on processors and graphics cards; those that throw darts to saturation
/// as well.
std::vector<GrowthCase> growth_cases()
{
    std::vector<GrowthCase> cases;
    for (const SamplerSpec& sampler : sampler_registry()) {
        if (sampler.name == "file" || sampler.name == "command") continue; // they make no sets themselves
        const auto needed = needed_keys().find(sampler.name);
        const std::string name = "sampler = \"" + sampler.name + "\"\n";
        for (const int dimension : sampler.dimensions)
            for (const char* device : {"CPU", "GPU"}) {
                cases.push_back(
                    {&sampler, dimension, device, name + (needed == needed_keys().end() ? "" : needed->second)});
                if (sampler.name.ends_with("dart-throwing") || sampler.name.ends_with("voronoi-darts"))
                    if (std::ranges::find(sampler.parameters, "stop", &ParameterSpec::key) != sampler.parameters.end())
                        cases.push_back({&sampler, dimension, device, name + "stop = \"saturation\"\n"});
            }
    }
    return cases;
}

class MemoryOfSamplers : public ::testing::TestWithParam<GrowthCase>
{
protected:
    double bytes(std::size_t points) const
    {
        return planned_bytes(GetParam().keys, GetParam().dimension, points, device_of_type(GetParam().device));
    }

    /// Grids of powers of two, and of whole cells, make steps: of a factor of two at most over the whole range, where
    /// N^1.5 would be sixteen times too much.
    void expect_linear_at_most() const
    {
        const double sets = static_cast<double>(large_set) / small_set, steps = 2;
        EXPECT_LE(bytes(large_set), bytes(small_set) * sets * steps);
        EXPECT_LE(bytes(small_set), bytes(middle_set));
        EXPECT_LE(bytes(middle_set), bytes(large_set));
    }

    /// Differences leave out memory that a sampler takes for sets of any size, such as a table.
    void expect_linear_at_least() const
    {
        const double sets = static_cast<double>(large_set) / middle_set, steps = 2;
        EXPECT_GE(bytes(large_set) - bytes(middle_set), (bytes(middle_set) - bytes(small_set)) * sets / steps);
        EXPECT_GT(bytes(middle_set), bytes(small_set));
    }
};

TEST_P(MemoryOfSamplers, GrowsAsTheirDescriptionSays)
{
    if (bytes(large_set) == 0) return; // the host does the work, on this kind of device
    switch (GetParam().sampler->memory_growth) {
    case MemoryGrowth::none:
        ADD_FAILURE() << "there is memory";
        break;
    case MemoryGrowth::fixed:
        EXPECT_EQ(bytes(large_set), bytes(small_set));
        break;
    case MemoryGrowth::limited:
        expect_linear_at_most();
        break;
    case MemoryGrowth::linear:
        expect_linear_at_most();
        expect_linear_at_least();
        break;
    }
}

INSTANTIATE_TEST_SUITE_P(Each, MemoryOfSamplers, ::testing::ValuesIn(growth_cases()), growth_case_name);

/// A law is said of those samplers that take memory, on some kind of device.
TEST(MemoryLaws, AreSaidWhereThereIsMemory)
{
    std::map<std::string, double> most;
    for (const GrowthCase& at : growth_cases()) {
        double& bytes = most[at.sampler->name];
        bytes = std::max(bytes, planned_bytes(at.keys, at.dimension, small_set, device_of_type(at.device)));
    }
    for (const SamplerSpec& sampler : sampler_registry()) {
        if (!most.contains(sampler.name)) continue;
        EXPECT_EQ(most.at(sampler.name) > 0, sampler.memory_growth != MemoryGrowth::none) << sampler.name;
    }
}

/// A million darts, on two processors as on many.
TEST(MemoryLaws, AMillionDartsTakeLessThanThreeHundredMegabytes)
{
    for (const unsigned units : {1U, 2U, 16U, 64U}) {
        DeviceInfo device = device_of_type("CPU");
        device.compute_units = units;
        EXPECT_LT(planned_bytes("sampler = \"dart-throwing\"\nrelative_radius = 0.75\n", 2, 1'000'000, device), 300e6)
            << units;
    }
}

}
}

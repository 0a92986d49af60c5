// Every config that ships can be run.
#include "experiment/config/collection.hpp"
#include "experiment/config/plan.hpp"
#include "experiment/exhibits/exhibit.hpp"
#include "tests/support/places.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(ShippedConfigs, ArePlannable)
{
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() + "/configs")) {
        if (entry.is_directory() || entry.path().filename() == "your-method.awk") continue;
        if (entry.path().parent_path().filename() == "peers" && entry.path().extension() != ".toml")
            continue;                                                       // scripts
        if (entry.path().parent_path().filename() == "exemplars") continue; // photographs, and where they are from
        if (entry.path().parent_path().filename() == "alphabets") continue; // what cells.toml reads
        if (entry.path().parent_path().filename() == "tilings") continue;   // tilings by polygons
        if (entry.path().parent_path().filename() == "regions") continue;   // polygons
        if (entry.path().parent_path().filename() == "surfaces") continue;  // meshes, and what makes them
        if (entry.path().parent_path().filename() == "painting") continue;  // a density, and stamps
        if (entry.path().parent_path().filename() == "goals") continue;     // drawings of animals
        if (entry.path().filename() == "draw_tiles.py") continue;           // draws what texture verify proves
        SCOPED_TRACE(entry.path());
        EXPECT_EQ(entry.path().extension(), ".toml");
        ParsedConfig parsed = parse_file(entry.path());
        if (is_collection(parsed)) continue; // its configs are here as well
        const Config config = checked_config(std::move(parsed));
        EXPECT_FALSE(make_plan(config).empty() && read_exhibits(config).empty());
        ++count;
    }
    EXPECT_GE(count, 6);
}

TEST(ShippedConfigs, TheDissertationIsWhole)
{
    // Every figure that there is a config for, in the order of the figures.
    std::vector<std::string> figures;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/configs/dissertation"))
        figures.push_back(entry.path().stem());
    std::ranges::sort(figures);
    std::vector<std::string> included;
    const auto collection = read_collection(parse_file(source_folder() + "/configs/dissertation.toml"));
    for (const CollectedConfig& config : collection.configs) included.push_back(config.name);
    EXPECT_EQ(included, figures);
}

/// Four gibibytes, a quarter of them in one piece: what PoCL says of a machine with so much memory.
TEST(ShippedConfigs, TheDissertationFitsInFourGibibytes)
{
    DeviceInfo device;
    device.name = "four gibibytes";
    device.type = "CPU";
    device.compute_units = 2;
    device.global_memory_bytes = std::uint64_t{4} << 30;
    device.max_allocation_bytes = std::uint64_t{1} << 30;
    const auto collection = read_collection(parse_file(source_folder() + "/configs/dissertation.toml"));
    for (const CollectedConfig& config : collection.configs) {
        EXPECT_NO_THROW(check_device_memory(make_plan(config.config), device)) << config.name;
        EXPECT_NO_THROW(check_device_memory(read_exhibits(config.config), device)) << config.name;
    }
}

TEST(ShippedConfigs, QuickIsWhatTheReadmePromises)
{
    const Config config = read_config(source_folder() + "/configs/quick.toml");
    EXPECT_EQ(config.seed, 1U);
    EXPECT_EQ(config.points, 16384U);
    EXPECT_EQ(config.realizations, 10);
    EXPECT_EQ(make_plan(config).size(), 3U);
}

}
}

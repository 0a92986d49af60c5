// Tile sets are built once, and files that are not what they should be are replaced.
#include "host/tile_sampling/tile_set_cache.hpp"

#include "base/files/file_lock.hpp"
#include "base/programs/cache_folder.hpp"
#include "tests/support/small_tile_sets.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <future>
#include <thread>

namespace poissonlab {
namespace {

const PoissonTileParameters parameters = tile_set_parameters(PoissonTileKind::corner, 2, 2, 16, 0.7);

class TileSetCache : public testing::Test
{
protected:
    PoissonTileSet cached(const PoissonTileParameters& p = parameters)
    {
        CachedTileSet result = cached_tile_set(
            p, Engine::opencl, [this]() -> Device& { return device_; }, folder_.path(),
            [this](const std::string& what) { steps_.push_back(what); });
        record_ = result.record;
        if (!record_.cached) ++built_;
        waiting_seconds_ = result.waiting_seconds;
        return result.set;
    }

    std::filesystem::path file() const { return folder_.path() / tile_cache_name(parameters, &device_.info()); }

    TemporaryFolder folder_;
    Device device_ = Device::open();
    TileSetRecord record_; ///< of the last set
    std::vector<std::string> steps_;
    double waiting_seconds_ = 0;
    int built_ = 0; ///< how often something was
};

TEST_F(TileSetCache, BuildsOnce)
{
    const PoissonTileSet built = cached();
    EXPECT_GE(built.squared_min_distance, asked_squared_distance(parameters));
    EXPECT_EQ(built_, 1);
    EXPECT_EQ(cached(), built);
    EXPECT_EQ(built_, 1);
    PoissonTileParameters other = parameters;
    other.seed = 2;
    EXPECT_NE(cached(other).points, built.points);
    EXPECT_EQ(built_, 2);
}

TEST_F(TileSetCache, SaysWhenItWaitsForAnotherProcess)
{
    const PoissonTileSet built = cached();
    const std::string bytes = encode_tile_set(built);
    std::filesystem::remove(file());
    steps_.clear();
    auto lock = FileLock::try_lock(file().string() + ".lock");
    ASSERT_TRUE(lock);
    auto other = std::async(std::launch::async, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        folder_.write(file().filename().string(), bytes);
        lock.reset();
    });
    EXPECT_EQ(cached(), built);
    other.get();
    EXPECT_TRUE(record_.cached);
    EXPECT_GE(waiting_seconds_, 0.05);
    EXPECT_EQ(steps_, std::vector<std::string>{"waiting for another process that builds the tile set"});
}

TEST(TileCacheName, TellsDevicesApartWhoseSetsMayDiffer)
{
    DeviceInfo card;
    card.platform = "A";
    card.name = "B";
    card.type = "GPU";
    DeviceInfo other_card = card;
    other_card.name = "C";
    const auto name_on = [](const DeviceInfo* info) { return tile_cache_name(parameters, info); };
    EXPECT_NE(name_on(&card), name_on(&other_card));
    EXPECT_NE(name_on(&card), name_on(nullptr));
    card.type = other_card.type = "CPU";
    EXPECT_EQ(name_on(&card), name_on(&other_card)) << "machines of a cluster share sets";
}

TEST_F(TileSetCache, ReplacesDamagedAndForeignFiles)
{
    const PoissonTileSet built = cached();
    const std::string bytes = encode_tile_set(built);
    std::string flipped = bytes;
    flipped[bytes.size() / 2] ^= 1;
    PoissonTileSet unproven = built;
    unproven.squared_min_distance = 0;
    PoissonTileSet foreign = built;
    foreign.parameters.seed = 3;
    for (const std::string& content : {std::string(), bytes.substr(0, bytes.size() / 2), flipped,
                                       encode_tile_set(unproven), encode_tile_set(foreign)}) {
        folder_.write(file().filename().string(), content);
        EXPECT_EQ(cached(), built);
        EXPECT_EQ(read_tile_set(file()), built);
    }
    EXPECT_EQ(built_, 6);
}

TEST_F(TileSetCache, BuildsWhereNothingCanBeKept)
{
    const auto device = [this]() -> Device& { return device_; };
    const PoissonTileSet built = cached();
    EXPECT_EQ(cached_tile_set(parameters, Engine::opencl, device, {}).set, built);
    EXPECT_EQ(cached_tile_set(parameters, Engine::opencl, device, "/proc/no-such-folder").set, built);
}

TEST_F(TileSetCache, KeepsWhatBuildingTook)
{
    cached();
    EXPECT_FALSE(record_.cached);
    EXPECT_EQ(record_.tiles, 16U);
    EXPECT_EQ(record_.points_per_tile, parameters.points_per_tile);
    ASSERT_TRUE(record_.build);
    EXPECT_GT(record_.build->seconds, 0);
    EXPECT_EQ(record_.build->device, device_.info().name);
    EXPECT_GE(record_.build->threads, 1);
    const TileSetBuild build = *record_.build;

    cached();
    EXPECT_TRUE(record_.cached);
    ASSERT_TRUE(record_.build);
    EXPECT_EQ(record_.build->seconds, build.seconds) << "of the run that built it";
    EXPECT_EQ(record_.build->device, build.device);
    EXPECT_EQ(record_.build->threads, build.threads);
}

TEST_F(TileSetCache, TakesSetsWithoutTimes)
{
    const PoissonTileSet built = cached();
    const std::string record = build_record_file(file()).filename().string();
    const auto with = [](const std::string& seconds, const std::string& version = "1") {
        return R"({"format": "poissonlab-tile-set-build", "format_version": )" + version + R"(, "build_seconds": )" +
               seconds + R"(, "device": "d", "threads": 2})";
    };
    folder_.write(record, with("0.5"));
    cached();
    EXPECT_TRUE(record_.build);
    for (const std::string& content : {std::string(), std::string("{"), std::string("[]"), std::string("{}"),
                                       with("-1"), with("\"soon\""), with("1e999"), with("0.5", "2")}) {
        folder_.write(record, content);
        EXPECT_EQ(cached(), built);
        EXPECT_TRUE(record_.cached);
        EXPECT_FALSE(record_.build) << content;
    }
    std::filesystem::remove(folder_.path() / record);
    EXPECT_EQ(cached(), built);
    EXPECT_FALSE(record_.build);
    EXPECT_EQ(built_, 1) << "none of that is a reason to build again";
}

TEST(TileCacheFolder, IsTheFirstThatTheEnvironmentNames)
{
    const char* home = std::getenv("HOME");
    const std::string kept = home ? home : "";
    setenv("POISSONLAB_CACHE", "/a", 1);
    setenv("XDG_CACHE_HOME", "/b", 1);
    setenv("HOME", "/c", 1);
    EXPECT_EQ(cache_folder(), "/a");
    unsetenv("POISSONLAB_CACHE");
    EXPECT_EQ(cache_folder(), "/b/poissonlab");
    unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(cache_folder(), "/c/.cache/poissonlab");
    unsetenv("HOME");
    EXPECT_TRUE(cache_folder().empty());
    if (home) setenv("HOME", kept.c_str(), 1);
}

}
}

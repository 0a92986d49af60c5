// The tile sets that ship: what their names, their table and their files promise is proven.
#include "base/geometry/relative_radius.hpp"
#include "tests/support/places.hpp"
#include "tiles/poisson/monotile_points_file.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

namespace poissonlab {
namespace {

std::filesystem::path folder() { return std::filesystem::path(source_folder()) / "runtime" / "tile_sets"; }

/// The name that a set has there.
std::string ready_name(const PoissonTileParameters& p)
{
    return fmt::format("{}-c{}-n{}-r0{:.0f}.ptiles", kind_name(p), p.colors, p.points_per_tile,
                       100 * p.relative_radius);
}

/// Each pair of classes keeps what is stated, and each class has the relative radius of the name.
void check_classes(const std::string& name, const PoissonTileSet& set, const std::string& table)
{
    const TileClasses& classes = set.parameters.classes;
    EXPECT_EQ(name,
              fmt::format("corner-classes-c{}-n{}-r070.ptiles", set.parameters.colors, fmt::join(classes.points, "-")));
    EXPECT_TRUE(set.parameters.ranked) << name;
    const std::vector<ClassPairProof> proofs = certify_classes(set);
    ASSERT_EQ(proofs.size(), class_pair_count(classes.count()));
    for (std::size_t k = 0; k < proofs.size(); ++k)
        EXPECT_EQ(proofs[k].squared_min_distance, set.class_squared_distances[k]) << name;
    for (std::size_t i = 0; i < classes.count(); ++i) {
        const double least = std::sqrt(static_cast<double>(proofs[class_pair(i, i)].squared_min_distance)) / tile_units;
        EXPECT_GE(relative_radius(least, classes.points[i], 2), 0.70) << name;
    }
    EXPECT_THAT(table, testing::HasSubstr(fmt::format("| [{0}]({0}) | {1} points a tile | 0.70 | {2} |", name,
                                                      fmt::join(classes.points, ", "), set.parameters.colors)));
}

/// The promises of these files are proven by a test of monotile files, which builds them again.
void check_monotile(const MonotilePointsFile& file, const std::string& name, const std::string& table)
{
    EXPECT_THAT(table, testing::HasSubstr(fmt::format("| [{0}]({0}) | {1:.4f} | {2:.5f} | {3} | {4} |", name,
                                                      std::floor(file.relative_radius() * 1e4) / 1e4,
                                                      std::floor(pmono_min_distance(&file.set()) * 1e5) / 1e5,
                                                      file.set().points_per_tile, (file.bytes().size() + 512) / 1024)));
}

TEST(ReadyTileSets, KeepWhatTheyPromise)
{
    std::ifstream table_file(folder() / "README.md");
    const std::string table(std::istreambuf_iterator<char>(table_file), {});
    std::set<std::string> kinds;
    for (const auto& entry : std::filesystem::directory_iterator(folder())) {
        if (entry.path().extension() != ".ptiles") continue;
        const std::string name = entry.path().filename().string();
        if (is_monotile_points_file(entry.path())) {
            check_monotile(read_monotile_points(entry.path()), name, table);
            continue;
        }
        const PoissonTileSet set = read_tile_set(entry.path());
        if (!set.parameters.classes.is_empty()) {
            check_classes(name, set, table);
            continue;
        }
        const TileCertificate proof = certify(set);
        EXPECT_EQ(name, ready_name(set.parameters));
        EXPECT_TRUE(set.parameters.ranked) << name;
        EXPECT_EQ(set.squared_min_distance, proof.squared_min_distance) << name;
        EXPECT_GE(proof.relative_radius, set.parameters.relative_radius) << name;
        EXPECT_THAT(table,
                    testing::HasSubstr(fmt::format(
                        "| [{0}]({0}) | {1:.4f} | {2:.5f} | {3} |", name, std::floor(proof.relative_radius * 1e4) / 1e4,
                        std::floor(std::sqrt(static_cast<double>(proof.squared_min_distance)) / tile_units * 1e5) / 1e5,
                        proof.moments.proven_exponent())));
        EXPECT_GE(proof.moments.proven_exponent(), 4U) << name;
        kinds.insert(
            fmt::format("{} {} {}", kind_name(set.parameters), set.parameters.colors, set.parameters.relative_radius));
    }
    EXPECT_THAT(kinds, testing::ElementsAre("corner 3 0.75", "corner 3 0.85", "corner 4 0.75", "corner 4 0.85",
                                            "corner 6 0.75", "corner 6 0.85", "corner 8 0.75", "corner 8 0.85",
                                            "sphere 2 0.75", "sphere 2 0.85"));
}

}
}
